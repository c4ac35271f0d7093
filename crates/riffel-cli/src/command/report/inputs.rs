//! The input files of a report, each with its fingerprint.

use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::text_file::is_standard_input;

use super::page::{escape, table};
use crate::fingerprint::fingerprint;

/// Input files in the order in which they were named.
#[derive(Default)]
pub(super) struct Inputs {
    rows: Vec<Vec<String>>,
}

impl Inputs {
    /// A file with what it is for and what it was understood as.
    pub(super) fn add(&mut self, role: &str, path: &Path, origin: &str) -> Result<(), CaseError> {
        let hash = if is_standard_input(path) {
            "standard input".to_owned()
        } else {
            fingerprint(path).map_err(|reason| {
                CaseError::data(path, format!("cannot read the file: {reason}"))
            })?
        };
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
