//! Whether the intervals of a calibration hold the truth as often as they say.

use riffel_calibrate::{Checked, Ranked, Simulated};
use riffel_keys::{Message, say};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Series};
use serde::Serialize;

use crate::{Answer, Column, Table};

/// The distance of a distribution of so many ranks, over its square root, that one in a thousand exceeds: Kolmogorov (1933).
const BAND: f64 = 1.95;

/// Ranks of the truth among draws from simulated data.
#[derive(Serialize)]
pub struct CalibrationCheck {
    riffel_version: &'static str,
    title: Option<String>,
    #[serde(flatten)]
    simulated: Simulated,
}

impl CalibrationCheck {
    /// Of a plan with this title.
    pub fn new(title: Option<String>, simulated: Simulated) -> Self {
        Self { riffel_version: env!("CARGO_PKG_VERSION"), title, simulated }
    }

    /// A sentence on each value whose ranks are uneven.
    pub fn doubts(&self) -> Vec<Message> {
        let uneven = self.simulated.values.iter();
        let uneven = uneven.filter(|value| !self.simulated.is_even(value));
        let sentence = |value: &Ranked| {
            say!(
                ranks_are_uneven,
                value = name(value),
                runs = value.ranks.len(),
                probability = format!("{:.1e}", value.probability)
            )
        };
        uneven.map(sentence).collect()
    }

    fn verdict(&self, value: &Ranked) -> Message {
        match self.simulated.is_even(value) {
            true => say!(ranks_even),
            false => say!(ranks_uneven),
        }
    }
}

fn name(value: &Ranked) -> Message {
    match &value.of {
        Checked::Parameter(name) => Message::verbatim(name),
        Checked::LogLikelihood => say!(log_likelihood_of_all_data),
        Checked::PassagesToLimit => say!(passages_to_the_limit),
    }
}

impl Answer for CalibrationCheck {
    fn name(&self) -> &'static str {
        "ranks"
    }

    fn document_name(&self) -> &'static str {
        "ranks.json"
    }

    fn introduction(&self) -> Vec<Message> {
        vec![say!(truth_among_draws, runs = self.simulated.runs)]
    }

    fn tables(&self) -> Vec<Table> {
        let values = &self.simulated.values;
        // Ranks of the ln likelihood are no interval of anything.
        let inside = |place: usize| {
            let share = |value: &Ranked| (value.of != Checked::LogLikelihood).then_some(100.0 * value.inside[place]);
            values.iter().map(share).collect::<Vec<Option<f64>>>().into_iter()
        };
        let probability = values.iter().map(|value| Some(value.probability));
        let simulations = values.iter().map(|value| Some(value.ranks.len() as f64));
        vec![Table {
            name: self.name(),
            columns: vec![
                Column::words("value", say!(checked_value), values.iter().map(name).collect()),
                Column::fixed("simulations", say!(simulations), simulations, 0),
                Column::fixed("inside_50_percent", say!(inside_50_percent), inside(0), 0),
                Column::fixed("inside_80_percent", say!(inside_80_percent), inside(1), 0),
                Column::fixed("inside_90_percent", say!(inside_90_percent), inside(2), 0),
                Column::fixed("probability", say!(probability_of_ranks), probability, 4),
                Column::words(
                    "verdict",
                    say!(verdict_on_ranks),
                    values.iter().map(|value| self.verdict(value)).collect(),
                ),
            ],
        }]
    }

    fn sentences(&self) -> Vec<Message> {
        match self.doubts().is_empty() {
            true => vec![say!(all_ranks_even, runs = self.simulated.runs)],
            false => Vec::new(),
        }
    }

    fn figure(&self) -> LineFigure {
        let runs = self.simulated.runs as f64;
        let text = |message: Message| message.text(riffel_keys::Language::English);
        let ends = [0.0, 1.0];
        let band = |sign: f64, label: &str| Series {
            label: label.to_owned(),
            x: ends.to_vec(),
            y: vec![sign * BAND / runs.sqrt(); 2],
            style: LineStyle::Dashed,
            ..Series::default()
        };
        let series = self.simulated.values.iter().map(|value| {
            let ranks = (0..=riffel_calibrate::RANKED).map(|rank| {
                let below = value.ranks.iter().filter(|own| **own <= rank).count() as f64;
                let share = (rank + 1) as f64 / (riffel_calibrate::RANKED + 1) as f64;
                (share, below / value.ranks.len() as f64 - share)
            });
            let (x, y) = ranks.unzip();
            Series { label: text(name(value)), x, y, ..Series::default() }
        });
        let bands = [band(1.0, "band of 99.9 %"), band(-1.0, "")];
        LineFigure {
            title: self.title.clone().unwrap_or_else(|| "Check".to_owned()),
            caption: format!(
                "Share of {} simulations in which at most so many draws lie below the truth, less that of even ranks; dashed, what one \
                 value in a thousand exceeds (Kolmogorov).",
                self.simulated.runs
            ),
            panels: vec![LinePanel {
                x_label: "share of draws below the truth".to_owned(),
                y_label: "share of simulations, less even".to_owned(),
                x_range: Some((0.0, 1.0)),
                series: series.chain(bands).collect(),
                ..LinePanel::default()
            }],
            ..LineFigure::default()
        }
    }

    fn remarks(&self) -> &[Message] {
        &[]
    }
}
