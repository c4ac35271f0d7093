//! The keys of curving: curve, bogie, body, profiles, and what curving takes of the other tables.

mod inclination;
mod rail_friction;
mod rail_profiles;

use riffel_keys::quantity::{
    Angle, Force, Length, Mass, Moment, Quantity, Ratio, Speed, Stiffness, TorsionalStiffness,
};
use riffel_rail::ProfileOrientation;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Steel;

pub use inclination::Inclination;
pub use rail_friction::{FrictionOfRails, RailFriction};
pub use rail_profiles::{RailProfiles, RailProfilesByRail};

/// What `riffel curve` and `riffel profile` take of a file. Every other key of a case may stand beside these.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(title = "Riffel case file of curving")]
pub struct CurvingFile {
    /// What the case is, for titles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Material of wheel and rail.
    #[serde(default)]
    pub steel: Steel,
    /// The wheels.
    pub wheel: CurvingWheel,
    /// The wheelsets.
    #[serde(default)]
    pub wheelset: CurvingWheelset,
    /// The curve.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<Curve>,
    /// The bogie, or what holds a lone wheelset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bogie: Option<Bogie>,
    /// The body of a vehicle on two bogies; left out, there is one bogie.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<Body>,
    /// The profiles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub profiles: Option<Profiles>,
    /// The contacts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<CurvingContact>,
}

/// What curving takes of the wheel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CurvingWheel {
    /// Rolling radius r₀ on the datum circle.
    pub rolling_radius: Quantity<Length>,
    /// That of the left wheels, where it differs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_rolling_radius: Option<Quantity<Length>>,
}

/// What curving takes of the wheelset.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct CurvingWheelset {
    /// Distance 2s of the contacts on the two rails; left out, that of the placed profiles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_spacing: Option<Quantity<Length>>,
    /// Mass M.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Quantity<Mass>>,
}

/// A circular curve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Curve {
    /// How the wheels roll.
    #[serde(default)]
    pub theory: CurvingTheory,
    /// Radius R, above zero to the right, below to the left.
    pub radius: Quantity<Length>,
    /// Height of the outer rail above the inner one, over the spacing of the contacts.
    #[serde(default = "Curve::no_cant")]
    pub cant: Quantity<Length>,
    /// Speed V.
    pub speed: Quantity<Speed>,
}

impl Curve {
    fn no_cant() -> Quantity<Length> {
        Quantity::new(0.0)
    }
}

/// How the wheels roll through the curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CurvingTheory {
    /// Any profile, yaw and rotation as they are, contacts that saturate.
    #[default]
    Nonlinear,
    /// Linear steering theory: cones, small angles, linear creep, no flange.
    Linear,
}

/// A bogie of two wheelsets in a rigid frame, or a lone wheelset in a frame that follows the track.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bogie {
    /// Wheelsets in the frame: 2, or 1 alone.
    #[serde(default = "Bogie::two", skip_serializing_if = "Bogie::is_two")]
    #[schemars(range(min = 1, max = 2))]
    pub wheelsets: u8,
    /// Distance of the axles 2a, of two wheelsets.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wheelbase: Option<Quantity<Length>>,
    /// Distance of the axle boxes of a wheelset 2b.
    pub primary_spacing: Quantity<Length>,
    /// Stiffness of the primary suspension along the track, per axle box.
    pub primary_longitudinal_stiffness: Quantity<Stiffness>,
    /// Stiffness of the primary suspension across the track, per axle box.
    pub primary_lateral_stiffness: Quantity<Stiffness>,
    /// Everything an axle carries, the wheelset and its share of frame and body included.
    pub mass_per_axle: Quantity<Mass>,
    /// Height of its centre of mass above the rails.
    pub centre_of_mass_height: Quantity<Length>,
    /// Moment on the frame of two wheelsets about the vertical, above zero where it turns the nose to the right.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frame_yaw_moment: Option<Quantity<Moment>>,
    /// Yaw of the frame of a lone wheelset from the tangent, 0 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frame_yaw: Option<Quantity<Angle>>,
    /// Lateral shift at which the frame of a lone wheelset is held; left out, it is free across the track.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frame_lateral_shift: Option<Quantity<Length>>,
    /// Torque on each wheelset, above zero where it drives forward; left out, there is none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drive_torque: Vec<Quantity<Moment>>,
}

impl Bogie {
    fn two() -> u8 {
        2
    }

    fn is_two(wheelsets: &u8) -> bool {
        *wheelsets == 2
    }
}

/// A rigid body on two bogies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Distance of the middles of the bogies 2l.
    pub bogie_spacing: Quantity<Length>,
    /// Mass of the body, a part of what the axles carry.
    pub mass: Quantity<Mass>,
    /// Stiffness of the secondary suspension across the track, per bogie.
    pub secondary_lateral_stiffness: Quantity<Stiffness>,
    /// Stiffness of the secondary suspension against yaw, per bogie.
    pub secondary_yaw_stiffness: Quantity<TorsionalStiffness>,
}

/// Wheels and rails, and how they lie to each other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Profiles {
    /// Profile of the wheels: a nominal name, a file, or "cone".
    pub wheel: String,
    /// Profile of the left wheels, drawn as a right one; left out, that of `wheel`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_wheel: Option<String>,
    /// Profile of the rails: a nominal name, a file, or a table of `left` and `right`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rail: Option<RailProfiles>,
    /// Standard deviation of the points of files across their curve, which is then a smooth one; left out, it goes through the points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scatter: Option<Quantity<Length>>,
    /// How the coordinates of a file of the wheel stand; left out, as they are written in columns, and as they are found in other formats.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wheel_orientation: Option<ProfileOrientation>,
    /// How the coordinates of files of rails stand; left out, as they are written in columns, and as they are found in other formats.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rail_orientation: Option<ProfileOrientation>,
    /// Gauge.
    #[serde(default = "Profiles::standard_gauge")]
    pub gauge: Quantity<Length>,
    /// How far below the crown of the placed rail the gauge is measured.
    #[serde(default = "Profiles::european_gauge_height")]
    pub gauge_height: Quantity<Length>,
    /// Inclination of the rails, as in "1:40"; "none" where the coordinates are inclined.
    #[serde(default)]
    pub inclination: Inclination,
    /// Distance of the flange backs.
    #[serde(default = "Profiles::usual_flange_back_distance")]
    pub flange_back_distance: Quantity<Length>,
    /// Where the flange back lies in the coordinates of the wheel.
    #[serde(default = "Profiles::usual_flange_back_position")]
    pub flange_back_position: Quantity<Length>,
    /// Conicity λ, for wheel = "cone".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub conicity: Option<Quantity<Ratio>>,
    /// Flange of cones: `clearance` and `stiffness` with a horizontal plane, `slope`, `shift` and `width` with a
    /// tilted one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flange: Option<Flange>,
    /// In which plane the contact forces act.
    #[serde(default)]
    pub contact_plane: ContactPlane,
    /// Whether contacts ahead of the axle have a yaw moment; only with a tilted plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_shift_moment: Option<bool>,
}

/// The key of the profile of the left wheels.
pub(crate) const LEFT_WHEEL: &str = "profiles.left_wheel";

impl Profiles {
    /// Profiles of wheels and rails by their keys; empty for cones.
    pub(crate) fn names(&self) -> Vec<(&'static str, &str)> {
        let mut names = Vec::new();
        if self.wheel != "cone" {
            names.push(("profiles.wheel", &*self.wheel));
        }
        names.extend(self.left_wheel.iter().map(|left| (LEFT_WHEEL, &**left)));
        match &self.rail {
            None => {}
            Some(RailProfiles::Both(rail)) => names.push(("profiles.rail", rail)),
            Some(RailProfiles::Each(rails)) => {
                names.extend([("profiles.rail.left", &*rails.left), ("profiles.rail.right", &*rails.right)])
            }
        }
        names
    }

    fn standard_gauge() -> Quantity<Length> {
        Quantity::new(1.435)
    }

    fn european_gauge_height() -> Quantity<Length> {
        Quantity::new(0.014)
    }

    fn usual_flange_back_distance() -> Quantity<Length> {
        Quantity::new(1.36)
    }

    fn usual_flange_back_position() -> Quantity<Length> {
        Quantity::new(-0.07)
    }
}

/// In which plane the contact forces act.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ContactPlane {
    /// Under the contact angle.
    #[default]
    Tilted,
    /// In the plane of the track.
    Horizontal,
}

/// The flange of a conical wheel.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flange {
    /// Lateral shift that a spring leaves free.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance: Option<Quantity<Length>>,
    /// Stiffness of the spring.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Quantity<Stiffness>>,
    /// Tangent of the flange angle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slope: Option<Quantity<Ratio>>,
    /// Lateral shift in the middle of the rise of the contact angle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shift: Option<Quantity<Length>>,
    /// Width of the rise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<Quantity<Length>>,
}

/// What curving takes of the contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CurvingContact {
    /// Creep law; left out, `linear` in linear theory, else `shen-hedrick-elkins`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub creep_law: Option<CurvingLaw>,
    /// Creep coefficients at one load; left out, those of Hertz and Kalker.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub creep_coefficients: Option<CreepCoefficients>,
    /// Coefficient of friction μ: a number, or a table of `left` and `right`.
    pub friction: RailFriction,
    /// Relative transverse radius of wheel and rail R_r, for the ellipse of cones without `creep_coefficients`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub transverse_radius: Option<Quantity<Length>>,
}

/// A creep law of curving, which knows lateral creepage and spin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CurvingLaw {
    /// Kalker's linear theory, without friction.
    Linear,
    /// Shen, Hedrick & Elkins (1983).
    ShenHedrickElkins,
    /// FASTSIM of Kalker (1982), on 50 strips.
    Fastsim,
}

impl CurvingLaw {
    /// The law of this name.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "linear" => Some(Self::Linear),
            "shen-hedrick-elkins" => Some(Self::ShenHedrickElkins),
            "fastsim" => Some(Self::Fastsim),
            _ => None,
        }
    }
}

/// Creep coefficients at a normal force P: f₁₁, f₂₂ ∝ P^(2/3), f₂₃ ∝ P.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CreepCoefficients {
    /// f₁₁.
    pub longitudinal: Quantity<Force>,
    /// f₂₂.
    pub lateral: Quantity<Force>,
    /// f₂₃.
    pub spin: Quantity<Moment>,
    /// The normal force.
    pub load: Quantity<Force>,
}
