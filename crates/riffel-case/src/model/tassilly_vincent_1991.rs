//! Tassilly & Vincent (1991).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};

/// A wheelset in a curve, on both rails.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "tassilly-vincent-1991",
    title: "Tassilly & Vincent 1991",
    source: "E. Tassilly, N. Vincent: A linear model for the corrugation of rails, J. Sound Vib. 150 (1991) 25; Rail \
             corrugations: analytical model and field tests, Wear 144 (1991) 163",
    joints: Joints {
        track: TrackJoint::Own,
        wheel: WheelJoint::ElasticWheelsetOnBothRails,
        creepage: CreepageJoint::Own,
        contact: ContactJoint::QuasiStatic,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::Own,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "steady creepages of a curve at both contacts of a wheelset",
        "frequency responses of wheelset and rails in all directions, six at the wheelset",
        "transversal wear at the first bending of a leading wheelset, longitudinal wear at the first torsion of a trailing \
         one",
    ],
    leaves_out: &["the delay of the contact"],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "its measured frequency responses: wheelset and track of the case stand in",
        "its creep law: that of the case stands in",
        "the profile of the opposite rail: that of the case, and smooth where it has none",
    ],
};
