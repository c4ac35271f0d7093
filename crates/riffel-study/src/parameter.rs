//! A key of the case that varies.

use std::fmt;

use riffel_case::{CaseKey, Setting};
use riffel_numerics::distribution::Distribution;
use serde::Serialize;
use toml::Value;

/// A key of the case, and the values it takes.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The key of the case.
    pub key: &'static CaseKey,
    /// Its values.
    pub spread: Spread,
}

/// The values that a parameter takes.
#[derive(Debug, Clone, PartialEq)]
pub enum Spread {
    /// One of several, each as likely.
    Values(Vec<ParameterValue>),
    /// Any number of a distribution.
    Distribution(Distribution),
}

/// A value of a parameter in one sample.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ParameterValue {
    /// A number, in SI.
    Number(f64),
    /// A whole number, a choice or a name, as TOML.
    Text(String),
}

impl ParameterValue {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Text(_) => None,
        }
    }
}

impl fmt::Display for ParameterValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}

impl Parameter {
    /// The value of a share `u` between 0 and 1: a quantile, or the place in the list.
    pub fn value(&self, u: f64) -> ParameterValue {
        match &self.spread {
            Spread::Values(values) => {
                let place = (u * values.len() as f64) as usize;
                values[place.min(values.len() - 1)].clone()
            }
            Spread::Distribution(distribution) => ParameterValue::Number(distribution.quantile(u)),
        }
    }

    /// Number of values in the list, if it is one.
    pub fn levels(&self) -> Option<usize> {
        match &self.spread {
            Spread::Values(values) => Some(values.len()),
            Spread::Distribution(_) => None,
        }
    }

    /// Whether its values are numbers.
    pub fn is_number(&self) -> bool {
        self.key.quantity.is_some()
    }

    /// What gives it a value in a case.
    pub(crate) fn setting(&self, value: &ParameterValue) -> Setting {
        let value = match value {
            ParameterValue::Number(number) => Value::Float(*number),
            ParameterValue::Text(text) => {
                // 60E1 is a rail: what takes a number with a fraction is a quantity.
                let read = text.parse().ok().filter(|value: &Value| !value.is_float());
                read.unwrap_or_else(|| Value::String(text.clone()))
            }
        };
        (self.key.key.clone(), value)
    }
}
