//! Names of the natural modes of a wheelset, in words.

use riffel::wheelset::{BendingPlane, DiscMotion, ModeName, RigidMotion};
use riffel_keys::{Message, say};

/// The name of a mode; its English is what the physics displays.
pub fn mode_in_words(name: &ModeName) -> Message {
    let ordinal = |order: usize| say!(ordinal, order);
    match *name {
        ModeName::RigidBody(motion) => match motion {
            RigidMotion::Longitudinal => say!(rigid_body_longitudinal),
            RigidMotion::Lateral => say!(rigid_body_lateral),
            RigidMotion::Bounce => say!(rigid_body_bounce),
            RigidMotion::Roll => say!(rigid_body_roll),
            RigidMotion::Yaw => say!(rigid_body_yaw),
        },
        ModeName::Bending { symmetric, order, plane } => {
            let bending = match symmetric {
                true => say!(symmetric_bending, ordinal = ordinal(order)),
                false => say!(antisymmetric_bending, ordinal = ordinal(order)),
            };
            match plane {
                BendingPlane::Both => bending,
                BendingPlane::Vertical => say!(mode_vertical, mode = bending),
                BendingPlane::Horizontal => say!(mode_horizontal, mode = bending),
            }
        }
        ModeName::Torsion { order, discs } => {
            let torsion = say!(torsional_mode, ordinal = ordinal(order));
            match discs {
                None => torsion,
                Some(DiscMotion::AgainstWheels) => say!(discs_against_wheels, mode = torsion),
                Some(DiscMotion::AgainstEachOther) => {
                    say!(discs_against_each_other, mode = torsion)
                }
            }
        }
        ModeName::Stretch { order } => say!(stretching_mode, ordinal = ordinal(order)),
        ModeName::Elastic { order } => say!(elastic_mode, ordinal = ordinal(order)),
        ref other => Message::verbatim(other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_keys::Language;

    #[test]
    fn every_mode_is_called_as_in_the_physics() {
        let mut names = Vec::new();
        for order in (1..=24).chain([31, 42]) {
            for symmetric in [true, false] {
                for plane in [BendingPlane::Both, BendingPlane::Vertical, BendingPlane::Horizontal] {
                    names.push(ModeName::Bending { symmetric, order, plane });
                }
            }
            for discs in [None, Some(DiscMotion::AgainstWheels), Some(DiscMotion::AgainstEachOther)] {
                names.push(ModeName::Torsion { order, discs });
            }
            names.extend([ModeName::Stretch { order }, ModeName::Elastic { order }]);
        }
        let motions =
            [RigidMotion::Longitudinal, RigidMotion::Lateral, RigidMotion::Bounce, RigidMotion::Roll, RigidMotion::Yaw];
        names.extend(motions.map(ModeName::RigidBody));
        for name in names {
            let words = mode_in_words(&name);
            assert_eq!(words.to_string(), name.to_string());
            assert_ne!(words.text(Language::German), name.to_string());
        }
    }
}
