//! Elkins, Grassie & Handal (1998).

use super::FieldModel;
use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};

/// Torsion of a driven wheelset near saturation.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "elkins-1998",
    title: "Elkins, Grassie & Handal 1998",
    source: "J. A. Elkins, S. L. Grassie, S. J. Handal: Rail corrugation mitigation in transit, TCRP Research Results \
             Digest 26 (1998); Vehicle System Dynamics 28 supplement (1998) 5",
    joints: Joints {
        track: TrackJoint::Own,
        wheel: WheelJoint::ElasticWheelset,
        creepage: CreepageJoint::NearSaturation,
        contact: ContactJoint::QuasiStatic,
        conformity: false,
        contact_filter: false,
        wave_geometry: false,
        place_of_wear: PlaceOfWearJoint::Own,
        wear: WearJoint::Energy,
    },
    assumptions: &[
        "a driven wheelset twists, with discs, gear and motor; its second torsion, about 300 Hz, fixes rutting",
        "creep is near saturation, as curving makes it",
        "the unsprung mass vibrates on the track",
    ],
    leaves_out: &["lateral creepage and spin", "the delay of the contact"],
    not_given: &[
        "the wave's own geometry: not found in what could be read of it, so none is taken",
        "a loop that tells growth: that of this program stands in",
        "how near to saturation: a tractive ratio of 0.95 is taken",
    ],
};
