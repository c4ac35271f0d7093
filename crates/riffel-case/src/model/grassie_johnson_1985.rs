//! Grassie & Johnson (1985).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};
use crate::file::Rotation;

/// Constant creepage: a control that levels most waves.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "grassie-johnson-1985",
    title: "Grassie & Johnson 1985",
    source: "S. L. Grassie, K. L. Johnson: Periodic microslip between a rolling wheel and a corrugated rail, Wear 101 \
             (1985)",
    joints: Joints {
        track: TrackJoint::Own,
        wheel: WheelJoint::Alone(Rotation::ConstantCreepage),
        creepage: CreepageJoint::AlongTheRail,
        contact: ContactJoint::Carter,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::Lag,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "the wheel turns evenly, so longitudinal creepage is constant",
        "the rail wears by the energy that the slip zone dissipates",
        "dissipation then keeps near the peak of the normal force, and most waves are levelled",
    ],
    leaves_out: &["rotational inertia of the wheel", "lateral creepage and spin"],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "its contact resolves the slip zone in time: the slopes of the steady law and a lag stand in",
        "its values of the track: that of the case stands in",
    ],
};
