//! The keys of the growth map.

use riffel_keys::quantity::{Length, Quantity, Speed};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// Window of a growth map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Map {
    /// Wavelengths λ, as a table or as in "20-80 mm".
    #[schemars(schema_with = "wavelength_range")]
    pub wavelength: WavelengthRange,
    /// Speeds V, as a table or as in "60-90 km/h".
    #[schemars(schema_with = "speed_range")]
    pub speed: SpeedRange,
}

fn wavelength_range(generator: &mut SchemaGenerator) -> Schema {
    table_or_range(generator.subschema_for::<WavelengthRange>(), "20-80 mm")
}

fn speed_range(generator: &mut SchemaGenerator) -> Schema {
    table_or_range(generator.subschema_for::<SpeedRange>(), "60-90 km/h")
}

fn table_or_range(table: Schema, example: &str) -> Schema {
    json_schema!({ "anyOf": [table, { "type": "string", "examples": [example] }] })
}

impl Default for Map {
    fn default() -> Self {
        Self {
            wavelength: WavelengthRange {
                min: Quantity::new(0.020),
                max: Quantity::new(0.080),
                points: WavelengthRange::default_points(),
            },
            speed: SpeedRange {
                min: Quantity::new(5.0),
                max: Quantity::new(60.0),
                points: SpeedRange::default_points(),
            },
        }
    }
}

/// Equally spaced wavelengths, both ends included.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WavelengthRange {
    /// Shortest.
    pub min: Quantity<Length>,
    /// Longest.
    pub max: Quantity<Length>,
    /// How many.
    #[serde(default = "WavelengthRange::default_points")]
    #[schemars(range(min = 2, max = 100_000))]
    pub points: u64,
}

impl WavelengthRange {
    fn default_points() -> u64 {
        241
    }
}

/// Equally spaced speeds, both ends included.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpeedRange {
    /// Lowest.
    pub min: Quantity<Speed>,
    /// Highest.
    pub max: Quantity<Speed>,
    /// How many.
    #[serde(default = "SpeedRange::default_points")]
    #[schemars(range(min = 2, max = 100_000))]
    pub points: u64,
}

impl SpeedRange {
    fn default_points() -> u64 {
        221
    }
}
