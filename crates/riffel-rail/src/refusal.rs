//! Why a file is refused.

use std::path::Path;

use riffel_keys::CaseError;

/// A sentence on a file, with the line.
pub(super) struct Refusal {
    pub(super) line: Option<usize>,
    pub(super) message: String,
    pub(super) help: Option<String>,
}

impl Refusal {
    pub(super) fn new(line: Option<usize>, message: impl Into<String>) -> Self {
        Self {
            line,
            message: message.into(),
            help: None,
        }
    }

    pub(super) fn of(self, path: &Path) -> CaseError {
        CaseError::Data {
            path: path.to_owned(),
            line: self.line,
            message: self.message.into(),
            help: self.help.map(Into::into),
        }
    }
}
