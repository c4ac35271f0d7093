//! A study that was computed, or a part of it.

use std::path::Path;

use riffel_keys::{Message, number, say};
use riffel_study::{ResultFolder, Study, StudyError, Summary};
use serde::Serialize;

use super::statistics::{self, Statistics};
use super::title;
use crate::{Answer, Table};

/// What a run of a study has made.
#[derive(Serialize)]
pub struct StudyAnswer<'a> {
    folder: String,
    fingerprint: &'a str,
    parameters: Vec<&'a str>,
    #[serde(flatten)]
    summary: Summary,
    /// Samples computed by this run.
    samples_computed: u64,
    seconds: f64,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    outputs: Vec<Statistics>,
    remarks: Vec<Message>,
    #[serde(skip)]
    title: Option<&'a str>,
}

impl<'a> StudyAnswer<'a> {
    /// Of a study whose folder at a path holds so much, after a run that computed so many samples in so many seconds.
    ///
    /// # Errors
    /// [`StudyError`] for results that cannot be read.
    pub fn new(
        study: &'a Study,
        (folder, path): (&ResultFolder, &Path),
        summary: Summary,
        (samples_computed, seconds): (u64, f64),
    ) -> Result<Self, StudyError> {
        let outputs = match summary.chunks_finished == summary.chunks {
            true => Statistics::of(study, folder)?,
            false => Vec::new(),
        };
        Ok(Self {
            folder: path.display().to_string(),
            fingerprint: &study.fingerprint,
            parameters: study.parameters().iter().map(|parameter| parameter.key.key.as_str()).collect(),
            summary,
            samples_computed,
            seconds,
            outputs,
            remarks: study.plan.remarks.iter().map(Message::verbatim).collect(),
            title: study.plan.file.title.as_deref(),
        })
    }
}

/// Why samples failed, one line for each reason.
pub(super) fn failures(summary: &Summary) -> Vec<Message> {
    if summary.samples_failed == 0 {
        return Vec::new();
    }
    let (failed, finished) = (number(summary.samples_failed), number(summary.samples_finished));
    let reasons = summary.reasons.iter();
    let reasons =
        reasons.map(|reason| say!(samples_fail_as, count = number(reason.count), example = reason.example.as_str()));
    [say!(samples_without_results, failed, finished)].into_iter().chain(reasons).collect()
}

impl Answer for StudyAnswer<'_> {
    fn name(&self) -> &'static str {
        "study"
    }

    fn introduction(&self) -> Vec<Message> {
        vec![title(self.title)]
    }

    fn tables(&self) -> Vec<Table> {
        vec![statistics::table(&self.outputs)]
    }

    fn sentences(&self) -> Vec<Message> {
        let chunks = self.summary.chunks;
        let left = chunks - self.summary.chunks_finished;
        let left = (left > 0).then(|| say!(chunks_left_to_shards, left = number(left), chunks = number(chunks)));
        failures(&self.summary).into_iter().chain(left).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
