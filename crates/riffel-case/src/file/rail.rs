//! The keys of the rail.

use riffel_keys::quantity::{
    Area, Density, Length, MassPerLength, Modulus, Quantity, Ratio, SecondMoment, WarpingConstant,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The rail: a named section, its values one by one, or a section with values that replace its own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rail {
    /// Name of a rail preset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section: Option<String>,
    /// Mass per length m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass_per_length: Option<Quantity<MassPerLength>>,
    /// Second moment of area I for vertical bending.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second_moment: Option<Quantity<SecondMoment>>,
    /// Second moment of area about the vertical axis, for lateral bending.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_second_moment: Option<Quantity<SecondMoment>>,
    /// How the rail bends; left out, `timoshenko` on discrete supports and `euler-bernoulli` on all
    /// others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beam: Option<BeamModel>,
    /// Cross-section A, for Timoshenko's beam and for the bar.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub area: Option<Quantity<Area>>,
    /// Shear coefficient κ for vertical bending, for Timoshenko's beam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_coefficient: Option<Quantity<Ratio>>,
    /// Shear coefficient for lateral bending.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_shear_coefficient: Option<Quantity<Ratio>>,
    /// Shear modulus G; left out, that of the steel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_modulus: Option<Quantity<Modulus>>,
    /// Density ρ, of which rotary inertia is made; left out, 7850 kg/m³.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<Quantity<Density>>,
    /// Loss factor η of the rail: E and G become E(1 + iη) and G(1 + iη); left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_factor: Option<Quantity<Ratio>>,
    /// Torsion constant J of the torsional stiffness GJ; left out, the rail does not twist.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torsion_constant: Option<Quantity<SecondMoment>>,
    /// Polar second moment I_p of the rotary inertia ρI_p, for a rail that twists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub polar_second_moment: Option<Quantity<SecondMoment>>,
    /// Warping constant I_ω of the stiffness EI_ω; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub warping_constant: Option<Quantity<WarpingConstant>>,
    /// Height c of the centroid, where the mass is, above the shear centre, for a rail that twists; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centroid_height: Option<Quantity<Length>>,
    /// Height h of the running surface above the shear centre, for a rail that twists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub head_height: Option<Quantity<Length>>,
    /// Depth d of the foot below the shear centre, for a rail that twists on supports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub foot_depth: Option<Quantity<Length>>,
    /// Width B of the foot on its pad, for a rail that twists on supports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub foot_width: Option<Quantity<Length>>,
}

/// How the rail bends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BeamModel {
    /// Without shear: the paper's rail.
    EulerBernoulli,
    /// With shear and rotary inertia; needs `area` and `shear_coefficient`.
    Timoshenko,
}
