//! The input files of a report, each with its fingerprint.

use std::path::Path;

use super::page::{escape, table};

/// Input files in the order in which they were named.
#[derive(Debug, Clone, Default)]
pub struct Inputs {
    rows: Vec<Vec<String>>,
}

impl Inputs {
    /// A file with what it is for and what it was understood as; `fingerprint` is its SHA-256, or the words in its
    /// place.
    pub fn add(&mut self, role: &str, path: &Path, origin: &str, fingerprint: &str) {
        self.rows.push(vec![
            escape(role),
            escape(&path.display().to_string()),
            escape(origin),
            format!("<code>{}</code>", escape(fingerprint)),
        ]);
    }

    pub(super) fn html(&self) -> String {
        table(
            "words",
            &["input", "file", "what it is", "SHA-256"],
            &self.rows,
        )
    }
}
