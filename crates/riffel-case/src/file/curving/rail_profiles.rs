//! Profiles of the two rails: one, or one for each.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::{Deserialize, Deserializer, Serialize, de};

/// Profiles of both rails: one for both, or one for each.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum RailProfiles {
    /// One profile, turned over on the left.
    Both(String),
    /// One for each.
    Each(RailProfilesByRail),
}

/// A profile for each rail, both drawn as right rails: x above zero on the field side.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RailProfilesByRail {
    /// The left one.
    pub left: String,
    /// The right one.
    pub right: String,
}

impl<'de> Deserialize<'de> for RailProfiles {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;

        impl<'de> de::Visitor<'de> for Visitor {
            type Value = RailProfiles;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a profile, a file, or a table of left and right")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                Ok(RailProfiles::Both(text.to_owned()))
            }

            fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                RailProfilesByRail::deserialize(MapAccessDeserializer::new(map)).map(RailProfiles::Each)
            }
        }

        deserializer.deserialize_any(Visitor)
    }
}

impl JsonSchema for RailProfiles {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "RailProfiles".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "anyOf": [
                { "type": "string" },
                generator.subschema_for::<RailProfilesByRail>(),
            ],
        })
    }
}
