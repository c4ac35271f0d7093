//! Both, Hong & Kurtze (2001).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};

/// The washboard road.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "both-2001",
    title: "Both, Hong & Kurtze 2001",
    source: "J. A. Both, D. C. Hong, D. A. Kurtze: Corrugation of roads, Physica A 301 (2001) 545, \
             arXiv:cond-mat/0011510",
    joints: Joints {
        track: TrackJoint::Rigid,
        wheel: WheelJoint::Sprung,
        creepage: CreepageJoint::AlongTheRail,
        contact: ContactJoint::Carter,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::WheelCentre,
        wear: WearJoint::NormalForce,
    },
    assumptions: &[
        "a vehicle is a mass on a spring and a damper",
        "the surface yields in proportion to the normal force",
        "without damping all waves longer than speed over natural frequency grow",
    ],
    leaves_out: &[
        "the wave's own geometry",
        "creepage: tangential forces take no part",
        "rail and supports, which are rigid",
        "the mass below the spring",
    ],
    not_given: &[
        "how a rail yields to a force: the mean wear is that of the case",
        "diffusion of the material along the road, which a rail has none of",
    ],
};
