//! Friction on the two rails: one coefficient, or one for each.

use std::borrow::Cow;
use std::fmt;

use riffel_keys::quantity::{Quantity, Ratio};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::{Deserialize, Deserializer, Serialize, de};

/// Coefficient of friction of both rails: one number, or one for each.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum RailFriction {
    /// One coefficient on both rails.
    Both(Quantity<Ratio>),
    /// One for each.
    Each(FrictionOfRails),
}

/// A coefficient of friction for each rail.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrictionOfRails {
    /// On the left rail.
    pub left: Quantity<Ratio>,
    /// On the right rail.
    pub right: Quantity<Ratio>,
}

impl RailFriction {
    /// Left, right.
    pub fn of_rails(self) -> [f64; 2] {
        match self {
            Self::Both(friction) => [friction.si(); 2],
            Self::Each(friction) => [friction.left.si(), friction.right.si()],
        }
    }
}

impl<'de> Deserialize<'de> for RailFriction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;

        impl<'de> de::Visitor<'de> for Visitor {
            type Value = RailFriction;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a ratio such as 0.4, or a table of left and right")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                Quantity::deserialize(de::value::F64Deserializer::new(value)).map(RailFriction::Both)
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                text.parse().map(RailFriction::Both).map_err(E::custom)
            }

            fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                FrictionOfRails::deserialize(MapAccessDeserializer::new(map)).map(RailFriction::Each)
            }
        }

        deserializer.deserialize_any(Visitor)
    }
}

impl JsonSchema for RailFriction {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "RailFriction".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "unit": "",
            "anyOf": [
                generator.subschema_for::<Quantity<Ratio>>(),
                generator.subschema_for::<FrictionOfRails>(),
            ],
        })
    }
}
