//! Hempelmann & Knothe (1996).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};

/// Lateral creepage, exact contact, sleepers in the mean.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "hempelmann-knothe-1996",
    title: "Hempelmann & Knothe 1996",
    source: "K. Hempelmann, K. Knothe: An extended linear model for the prediction of short pitch corrugation, Wear 191 \
             (1996) 161",
    joints: Joints {
        track: TrackJoint::DiscreteMean,
        wheel: WheelJoint::Wheelset,
        creepage: CreepageJoint::AcrossTheRail,
        contact: ContactJoint::Exact,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::Own,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "vertical and lateral dynamics; steady creepage is lateral",
        "the contact answers by complex coefficients of the exact theory (Groß-Thebing)",
        "supports at discrete places, their growth in the mean over the bay; no parametric excitation",
    ],
    leaves_out: &["longitudinal creepage and spin", "rotation of the wheel"],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "its rail of several beams and its wheel of modes: rail and wheelset of the case stand in, so its high lateral \
         resonances are missing unless the case has them",
        "its creepage and values of the track",
    ],
};
