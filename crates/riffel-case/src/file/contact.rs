//! The keys of the contact.

use riffel::contact::HalfSpace;
use riffel_keys::quantity::{Angle, Force, Length, Quantity, Ratio, RelativeSlope, Speed, Stiffness, VelocityDecay};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{CreepLawName, Creepage, FromCurve};

/// Contact of wheel and rail. Give `tractive_ratio` or `creepage`, not both.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Relative transverse radius of wheel and rail R_r.
    pub transverse_radius: Quantity<Length>,
    /// Relative radius of wheel and rail along the rail; left out, the rolling radius R, which under a contact angle γ is R/cos γ.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub longitudinal_radius: Option<Quantity<Length>>,
    /// Normal force P₀ per wheel.
    pub normal_load: Quantity<Force>,
    /// Linearised contact stiffness k_H under that force; left out, that of the ellipse.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Quantity<Stiffness>>,
    /// Coefficient of friction μ.
    pub friction: Quantity<Ratio>,
    /// Tractive ratio τ = Q₀/μP₀, between 0 and 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tractive_ratio: Option<Quantity<Ratio>>,
    /// Creepage ξ₀: a number above 0 and below the one at which full slip begins, or a table of `longitudinal`,
    /// `lateral` and `spin`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub creepage: Option<Creepage>,
    /// Where the mean state comes from, in place of creepages, contact angle, normal load, transverse radius and friction that are
    /// not written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<FromCurve>,
    /// Contact angle γ, under which the normal force pushes the rail outward; left out, 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_angle: Option<Quantity<Angle>>,
    /// Lateral offset e of the contact from the shear centre of the rail, to the right; left out, 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_offset: Option<Quantity<Length>>,
    /// How the contact moves across the profiles of wheel and rail; left out, it stays where it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub conformity: Option<Conformity>,
    /// Reading of the phase between dissipation at the wheel and at a point of the rail; a non-steady
    /// contact resolves it itself.
    #[serde(default)]
    pub dissipation_phase: DissipationPhase,
    /// Whether the shape of the wave itself has a part: the contact runs slower over crests and presses as a smaller wheel. Left out, false, with
    /// a remark on what it would take.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wave_geometry: Option<bool>,
    /// What of the curvature of a wave the contact feels.
    #[serde(default)]
    pub wave_patch: WavePatch,
    /// Steady creep law; left out, `carter-3d`, or `half-space` with a non-steady response.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub creep_law: Option<CreepLawName>,
    /// How the contact answers to oscillations.
    #[serde(default)]
    pub response: ContactDynamics,
    /// Contact ellipse; left out, `paper` with `carter-3d` and `exact` with all others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hertz: Option<HertzTheory>,
    /// Elements over a diameter of the ellipse for `half-space`, an even number.
    #[serde(default = "Contact::default_grid")]
    #[schemars(range(min = 16, max = 200))]
    pub grid: u64,
    /// Falling friction and layers between the surfaces, for `polach`; left out, dry and constant.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub polach: Option<PolachParameters>,
}

impl Contact {
    fn default_grid() -> u64 {
        HalfSpace::DEFAULT_ELEMENTS as u64
    }
}

/// How the contact moves across the profiles of wheel and rail as they shift and roll against one another, which makes
/// longitudinal creepage oscillate by geometry alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Conformity {
    /// Transverse radius of the rail head, at most `contact.transverse_radius`, the relative one of both profiles: equal
    /// under a cone, and the closer the wheel is to the rail, the smaller beside it.
    pub rail_radius: Quantity<Length>,
    /// Relative cross slope of the ripple: by which share of itself its height grows for a metre outward across the head;
    /// left out, 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cross_slope: Option<Quantity<RelativeSlope>>,
    /// Longitudinal creepage by the rolling radius of the place.
    #[serde(default = "yes")]
    pub rolling_radius: bool,
    /// The forces that turn with the plane of contact.
    #[serde(default = "yes")]
    pub contact_angle: bool,
    /// Spin by the turn of that plane.
    #[serde(default = "yes")]
    pub spin: bool,
    /// The roll of the rail that moves the contact, and the moment of the shifted load on the rail.
    #[serde(default = "yes")]
    pub rail_roll: bool,
}

fn yes() -> bool {
    true
}

/// Parameters of Polach's creep law: μ(w) = μ ((1 − A) exp(−B w) + A) at the slip velocity w = V ξ, and the
/// reduced slopes of the creep curve. Give `limit_friction_ratio`, `friction_decay` and `speed`
/// together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct PolachParameters {
    /// A, the coefficient of friction at infinite slip velocity over `friction`, the one at rest; above
    /// 0 and at most 1. Left out, friction is constant.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_friction_ratio: Option<Quantity<Ratio>>,
    /// B, exponential decay of friction over slip velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_decay: Option<Quantity<VelocityDecay>>,
    /// Rolling speed V of the slip velocity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<Quantity<Speed>>,
    /// k_A, reduction factor in the area of adhesion, above 0 and at most 1.
    pub adhesion_reduction: Quantity<Ratio>,
    /// k_S, reduction factor in the area of slip, above 0 and at most `adhesion_reduction`.
    pub slip_reduction: Quantity<Ratio>,
}

impl Default for PolachParameters {
    fn default() -> Self {
        Self {
            limit_friction_ratio: None,
            friction_decay: None,
            speed: None,
            adhesion_reduction: Quantity::new(1.0),
            slip_reduction: Quantity::new(1.0),
        }
    }
}

/// How the contact answers to oscillations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ContactDynamics {
    /// At once, by the slopes of the creep law.
    #[default]
    QuasiStatic,
    /// By a spring (Mindlin) in series with a dashpot (the slope of the creep law).
    SpringDashpot,
    /// By the exact theory of non-steady rolling, which resolves where in the patch the rail wears.
    NonSteady,
}

/// What of the curvature of a wave the contact feels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum WavePatch {
    /// What an ellipse does.
    #[default]
    Patch,
    /// All of it, as a point does.
    Point,
}

/// Theory of the contact ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum HertzTheory {
    /// Elliptic integrals.
    Exact,
    /// The paper's closed form, equations (22) and (26).
    Paper,
}

/// Reading of the phase between dissipation at the wheel and at a point of the rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DissipationPhase {
    /// Later, as in the figures of the paper.
    #[default]
    Lag,
    /// Earlier, as geometry alone has it.
    Lead,
    /// At the wheel centre.
    None,
}
