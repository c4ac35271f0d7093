//! The keys of a case file, as written.

use riffel_keys::quantity::{
    Area, Damping, DampingPerLength, Density, Force, Inertia, Length, Mass, MassPerLength, Modulus,
    Quantity, Ratio, SecondMoment, Speed, Stiffness, VelocityDecay, WearCoefficient,
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// A Riffel case: one vehicle wheel on one track.
///
/// Every quantity is a bare number in SI or a string with its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Riffel case file")]
pub struct CaseFile {
    /// What the case is, for titles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Name of a vehicle preset, for the wheel and its normal load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vehicle: Option<String>,
    /// Material of wheel and rail.
    #[serde(default)]
    pub steel: Steel,
    /// The wheel.
    pub wheel: Wheel,
    /// The rail.
    pub rail: Rail,
    /// What the rail lies on.
    pub track: Track,
    /// Contact of wheel and rail.
    pub contact: Contact,
    /// The profile already on the rail.
    #[serde(default)]
    pub corrugation: Corrugation,
    /// Law of wear.
    #[serde(default)]
    pub wear: Wear,
    /// Window of a growth map.
    #[serde(default)]
    pub map: Map,
}

/// Material of wheel and rail.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Steel {
    /// Young's modulus E.
    pub youngs_modulus: Quantity<Modulus>,
    /// Poisson's ratio ν, between -1 and 0.5.
    pub poisson_ratio: Quantity<Ratio>,
}

impl Default for Steel {
    fn default() -> Self {
        Self {
            youngs_modulus: Quantity::new(207e9),
            poisson_ratio: Quantity::new(0.3),
        }
    }
}

/// The wheel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wheel {
    /// Rolling radius R.
    pub rolling_radius: Quantity<Length>,
    /// Unsprung mass per wheel m_w.
    pub mass: Quantity<Mass>,
    /// Rotational inertia per wheel I_w; left out, 0.75 · mass · R² / 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inertia: Option<Quantity<Inertia>>,
    /// How the wheel turns under the oscillating tangential force.
    #[serde(default)]
    pub rotation: Rotation,
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

/// What the rail lies on. Values are per support and per rail; a model takes those it needs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Track {
    /// The model.
    pub model: TrackModel,
    /// Name of a track preset, for its supports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Distance of supports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub support_spacing: Option<Quantity<Length>>,
    /// Rail pad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pad: Option<Support>,
    /// Sleeper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sleeper: Option<Sleeper>,
    /// Ballast.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ballast: Option<Support>,
    /// Viscous damping of the rail per length; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rail_damping: Option<Quantity<DampingPerLength>>,
    /// Place of the wheel on discrete supports, from one of them; left out, over a support.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<Quantity<Length>>,
    /// Where a measured receptance is found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measurement: Option<Measurement>,
}

/// Model of the track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TrackModel {
    /// Infinite rail without support under a stationary load.
    FreeBeam,
    /// The same under a moving load; on pads if `pad` is given, on pads, sleepers and ballast if
    /// `ballast` is given, spread evenly.
    MovingBeam,
    /// Rail on pads, spread evenly; needs `support_spacing` and `pad`.
    OneLayer,
    /// Rail on pads, sleepers and ballast, spread evenly; needs `preset`, or `support_spacing`,
    /// `pad`, `sleeper` and `ballast`.
    TwoLayer,
    /// Rail on pads at every `support_spacing`.
    OneLayerPeriodic,
    /// Rail on pads, sleepers and ballast at every `support_spacing`.
    TwoLayerPeriodic,
    /// A receptance from a file; needs `measurement`.
    Measured,
}

impl TrackModel {
    /// The name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::FreeBeam => "free-beam",
            Self::MovingBeam => "moving-beam",
            Self::OneLayer => "one-layer",
            Self::TwoLayer => "two-layer",
            Self::OneLayerPeriodic => "one-layer-periodic",
            Self::TwoLayerPeriodic => "two-layer-periodic",
            Self::Measured => "measured",
        }
    }

    /// True for supports at discrete places.
    pub fn is_periodic(self) -> bool {
        matches!(self, Self::OneLayerPeriodic | Self::TwoLayerPeriodic)
    }
}

/// A spring with viscous and hysteretic damping.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Name of a pad or ballast preset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Vertical stiffness per support.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Quantity<Stiffness>>,
    /// Viscous damping per support; with `loss_factor`, both act.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damping: Option<Quantity<Damping>>,
    /// Loss factor η: the stiffness becomes k(1 + iη).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_factor: Option<Quantity<Ratio>>,
    /// Lateral stiffness per support; its damping is in proportion to the vertical one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral_stiffness: Option<Quantity<Stiffness>>,
    /// Stiffness along the rail per support; its damping is in proportion to the vertical one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub longitudinal_stiffness: Option<Quantity<Stiffness>>,
}

/// A sleeper.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sleeper {
    /// Name of a sleeper preset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Mass per support and rail: half of a sleeper under two rails.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Quantity<Mass>>,
}

/// A frequency response in a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Measurement {
    /// The file: a table (CSV), or a universal file with dataset 58 if its name ends in .uff, .unv
    /// or .u58. Relative to the case file.
    pub file: String,
    /// What was measured; left out, what the unit of a table tells, else a receptance. A universal
    /// file says so itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<Response>,
    /// Unit of the values in a table, such as "mm/s/kN", "g/N" or, of a modulus, "dB re 1 m/N"; left
    /// out, the one in its header, else m/N, m/(s N) or m/(s² N).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Column of the frequency; left out, like those of the values, the one that the header tells.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frequency: Option<String>,
    /// Unit of the frequency; left out, the one in the header, else Hz.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frequency_unit: Option<String>,
    /// Column of the real part; with `imaginary`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub real: Option<String>,
    /// Column of the imaginary part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub imaginary: Option<String>,
    /// Column of the modulus; with `phase`, instead of `real` and `imaginary`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modulus: Option<String>,
    /// Column of the phase.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phase: Option<String>,
    /// Unit of the phase; left out, the one in the header, else degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phase_unit: Option<AngleUnit>,
    /// Column of the coherence γ². Where it is below 0.8 the lines around are averaged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coherence: Option<String>,
    /// Number of the function in a universal file with several, from one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub function: Option<u32>,
    /// Vertical axis of a universal file: its function must respond along it to a force along it.
    #[serde(default, skip_serializing_if = "VerticalAxis::is_z")]
    pub vertical_axis: VerticalAxis,
    /// True for values that follow exp(−iωt): their imaginary parts change sign.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub conjugate: bool,
}

/// An axis of a tested structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum VerticalAxis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    #[default]
    Z,
}

impl VerticalAxis {
    /// Its letter.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }

    // Asked by serde, which has a reference.
    #[allow(clippy::trivially_copy_pass_by_ref)]
    fn is_z(&self) -> bool {
        *self == Self::Z
    }
}

/// What a frequency response is of, per force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Response {
    /// Displacement.
    #[default]
    Receptance,
    /// Velocity.
    Mobility,
    /// Acceleration.
    Accelerance,
}

/// Unit of an angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum AngleUnit {
    /// Degrees.
    #[default]
    Degrees,
    /// Radians.
    Radians,
}

/// Contact of wheel and rail. Give `tractive_ratio` or `creepage`, not both.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Relative transverse radius of wheel and rail R_r.
    pub transverse_radius: Quantity<Length>,
    /// Normal force P₀ per wheel.
    pub normal_load: Quantity<Force>,
    /// Coefficient of friction μ.
    pub friction: Quantity<Ratio>,
    /// Tractive ratio τ = Q₀/μP₀, between 0 and 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tractive_ratio: Option<Quantity<Ratio>>,
    /// Creepage ξ₀, above 0 and below the one at which full slip begins.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub creepage: Option<Quantity<Ratio>>,
    /// Reading of the phase between dissipation at the wheel and at a point of the rail; a non-steady
    /// contact resolves it itself.
    #[serde(default)]
    pub dissipation_phase: DissipationPhase,
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
        36
    }
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

/// Steady creep law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum CreepLawName {
    /// The paper's, equation (5).
    #[serde(rename = "carter-3d")]
    Carter3d,
    /// Carter (1926), a line contact as long and as large as the ellipse.
    #[serde(rename = "carter-2d")]
    Carter2d,
    /// Vermeulen & Johnson (1964), with Kalker's slope.
    #[serde(rename = "johnson-vermeulen")]
    JohnsonVermeulen,
    /// Shen, Hedrick & Elkins (1983).
    #[serde(rename = "shen-hedrick-elkins")]
    ShenHedrickElkins,
    /// Polach (2000), with the parameters of `polach`.
    #[serde(rename = "polach")]
    Polach,
    /// Kalker's simplified theory (1982).
    #[serde(rename = "fastsim")]
    Fastsim,
    /// Kalker's exact theory.
    #[serde(rename = "half-space")]
    HalfSpace,
}

impl CreepLawName {
    /// The name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Carter3d => "carter-3d",
            Self::Carter2d => "carter-2d",
            Self::JohnsonVermeulen => "johnson-vermeulen",
            Self::ShenHedrickElkins => "shen-hedrick-elkins",
            Self::Polach => "polach",
            Self::Fastsim => "fastsim",
            Self::HalfSpace => "half-space",
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

/// The profile already on the rail.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Corrugation {
    /// Amplitude Δ. Forces and dissipation are proportional to it; growth rates do not depend on it.
    pub amplitude: Quantity<Length>,
}

impl Default for Corrugation {
    fn default() -> Self {
        Self {
            amplitude: Quantity::new(31.5e-6),
        }
    }
}

/// Law of wear: depth in proportion to dissipated energy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Wear {
    /// Mass worn per dissipated energy k_w.
    pub coefficient: Quantity<WearCoefficient>,
    /// Density ρ of the rail.
    pub density: Quantity<Density>,
}

impl Default for Wear {
    fn default() -> Self {
        Self {
            coefficient: Quantity::new(riffel::EnergyWear::DEFAULT_COEFFICIENT),
            density: Quantity::new(riffel::EnergyWear::DEFAULT_DENSITY),
        }
    }
}

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
