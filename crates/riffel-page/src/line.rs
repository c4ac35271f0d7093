//! `POST /api/line`: what grows fastest under the traffic of the line.

use riffel_answers::LineGrowth;
use serde::{Deserialize, Serialize};

use crate::{CaseText, Fault, Note, Reply, Traffic, Wanted};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
    /// The traffic of the line; none, and it is the usual one.
    #[serde(default)]
    traffic: Option<Traffic>,
}

#[derive(Serialize)]
struct Answer {
    #[serde(flatten)]
    growth: LineGrowth,
    notes: Vec<Note>,
}

impl crate::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("line".to_owned())
    }

    fn answer(&self, _: Wanted) -> Result<Reply, Fault> {
        let traffic = self.traffic.as_ref().map(Traffic::read).transpose()?;
        let growth = LineGrowth::new(&self.case.read()?, traffic.as_ref())?;
        Reply::json(&Answer {
            notes: growth.remarks.iter().map(Note::from).collect(),
            growth,
        })
    }
}
