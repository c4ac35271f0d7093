//! The keys of the train.

use riffel_keys::quantity::{Length, Quantity};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The wheels that run on the rail one behind the other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Train {
    /// Distances behind the first wheel, its own zero first.
    pub wheels: Vec<Quantity<Length>>,
    /// What is made of the interference of the wheels.
    pub comb: Comb,
}

impl Default for Train {
    fn default() -> Self {
        Self { wheels: vec![Quantity::new(0.0)], comb: Comb::default() }
    }
}

/// What is made of the interference of wheels, a comb over wavelength with teeth λ²/l apart for a distance l.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Comb {
    /// Each tooth is shown.
    #[default]
    Resolved,
    /// Growth is the mean over the comb.
    Mean,
}
