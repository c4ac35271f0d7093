//! The input files of a report, each with its fingerprint.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use riffel_case::CaseError;
use sha2::{Digest, Sha256};

use super::page::{escape, table};

/// Input files in the order in which they were named.
#[derive(Default)]
pub(super) struct Inputs {
    rows: Vec<Vec<String>>,
}

impl Inputs {
    /// A file with what it is for and what it was understood as.
    pub(super) fn add(&mut self, role: &str, path: &Path, origin: &str) -> Result<(), CaseError> {
        let hash = fingerprint(path)
            .map_err(|reason| CaseError::data(path, format!("cannot read the file: {reason}")))?;
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

/// SHA-256 of a file, in hexadecimal digits. A profile may be larger than all else that a report holds: it is
/// read in parts.
fn fingerprint(path: &Path) -> io::Result<String> {
    let mut file = File::open(path)?;
    let mut hash = Sha256::new();
    let mut part = vec![0; 1 << 20];
    loop {
        match file.read(&mut part) {
            Ok(0) => break,
            Ok(length) => hash.update(&part[..length]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    let digits = hash.finalize();
    Ok(digits.iter().map(|byte| format!("{byte:02x}")).collect())
}
