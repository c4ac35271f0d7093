//! Bhaskar, Johnson, Wood & Woodhouse (1997).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};

/// Spring and dashpot at the contact, without inertia of rotation.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "bhaskar-1997",
    title: "Bhaskar et al. 1997",
    source: "A. Bhaskar, K. L. Johnson, G. D. Wood, J. Woodhouse: Wheel–rail dynamics with closely conformal contact, \
             parts 1 and 2, Proc. IMechE F 211 (1997)",
    joints: Joints {
        track: TrackJoint::Continuous,
        wheel: WheelJoint::EvenlyTurningWheelset,
        creepage: CreepageJoint::Own,
        contact: ContactJoint::SpringDashpot,
        conformity: true,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::WheelCentre,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "a track on pads, sleepers and ballast spread evenly",
        "the contact is a spring (Mindlin) and a dashpot (the slope of the steady law) in series in each direction",
        "the wheelset does not answer in rotation: creepage along the rail oscillates by geometry alone",
        "the contact moves across close profiles as `contact.conformity` of the case says; without it the contact stays",
    ],
    leaves_out: &[
        "rotational inertia of the wheelset",
        "discrete supports",
        "the work of a moment of spin",
        "the exact delay of the contact",
        "the roll of the wheel",
    ],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "profiles of wheel and rail, steady creepages and values of the track: those of the case stand in",
        "most of its results are with the dashpot alone, which is the quasi-static response",
    ],
};
