//! Whether the intervals of a calibration hold the truth as often as they say.

use std::path::PathBuf;

use riffel_calibrate::{Checked, LEAST_RUNS, Plan, Ranked, Simulated};
use riffel_keys::{Message, say};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Series};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::question::{Client, Files, Question, Source, on_threads};
use crate::{Answer, AnswerError, Result, Rows, Table, level_limit};

/// The limit of forecasts.
const LIMIT: &str = "iso-3095-2013";

/// The distance of a distribution of so many ranks, over its square root, that one in a thousand exceeds: Kolmogorov (1933).
const BAND: f64 = 1.95;

/// Whether intervals of a plan hold the truth as often as they say, by simulated data.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct CheckQuestion {
    /// Plan of the calibration.
    #[schemars(with = "Source<()>", extend("positional" = true))]
    plan: PathBuf,
    /// Number of simulations, 20 at least.
    #[schemars(range(min = LEAST_RUNS), extend("value_name" = "N", "default" = 200))]
    runs: u64,
    /// Folder for the table and the picture of the ranks; left out, none are written.
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub output: Option<PathBuf>,
    /// Number of threads [default: one for each processor].
    #[schemars(range(min = 1), extend("value_name" = "N"))]
    threads: Option<u16>,
}

impl Question for CheckQuestion {
    const NAME: &'static str = "calibrate check";
    const EXAMPLE: &'static str = "Example: riffel calibrate check plan.toml --runs 100 -o check\n\n\
        Values are drawn from the priors of the plan, data from its likelihood with these values, and a chain of the plan on these \
        data; the truth is ranked among its draws. It takes N times as long as one chain.\n\n\
        Exit status: 0 the ranks are even, 1 they are not, 2 bad input, 130 stopped by Ctrl-C.";
    const FILES: Files = Files::OutputOnly;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let plan = Plan::read(&self.plan)?;
        let (_, limit) = level_limit(LIMIT)?;
        let stop = client.stop();
        let step = client.count(say!(progress_simulations), self.runs);
        let work = || Simulated::of(&plan, self.runs, &limit, &|done| step(done as usize), &stop);
        let simulated = on_threads(self.threads, work)??;
        let simulated = simulated.ok_or_else(|| AnswerError::Stopped(say!(check_stopped)))?;
        Ok(Box::new(CalibrationCheck::new(&plan, simulated)))
    }
}

/// Ranks of the truth among draws from simulated data.
#[derive(Serialize)]
pub struct CalibrationCheck {
    riffel_version: &'static str,
    title: Option<String>,
    #[serde(flatten)]
    simulated: Simulated,
    #[serde(skip)]
    remarks: Vec<Message>,
}

impl CalibrationCheck {
    /// Of a plan.
    fn new(plan: &Plan, simulated: Simulated) -> Self {
        let (title, remarks) = (plan.file.title.clone(), plan.remarks.clone());
        Self { riffel_version: env!("CARGO_PKG_VERSION"), title, simulated, remarks }
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
        let inside = |name: &str, head, place: usize| {
            let share = |value: &Ranked| (value.of != Checked::LogLikelihood).then_some(100.0 * value.inside[place]);
            values.fixed(name, head, 0, share)
        };
        vec![Table {
            name: self.name(),
            columns: vec![
                values.words("value", say!(checked_value), name),
                values.fixed("simulations", say!(simulations), 0, |value| value.ranks.len() as f64),
                inside("inside_50_percent", say!(inside_50_percent), 0),
                inside("inside_80_percent", say!(inside_80_percent), 1),
                inside("inside_90_percent", say!(inside_90_percent), 2),
                values.fixed("probability", say!(probability_of_ranks), 4, |value| value.probability),
                values.words("verdict", say!(verdict_on_ranks), |value| self.verdict(value)),
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
        let band = |sign: f64, label: &str| {
            Series::new(label, ends.to_vec(), vec![sign * BAND / runs.sqrt(); 2]).styled(LineStyle::Dashed)
        };
        let series = self.simulated.values.iter().map(|value| {
            let ranks = (0..=riffel_calibrate::RANKED).map(|rank| {
                let below = value.ranks.iter().filter(|own| **own <= rank).count() as f64;
                let share = (rank + 1) as f64 / (riffel_calibrate::RANKED + 1) as f64;
                (share, below / value.ranks.len() as f64 - share)
            });
            let (x, y) = ranks.unzip();
            Series::new(text(name(value)), x, y)
        });
        let bands = [band(1.0, "band of 99.9 %"), band(-1.0, "")];
        LineFigure::new(
            self.title.clone().unwrap_or_else(|| "Check".to_owned()),
            format!(
                "Share of {} simulations in which at most so many draws lie below the truth, less that \
                 of even ranks; dashed, what one value in a thousand exceeds (Kolmogorov).",
                self.simulated.runs
            ),
            [LinePanel {
                x_range: Some((0.0, 1.0)),
                ..LinePanel::new(
                    "share of draws below the truth",
                    "share of simulations, less even",
                    series.chain(bands),
                )
            }],
        )
    }

    fn doubts(&self) -> Vec<Message> {
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

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
