//! Inclination of the rails, such as 1:40.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// Inclination of the rails towards each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inclination {
    /// Tangent of the angle; 0 for rails that stand upright or whose coordinates are inclined.
    pub slope: f64,
}

impl Default for Inclination {
    fn default() -> Self {
        Self { slope: 1.0 / 40.0 }
    }
}

impl Serialize for Inclination {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.slope {
            0.0 => serializer.serialize_str("none"),
            slope => serializer.collect_str(&format_args!("1:{}", 1.0 / slope)),
        }
    }
}

impl<'de> Deserialize<'de> for Inclination {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = Cow::<str>::deserialize(deserializer)?;
        Self::read(&text).map_err(|rule| de::Error::custom(format!("is \"{text}\", but must be {rule}")))
    }
}

impl Inclination {
    /// The inclination of a text such as "1:40", or "none".
    ///
    /// # Errors
    /// What it must be.
    pub fn read(text: &str) -> Result<Self, String> {
        if text == "none" {
            return Ok(Self { slope: 0.0 });
        }
        let run = text.strip_prefix("1:").and_then(|run| run.trim().parse::<f64>().ok());
        match run.filter(|run| run.abs() >= 5.0) {
            Some(run) => Ok(Self { slope: 1.0 / run }),
            None => Err("\"none\" or as in \"1:40\", 1:5 at the steepest".to_owned()),
        }
    }
}

impl JsonSchema for Inclination {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Inclination".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "pattern": "^(none|1:-?[0-9.]+)$", "examples": ["1:40"] })
    }
}
