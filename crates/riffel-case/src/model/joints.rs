//! The joints of a model of the field, each as one of the choices that the models differ by.

use serde::{Deserialize, Serialize, Serializer};

use crate::file::Rotation;

/// A joint of the loop by which models differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Joint {
    /// Rail and supports.
    Track,
    /// Wheel or wheelset.
    Wheel,
    /// Steady creepage.
    Creepage,
    /// Creep law and its response.
    Contact,
    /// What moves the contact across the profiles.
    Conformity,
    /// What the patch leaves of the profile.
    ContactFilter,
    /// What the shape of the wave itself does.
    WaveGeometry,
    /// Phase between dissipation and wear.
    PlaceOfWear,
    /// What wears the rail.
    Wear,
}

impl Joint {
    /// Every joint, in the order of tables.
    pub const ALL: [Self; 9] = [
        Self::Track,
        Self::Wheel,
        Self::Creepage,
        Self::Contact,
        Self::Conformity,
        Self::ContactFilter,
        Self::WaveGeometry,
        Self::PlaceOfWear,
        Self::Wear,
    ];

    /// Key in documents.
    pub fn key(self) -> &'static str {
        match self {
            Self::Track => "track",
            Self::Wheel => "wheel",
            Self::Creepage => "creepage",
            Self::Contact => "contact",
            Self::Conformity => "conformity",
            Self::ContactFilter => "contact_filter",
            Self::WaveGeometry => "wave_geometry",
            Self::PlaceOfWear => "place_of_wear",
            Self::Wear => "wear",
        }
    }

    /// Name in tables.
    pub fn name(self) -> String {
        self.key().replace('_', " ")
    }
}

/// What stands at each joint of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Joints {
    pub(crate) track: TrackJoint,
    pub(crate) wheel: WheelJoint,
    pub(crate) creepage: CreepageJoint,
    pub(crate) contact: ContactJoint,
    pub(crate) conformity: bool,
    pub(crate) contact_filter: bool,
    pub(crate) wave_geometry: bool,
    pub(crate) place_of_wear: PlaceOfWearJoint,
    pub(crate) wear: WearJoint,
}

impl Serialize for Joints {
    /// Key and words of each joint.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(Joint::ALL.map(|joint| (joint.key(), self.words(joint))))
    }
}

/// Rail and supports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum TrackJoint {
    /// Track of the case.
    Own,
    /// The paper's rail, without supports.
    FreeBeam,
    /// On the supports of the case, spread evenly.
    Continuous,
    /// On the supports of the case at discrete places.
    Discrete,
    /// Track of the case on discrete supports, growth in the mean over the bay.
    DiscreteMean,
    /// Ground that does not move.
    Rigid,
}

/// Wheel or wheelset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum WheelJoint {
    /// Wheel or wheelset of the case.
    Own,
    /// One wheel: a mass that turns so.
    Alone(Rotation),
    /// That of the case; where it has none, two of its wheels on a rigid axle.
    Wheelset,
    /// Wheelset of the case that turns evenly.
    EvenlyTurningWheelset,
    /// One with an elastic axle, on the rail under study.
    ElasticWheelset,
    /// One with an elastic axle, on both rails.
    ElasticWheelsetOnBothRails,
    /// The mass above the primary suspension on its spring.
    Sprung,
}

/// Steady creepage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum CreepageJoint {
    /// Steady creepage of the case.
    Own,
    /// Of the size of the case, along the rail alone.
    AlongTheRail,
    /// Of the size of the case, across the rail alone.
    AcrossTheRail,
    /// Along the rail, near saturation.
    NearSaturation,
}

/// Creep law and its response.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ContactJoint {
    /// The exact theory of non-steady rolling.
    Exact,
    /// The law of the case, quasi-static.
    QuasiStatic,
    /// The paper's law, quasi-static.
    Carter,
    /// The paper's law behind Mindlin's spring.
    SpringDashpot,
}

/// Phase between dissipation and wear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum PlaceOfWearJoint {
    /// Phase of the case, or that which the exact contact resolves.
    Own,
    /// Later than at the wheel centre, as in the figures of the paper.
    Lag,
    /// At the wheel centre.
    WheelCentre,
}

/// What wears the rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum WearJoint {
    /// Dissipated energy.
    Energy,
    /// The normal force.
    NormalForce,
}

impl Default for Joints {
    fn default() -> Self {
        Self::OURS
    }
}

impl Joints {
    /// What Riffel takes for right: the track and wheelset of the case, and the exact contact.
    pub const OURS: Self = Self {
        track: TrackJoint::Own,
        wheel: WheelJoint::Own,
        creepage: CreepageJoint::Own,
        contact: ContactJoint::Exact,
        conformity: true,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::Own,
        wear: WearJoint::Energy,
    };

    /// Joints with one joint of others.
    #[must_use]
    pub fn with(self, joint: Joint, of: Self) -> Self {
        let mut changed = self;
        match joint {
            Joint::Track => changed.track = of.track,
            Joint::Wheel => changed.wheel = of.wheel,
            Joint::Creepage => changed.creepage = of.creepage,
            Joint::Contact => changed.contact = of.contact,
            Joint::Conformity => changed.conformity = of.conformity,
            Joint::ContactFilter => changed.contact_filter = of.contact_filter,
            Joint::WaveGeometry => changed.wave_geometry = of.wave_geometry,
            Joint::PlaceOfWear => changed.place_of_wear = of.place_of_wear,
            Joint::Wear => changed.wear = of.wear,
        }
        changed
    }

    /// The joints that differ.
    pub fn differences(self, from: Self) -> impl Iterator<Item = Joint> {
        let joints = Joint::ALL.into_iter();
        joints.filter(move |&joint| self.with(joint, from) != self)
    }

    /// What stands at a joint.
    pub fn words(&self, joint: Joint) -> &'static str {
        match joint {
            Joint::Track => match self.track {
                TrackJoint::Own => "that of the case",
                TrackJoint::FreeBeam => "free Euler–Bernoulli beam",
                TrackJoint::Continuous => "rail and supports of the case, spread evenly",
                TrackJoint::Discrete => "rail and supports of the case, at discrete places",
                TrackJoint::DiscreteMean => "rail and supports of the case, at discrete places; mean over the bay",
                TrackJoint::Rigid => "rigid",
            },
            Joint::Wheel => match self.wheel {
                WheelJoint::Own => "that of the case",
                WheelJoint::Alone(Rotation::Inertia) => "one wheel: mass and rotational inertia",
                WheelJoint::Alone(Rotation::ConstantCreepage) => "one wheel: mass, turning evenly (constant creepage)",
                WheelJoint::Alone(Rotation::ConstantTangentialForce) => {
                    "one wheel: mass, turning freely (constant tangential force)"
                }
                WheelJoint::Wheelset => "wheelset of the case, or two of its wheels on a rigid axle",
                WheelJoint::EvenlyTurningWheelset => {
                    "wheelset of the case, or two of its wheels on a rigid axle; turning evenly (constant creepage)"
                }
                WheelJoint::ElasticWheelset => "elastic wheelset of the case",
                WheelJoint::ElasticWheelsetOnBothRails => "elastic wheelset of the case, on both rails",
                WheelJoint::Sprung => "mass above the primary suspension, on its spring",
            },
            Joint::Creepage => match self.creepage {
                CreepageJoint::Own => "that of the case",
                CreepageJoint::AlongTheRail => "longitudinal, of the size in the case",
                CreepageJoint::AcrossTheRail => "lateral, of the size in the case",
                CreepageJoint::NearSaturation => "longitudinal, at the tractive ratio 0.95",
            },
            Joint::Contact => match self.contact {
                ContactJoint::Exact => "half-space, non-steady (exact)",
                ContactJoint::QuasiStatic => "creep law of the case, quasi-static",
                ContactJoint::Carter => "Carter in three dimensions, quasi-static",
                ContactJoint::SpringDashpot => "Carter in three dimensions, spring and dashpot in series",
            },
            Joint::Conformity => match self.conformity {
                true => "that of the case",
                false => "none",
            },
            Joint::ContactFilter => match self.contact_filter {
                true => "mean of the profile over the patch",
                false => "none",
            },
            Joint::WaveGeometry => match self.wave_geometry {
                true => "slower over crests, and as curved as the wave",
                false => "none",
            },
            Joint::PlaceOfWear => match (self.place_of_wear, self.wear, self.contact) {
                (_, WearJoint::NormalForce, _) => "under the wheel centre",
                (_, _, ContactJoint::Exact) => "resolved in the patch",
                (PlaceOfWearJoint::Own, ..) => "as the case reads it",
                (PlaceOfWearJoint::Lag, ..) => "behind the wheel centre",
                (PlaceOfWearJoint::WheelCentre, ..) => "under the wheel centre",
            },
            Joint::Wear => match self.wear {
                WearJoint::Energy => "dissipated energy",
                WearJoint::NormalForce => "normal force",
            },
        }
    }
}
