//! The keys of a case file, as written.

pub(crate) mod key;
pub(crate) mod setting;

mod contact;
mod creep_law_name;
mod creepage;
mod curving;
mod damage;
mod from_curve;
mod map;
mod measured_wear;
mod opposite_contact;
mod rail;
mod track;
mod train;
mod wheel;
mod wheelset;

use riffel_keys::quantity::{Density, Length, Modulus, Quantity, Ratio, Speed, WearCoefficient};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use contact::{Conformity, Contact, ContactDynamics, DissipationPhase, HertzTheory, PolachParameters, WavePatch};
pub use creep_law_name::CreepLawName;
pub use creepage::{Creepage, VectorCreepage};
pub(crate) use curving::LEFT_WHEEL;
pub use curving::{
    Body, Bogie, ContactPlane, CreepCoefficients, Curve, CurvingContact, CurvingFile, CurvingLaw, CurvingTheory,
    CurvingWheel, CurvingWheelset, Flange, FrictionOfRails, Inclination, Profiles, RailFriction, RailProfiles,
    RailProfilesByRail,
};
pub use damage::{Bending, Damage, DamageLawName, Fatigue, Flow, FlowAlong, LimitName, Load, RailGrade};
pub use from_curve::{ContactOfWheel, CurveRail, FromCurve, Patch};
pub use map::{Map, SpeedRange, WavelengthRange};
pub use measured_wear::MeasuredWear;
pub use opposite_contact::OppositeContact;
pub use rail::{BeamModel, Rail};
pub use track::{Sleeper, Support, Track, TrackModel};
pub use train::{Comb, Train};
pub use wheel::{Rotation, Wheel};
pub use wheelset::{Axle, AxleSegment, Disc, OppositeRail, RailSide, Suspension, Wheelset, WheelsetModel};

/// A Riffel case: one vehicle wheel on one track, or wheelsets on both rails.
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
    /// The wheelset; left out, the wheel is alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wheelset: Option<Wheelset>,
    /// The wheels that follow one another; left out, one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub train: Option<Train>,
    /// The rail.
    pub rail: Rail,
    /// What the rail lies on.
    pub track: Track,
    /// Contact of wheel and rail.
    pub contact: Contact,
    /// What differs in the contact on the opposite rail, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub opposite_contact: Option<OppositeContact>,
    /// The profile already on the rail.
    #[serde(default)]
    pub corrugation: Corrugation,
    /// Law of wear.
    #[serde(default)]
    pub wear: Wear,
    /// What damages the rail beside wear; left out, wear alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damage: Option<Damage>,
    /// Window of a growth map.
    #[serde(default)]
    pub map: Map,
    /// The curve of `riffel curve`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<Curve>,
    /// The bogie of `riffel curve`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bogie: Option<Bogie>,
    /// The body of `riffel curve`, on two bogies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<Body>,
    /// The profiles of `riffel curve` and `riffel profile`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub profiles: Option<Profiles>,
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
        Self { youngs_modulus: Quantity::new(207e9), poisson_ratio: Quantity::new(0.3) }
    }
}

/// The profile already on the rail.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Corrugation {
    /// Amplitude Δ. Forces and dissipation are proportional to it; growth rates do not depend on it, but those of laws of damage with a limit.
    pub amplitude: Quantity<Length>,
}

impl Default for Corrugation {
    fn default() -> Self {
        Self { amplitude: Quantity::new(31.5e-6) }
    }
}

/// Law of wear: depth in proportion to dissipated energy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Wear {
    /// Mass worn per dissipated energy k_w.
    pub coefficient: Quantity<WearCoefficient>,
    /// Wear of the rail under study as it was measured, as in "1.2 mm / 100 MGT", in place of `coefficient`: k_w is what gives it under
    /// the traffic.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "measured_wear::schema")]
    pub measured: Option<MeasuredWear>,
    /// Density ρ of the rail.
    pub density: Quantity<Density>,
    /// How wear goes with the work of a contact.
    #[serde(default, skip_serializing_if = "WearLaw::is_energy")]
    pub law: WearLaw,
    /// Speed of the wheel, of which creepage makes the sliding speed of `archard-map`; left out, the middle of `map.speed`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<Quantity<Speed>>,
    /// How many times less the rail wears than by its law, by natural lubrication, where that law is of dry steel; left out, as much.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub natural_lubrication: Option<Quantity<Ratio>>,
    /// Standard deviation of ln(Tγ/A) over the wheels of traffic, about the value of the case as their median, for laws by Tγ/A;
    /// left out, all are alike.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spread: Option<Quantity<Ratio>>,
    /// Width of the band over which the contacts of traffic are spread; left out, that of one contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub band_width: Option<Quantity<Length>>,
}

/// How wear goes with the work of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum WearLaw {
    /// In proportion to dissipated energy, by `coefficient`.
    #[default]
    Energy,
    /// By Tγ/A, energy per metre over the area of the patch: mild, severe and catastrophic regimes of twin discs, dry, smooth between
    /// them.
    TgammaArea,
    /// The USFD law: Tγ/A in the same regimes with its sharp corners, mild, a plateau, catastrophic.
    Usfd,
    /// USFD law made smooth between the regimes, that of `tgamma-area`.
    UsfdSmooth,
    /// Archard's law by a map of sliding speed and pressure, smooth between its regimes; its numbers are recalled, not looked up.
    ArchardMap,
}

impl WearLaw {
    fn is_energy(&self) -> bool {
        *self == Self::Energy
    }
}

impl Default for Wear {
    fn default() -> Self {
        Self {
            coefficient: Quantity::new(riffel::EnergyWear::DEFAULT_COEFFICIENT),
            measured: None,
            density: Quantity::new(riffel::EnergyWear::DEFAULT_DENSITY),
            law: WearLaw::default(),
            speed: None,
            natural_lubrication: None,
            spread: None,
            band_width: None,
        }
    }
}
