//! The input files of a report, each with its fingerprint.

use std::path::Path;

use riffel_case::CaseError;
use sha2::{Digest, Sha256};

use super::page::{escape, table};
use crate::command::roughness::choice::refuse;

/// Input files in the order in which they were named.
#[derive(Default)]
pub(super) struct Inputs {
    rows: Vec<Vec<String>>,
}

impl Inputs {
    /// A file with what it is for and what it was understood as.
    pub(super) fn add(&mut self, role: &str, path: &Path, origin: &str) -> Result<(), CaseError> {
        let bytes = std::fs::read(path)
            .map_err(|reason| refuse(path, format!("cannot read the file: {reason}")))?;
        let hash: String = Sha256::digest(&bytes)
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        self.rows.push(vec![
            escape(role),
            escape(&path.display().to_string()),
            escape(origin),
            format!("<code>{hash}</code>"),
        ]);
        Ok(())
    }

    pub(super) fn html(&self) -> String {
        table(
            "words",
            &["input", "file", "what it is", "SHA-256"],
            &self.rows,
        )
    }
}
