//! The keys of the contact on the opposite rail.

use riffel_keys::quantity::{Angle, Force, Length, Quantity, Ratio, Stiffness};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Creepage;

/// What differs in the contact on the opposite rail.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OppositeContact {
    /// Relative transverse radius of wheel and rail R_r; left out, that of the contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub transverse_radius: Option<Quantity<Length>>,
    /// Relative radius of wheel and rail along the rail; left out, that of the contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub longitudinal_radius: Option<Quantity<Length>>,
    /// Normal force P₀; left out, that of the contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal_load: Option<Quantity<Force>>,
    /// Linearised contact stiffness k_H under that force; left out, that of the contact, or of the ellipse where radius or force are given here.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Quantity<Stiffness>>,
    /// Coefficient of friction μ; left out, that of the contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<Quantity<Ratio>>,
    /// Creepage ξ₀, a number or a table; left out, that of the contact with its spin turned round.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub creepage: Option<Creepage>,
    /// Contact angle γ; left out, that of the contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_angle: Option<Quantity<Angle>>,
    /// Lateral offset e, to the right; left out, that of the contact to the other side.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_offset: Option<Quantity<Length>>,
    /// Transverse radius of the rail head, where `contact.conformity` is given; left out, that of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rail_radius: Option<Quantity<Length>>,
}
