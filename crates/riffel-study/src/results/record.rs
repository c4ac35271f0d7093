//! What a folder says of itself.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::StudyError;
use crate::study::{Chunk, Study};

/// Version of the layout of a folder.
const FORMAT: u32 = 1;
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// `study.json`
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct StudyRecord {
    format: u32,
    riffel_version: String,
    title: Option<String>,
    fingerprint: String,
    pub(super) samples: u64,
    pub(super) samples_per_chunk: u64,
    pub(super) chunks: u64,
    /// Files of data beside the case.
    pub(super) data: Vec<String>,
}

/// `finished/000012.json`
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct ChunkRecord {
    pub(super) chunk: u64,
    pub(super) samples: u64,
    failures: BTreeMap<String, Reason>,
    /// SHA-256 of each file below `results.zarr`.
    pub(super) files: BTreeMap<String, String>,
}

/// How often samples failed for one reason, with one of the sentences.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reason {
    /// How often.
    pub count: u64,
    /// A sentence with its numbers.
    pub example: String,
}

/// What the finished chunks of a folder hold.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Samples of the study.
    pub samples: u64,
    /// Samples of the finished chunks.
    pub samples_finished: u64,
    /// Chunks of the study.
    pub chunks: u64,
    /// Finished chunks.
    pub chunks_finished: u64,
    /// Samples without results.
    pub samples_failed: u64,
    /// Why, the most frequent first.
    pub reasons: Vec<Reason>,
    #[serde(skip)]
    by_sentence: BTreeMap<String, Reason>,
}

impl StudyRecord {
    pub(super) fn of(study: &Study) -> Self {
        Self {
            format: FORMAT,
            riffel_version: VERSION.to_owned(),
            title: study.plan.file.title.clone(),
            fingerprint: study.fingerprint.clone(),
            samples: study.samples(),
            samples_per_chunk: study.samples_per_chunk(),
            chunks: study.chunks(),
            data: study.data.iter().map(|(name, _)| name.clone()).collect(),
        }
    }

    pub(super) fn read(path: &Path) -> Result<Self, StudyError> {
        read(path)
    }

    pub(super) fn check_version(&self, folder: &Path) -> Result<(), StudyError> {
        if self.format == FORMAT && self.riffel_version == VERSION {
            return Ok(());
        }
        Err(StudyError::OtherVersion { folder: folder.to_owned(), version: self.riffel_version.clone(), own: VERSION })
    }

    /// `Ok` if the folder is that of the study.
    pub(super) fn check(&self, study: &Self, folder: &Path) -> Result<(), StudyError> {
        self.check_version(folder)?;
        let same = self.fingerprint == study.fingerprint
            && self.samples == study.samples
            && self.samples_per_chunk == study.samples_per_chunk;
        if same {
            return Ok(());
        }
        Err(StudyError::OtherPlan { folder: folder.to_owned() })
    }
}

impl ChunkRecord {
    pub(super) fn new(chunk: &Chunk) -> Self {
        let mut failures: BTreeMap<String, Reason> = BTreeMap::new();
        for sample in &chunk.samples {
            if let Err(sentence) = &sample.outputs {
                let reason = failures
                    .entry(without_numbers(sentence))
                    .or_insert_with(|| Reason { count: 0, example: sentence.clone() });
                reason.count += 1;
            }
        }
        Self { chunk: chunk.index, samples: chunk.samples.len() as u64, failures, files: BTreeMap::new() }
    }

    pub(super) fn read(path: &Path) -> Result<Self, StudyError> {
        read(path)
    }
}

impl Summary {
    pub(super) fn new(samples: u64, chunks: u64) -> Self {
        Self {
            samples,
            samples_finished: 0,
            chunks,
            chunks_finished: 0,
            samples_failed: 0,
            reasons: Vec::new(),
            by_sentence: BTreeMap::new(),
        }
    }

    pub(super) fn add(&mut self, record: &ChunkRecord) {
        self.chunks_finished += 1;
        self.samples_finished += record.samples;
        for (sentence, reason) in &record.failures {
            self.samples_failed += reason.count;
            self.by_sentence
                .entry(sentence.clone())
                .and_modify(|known| known.count += reason.count)
                .or_insert_with(|| reason.clone());
        }
        self.reasons = self.by_sentence.values().cloned().collect();
        self.reasons.sort_by_key(|reason| std::cmp::Reverse(reason.count));
    }
}

/// A sentence with its numbers left out: samples that fail for the same reason differ in them.
fn without_numbers(sentence: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for c in sentence.chars() {
        let number = c.is_ascii_digit() || (inside && matches!(c, '.' | 'e' | '-' | '+'));
        if number && !inside {
            text.push('#');
        }
        if !number {
            text.push(c);
        }
        inside = number;
    }
    text
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<T, StudyError> {
    let text = fs::read(path).map_err(|reason| StudyError::Read { path: path.to_owned(), reason })?;
    serde_json::from_slice(&text)
        .map_err(|error| StudyError::Record { path: path.to_owned(), reason: error.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_are_told_apart_without_their_numbers() {
        let one = without_numbers("`contact.tractive_ratio` is 1.25, but must be between 0 and 1");
        let other = without_numbers("`contact.tractive_ratio` is 1.9e1, but must be between 0 and 1");
        assert_eq!(one, other);
        assert_eq!(one, "`contact.tractive_ratio` is #, but must be between # and #");
    }
}
