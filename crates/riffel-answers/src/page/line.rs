//! `POST /api/line`: what grows fastest under the traffic of the line, and what that follows.

use crate::{Cause, LineGrowth};
use riffel_keys::Message;
use serde::{Deserialize, Serialize};

use crate::page::traffic::OnLine;
use crate::page::{Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    #[serde(flatten)]
    line: OnLine,
    /// Of each use only the newest question is wanted.
    #[serde(default, rename = "for")]
    purpose: Purpose,
}

/// What the answer is for.
#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Purpose {
    #[default]
    Headline,
    Sweep,
}

#[derive(Serialize)]
struct Answer<'a> {
    #[serde(flatten)]
    growth: &'a LineGrowth,
    /// In what the fastest doubles; `None` if nothing grows.
    doubles_in: Option<Message>,
    notes: &'a [Message],
    card: Option<Card>,
    /// Wavelengths \[m\] with their growth rates per passage under the traffic.
    curve: &'a [[f64; 2]],
}

/// What the fastest follows, in words.
#[derive(Serialize)]
struct Card {
    title: Message,
    evidence_for: Vec<Message>,
    evidence_against: Vec<Message>,
}

impl From<&Cause> for Card {
    fn from(cause: &Cause) -> Self {
        Self {
            title: cause.title(),
            evidence_for: cause.evidence_for.clone(),
            evidence_against: cause.evidence_against.clone(),
        }
    }
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        let subject = match self.purpose {
            Purpose::Headline => "line",
            Purpose::Sweep => "line of a sweep",
        };
        Some(subject.to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let (case, traffic) = self.line.read()?;
        let growth = LineGrowth::new(&case, traffic.as_ref())?;
        Reply::json(&Answer {
            doubles_in: growth.fastest.map(|it| it.time()),
            notes: &growth.remarks,
            card: growth.cause.as_ref().map(Card::from),
            curve: &growth.curve,
            growth: &growth,
        })
    }
}
