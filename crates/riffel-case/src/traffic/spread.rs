//! A value that is spread over the wheels of a vehicle, as written.

use riffel_keys::{CaseError, KeyFile, say};
use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use riffel::forecast::WheelValues;
use riffel_keys::quantity::{Dimension, Kind, Quantity, Ratio};
use riffel_numerics::distribution::Distribution;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::{Deserialize, Deserializer, Serialize, de};
use toml::Value;

use super::shares::sums_to_one;

/// A value that is spread over the wheels of a vehicle: normal, even between two ends, or some values with their shares.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged, bound = "D: Dimension")]
pub enum Spread<D: Dimension> {
    /// A table of `mean` and `standard_deviation`, or of `min` and `max`.
    Ends(SpreadEnds<D>),
    /// Values with their shares.
    Shares(Vec<ValueShare<D>>),
}

/// A normal distribution, or an even one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, bound = "D: Dimension")]
pub struct SpreadEnds<D: Dimension> {
    /// Mean.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mean: Option<Quantity<D>>,
    /// Standard deviation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub standard_deviation: Option<Quantity<D>>,
    /// Lowest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<Quantity<D>>,
    /// Highest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max: Option<Quantity<D>>,
}

/// One value of several.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, bound = "D: Dimension")]
pub struct ValueShare<D: Dimension> {
    /// The value.
    pub value: Quantity<D>,
    /// Its share of the passages of the vehicle.
    pub share: Quantity<Ratio>,
}

impl<'de, D: Dimension> Deserialize<'de> for Spread<D> {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        struct Visitor<D>(PhantomData<fn() -> D>);

        impl<'de, D: Dimension> de::Visitor<'de> for Visitor<D> {
            type Value = Spread<D>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "a table of mean and standard_deviation, one of min and max, or a list of values with shares",
                )
            }

            fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                SpreadEnds::deserialize(MapAccessDeserializer::new(map)).map(Spread::Ends)
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, seq: A) -> Result<Self::Value, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(seq)).map(Spread::Shares)
            }
        }

        deserializer.deserialize_any(Visitor(PhantomData))
    }
}

impl<D: Dimension> JsonSchema for Spread<D> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed("spread")
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let value = Quantity::<D>::json_schema(generator);
        let share = Quantity::<Ratio>::json_schema(generator);
        json_schema!({ "oneOf": [
            {
                "type": "object",
                "properties": { "mean": value, "standard_deviation": value },
                "required": ["mean", "standard_deviation"],
                "additionalProperties": false
            },
            {
                "type": "object",
                "properties": { "min": value, "max": value },
                "required": ["min", "max"],
                "additionalProperties": false
            },
            {
                "type": "array",
                "items": {
                    "type": "object",
                    "properties": { "value": value, "share": share },
                    "required": ["value", "share"],
                    "additionalProperties": false
                }
            }
        ] })
    }
}

/// What the values of a distribution may be.
#[derive(Clone, Copy)]
pub(super) enum Values {
    /// Any.
    Any,
    /// Above zero, four standard deviations below the mean as well.
    Positive,
}

impl<D: Dimension> Spread<D> {
    /// The values of a key of the traffic file.
    ///
    /// # Errors
    /// [`CaseError`] with key, value and rule.
    pub(super) fn values(&self, source: &KeyFile, key: &str, allowed: Values) -> Result<WheelValues, CaseError> {
        let refused = |error: riffel::Error| source.invalid(key, &error, "");
        let values = match self {
            Self::Shares(list) => {
                if list.is_empty() {
                    let help = "give one { value, share } or more";
                    return Err(source.invalid(key, say!(is_an_empty_list), help));
                }
                sums_to_one(source, key, list.iter().map(|entry| entry.share.si()))?;
                let list: Vec<(f64, f64)> = list.iter().map(|entry| (entry.value.si(), entry.share.si())).collect();
                WheelValues::shares(&list)
            }
            Self::Ends(SpreadEnds { mean: Some(mean), standard_deviation: Some(deviation), min: None, max: None }) => {
                WheelValues::normal(mean.si(), deviation.si())
            }
            Self::Ends(SpreadEnds { mean: None, standard_deviation: None, min: Some(min), max: Some(max) }) => {
                WheelValues::even(min.si(), max.si())
            }
            Self::Ends(_) => {
                let rule = "is neither { mean, standard_deviation } nor { min, max }";
                return Err(source.invalid(key, rule, say!(give_both_keys_of_one_of)));
            }
        };
        let values = values.map_err(refused)?;
        let [lowest, _] = values.reach();
        match allowed {
            Values::Positive if lowest <= 0.0 => {
                let rule = say!(goes_down_to_but_every_value, value = Quantity::<D>::new(lowest));
                let help = match values {
                    WheelValues::Spread(Distribution::Normal { .. }) => {
                        "the standard deviation must be less than a quarter of the mean"
                    }
                    _ => "",
                };
                Err(source.invalid(key, &rule, help))
            }
            _ => Ok(values),
        }
    }
}

/// The values of a key of the case, at its place in the traffic file: numbers are read as its quantity.
///
/// # Errors
/// [`CaseError`] with key, value and rule.
pub(super) fn of_key(source: &KeyFile, at: &str, kind: Kind, value: &Value) -> Result<WheelValues, CaseError> {
    let in_si = in_si(source, at, kind, value)?;
    let spread: Spread<Ratio> = in_si.try_into().map_err(|_| {
        let rule = say!(is_no_spread_give_mean_and, name = kind.name, example = kind.example);
        source.invalid(at, &rule, "")
    })?;
    spread.values(source, at, Values::Any)
}

/// A value with every number of it but shares in SI.
fn in_si(source: &KeyFile, at: &str, kind: Kind, value: &Value) -> Result<Value, CaseError> {
    match value {
        Value::String(text) => {
            let read = kind.read(text);
            let number = read.map_err(|error| source.invalid(at, error.to_string(), ""))?;
            Ok(Value::Float(number))
        }
        Value::Table(table) => {
            let entries = table.iter().map(|(name, value)| {
                let value = match &**name {
                    "share" => value.clone(),
                    _ => in_si(source, &format!("{at}.{name}"), kind, value)?,
                };
                Ok((name.clone(), value))
            });
            Ok(Value::Table(entries.collect::<Result<_, CaseError>>()?))
        }
        Value::Array(list) => {
            let entries = list.iter().enumerate();
            let entries = entries.map(|(index, entry)| in_si(source, &format!("{at}[{index}]"), kind, entry));
            Ok(Value::Array(entries.collect::<Result<_, CaseError>>()?))
        }
        value => Ok(value.clone()),
    }
}

/// The names that a key of the case takes, with their shares, at its place in the traffic file.
///
/// # Errors
/// [`CaseError`] with key, value and rule.
pub(super) fn names_of_key(source: &KeyFile, at: &str, value: &Value) -> Result<Vec<(String, f64)>, CaseError> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct NameShare {
        value: String,
        share: Quantity<Ratio>,
    }
    let list: Result<Vec<NameShare>, _> = value.clone().try_into();
    let list = list.ok().filter(|list| !list.is_empty()).ok_or_else(|| {
        let rule = "takes a name, so that its spread must be a list of value and share";
        source.invalid(at, rule, "")
    })?;
    sums_to_one(source, at, list.iter().map(|entry| entry.share.si()))?;
    Ok(list.into_iter().map(|entry| (entry.value, entry.share.si())).collect())
}
