//! A site: its folder with the case, the traffic, what is published and what had to be chosen.

use riffel_answers::AnswerError;
use riffel_case::Case;
use riffel_keys::{CaseError, KeyFile};
use riffel_numerics::normal_distribution::quantile;
use serde::{Deserialize, Serialize};
use toml::{Table, Value};

use super::draw::draw;

/// A site as its `site.toml` tells it.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SiteFile {
    pub(super) title: String,
    /// What is not known, and what follows from that.
    #[serde(default)]
    pub(super) reason: Option<String>,
    /// Nothing must grow there.
    #[serde(default)]
    pub(super) null_case: bool,
    #[serde(default, rename = "choice")]
    pub(super) choices: Vec<Choice>,
    #[serde(default, rename = "outcome")]
    pub(super) outcomes: Vec<Outcome>,
}

/// A value that no source gives, as a distribution.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Choice {
    /// A key of the case, or of the traffic file as `line.passages_per_day` or `vehicle.speed.mean`.
    key: String,
    /// Even from here …
    min: Option<f64>,
    /// … to here,
    max: Option<f64>,
    /// in the logarithm.
    #[serde(default)]
    logarithmic: bool,
    /// Normal about here …
    mean: Option<f64>,
    /// … with this deviation.
    standard_deviation: Option<f64>,
    /// One of these, each as likely.
    values: Option<Vec<Value>>,
    /// `chosen`, `recalled`, `derived` …
    #[serde(rename = "mark")]
    _mark: String,
    /// Why these.
    #[serde(rename = "why")]
    _why: String,
}

/// What is published of a site.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Outcome {
    pub(super) what: String,
    pub(super) quantity: Quantity,
    /// A number, or two ends; an end that is left open is an empty text.
    pub(super) measured: Value,
    pub(super) unit: String,
    /// Keys that are different; the outcome is then the growth with them over that without.
    #[serde(default)]
    pub(super) set: Table,
    pub(super) mark: String,
    pub(super) source: String,
}

/// What of a prediction an outcome is held against.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Quantity {
    /// Of the fastest growth \[mm\].
    Wavelength,
    /// The shorter of the two strongest peaks \[mm\].
    ShorterWavelength,
    /// The longer of the two strongest peaks \[mm\].
    LongerWavelength,
    /// Of the fastest growth \[Hz\].
    Frequency,
    /// \[dB per million axles\].
    Growth,
    /// \[dB a month\].
    GrowthPerMonth,
    /// Growth with other keys over that without \[-\].
    Ratio,
}

/// A site, read.
pub(super) struct Site {
    pub(super) name: String,
    pub(super) file: SiteFile,
    pub(super) case: Case,
    pub(super) traffic: Table,
}

impl Site {
    /// A site of the texts of its three files.
    pub(super) fn read(name: &str, case: &str, traffic: &str, site: &str) -> Result<Self, AnswerError> {
        let named = |file: &str| format!("validation/field/{name}/{file}");
        let file: SiteFile = KeyFile::parse(&named("site.toml"), site)?.deserialize()?;
        Ok(Self {
            name: name.to_owned(),
            file,
            case: Case::parse(&named("case.toml"), case, &[])?.sharing_parts(),
            traffic: KeyFile::parse(&named("traffic.toml"), traffic)?.table().clone(),
        })
    }

    /// The traffic of a sample, with further keys of the case under every vehicle.
    pub(super) fn traffic(&self, seed: u64, sample: usize, set: &[(String, Value)]) -> Result<Table, CaseError> {
        let choices = &self.file.choices;
        let mut traffic = self.traffic.clone();
        for (place, choice) in choices.iter().enumerate() {
            let value = choice.value(draw(seed, sample, place, choices.len()))?;
            put(&mut traffic, &choice.key, &value);
        }
        for (key, value) in set {
            put(&mut traffic, key, value);
        }
        Ok(traffic)
    }
}

impl Choice {
    /// The value of a draw.
    fn value(&self, draw: f64) -> Result<Value, CaseError> {
        let number = match self {
            Self { values: Some(values), .. } if !values.is_empty() => {
                let place = (draw * values.len() as f64) as usize;
                return Ok(values[place.min(values.len() - 1)].clone());
            }
            Self { min: Some(min), max: Some(max), logarithmic: true, .. } => min * (max / min).powf(draw),
            Self { min: Some(min), max: Some(max), .. } => min + draw * (max - min),
            Self { mean: Some(mean), standard_deviation: Some(deviation), .. } => mean + deviation * quantile(draw),
            _ => {
                let message = format!(
                    "the choice `{}` is no distribution: give min and max, mean and standard_deviation, or values",
                    self.key
                );
                return Err(CaseError::data("site.toml", message));
            }
        };
        Ok(Value::Float(number))
    }
}

/// Put a value into a traffic file: keys of `line` and `vehicle` there, all others below `set` of every vehicle.
fn put(traffic: &mut Table, key: &str, value: &Value) {
    match key.split_once('.') {
        Some(("line", rest)) => insert(traffic, &["line", rest], value),
        Some(("vehicle", rest)) => each(traffic, &rest.split('.').collect::<Vec<_>>(), value),
        _ => {
            let path: Vec<&str> = std::iter::once("set").chain(key.split('.')).collect();
            each(traffic, &path, value);
        }
    }
}

fn each(traffic: &mut Table, path: &[&str], value: &Value) {
    let vehicles = traffic.get_mut("vehicle").and_then(Value::as_array_mut);
    for vehicle in vehicles.into_iter().flatten().filter_map(Value::as_table_mut) {
        insert(vehicle, path, value);
    }
}

fn insert(table: &mut Table, path: &[&str], value: &Value) {
    match path {
        [] => {}
        [last] => {
            table.insert((*last).to_owned(), value.clone());
        }
        [first, rest @ ..] => {
            let inner = table.entry((*first).to_owned());
            let inner = inner.or_insert_with(|| Value::Table(Table::new()));
            if let Some(inner) = inner.as_table_mut() {
                insert(inner, rest, value);
            }
        }
    }
}
