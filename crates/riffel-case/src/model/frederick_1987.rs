//! Frederick (1987).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};

/// Wear in the complex plane.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "frederick-1987",
    title: "Frederick 1987",
    source: "C. O. Frederick: A rail corrugation theory, in Contact Mechanics and Wear of Rail/Wheel Systems II, \
             University of Waterloo Press (1987)",
    joints: Joints {
        track: TrackJoint::Discrete,
        wheel: WheelJoint::Wheelset,
        creepage: CreepageJoint::Own,
        contact: ContactJoint::QuasiStatic,
        conformity: false,
        contact_filter: true,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::WheelCentre,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "small oscillations about a mean state, by complex transfer functions, along and across the rail",
        "a wave grows where its wear lies in the left half of the complex plane, and travels by the imaginary part",
        "sleepers make the difference: over one the rail is stiff downward and soft across",
        "a filter of the contact: below 1.5 lengths of the patch nothing is left",
    ],
    leaves_out: &["the delay of the contact"],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "details of wheelset and contact, which the paper draws crudely: those of the case stand in",
        "its values of track and creepage, and how its filter passes longer waves: that of the patch stands in",
    ],
};
