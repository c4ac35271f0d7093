//! The keys of the wheelset.

use std::f64::consts::PI;

use riffel::wheelset;
use riffel_keys::quantity::{
    Damping, Density, Inertia, Length, Mass, Modulus, Quantity, Ratio, Stiffness, TorsionalDamping, TorsionalStiffness,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The wheelset, in place of mass, inertia and rotation of the wheel. A model takes the keys it needs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wheelset {
    /// Name of a wheelset preset, which also gives the model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// The model.
    pub model: WheelsetModel,
    /// Mass M, for `rigid` and `modal`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<Quantity<Mass>>,
    /// Moment of inertia J_x about an axis through the middle of the axle, along the track or upright, for `rigid`
    /// and `modal`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roll_inertia: Option<Quantity<Inertia>>,
    /// Moment of inertia J_y about the axle, for `rigid` and `modal`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spin_inertia: Option<Quantity<Inertia>>,
    /// Distance 2s of the contacts on the two rails.
    #[serde(default = "Wheelset::default_contact_spacing")]
    pub contact_spacing: Quantity<Length>,
    /// What the opposite wheel runs on.
    #[serde(default)]
    pub opposite_rail: OppositeRail,
    /// The rail under study.
    #[serde(default)]
    pub rail: RailSide,
    /// Whether the normal forces turn with the slope of a wave, P₀r' along the rail; for `rigid` and `flexible`.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub normal_direction: bool,
    /// Primary suspension, but for `measured`; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub suspension: Option<Suspension>,
    /// The axle, for `flexible`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axle: Option<Axle>,
    /// Rigid discs on the axle, for `flexible`: wheels, brake discs, gear.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub discs: Vec<Disc>,
    /// Table of modes for `modal`, of receptances for `measured`. Relative to the case file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
}

impl Wheelset {
    pub(crate) fn default_contact_spacing() -> Quantity<Length> {
        Quantity::new(1.5)
    }

    /// Mass \[kg\] and inertia about the axle \[kg m²\] of half of it; `None` where it is known by its receptances alone.
    pub(crate) fn half(&self) -> Option<[f64; 2]> {
        let [mass, inertia] = match self.model {
            WheelsetModel::Measured => return None,
            WheelsetModel::Rigid | WheelsetModel::Modal => [self.mass?.si(), self.spin_inertia?.si()],
            WheelsetModel::Flexible => {
                let mut sums = self.axle.as_ref()?.mass_and_inertia()?;
                for disc in &self.discs {
                    sums[0] += disc.mass.si();
                    sums[1] += disc.polar_inertia.si();
                }
                sums
            }
        };
        Some([0.5 * mass, 0.5 * inertia])
    }
}

/// Model of the wheelset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum WheelsetModel {
    /// One rigid body; needs `mass`, `roll_inertia` and `spin_inertia`.
    Rigid,
    /// A flexible axle with rigid discs, not rotating; needs `axle`.
    Flexible,
    /// Modes from a file, beside the motions of the rigid body; needs `file`, `mass`, `roll_inertia` and
    /// `spin_inertia`.
    Modal,
    /// Receptances from a file; needs `file`.
    Measured,
}

impl WheelsetModel {
    /// The name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rigid => "rigid",
            Self::Flexible => "flexible",
            Self::Modal => "modal",
            Self::Measured => "measured",
        }
    }
}

/// What the opposite wheel runs on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OppositeRail {
    /// Nothing: its contact takes no part.
    #[default]
    Absent,
    /// A rail without profile.
    Smooth,
    /// A rail with the same profile.
    InPhase,
    /// A rail with the profile turned over.
    Antiphase,
}

/// One of the two rails, as seen in the direction of travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RailSide {
    /// The right one.
    #[default]
    Right,
    /// The left one.
    Left,
}

impl RailSide {
    /// That of a rail of the track.
    pub fn of(rail: riffel::Rail) -> Self {
        match rail {
            riffel::Rail::Right => Self::Right,
            riffel::Rail::Left => Self::Left,
        }
    }

    /// The rail of the track.
    pub fn of_track(self) -> riffel::Rail {
        match self {
            Self::Right => riffel::Rail::Right,
            Self::Left => riffel::Rail::Left,
        }
    }
}

/// Springs and dampers between axle boxes and a frame at rest, per side.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Suspension {
    /// Stiffness along the track.
    pub longitudinal_stiffness: Quantity<Stiffness>,
    /// Stiffness across the track.
    pub lateral_stiffness: Quantity<Stiffness>,
    /// Vertical stiffness.
    pub vertical_stiffness: Quantity<Stiffness>,
    /// Viscous damping along the track.
    pub longitudinal_damping: Quantity<Damping>,
    /// Viscous damping across the track.
    pub lateral_damping: Quantity<Damping>,
    /// Vertical viscous damping.
    pub vertical_damping: Quantity<Damping>,
    /// Distance of the two sides, both on the centre line of the axle.
    pub spacing: Quantity<Length>,
}

impl Default for Suspension {
    fn default() -> Self {
        let (stiffness, damping) = (Quantity::new(0.0), Quantity::new(0.0));
        Self {
            longitudinal_stiffness: stiffness,
            lateral_stiffness: stiffness,
            vertical_stiffness: stiffness,
            longitudinal_damping: damping,
            lateral_damping: damping,
            vertical_damping: damping,
            spacing: Quantity::new(2.0),
        }
    }
}

/// The axle, its middle between the rails. Give `length` and `diameter`, or `segments`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Axle {
    /// Length of an axle of one diameter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<Quantity<Length>>,
    /// Its diameter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diameter: Option<Quantity<Length>>,
    /// Segments of a stepped axle, from left to right.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub segments: Option<Vec<AxleSegment>>,
    /// Density ρ.
    pub density: Quantity<Density>,
    /// Young's modulus E; left out, that of the steel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub youngs_modulus: Option<Quantity<Modulus>>,
    /// Poisson's ratio ν; left out, that of the steel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<Quantity<Ratio>>,
    /// Shear coefficient κ; left out, that of a solid circle, 6(1 + ν)/(7 + 6ν).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shear_coefficient: Option<Quantity<Ratio>>,
    /// Loss factor η: E and G become E(1 + iη) and G(1 + iη).
    pub loss_factor: Quantity<Ratio>,
}

impl Axle {
    /// Mass \[kg\] and inertia about itself \[kg m²\], of solid cylinders.
    fn mass_and_inertia(&self) -> Option<[f64; 2]> {
        let pieces: Vec<[f64; 2]> = match &self.segments {
            Some(segments) => segments.iter().map(|segment| [segment.length.si(), segment.diameter.si()]).collect(),
            None => vec![[self.length?.si(), self.diameter?.si()]],
        };
        let masses = pieces.iter().map(|[length, diameter]| {
            let mass = self.density.si() * length * 0.25 * PI * diameter * diameter;
            [mass, mass * diameter * diameter / 8.0]
        });
        Some(masses.fold([0.0; 2], |sums, piece| [sums[0] + piece[0], sums[1] + piece[1]]))
    }
}

impl Default for Axle {
    fn default() -> Self {
        Self {
            length: None,
            diameter: None,
            segments: None,
            density: Quantity::new(riffel::STEEL_DENSITY),
            youngs_modulus: None,
            poisson_ratio: None,
            shear_coefficient: None,
            loss_factor: Quantity::new(0.0),
        }
    }
}

/// A piece of the axle of one diameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxleSegment {
    /// Its length.
    pub length: Quantity<Length>,
    /// Its diameter.
    pub diameter: Quantity<Length>,
}

/// A rigid disc on the axle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Disc {
    /// Its place, from the middle of the axle to the right.
    pub position: Quantity<Length>,
    /// Its mass.
    pub mass: Quantity<Mass>,
    /// Its moment of inertia about the axle.
    pub polar_inertia: Quantity<Inertia>,
    /// Its moment of inertia about a diameter.
    pub diametral_inertia: Quantity<Inertia>,
    /// An inertia that turns with it through a spring: the rotor of a motor behind its gear, an absorber.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coupled: Option<Coupled>,
}

impl From<&Disc> for wheelset::Disc {
    fn from(keys: &Disc) -> Self {
        Self {
            position: keys.position.si(),
            mass: keys.mass.si(),
            polar_inertia: keys.polar_inertia.si(),
            diametral_inertia: keys.diametral_inertia.si(),
            coupled: keys.coupled.map(|coupled| wheelset::CoupledInertia {
                polar_inertia: coupled.polar_inertia.si(),
                stiffness: coupled.stiffness.si(),
                damping: coupled.damping.si(),
            }),
        }
    }
}

/// An inertia that turns about the axle on a torsional spring and a damper.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupled {
    /// Its moment of inertia; behind a gear of ratio n, n² times that of the rotor.
    pub polar_inertia: Quantity<Inertia>,
    /// Torsional stiffness between it and the disc, seen at the axle: n² times that on the side of the rotor.
    pub stiffness: Quantity<TorsionalStiffness>,
    /// Viscous damping beside the spring.
    #[serde(default = "Coupled::no_damping")]
    pub damping: Quantity<TorsionalDamping>,
}

impl Coupled {
    fn no_damping() -> Quantity<TorsionalDamping> {
        Quantity::new(0.0)
    }
}
