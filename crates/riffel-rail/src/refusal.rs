//! Why a file is refused.

use std::path::Path;

use riffel_keys::{CaseError, Message};

/// A sentence on a file, with the line.
pub(super) struct Refusal {
    pub(super) line: Option<usize>,
    pub(super) message: Message,
    pub(super) help: Option<Message>,
}

impl Refusal {
    pub(super) fn new(line: Option<usize>, message: impl Into<Message>) -> Self {
        Self { line, message: message.into(), help: None }
    }

    pub(super) fn of(self, path: &Path) -> CaseError {
        CaseError::Data { path: path.to_owned(), line: self.line, message: self.message, help: self.help }
    }
}
