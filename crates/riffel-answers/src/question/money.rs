//! Sums of money.

use std::borrow::Cow;
use std::str::FromStr;

use riffel_keys::money;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, de};
use serde_json::Value;

use super::as_written::written;

/// A sum without a currency, which no separator of thousands makes another.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Money(pub(crate) f64);

impl FromStr for Money {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match money::read(text) {
            Ok((sum, "")) => Ok(Self(sum)),
            Err(rule) => Err(format!("the sum {rule}")),
            Ok(_) => Err(format!("\"{text}\" is not a number; write it without its currency")),
        }
    }
}

impl<'de> Deserialize<'de> for Money {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        written(Value::deserialize(deserializer)?).parse().map_err(de::Error::custom)
    }
}

impl JsonSchema for Money {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Money".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["string", "number"] })
    }
}
