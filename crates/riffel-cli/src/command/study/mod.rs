//! `riffel study`

mod compute;
mod merge;
mod sensitivity;
mod statistics;

use crate::arguments::{Study, StudyCommand};

pub(crate) fn run(arguments: &Study) -> miette::Result<u8> {
    match &arguments.command {
        None => compute::run(&arguments.run),
        Some(StudyCommand::Merge(arguments)) => merge::run(arguments),
        Some(StudyCommand::Sensitivity(arguments)) => sensitivity::run(arguments),
    }
}

/// Why samples failed, one line for each reason.
fn failures(summary: &riffel_study::Summary) -> String {
    let mut text = String::new();
    if summary.samples_failed == 0 {
        return text;
    }
    text.push_str(&format!("{} of {} samples have no results:\n", summary.samples_failed, summary.samples_finished));
    for reason in &summary.reasons {
        text.push_str(&format!("  {} times, as in: {}\n", reason.count, reason.example));
    }
    text
}
