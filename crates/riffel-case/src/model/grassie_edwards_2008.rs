//! Grassie & Edwards (2008).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};
use crate::file::Rotation;

/// Varying normal load under constant tangential load.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "grassie-edwards-2008",
    title: "Grassie & Edwards 2008",
    source: "S. L. Grassie, J. W. Edwards: Development of corrugation as a result of varying normal load, Wear 265 \
             (2008) 1150",
    joints: Joints {
        track: TrackJoint::Own,
        wheel: WheelJoint::Alone(Rotation::ConstantTangentialForce),
        creepage: CreepageJoint::AlongTheRail,
        contact: ContactJoint::Carter,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::WheelCentre,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "normal load varies under a tangential load that is constant",
        "dissipation varies with the creepage that the load asks for, by the steady law",
        "the P2 resonance, 50–100 Hz, or the pinned-pinned resonance, about 1000 Hz, fixes the frequency",
    ],
    leaves_out: &[
        "rotational inertia of the wheel",
        "the delay of the contact",
        "varying tangential load under constant normal load, its second case",
    ],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "the phase of the dissipation, which the paper does not check: that of the loop is taken, under the wheel centre",
        "its equations and values in full: only what Afferrante & Ciavarella (2009) report was at hand",
    ],
};
