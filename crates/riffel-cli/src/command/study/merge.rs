//! `riffel study merge`

use std::path::Path;

use riffel_answers::study::failures;
use riffel_keys::{number, say};
use riffel_study::ResultFolder;

use crate::arguments::Merge;
use crate::messages::{complain, language};
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
        let (finished, chunks) = (number(report.summary.chunks_finished), number(report.summary.chunks));
        let copied = number(report.copied);
        let merged = match report.there_already {
            0 => say!(chunks_merged, finished = finished, chunks = chunks, copied = copied),
            count => say!(
                chunks_merged_beside_others,
                finished = finished,
                chunks = chunks,
                copied = copied,
                already = number(count)
            ),
        };
        let merged = merged.about(arguments.into.display().to_string());
        let lines = [merged].into_iter().chain(failures(&report.summary));
        print(&lines.map(|line| line.text(language()) + "\n").collect::<String>())?;
    }
    if !whole {
        let named: Vec<String> = report.missing.iter().take(NAMED).map(ToString::to_string).collect();
        let more = if report.missing.len() > NAMED { " …" } else { "" };
        complain(say!(
            chunks_are_missing,
            count = number(report.missing.len()),
            chunks = named.join(" ") + more,
            folder = arguments.into.display().to_string()
        ));
    }
    Ok(u8::from(!whole))
}
