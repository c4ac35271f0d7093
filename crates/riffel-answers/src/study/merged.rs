//! Parts of a study in one folder.

use std::path::PathBuf;

use riffel_keys::{Message, number, say};
use riffel_study::MergeReport;
use serde::Serialize;

use super::failures;
use crate::Answer;

/// Most missing chunks that are named.
const NAMED: usize = 12;

/// What a merge did.
#[derive(Serialize)]
#[serde(transparent)]
pub struct MergeAnswer {
    pub(super) report: MergeReport,
    #[serde(skip)]
    pub(super) into: PathBuf,
}

impl Answer for MergeAnswer {
    fn name(&self) -> &'static str {
        "merge"
    }

    fn introduction(&self) -> Vec<Message> {
        let summary = &self.report.summary;
        let (finished, chunks) = (number(summary.chunks_finished), number(summary.chunks));
        let copied = number(self.report.copied);
        let merged = match self.report.there_already {
            0 => say!(chunks_merged, finished, chunks, copied),
            count => say!(chunks_merged_beside_others, finished, chunks, copied, already = number(count)),
        };
        let merged = merged.about(self.into.display().to_string());
        [merged].into_iter().chain(failures(summary)).collect()
    }

    fn doubts(&self) -> Vec<Message> {
        let missing = &self.report.missing;
        if missing.is_empty() {
            return Vec::new();
        }
        let named: Vec<String> = missing.iter().take(NAMED).map(ToString::to_string).collect();
        let more = if missing.len() > NAMED { " …" } else { "" };
        vec![say!(
            chunks_are_missing,
            count = number(missing.len()),
            chunks = named.join(" ") + more,
            folder = self.into.display().to_string()
        )]
    }
}
