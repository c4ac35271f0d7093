//! What a calibration tells of each value, and of values together.

use riffel_calibrate::{Chains, Correlation, Direction, Identifiability, Marginal, Parameter, Plan, Summary};
use riffel_keys::{Message, fixed, say};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Series};
use serde::Serialize;

use crate::{Rows, Table};

/// Bins of a marginal distribution.
const BINS: usize = 30;
/// Draws of a pair that are shown.
const SHOWN: usize = 400;
/// Most pairs that are shown.
const PAIRS: usize = 4;

/// Directions of the values, those that the data tell first.
pub(crate) fn directions(told: &Identifiability) -> Table {
    let directions = &told.directions;
    let by = |direction: &Direction| match direction.is_told() {
        true => say!(told_by_data),
        false => say!(told_by_prior),
    };
    let spread = |it: &Direction| {
        let spread = (!it.powers.is_empty()).then(|| 100.0 * it.spread.exp_m1());
        spread.filter(|spread| spread.is_finite())
    };
    let mut columns = vec![
        directions.words("direction", say!(values_together), |it| Message::verbatim(it.words())),
        directions.words("told_by", say!(told_by), by),
        directions.fixed("spread_percent", say!(spread_percent), 1, spread),
        directions.plain("information", |it| it.information),
    ];
    for (place, name) in told.names.iter().enumerate() {
        columns.push(directions.plain(name, |it| it.parts[place]));
    }
    Table { name: "identifiability", columns }
}

/// Correlations of all pairs, for a file.
pub(crate) fn correlations(told: &Identifiability) -> Table {
    let pairs = &told.correlations;
    Table {
        name: "correlations",
        columns: vec![
            pairs.names("parameter", |pair| &pair.names[0]),
            pairs.names("other", |pair| &pair.names[1]),
            pairs.plain("correlation", |pair| pair.correlation),
        ],
    }
}

/// All pairs, those that move together most closely first.
fn closest_first(told: &Identifiability) -> Vec<&Correlation> {
    let mut pairs: Vec<&Correlation> = told.correlations.iter().collect();
    pairs.sort_by(|a, b| b.correlation.abs().total_cmp(&a.correlation.abs()));
    pairs
}

/// A sentence on each pair that the data do not part.
pub(crate) fn close_pairs(told: &Identifiability) -> Vec<Message> {
    let close = closest_first(told).into_iter();
    let pairs = close.take_while(|pair| pair.is_close()).map(|pair| {
        let [one, other] = &pair.names;
        let correlation = fixed(pair.correlation, 2);
        match pair.correlation < 0.0 {
            true => say!(told_as_a_product, one, other, correlation),
            false => say!(told_as_a_ratio, one, other, correlation),
        }
    });
    pairs.collect()
}

/// ln of the evidence.
#[derive(Serialize)]
pub(crate) struct LogEvidence {
    /// Of the mean of the evidences of all runs.
    value: f64,
    /// The least and the greatest of a run.
    range: [f64; 2],
    runs: usize,
}

impl LogEvidence {
    /// Of chains; `None` where the sampler tells none.
    pub(crate) fn of(chains: &Chains) -> Option<Self> {
        let told = &chains.log_evidences;
        // The mean of the evidences, not of their logarithms.
        let highest = told.iter().copied().reduce(f64::max)?;
        let sum: f64 = told.iter().map(|it| (it - highest).exp()).sum();
        Some(Self {
            value: highest + (sum / told.len() as f64).ln(),
            range: [told.iter().copied().fold(highest, f64::min), highest],
            runs: told.len(),
        })
    }

    /// Evidence in words, with the range and the number of its runs.
    pub(crate) fn in_words(&self) -> Message {
        let Self { value, range, runs } = *self;
        let [low, high] = range.map(|it| fixed(it, 2));
        say!(log_evidence, value = fixed(value, 2), low, high, runs)
    }
}

/// Name and unit of a value.
fn axis(parameter: &Parameter) -> String {
    match &*parameter.unit {
        "" => parameter.name.clone(),
        unit => format!("{} [{unit}]", parameter.name),
    }
}

/// Densities of a value after and before the data, over the highest after them.
#[derive(Default, Serialize)]
pub(crate) struct Densities {
    from: f64,
    to: f64,
    x: Vec<f64>,
    after: Vec<f64>,
    x_before: Vec<f64>,
    before: Vec<f64>,
}

impl Densities {
    pub(crate) fn of(parameter: &Parameter, values: &[f64], found: &Marginal) -> Self {
        let prior = &parameter.prior;
        let [low, .., high] = found.quantiles;
        let ends = [1e-3, 1.0 - 1e-3].map(|share| prior.quantile(share));
        let from = (low - 0.7 * (high - low)).max(ends[0].min(low));
        let to = (high + 0.7 * (high - low)).min(ends[1].max(high));
        let width = (to - from) / BINS as f64;
        let middle = |bin: usize| from + (bin as f64 + 0.5) * width;
        let after = (0..BINS).map(|bin| {
            let is_in = |x: &&f64| (**x - middle(bin)).abs() <= 0.5 * width;
            values.iter().filter(is_in).count() as f64 / values.len() as f64 / width
        });
        let after: Vec<f64> = after.collect();
        let highest = after.iter().copied().fold(0.0, f64::max);
        // Density of the prior: shares over the distances of its quantiles.
        let ends = (0..=400).map(|part| (0.5 + f64::from(part)) / 401.0);
        let ends: Vec<f64> = ends.map(|share| prior.quantile(share)).collect();
        let before = ends.windows(2).map(|pair| (0.5 * (pair[0] + pair[1]), 1.0 / 401.0 / (pair[1] - pair[0])));
        let before = before.filter(|(x, _)| (from..=to).contains(x));
        let (x_before, before) = before.map(|(x, density)| (x, density / highest)).unzip();
        Self {
            from,
            to,
            x: (0..BINS).map(middle).collect(),
            after: after.iter().map(|density| density / highest).collect(),
            x_before,
            before,
        }
    }
}

/// The distribution of a value after and before the data.
fn marginal(parameter: &Parameter, values: &[f64], found: &Marginal) -> LinePanel {
    let densities = Densities::of(parameter, values, found);
    LinePanel {
        x_range: Some((densities.from, densities.to)),
        ..LinePanel::new(
            axis(parameter),
            "density, relative",
            [
                Series::new("after", densities.x, densities.after),
                Series::new("before", densities.x_before, densities.before).styled(LineStyle::Dashed),
            ],
        )
    }
}

/// Draws of two values together.
fn pair(plan: &Plan, chains: &Chains, pair: &Correlation) -> Option<LinePanel> {
    let parameters = plan.posterior.parameters();
    let place = |name: &String| parameters.iter().position(|parameter| parameter.name == *name);
    let (one, other) = (place(&pair.names[0])?, place(&pair.names[1])?);
    let [x, y] = [one, other].map(|place| {
        let values = chains.values(plan, place);
        let step = values.len().div_ceil(SHOWN);
        values.into_iter().step_by(step).collect::<Vec<f64>>()
    });
    Some(
        LinePanel::new(
            axis(&parameters[one]),
            axis(&parameters[other]),
            [Series::new("", x, y).styled(LineStyle::Markers)],
        )
        .titled(format!("r = {:.2}", pair.correlation)),
    )
}

/// Marginal distributions after and before the data, and pairs: those that the data do not part, or else the closest.
pub(crate) fn figure(plan: &Plan, chains: &Chains, summary: &Summary, told: &Identifiability) -> LineFigure {
    let pairs = closest_first(told);
    let parameters = plan.posterior.parameters();
    let marginals = parameters.iter().zip(&summary.marginals).enumerate();
    let panels = marginals.map(|(place, (parameter, found))| marginal(parameter, &chains.values(plan, place), found));
    let shown = pairs.iter().take(PAIRS);
    let shown = shown.filter_map(|correlation| pair(plan, chains, correlation));
    let together = close_pairs(told);
    let mut caption =
        "Distributions after and before the data, over their highest; below the closest pairs of values.".to_owned();
    for sentence in &together {
        caption += &format!(" {}.", sentence.text(riffel_keys::Language::English));
    }
    LineFigure::new(plan.file.title.clone().unwrap_or_else(|| "Calibration".to_owned()), caption, panels.chain(shown))
}
