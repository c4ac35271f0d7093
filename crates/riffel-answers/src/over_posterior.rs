//! What an answer says over the draws of a calibration: every number of its document with its bands.

use std::collections::BTreeMap;

use rayon::prelude::*;
use riffel_calibrate::{CalibrationError, Chains, Drawn, Plan};
use riffel_case::ask;
use riffel_case::traffic::Traffic;
use riffel_keys::{Message, fixed, say};
use riffel_study::sensitivity::quantile;
use serde::{Serialize, Serializer};
use serde_json::Value;

use crate::{Banded, Column, Result, Table, Values};

/// Draws that are taken: a quantile of 5 % is then known to a sixth of a standard deviation.
const DRAWS: usize = 200;
/// What a document says of its question, not of its answer.
const OF_QUESTION: [&str; 4] = ["riffel_version", "inputs", "case", "remarks"];
/// How numbers end that have a band of their own, in which the draws have a part.
const BANDED: &str = "_banded";

/// The draws of a calibration, each as a case and its traffic.
pub struct PosteriorDraws {
    /// 200 at most.
    pub drawn: Vec<Drawn>,
    /// The traffic of the plan, if it names one.
    pub traffic: Option<Traffic>,
    /// What the reader should know of them.
    pub remarks: Vec<Message>,
}

impl PosteriorDraws {
    /// Of the finished chains of a plan.
    ///
    /// # Errors
    /// [`CalibrationError::Refused`] where the case refuses the values of a draw.
    pub fn new(plan: &Plan, chains: &Chains) -> Result<Self, CalibrationError> {
        let mut remarks = Vec::new();
        let set = plan.set_for_trains();
        if !set.is_empty() {
            remarks.push(say!(drawn_as_levels_see_it, set = set.join(", ")));
        }
        let doubts = chains.summary(plan).doubts().len();
        if doubts > 0 {
            remarks.push(say!(forecast_on_doubtful_chains, doubts));
        }
        Ok(Self { drawn: plan.drawn(chains, DRAWS)?, traffic: plan.traffic.clone(), remarks })
    }

    /// Steps of progress that an answer over them takes.
    pub fn count(&self) -> usize {
        self.drawn.len()
    }

    /// The numbers of a document over the draws; `progress` is called after each.
    ///
    /// # Errors
    /// The first that a draw gives.
    pub fn over<D: Serialize>(
        &self,
        progress: &(dyn Fn(usize) + Sync),
        document: impl Fn(&Drawn) -> Result<D> + Sync,
    ) -> Result<OverPosterior> {
        let documents = self.drawn.par_iter().map(|drawn| {
            if let Some(frequency) = oscillates(drawn) {
                progress(1);
                return Ok(Err(frequency));
            }
            let document = document(drawn)?;
            progress(1);
            let mut numbers = BTreeMap::new();
            if let Ok(Value::Object(document)) = serde_json::to_value(&document) {
                let answers = document.iter();
                for (key, value) in answers.filter(|(key, _)| is_of_answer(key)) {
                    collect(key, value, &mut numbers);
                }
            }
            Ok(Ok(numbers))
        });
        let documents = documents.collect::<Result<Vec<_>>>()?;
        let mut samples: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        let mut unstable = Vec::new();
        for document in documents {
            match document {
                Err(frequency) => unstable.push(frequency),
                Ok(numbers) => {
                    for (name, value) in numbers {
                        samples.entry(name).or_default().push(value);
                    }
                }
            }
        }
        let numbers = samples.into_iter();
        Ok(OverPosterior {
            draws: self.drawn.len(),
            unstable_samples: unstable.len(),
            unstable_frequency_hz: Banded::of_samples(unstable),
            numbers: numbers.map(|(name, samples)| NumberOverPosterior::new(name, samples)).collect(),
        })
    }
}

/// Every number of an answer over the draws; serialised, those that the draws change.
#[derive(Debug, Clone, Serialize)]
pub struct OverPosterior {
    /// Draws of the posterior.
    pub draws: usize,
    /// Those whose loop oscillates by itself: no number holds them.
    pub unstable_samples: usize,
    /// At which they do.
    pub unstable_frequency_hz: Option<Banded>,
    /// In the order of their names.
    #[serde(serialize_with = "those_that_vary")]
    numbers: Vec<NumberOverPosterior>,
}

fn those_that_vary<S: Serializer>(numbers: &[NumberOverPosterior], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(numbers.iter().filter(|number| number.varies()))
}

/// A number over the draws.
#[derive(Debug, Clone, Serialize)]
pub struct NumberOverPosterior {
    /// Where it stands in the document, as `level.total_db[3]`; what has a title goes by it, as `outcomes[soft pads].months_to_limit`.
    pub name: String,
    /// Draws in which it is there.
    pub draws: usize,
    /// Half of them lie below.
    pub median: f64,
    /// From the quantile of 25 to that of 75 %.
    pub band_50: [f64; 2],
    /// From the quantile of 5 to that of 95 %.
    pub band_90: [f64; 2],
    /// In rising order.
    #[serde(skip)]
    samples: Vec<f64>,
}

impl NumberOverPosterior {
    fn new(name: String, mut samples: Vec<f64>) -> Self {
        samples.sort_by(f64::total_cmp);
        let at = |share: f64| quantile(&samples, share);
        Self {
            name,
            draws: samples.len(),
            median: at(0.5),
            band_50: [at(0.25), at(0.75)],
            band_90: [at(0.05), at(0.95)],
            samples,
        }
    }

    /// Whether the draws change it.
    pub fn varies(&self) -> bool {
        self.samples.first() != self.samples.last()
    }

    /// Share of the draws in which it is there in which it is below a bound.
    pub fn share_below(&self, bound: f64) -> f64 {
        self.samples.partition_point(|it| *it < bound) as f64 / self.draws as f64
    }

    /// Median and band of 90 % as in "7.2 (3.9 … 12.1)", times a factor of its unit.
    pub fn times(&self, factor: f64, digits: usize) -> Message {
        let [low, high] = self.band_90.map(|it| factor * it);
        say!(
            median_with_band,
            median = fixed(factor * self.median, digits),
            low = fixed(low, digits),
            high = fixed(high, digits)
        )
    }
}

impl OverPosterior {
    /// A number of what has a title or else a place in a list; `None` if no draw has it.
    pub fn number_of(&self, list: &str, title: &str, place: usize, name: &str) -> Option<&NumberOverPosterior> {
        self.number(&format!("{list}[{title}].{name}")).or_else(|| self.number(&format!("{list}[{place}].{name}")))
    }

    /// A number by its name; `None` if no draw has it.
    pub fn number(&self, name: &str) -> Option<&NumberOverPosterior> {
        let place = self.numbers.binary_search_by(|it| it.name.as_str().cmp(name));
        Some(&self.numbers[place.ok()?])
    }

    /// Its file: `posterior.csv`.
    pub fn table(&self) -> Table {
        let numbers = || self.numbers.iter().filter(|number| number.varies());
        let column = |name: &str, of: fn(&NumberOverPosterior) -> f64| Column::in_file(name, numbers().map(of));
        Table {
            name: "posterior",
            columns: vec![
                Column {
                    name: "number".to_owned(),
                    head: None,
                    values: Values::Words(numbers().map(|it| Message::verbatim(&it.name)).collect()),
                },
                column("draws", |it| it.draws as f64),
                column("q05", |it| it.band_90[0]),
                column("q25", |it| it.band_50[0]),
                column("q50", |it| it.median),
                column("q75", |it| it.band_50[1]),
                column("q95", |it| it.band_90[1]),
            ],
        }
    }
}

/// Frequency \[Hz\] at which the loop of a draw oscillates by itself at the mean speed of its first vehicle, or else in the middle of
/// the map, if it does.
fn oscillates(drawn: &Drawn) -> Option<f64> {
    let traffic = drawn.traffic.as_ref();
    let speed = traffic.and_then(|traffic| Some(traffic.speeds().first()?.mean()));
    let map = drawn.case.speed;
    let speed = speed.unwrap_or(map.min().midpoint(map.max()));
    ask::stability(&drawn.case, speed)?.frequency
}

fn is_of_answer(key: &str) -> bool {
    !OF_QUESTION.contains(&key) && !key.ends_with(BANDED)
}

/// All numbers of a document under their names; what has a title that no other has goes by it, for the order may differ from draw to
/// draw.
fn collect(name: &str, value: &Value, numbers: &mut BTreeMap<String, f64>) {
    match value {
        Value::Number(number) => {
            numbers.extend(number.as_f64().map(|number| (name.to_owned(), number)));
        }
        Value::Array(values) => {
            for (index, value) in values.iter().enumerate() {
                let title = value["title"].as_str().filter(|title| {
                    let same = |other: &&Value| other["title"].as_str() == Some(title);
                    values.iter().filter(same).count() == 1
                });
                match title {
                    Some(title) => collect(&format!("{name}[{title}]"), value, numbers),
                    None => collect(&format!("{name}[{index}]"), value, numbers),
                }
            }
        }
        Value::Object(values) => {
            for (key, value) in values.iter().filter(|(key, _)| is_of_answer(key)) {
                collect(&format!("{name}.{key}"), value, numbers);
            }
        }
        Value::Null | Value::Bool(_) | Value::String(_) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_case::{Case, NOMINAL_CASE};
    use riffel_keys::quantity::Quantity;
    use serde_json::json;

    use crate::ExpectedRates;

    /// Cases whose wear coefficient is 1 to 101 times 10⁻¹⁰ kg/J.
    fn ramp() -> PosteriorDraws {
        let case = Case::parse("nominal", NOMINAL_CASE, &[]).unwrap();
        let drawn = |step: u32| Drawn {
            case: case.edit(|keys| keys.wear.coefficient = Quantity::new(1e-10 * f64::from(step))).unwrap(),
            traffic: None,
        };
        PosteriorDraws { drawn: (1..=101).map(drawn).collect(), traffic: None, remarks: Vec::new() }
    }

    /// Quantiles of a ramp, what has a title under it wherever it stands, shares, and nothing of what all draws have alike.
    #[test]
    fn numbers_of_documents_are_those_of_the_draws() {
        let over = ramp().over(&|_| (), |drawn| {
            let step = 1e10 * drawn.case.file.wear.coefficient.si();
            let mut variants =
                vec![json!({"title": "soft", "change": -step}), json!({"title": "hard", "change": step})];
            if step > 51.5 {
                variants.reverse();
            }
            let grows = (step > 10.5).then_some(step);
            Ok(json!({
                "inputs": { "own": step }, "variants": variants, "grows": grows, "list": [7.0, step],
                "time_banded": { "median": step },
            }))
        });
        let over = over.unwrap();
        let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        let soft = over.number_of("variants", "soft", 0, "change").unwrap();
        near(soft.median, -51.0);
        near(soft.band_50[0], -76.0);
        near(soft.band_90[1], -6.0);
        near(soft.share_below(-50.5), 51.0 / 101.0);
        assert_eq!(over.number("grows").unwrap().draws, 91);
        assert!(!over.number("list[0]").unwrap().varies());
        let shown = serde_json::to_value(&over).unwrap();
        let names = shown["numbers"].as_array().unwrap().iter();
        let names: Vec<&str> = names.map(|it| it["name"].as_str().unwrap()).collect();
        assert_eq!(names, ["grows", "list[1]", "variants[hard].change", "variants[soft].change"]);
        assert_eq!(over.table().rows(), 4);
    }

    /// Growth goes with the wear coefficient: its median is that of the middle draw, its bands those of the ramp.
    #[test]
    fn growth_of_a_line_over_draws_is_banded_by_them() {
        let draws = ramp();
        let bands = [[0.04, 0.05], [0.05, 0.06]];
        let over = ExpectedRates::over(&draws, &bands, &|_| ()).unwrap();
        let middle = ExpectedRates::new(&draws.drawn[50].case, None, &bands).unwrap();
        assert_eq!(over.without_rate, None);
        for (over, middle) in over.of_bands.iter().zip(middle.of_bands) {
            let (over, middle) = (over.unwrap(), middle.unwrap().median);
            assert!((over.median / middle - 1.0).abs() < 1e-9);
            let [low, high] = over.band_80.map(|end| end / middle);
            assert!((low.min(high) - 11.0 / 51.0).abs() < 1e-9);
            assert!((low.max(high) - 91.0 / 51.0).abs() < 1e-9);
        }
    }
}
