//! The keys of the wheel.

use riffel_keys::quantity::{Inertia, Length, Mass, Quantity};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The wheel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wheel {
    /// Rolling radius R.
    pub rolling_radius: Quantity<Length>,
    /// Unsprung mass per wheel m_w; needed without a wheelset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Quantity<Mass>>,
    /// Rotational inertia per wheel I_w; left out, 0.75 · mass · R² / 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<Quantity<Inertia>>,
    /// How the wheel turns under the oscillating tangential force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Rotation", extend("default" = "inertia"))]
    pub rotation: Option<Rotation>,
    /// Whether the normal force turns with the slope of a wave, P₀r' along the rail; the hub then moves along the rail as the mass.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub normal_direction: bool,
}

impl Wheel {
    /// How it turns: as written, or with its inertia.
    pub fn rotation(&self) -> Rotation {
        self.rotation.unwrap_or_default()
    }
}

/// How the wheel turns under the oscillating tangential force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Rotation {
    /// With its inertia.
    #[default]
    Inertia,
    /// Freely: the limit of no inertia.
    ConstantTangentialForce,
    /// Evenly: the limit of infinite inertia.
    ConstantCreepage,
}
