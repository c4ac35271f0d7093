//! `POST /api/line`: what grows fastest under the traffic of the line, and what that follows.

use riffel_answers::{Cause, LineGrowth};
use serde::{Deserialize, Serialize};

use crate::traffic::OnLine;
use crate::{Fault, Note, Reply};

#[derive(Deserialize)]
pub(crate) struct Question(OnLine);

#[derive(Serialize)]
struct Answer<'a> {
    #[serde(flatten)]
    growth: &'a LineGrowth,
    /// In what the fastest doubles; none where nothing grows.
    doubles_in: Option<Note>,
    notes: Vec<Note>,
    card: Option<Card>,
    /// Wavelengths \[m\] with their growth rates per passage under the traffic.
    curve: &'a [[f64; 2]],
}

/// What the fastest follows, in words.
#[derive(Serialize)]
struct Card {
    title: Note,
    evidence_for: Vec<Note>,
    evidence_against: Vec<Note>,
}

impl From<&Cause> for Card {
    fn from(cause: &Cause) -> Self {
        Self {
            title: Note::from(&cause.title()),
            evidence_for: Note::all(&cause.evidence_for),
            evidence_against: Note::all(&cause.evidence_against),
        }
    }
}

impl crate::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("line".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let (case, traffic) = self.0.read()?;
        let growth = LineGrowth::new(&case, traffic.as_ref())?;
        Reply::json(&Answer {
            doubles_in: growth.fastest.map(|it| Note::from(&it.time())),
            notes: Note::all(&growth.remarks),
            card: growth.cause.as_ref().map(Card::from),
            curve: &growth.curve,
            growth: &growth,
        })
    }
}
