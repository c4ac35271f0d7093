//! `POST /api/field`: what was predicted of sites whose corrugation is published beside what was measured there. It is the table
//! that the project keeps: `riffel validate --field` takes minutes.

use riffel_keys::{Message, fixed, say};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::page::{Fault, Reply};

/// What `riffel validate --field --json` printed when the outcomes had been written down.
const KEPT: &str = include_str!("../../field-prediction.json");

#[derive(Deserialize)]
pub(crate) struct Question {}

#[derive(Deserialize)]
struct Prediction {
    riffel_version: String,
    log_score: f64,
    cases: Vec<Site>,
}

#[derive(Deserialize)]
struct Site {
    title: String,
    samples: usize,
    outcomes: Vec<Outcome>,
}

#[derive(Deserialize)]
struct Outcome {
    what: String,
    unit: String,
    /// A number, or two ends of which one may be open.
    measured: Value,
    predicted: Option<Value>,
    inside: bool,
    source: String,
}

#[derive(Serialize)]
struct Answer {
    /// Which version predicted it, and how it came out.
    summary: Message,
    outcomes: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    site: String,
    what: Message,
    unit: Message,
    measured: Value,
    /// Median and bands of 50 and 80 % of the samples; `None` if nothing grows in most.
    predicted: Option<Value>,
    inside: bool,
    source: String,
}

impl Row {
    fn new(site: &str, outcome: Outcome) -> Self {
        Self {
            site: site.to_owned(),
            what: quantity(&outcome.what),
            unit: unit(&outcome.unit),
            measured: outcome.measured,
            predicted: outcome.predicted,
            inside: outcome.inside,
            source: outcome.source,
        }
    }
}

/// What was measured.
fn quantity(what: &str) -> Message {
    match what {
        "wavelength" => say!(field_wavelength),
        "frequency" => say!(field_frequency),
        "growth" => say!(field_growth),
        "shorter of the two strongest waves" => say!(field_shorter_wave),
        "longer of the two strongest waves" => say!(field_longer_wave),
        "high rail over low rail" => say!(field_high_over_low),
        "outer rail over inner rail" => say!(field_outer_over_inner),
        "growth with a friction modifier, over that without" => say!(field_with_modifier),
        other => Message::verbatim(other),
    }
}

fn unit(unit: &str) -> Message {
    match unit {
        "1" => Message::verbatim(""),
        "dB per million axles" => say!(decibels_per_million_axles),
        other => Message::verbatim(other),
    }
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        None
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let kept: Prediction =
            serde_json::from_str(KEPT).map_err(|_| Fault::defect(say!(the_computation_broke_off)))?;
        let samples = kept.cases.iter().map(|site| site.samples).min();
        let rows = kept.cases.into_iter().flat_map(|site| {
            let outcomes = site.outcomes.into_iter();
            outcomes.map(move |outcome| Row::new(&site.title, outcome))
        });
        let outcomes: Vec<Row> = rows.collect();
        let summary = say!(
            field_is_kept,
            version = kept.riffel_version,
            samples = samples.unwrap_or_default(),
            inside = outcomes.iter().filter(|row| row.inside).count(),
            outcomes = outcomes.len(),
            score = fixed(kept.log_score, 2)
        );
        Reply::json(&Answer { summary, outcomes })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A site of the project that measures something else needs its words here.
    #[test]
    fn every_quantity_and_unit_of_the_field_has_its_words() {
        let kept: Prediction = serde_json::from_str(KEPT).unwrap();
        let outcomes = kept.cases.iter().flat_map(|site| &site.outcomes);
        let german = |message: Message| message.text(riffel_keys::Language::German);
        for outcome in outcomes {
            assert_ne!(german(quantity(&outcome.what)), outcome.what);
            assert!(["mm", "Hz"].contains(&&*outcome.unit) || german(unit(&outcome.unit)) != outcome.unit);
        }
    }
}
