//! Afferrante & Ciavarella (2009).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};
use crate::file::Rotation;

/// A wheel that turns with its inertia, on a rail without resonances.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "afferrante-ciavarella-2009",
    title: "Afferrante & Ciavarella 2009",
    source: "L. Afferrante, M. Ciavarella: Corrugation models and the roaring rails enigma: a simple analytical contact \
             mechanics model based on a perturbation of Carter's solution (2009)",
    joints: Joints {
        track: TrackJoint::FreeBeam,
        wheel: WheelJoint::Alone(Rotation::Inertia),
        creepage: CreepageJoint::AlongTheRail,
        contact: ContactJoint::Carter,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::Lag,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "rotational inertia of the wheel couples normal force, tangential force and creepage",
        "the rail needs no resonance: a free beam, its asymptote above some 500 Hz",
        "the contact answers at once, by the slopes of its steady law",
        "dissipation at a point of the rail lags that at the wheel by a share of the patch",
    ],
    leaves_out: &[
        "the wave's own geometry",
        "supports of the rail",
        "lateral creepage and spin",
        "the delay of the contact",
        "the axle and the opposite wheel",
    ],
    not_given: &["the values of its second track, that of Bhaskar et al."],
};
