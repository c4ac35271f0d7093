//! Creepage: a number, or a table of its components.

use std::borrow::Cow;
use std::fmt;

use riffel::contact::Creepages;
use riffel_keys::quantity::{Quantity, Ratio, Spin};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::{Deserialize, Deserializer, Serialize, de};
use toml::{Table, Value};

use crate::file::setting::Setting;

/// Steady creepage ξ₀ of wheel and rail: along the rail, or in any direction and with spin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Creepage {
    /// Along the rail.
    Longitudinal(Quantity<Ratio>),
    /// In any direction, with spin.
    Vector(VectorCreepage),
}

/// Creepage in any direction, with spin; each left out is none.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct VectorCreepage {
    /// Longitudinal creepage ξ_x, positive in braking.
    pub longitudinal: Quantity<Ratio>,
    /// Lateral creepage ξ_y, positive where the wheel slides to the right.
    pub lateral: Quantity<Ratio>,
    /// Spin φ of the wheel against the rail about the normal into the rail, that of the contact angle included.
    pub spin: Quantity<Spin>,
}

impl Default for VectorCreepage {
    fn default() -> Self {
        Self { longitudinal: Quantity::new(0.0), lateral: Quantity::new(0.0), spin: Quantity::new(0.0) }
    }
}

impl Creepage {
    /// True for a table, whatever stands in it.
    pub fn is_vector(&self) -> bool {
        matches!(self, Self::Vector(_))
    }

    /// What gives it to a case.
    pub(crate) fn setting(&self) -> Setting {
        let value = match self {
            Self::Longitudinal(creepage) => Value::Float(creepage.si()),
            Self::Vector(vector) => Value::Table(Table::from_iter(
                [
                    ("longitudinal", vector.longitudinal.si()),
                    ("lateral", vector.lateral.si()),
                    ("spin", vector.spin.si()),
                ]
                .map(|(name, size)| (name.to_owned(), Value::Float(size))),
            )),
        };
        ("contact.creepage".to_owned(), value)
    }

    /// Its components.
    pub fn components(&self) -> Creepages {
        match self {
            Self::Longitudinal(creepage) => Creepages::longitudinal(creepage.si()),
            Self::Vector(vector) => Creepages {
                longitudinal: vector.longitudinal.si(),
                lateral: vector.lateral.si(),
                spin: vector.spin.si(),
            },
        }
    }
}

impl<'de> Deserialize<'de> for Creepage {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;

        impl<'de> de::Visitor<'de> for Visitor {
            type Value = Creepage;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a ratio such as 0.004 or \"0.4 %\", or a table of longitudinal, lateral and spin")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                Quantity::deserialize(de::value::F64Deserializer::new(value)).map(Creepage::Longitudinal)
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                text.parse().map(Creepage::Longitudinal).map_err(E::custom)
            }

            fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                VectorCreepage::deserialize(MapAccessDeserializer::new(map)).map(Creepage::Vector)
            }
        }

        deserializer.deserialize_any(Visitor)
    }
}

impl JsonSchema for Creepage {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Creepage".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        // The unit beside the choice is that of the number, which most cases give.
        json_schema!({
            "unit": "",
            "anyOf": [
                generator.subschema_for::<Quantity<Ratio>>(),
                generator.subschema_for::<VectorCreepage>(),
            ],
        })
    }
}
