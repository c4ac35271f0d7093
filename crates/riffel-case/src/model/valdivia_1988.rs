//! Valdivia (1988).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};

/// Lateral creepage and a contact filter.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "valdivia-1988",
    title: "Valdivia 1988",
    source: "A. Valdivia: Die Wechselwirkung von hochfrequenter Rad-Schiene-Dynamik und ungleichförmigem \
             Schienenverschleiß, VDI-Fortschritt-Berichte 12/93 (1988); 10th IAVSD Symposium (1988)",
    joints: Joints {
        track: TrackJoint::Continuous,
        wheel: WheelJoint::Wheelset,
        creepage: CreepageJoint::AcrossTheRail,
        contact: ContactJoint::Exact,
        conformity: false,
        contact_filter: true,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::Own,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "vertical and lateral dynamics; steady creepage is lateral",
        "the contact answers late, and its patch takes the mean of the profile: below 1.5 lengths of the patch nothing is \
         left",
        "wear by frictional work",
    ],
    leaves_out: &["longitudinal creepage and spin", "rotation of the wheel"],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "his coefficients of the non-steady contact: the exact theory stands in",
        "his track, wheel and creepage: those of the case stand in, supports spread evenly",
        "whether he goes beyond linear equations: Afferrante & Ciavarella (2009) name him among the linear models",
    ],
};
