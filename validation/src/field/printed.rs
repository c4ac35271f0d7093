//! The sites of the field in a table and lines.

use riffel_answers::forecast::number_alone;
use riffel_answers::{Answer, Banded, Column, Printed, Table};
use riffel_keys::{Message, fixed, number, say};

use super::{FieldDocument, Measured, OutcomeDocument, SiteDocument};

/// Site, what, unit, median, band of 80 %, what was measured, and whether it is inside.
type Cells = [Message; 7];

fn nothing() -> Message {
    Message::verbatim("")
}

fn row(
    site: &SiteDocument,
    [what, unit]: [Message; 2],
    predicted: Option<Banded>,
    [measured, inside]: [Message; 2],
) -> Cells {
    // Four digits, written plainly.
    let four =
        |value: f64| format!("{value:.3e}").parse().map_or_else(|_| String::new(), |value: f64| value.to_string());
    let [median, band] = match predicted {
        None => [nothing(), nothing()],
        Some(predicted) => {
            let [low, high] = predicted.band_80.map(|end| number(four(end)));
            [number_alone(four(predicted.median)), say!(from_to, from = low, to = high)]
        }
    };
    [Message::verbatim(&site.name), what, unit, median, band, measured, inside]
}

/// What is predicted of a site, then its outcomes.
fn rows(site: &SiteDocument) -> Vec<Cells> {
    let mut rows = Vec::new();
    for (with_geometry, predicted) in [(true, &site.predicted), (false, &site.without_wave_geometry)] {
        let quantities = [
            (say!(predicted_wavelength), Message::verbatim("mm"), predicted.wavelength_mm),
            (say!(predicted_frequency), Message::verbatim("Hz"), predicted.frequency_hz),
            (say!(predicted_growth), say!(decibels_per_million_axles), predicted.growth_db_per_million_axles),
            (say!(predicted_growth), say!(decibels_a_month), predicted.growth_db_per_month),
            (say!(predicted_wear), say!(millimetres_per_100_mgt), predicted.mean_wear_mm_per_100_mgt),
        ];
        rows.extend(quantities.map(|(what, unit, predicted)| {
            let what = if with_geometry { what } else { say!(no_wave_geometry, what = what) };
            row(site, [what, unit], predicted, [nothing(), nothing()])
        }));
    }
    rows.extend(site.outcomes.iter().map(|outcome| outcome_row(site, outcome)));
    rows
}

fn outcome_row(site: &SiteDocument, outcome: &OutcomeDocument) -> Cells {
    let measured = match outcome.measured {
        Measured::Number(measured) => number_alone(measured),
        Measured::Ends([Some(low), Some(high)]) => say!(from_to, from = number(low), to = number(high)),
        Measured::Ends([Some(low), None]) => say!(from_on, from = number(low)),
        Measured::Ends([None, high]) => {
            say!(up_to, to = number(high.map_or_else(String::new, |high| high.to_string())))
        }
    };
    let inside = if outcome.inside { say!(inside_band) } else { say!(outside_band) };
    let named = [Message::verbatim(&outcome.what), Message::verbatim(&outcome.unit)];
    row(site, named, outcome.predicted, [measured, inside])
}

impl Answer for FieldDocument {
    fn name(&self) -> &'static str {
        "field"
    }

    fn tables(&self) -> Vec<Table> {
        let rows: Vec<Cells> = self.cases.iter().flat_map(rows).collect();
        let heads = [
            say!(site_column),
            say!(what_column),
            say!(unit_column),
            say!(median),
            number_alone("80 %"),
            say!(measured_word),
            say!(inside_band),
        ];
        let columns = heads.into_iter().enumerate();
        let columns =
            columns.map(|(place, head)| Column::shown(head, rows.iter().map(|row| row[place].clone()).collect()));
        vec![Table { name: self.name(), columns: columns.collect() }]
    }

    fn sentences(&self) -> Vec<Message> {
        let reasons = self.cases.iter().filter_map(|site| {
            let reason = site.reason.as_deref()?;
            Some(Message::verbatim(reason).about(site.name.as_str()))
        });
        let scores = self.inside_share.zip(self.log_score);
        let inside = scores
            .map(|(share, score)| say!(outcomes_inside, share = fixed(100.0 * share, 0), score = fixed(score, 2)));
        reasons.chain(inside).collect()
    }

    fn printed(&self) -> Vec<Printed> {
        let lines = self.sentences().into_iter().map(Printed::Line);
        self.tables().into_iter().map(Printed::Texts).chain(lines).collect()
    }

    fn remarks(&self) -> &[Message] {
        &[]
    }
}
