//! The values of a parameter, as written.

use std::collections::HashSet;

use riffel_case::CaseKey;
use riffel_keys::quantity::Kind;
use riffel_keys::{CaseError, KeyFile, Message, say};
use riffel_numerics::distribution::Distribution;
use toml::Value;

use super::file::{LognormalFile, NormalFile, ParameterFile, RangeFile, Spacing};
use crate::parameter::{ParameterValue, Spread};

/// Most values of a list or range.
const MOST_VALUES: u64 = 1_000_000;

/// Where in a plan a value stands, and what its key takes.
struct Place<'a> {
    source: &'a KeyFile,
    /// `parameter[2]`.
    at: String,
    kind: Kind,
}

/// The values of the parameter of a number.
pub(super) fn of(
    source: &KeyFile,
    index: usize,
    written: &ParameterFile,
    key: &'static CaseKey,
) -> Result<Spread, CaseError> {
    let at = format!("parameter[{index}]");
    let given = [
        ("values", written.values.is_some()),
        ("range", written.range.is_some()),
        ("uniform", written.uniform.is_some()),
        ("normal", written.normal.is_some()),
        ("lognormal", written.lognormal.is_some()),
        ("triangular", written.triangular.is_some()),
    ];
    let given: Vec<&str> = given.iter().filter(|(_, is)| *is).map(|(name, _)| *name).collect();
    let &[way] = &given[..] else {
        let help = "give just one of values, range, uniform, normal, lognormal and triangular";
        return Err(match given[..] {
            [] => source.missing(&format!("{at}.values"), help),
            [one, other, ..] => {
                let rule = say!(and_exclude_each_other, other = format!("{at}.{one}"));
                source.invalid(&format!("{at}.{other}"), rule, help)
            }
            [_] => unreachable!("one way is handled above"),
        });
    };
    let Some(kind) = key.quantity else {
        let Some(values) = &written.values else {
            return Err(source.invalid(
                &format!("{at}.{way}"),
                say!(is_for_quantities, key = &key.key),
                "give its values one by one: values = [...]",
            ));
        };
        let texts = values.iter().map(|value| match value {
            Value::String(text) => text.clone(),
            other => other.to_string(),
        });
        return list(source, &at, texts.map(ParameterValue::Text).collect());
    };
    let place = Place { source, at, kind };
    if let Some(values) = &written.values {
        let numbers = values
            .iter()
            .enumerate()
            .map(|(index, value)| place.number(&format!("values[{index}]"), value))
            .collect::<Result<Vec<f64>, CaseError>>()?;
        return list(source, &place.at, numbers.into_iter().map(ParameterValue::Number).collect());
    }
    if let Some(range) = &written.range {
        return place.range(range);
    }
    let written = distribution(source, &place.at, kind, written)?;
    match written {
        Some(distribution) => Ok(Spread::Distribution(distribution)),
        None => unreachable!("one way is given"),
    }
}

/// The distribution of a parameter of this kind, which stands at a place such as `parameter[2]`; `None` if it gives values or a
/// range, or nothing.
///
/// # Errors
/// [`CaseError`] with the key, the value and the rule.
pub fn distribution(
    source: &KeyFile,
    at: &str,
    kind: Kind,
    written: &ParameterFile,
) -> Result<Option<Distribution>, CaseError> {
    let place = Place { source, at: at.to_owned(), kind };
    Ok(Some(if let Some(uniform) = &written.uniform {
        let (min, max) = place.ends("uniform", &uniform.min, &uniform.max)?;
        Distribution::Uniform { min, max }
    } else if let Some(normal) = &written.normal {
        place.normal(normal)?
    } else if let Some(lognormal) = &written.lognormal {
        place.lognormal(lognormal)?
    } else if let Some(triangular) = &written.triangular {
        let (min, max) = place.ends("triangular", &triangular.min, &triangular.max)?;
        let mode = place.number("triangular.mode", &triangular.mode)?;
        if !(min..=max).contains(&mode) {
            let rule = say!(is_outside, value = mode, low = min, high = max);
            return Err(place.wrong("triangular.mode", rule));
        }
        Distribution::Triangular { min, mode, max }
    } else {
        return Ok(None);
    }))
}

/// A list that is not empty and names nothing twice.
fn list(source: &KeyFile, at: &str, values: Vec<ParameterValue>) -> Result<Spread, CaseError> {
    let key = format!("{at}.values");
    if values.is_empty() {
        return Err(source.invalid(&key, "is empty, but must hold a value", ""));
    }
    let mut known = HashSet::new();
    for value in &values {
        // Numbers are written with all their digits.
        if !known.insert(value.to_string()) {
            let rule = format!("holds {value} twice");
            return Err(source.invalid(&key, &rule, ""));
        }
    }
    Ok(Spread::Values(values))
}

impl Place<'_> {
    fn wrong(&self, key: &str, rule: Message) -> CaseError {
        self.source.invalid(&format!("{}.{key}", self.at), rule, "")
    }

    /// An end that is not above the other one.
    fn not_above(&self, key: &str, (min, max): (f64, f64)) -> CaseError {
        self.wrong(key, say!(is_but_must_be, value = max, rule = say!(above_the_min, min)))
    }

    fn number(&self, key: &str, value: &Value) -> Result<f64, CaseError> {
        let read = match value {
            Value::Integer(number) => self.kind.read(&number.to_string()),
            Value::Float(number) => self.kind.read(&number.to_string()),
            Value::String(text) => self.kind.read(text),
            _ => {
                let must_be = say!(kind_as_in_example, kind = self.kind.name.to_owned(), example = self.kind.example);
                let rule = say!(is_no_number, rule = must_be);
                return Err(self.wrong(key, rule));
            }
        };
        read.map_err(|error| self.wrong(key, error.message()))
    }

    fn optional(&self, key: &str, value: Option<&Value>, left_out: f64) -> Result<f64, CaseError> {
        value.map_or(Ok(left_out), |value| self.number(key, value))
    }

    fn ends(&self, table: &str, min: &Value, max: &Value) -> Result<(f64, f64), CaseError> {
        let low = self.number(&format!("{table}.min"), min)?;
        let high = self.number(&format!("{table}.max"), max)?;
        if low >= high {
            return Err(self.not_above(&format!("{table}.max"), (low, high)));
        }
        Ok((low, high))
    }

    fn positive(&self, key: &str, value: f64) -> Result<f64, CaseError> {
        if value > 0.0 {
            return Ok(value);
        }
        let rule = say!(greater_than_zero);
        Err(self.wrong(key, say!(is_but_must_be, value, rule)))
    }

    fn range(&self, range: &RangeFile) -> Result<Spread, CaseError> {
        let (min, max) = self.ends("range", &range.min, &range.max)?;
        if !(2..=MOST_VALUES).contains(&range.points) {
            let [value, high] = [range.points, MOST_VALUES].map(|it| it as f64);
            let rule = say!(is_outside, value, low = 2.0, high);
            return Err(self.wrong("range.points", rule));
        }
        if range.spacing == Spacing::Log {
            self.positive("range.min", min)?;
        }
        let last = range.points - 1;
        let value = |index: u64| {
            let share = index as f64 / last as f64;
            match (index, range.spacing) {
                (0, _) => min,
                (index, _) if index == last => max,
                (_, Spacing::Linear) => min + (max - min) * share,
                (_, Spacing::Log) => min * (max / min).powf(share),
            }
        };
        let values = (0..range.points).map(|index| ParameterValue::Number(value(index)));
        Ok(Spread::Values(values.collect()))
    }

    fn normal(&self, normal: &NormalFile) -> Result<Distribution, CaseError> {
        let mean = self.number("normal.mean", &normal.mean)?;
        let deviation = self.number("normal.standard_deviation", &normal.standard_deviation)?;
        let standard_deviation = self.positive("normal.standard_deviation", deviation)?;
        let min = self.optional("normal.min", normal.min.as_ref(), f64::NEG_INFINITY)?;
        let max = self.optional("normal.max", normal.max.as_ref(), f64::INFINITY)?;
        let far = |end: f64| (end - mean) / standard_deviation;
        self.cut("normal", min, max, [far(min), far(max)])?;
        Ok(Distribution::Normal { mean, standard_deviation, min, max })
    }

    fn lognormal(&self, lognormal: &LognormalFile) -> Result<Distribution, CaseError> {
        let key = |name: &str| format!("lognormal.{name}");
        let min = self.optional(&key("min"), lognormal.min.as_ref(), 0.0)?;
        let max = self.optional(&key("max"), lognormal.max.as_ref(), f64::INFINITY)?;
        if min < 0.0 {
            let rule = say!(is_but_must_be, value = min, rule = say!(zero_or_more));
            return Err(self.wrong(&key("min"), rule));
        }
        let distribution = match lognormal {
            LognormalFile {
                mean: Some(mean), standard_deviation: Some(deviation), median: None, factor: None, ..
            } => {
                let mean = self.positive(&key("mean"), self.number(&key("mean"), mean)?)?;
                let name = key("standard_deviation");
                let deviation = self.positive(&name, self.number(&name, deviation)?)?;
                Distribution::lognormal_of_moments(mean, deviation, (min, max))
            }
            LognormalFile {
                mean: None, standard_deviation: None, median: Some(median), factor: Some(factor), ..
            } => {
                let median = self.positive(&key("median"), self.number(&key("median"), median)?)?;
                let factor = factor.si();
                if factor <= 1.0 {
                    let rule = say!(is_but_must_be, value = factor, rule = say!(more_than_one));
                    return Err(self.wrong(&key("factor"), rule));
                }
                Distribution::Lognormal { log_mean: median.ln(), log_deviation: factor.ln(), min, max }
            }
            _ => {
                return Err(self.wrong("lognormal", say!(needs_moments_or_median)));
            }
        };
        if let Distribution::Lognormal { log_mean, log_deviation, .. } = distribution {
            let far = |end: f64| (end.ln() - log_mean) / log_deviation;
            self.cut("lognormal", min, max, [far(min), far(max)])?;
        }
        Ok(distribution)
    }

    /// `Ok` if something is left between the ends; `scores` are the ends in standard deviations.
    fn cut(&self, table: &str, min: f64, max: f64, scores: [f64; 2]) -> Result<(), CaseError> {
        /// Beyond this the probabilities have no digits left.
        const FARTHEST: f64 = 30.0;
        if min >= max {
            return Err(self.not_above(&format!("{table}.max"), (min, max)));
        }
        if scores[0] > FARTHEST || scores[1] < -FARTHEST {
            return Err(self.wrong(table, say!(leaves_nothing_between_its_ends)));
        }
        Ok(())
    }
}
