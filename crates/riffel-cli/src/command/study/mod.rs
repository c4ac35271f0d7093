//! `riffel study`

mod compute;
mod merge;
mod sensitivity;

use crate::arguments::{Study, StudyCommand};

pub(crate) fn run(arguments: &Study) -> miette::Result<u8> {
    match &arguments.command {
        None => compute::run(&arguments.run),
        Some(StudyCommand::Merge(arguments)) => merge::run(arguments),
        Some(StudyCommand::Sensitivity(arguments)) => sensitivity::run(arguments),
    }
}
