//! What a calibration says, as one document.

use riffel_calibrate::file::SamplerFile;
use riffel_calibrate::{Chains, Identifiability, Marginal, Outlying, Plan, Predicted, Summary, TOLD};
use riffel_keys::{Message, fixed, say};
use riffel_plot::LineFigure;
use serde::Serialize;

use crate::calibrate::{Densities, LogEvidence, close_pairs, correlations, directions, figure};
use crate::number_alone;
use crate::outlying::in_words;
use crate::{Answer, Rows, Table};

/// What the chains of a plan say of each value, and of the data.
#[derive(Serialize)]
pub struct Calibration {
    riffel_version: &'static str,
    title: Option<String>,
    sampler: Sampler,
    /// Whether the chains agree, and count for enough draws.
    pub is_conclusive: bool,
    /// What the data tell and what they do not.
    pub conclusion: Message,
    parameters: Vec<Value>,
    data: Vec<Predicted>,
    /// A sentence on each pair that the data do not part.
    pub together: Vec<Message>,
    /// A sentence on each value that the data do not tell.
    pub untold: Vec<Message>,
    /// Data that lie far from what all others say.
    outlying: Vec<Outlying>,
    /// A sentence on each of these.
    pub far_from_others: Vec<Message>,
    /// Why the chains allow no conclusion.
    pub doubts: Vec<Message>,
    remarks: Vec<Message>,
    /// ln of the evidence, where the sampler tells it.
    #[serde(skip_serializing_if = "Option::is_none")]
    log_evidence: Option<LogEvidence>,
    #[serde(skip)]
    tables: Vec<Table>,
    /// Marginal distributions and pairs.
    #[serde(skip)]
    figure: LineFigure,
}

/// How the posterior was sampled.
#[derive(Serialize)]
pub(crate) struct Sampler {
    chains: u64,
    warmup: u64,
    draws: u64,
    seed: u64,
}

impl From<&SamplerFile> for Sampler {
    fn from(file: &SamplerFile) -> Self {
        Self { chains: file.chains, warmup: file.left_out(), draws: file.draws, seed: file.seed }
    }
}

/// A value after and before the data, in SI; quantiles are those of 5, 25, 50, 75 and 95 %.
#[derive(Serialize)]
struct Value {
    name: String,
    unit: String,
    /// Its key, where it is one of the case.
    key: Option<String>,
    /// Whether it is the size of what the model misses.
    is_size: bool,
    mean: f64,
    standard_deviation: f64,
    quantiles: [f64; 5],
    prior_quantiles: [f64; 5],
    rhat: f64,
    ess_bulk: f64,
    ess_tail: f64,
    contraction: f64,
    is_told: bool,
    /// Whether its median may be written into the case: the chains agree, the data tell it, and not only together with another.
    may_be_written_back: bool,
    densities: Densities,
}

fn is_told(marginal: &Marginal) -> bool {
    marginal.contraction >= TOLD
}

impl Calibration {
    /// Of the chains of a plan.
    pub fn new(plan: &Plan, chains: &Chains, summary: &Summary, told: &Identifiability) -> Self {
        let doubts = summary.doubts();
        let is_conclusive = doubts.is_empty();
        let close = told.correlations.iter().filter(|pair| pair.is_close());
        let close: Vec<&String> = close.flat_map(|pair| &pair.names).collect();
        let parameters = plan.posterior.parameters().iter().zip(&summary.marginals);
        let parameters = parameters.enumerate().map(|(index, (parameter, found))| {
            let key = parameter.key_of_case();
            let is_alone = !close.contains(&&found.name);
            Value {
                name: found.name.clone(),
                unit: found.unit.clone(),
                key: key.map(str::to_owned),
                is_size: parameter.is_size(),
                mean: found.mean,
                standard_deviation: found.standard_deviation,
                quantiles: found.quantiles,
                prior_quantiles: found.prior_quantiles,
                rhat: found.rhat,
                ess_bulk: found.ess_bulk,
                ess_tail: found.ess_tail,
                contraction: found.contraction,
                is_told: is_told(found),
                may_be_written_back: is_conclusive && key.is_some() && is_told(found) && is_alone,
                densities: Densities::of(parameter, &chains.values(plan, index), found),
            }
        });
        let parameters: Vec<Value> = parameters.collect();
        let outlying = chains.outlying(plan);
        let untold = summary.marginals.iter().filter(|found| !is_told(found));
        Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            title: plan.file.title.clone(),
            sampler: Sampler {
                // More than were asked for where the chains went on.
                draws: (summary.draws as u64) / plan.file.sampler.chains,
                ..Sampler::from(&plan.file.sampler)
            },
            is_conclusive,
            conclusion: match is_conclusive {
                true => conclusion(&parameters),
                false => say!(calibration_allows_no_conclusion, doubts = doubts.len()),
            },
            parameters,
            data: chains.predicted(plan),
            together: close_pairs(told),
            untold: untold.map(untold_value).collect(),
            far_from_others: outlying.iter().map(in_words).collect(),
            outlying,
            doubts,
            remarks: plan.remarks.clone(),
            log_evidence: LogEvidence::of(chains),
            tables: vec![marginals(summary), directions(told), correlations(told)],
            figure: figure(plan, chains, summary, told),
        }
    }
}

impl Answer for Calibration {
    fn name(&self) -> &'static str {
        "posterior"
    }

    fn introduction(&self) -> Vec<Message> {
        let title = self.title.as_deref().map(Message::verbatim);
        vec![title.unwrap_or_else(|| say!(calibration_word))]
    }

    fn tables(&self) -> Vec<Table> {
        self.tables.clone()
    }

    fn sentences(&self) -> Vec<Message> {
        let evidence = self.log_evidence.as_ref().map(LogEvidence::in_words);
        self.together.iter().cloned().chain(evidence).collect()
    }

    fn figure(&self) -> LineFigure {
        self.figure.clone()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

/// What the data say of each parameter, as a reader sees it.
fn marginals(summary: &Summary) -> Table {
    let rows = &summary.marginals;
    let quantile = |head: Message, place: usize| rows.numbers(head, |found| four_digits(found.quantiles[place]));
    Table {
        name: "marginals",
        columns: vec![
            rows.shown(Message::verbatim(""), |found| Message::verbatim(&found.name)),
            quantile(say!(median), 2),
            quantile(number_alone("5 %"), 0),
            quantile(number_alone("95 %"), 4),
            rows.digits(Message::verbatim("R̂"), 3, |found| found.rhat),
            rows.numbers(say!(told_by_data_column), |found| format!("{:.0} %", 100.0 * found.contraction.max(0.0))),
            rows.shown(say!(unit_column), |found| Message::verbatim(&found.unit)),
        ],
    }
}

/// What the data tell of values of the case and its traffic, and of which they do not.
fn conclusion(parameters: &[Value]) -> Message {
    let values = || parameters.iter().filter(|value| !value.is_size);
    let count = values().count();
    let told = values().filter(|value| value.is_told);
    let best = told.clone().max_by(|a, b| a.contraction.total_cmp(&b.contraction));
    let Some(best) = best else {
        return say!(calibration_tells_nothing, count);
    };
    let untold = values().filter(|value| !value.is_told);
    let untold: Vec<&str> = untold.map(|value| &*value.name).collect();
    match &untold[..] {
        [] => {
            let contractions = values().map(|value| value.contraction);
            say!(
                calibration_tells_all,
                count,
                least = fixed(1e2 * contractions.fold(f64::INFINITY, f64::min), 0),
                most = fixed(1e2 * best.contraction, 0),
                best = &best.name
            )
        }
        untold => {
            say!(calibration_tells_some, told = told.count(), count, best = &best.name, untold = untold.join(", "))
        }
    }
}

fn untold_value(marginal: &Marginal) -> Message {
    let [low, .., high] = marginal.prior_quantiles;
    say!(
        value_is_not_told,
        value = &marginal.name,
        low = four_digits(low),
        high = four_digits(high),
        unit = &marginal.unit
    )
}

/// A number with four digits.
fn four_digits(number: f64) -> String {
    match number.abs() {
        size if (0.01..1e5).contains(&size) => {
            let decimals = (3 - size.log10().floor() as i32).clamp(0, 6);
            format!("{number:.*}", decimals as usize)
        }
        _ => format!("{number:.3e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(name: &str, contraction: f64, is_size: bool) -> Value {
        let zero = Densities::default();
        Value {
            name: name.to_owned(),
            unit: String::new(),
            key: None,
            is_size,
            mean: 0.0,
            standard_deviation: 0.0,
            quantiles: [0.0; 5],
            prior_quantiles: [0.0; 5],
            rhat: 1.0,
            ess_bulk: 1000.0,
            ess_tail: 1000.0,
            contraction,
            is_told: contraction >= TOLD,
            may_be_written_back: false,
            densities: zero,
        }
    }

    #[test]
    fn the_conclusion_names_what_data_tell_best_and_what_they_do_not() {
        let conclusion = |values: &[Value]| conclusion(values).to_string();
        let [pad, mass, size] = [("pad", 0.9), ("mass", 0.05), ("size", 0.99)];
        let of = |(name, contraction): (&str, f64)| value(name, contraction, name == "size");
        let some = conclusion(&[of(pad), of(mass), of(size)]);
        assert!(some.contains("1 of 2") && some.contains("most of all pad"), "{some}");
        assert!(some.ends_with("mass") && !some.contains("size"), "{some}");
        assert!(conclusion(&[of(pad), of(size)]).contains("all 1"));
        assert!(conclusion(&[of(mass), of(size)]).contains("none of the 1"));
    }

    #[test]
    fn numbers_have_four_digits() {
        for (number, text) in [(0.35, "0.3500"), (99_999.0, "99999"), (3e8, "3.000e8"), (2.5e-9, "2.500e-9")] {
            assert_eq!(four_digits(number), text);
        }
    }
}
