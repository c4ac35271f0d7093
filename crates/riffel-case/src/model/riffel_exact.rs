//! The case as this program takes it for right.

use super::FieldModel;
use super::joints::Joints;

/// The exact contact on the track and the wheelset of the case.
pub(super) static MODEL: FieldModel = FieldModel {
    name: "riffel",
    title: "Riffel, exact contact",
    source: "this program: track, wheelset and creepages of the case, non-steady rolling contact of the half-space \
             (Kalker 1990)",
    joints: Joints::OURS,
    assumptions: &[
        "track and wheelset are those of the case",
        "the contact is two elastic half-spaces in non-steady rolling; the patch says where the rail wears",
    ],
    leaves_out: &[
        "oscillation of the spin",
        "conformity: the contact does not move across the profiles",
        "what the passage of supports excites",
    ],
    not_given: &[],
};

/// Exact contact on waves that have a shape.
pub(super) static WITH_WAVES: FieldModel = FieldModel {
    name: "riffel-wave-geometry",
    title: "Riffel, exact contact and wave geometry",
    source: "this program: the same, and the wave's own geometry, by which the contact runs slower over crests (derived in the \
             chapter \"What the wave itself does\")",
    joints: Joints { wave_geometry: true, ..Joints::OURS },
    assumptions: &[
        "track and wheelset are those of the case",
        "the contact is two elastic half-spaces in non-steady rolling; the patch says where the rail wears",
        "a crest is rolled over more slowly and presses as a smaller wheel",
    ],
    leaves_out: &[
        "oscillation of the spin",
        "conformity: the contact does not move across the profiles",
        "what the passage of supports excites",
        "the direction of the normal force on the slope of a wave, unless the case has it",
    ],
    not_given: &[],
};
