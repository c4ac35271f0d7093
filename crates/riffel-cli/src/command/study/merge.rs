//! `riffel study merge`

use std::path::Path;

use riffel_study::ResultFolder;

use crate::arguments::Merge;
use crate::messages::complain;
use crate::output::{print, print_json};

/// Most missing chunks that are named.
const NAMED: usize = 12;

pub(super) fn run(arguments: &Merge) -> miette::Result<u8> {
    let from: Vec<&Path> = arguments.from.iter().map(AsRef::as_ref).collect();
    let report = ResultFolder::merge(&arguments.into, &from)?;
    let whole = report.missing.is_empty();
    if arguments.json {
        print_json(&report)?;
    } else {
        let into = arguments.into.display();
        let already = match report.there_already {
            0 => String::new(),
            count => format!(", {count} were there already with the same numbers"),
        };
        print(&format!(
            "{into}: {} of {} chunks, {} copied{already}\n{}",
            report.summary.chunks_finished,
            report.summary.chunks,
            report.copied,
            super::failures(&report.summary)
        ))?;
    }
    if !whole {
        let named: Vec<String> = report.missing.iter().take(NAMED).map(ToString::to_string).collect();
        let more = if report.missing.len() > NAMED { " …" } else { "" };
        complain(format_args!(
            "note: {} chunks are missing: {}{more}; riffel study PLAN -o {} computes them",
            report.missing.len(),
            named.join(" "),
            arguments.into.display()
        ));
    }
    Ok(u8::from(!whole))
}
