//! `POST /api/wheelset`: how the wheelset of a case moves at its natural frequencies.

use crate::wheelset_motions::WheelsetMotions;
use serde::Deserialize;

use crate::page::{CaseText, Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("wheelset".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        Reply::json(&WheelsetMotions::new(&self.case.read()?)?)
    }
}
