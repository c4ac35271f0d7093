//! Carson & Johnson (1971).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};
use crate::file::Rotation;

/// Contact resonance.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "carson-johnson-1971",
    title: "Carson & Johnson 1971",
    source: "R. M. Carson, K. L. Johnson: Surface corrugations spontaneously generated in a rolling contact disc \
             machine, Wear 17 (1971) 59",
    joints: Joints {
        track: TrackJoint::Own,
        wheel: WheelJoint::Alone(Rotation::ConstantCreepage),
        creepage: CreepageJoint::AlongTheRail,
        contact: ContactJoint::Carter,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::WheelCentre,
        wear: WearJoint::NormalForce,
    },
    assumptions: &[
        "two bodies vibrate on the spring of their contact",
        "the surface yields in proportion to the normal force of the moment",
        "growth where the force is smallest on the crests, below the contact resonance",
    ],
    leaves_out: &[
        "the wave's own geometry",
        "creepage: tangential forces take no part",
        "the threshold of plastic flow",
    ],
    not_given: &[
        "a rail: the second disc is here the track of the case",
        "damping: waves that leave along the rail give it",
        "the rate of flow: the mean wear is that of the case",
    ],
};
