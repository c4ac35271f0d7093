//! `POST /api/case`: a case checked, as keys and as text.

use riffel_keys::{Message, say};
use serde::{Deserialize, Serialize};

use crate::page::{CaseText, Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

#[derive(Serialize)]
struct Answer {
    /// The keys as they were written.
    keys: toml::Table,
    /// Keys as the text of a case file.
    toml: String,
    /// Every key, with presets and defaults.
    complete: riffel_case::file::CaseFile,
    remarks: Vec<Message>,
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        None
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let case = self.case.read()?;
        let toml = self.case.toml()?;
        let keys = toml
            .parse()
            .map_err(|error: toml::de::Error| Fault::bad(say!(not_valid_toml, message = error.to_string())))?;
        Reply::json(&Answer { keys, toml, complete: case.file, remarks: case.remarks })
    }
}
