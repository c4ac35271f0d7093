//! Names of the natural modes of a wheelset.

use std::fmt;

/// What a natural mode is, in the field's words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ModeName {
    /// The wheelset moves on its suspension as a rigid body.
    RigidBody(RigidMotion),
    /// The axle bends.
    Bending {
        /// Deflection alike on both sides of the middle, or more so than opposite.
        symmetric: bool,
        /// From 1, among those of the same symmetry and plane.
        order: usize,
        /// The plane or planes.
        plane: BendingPlane,
    },
    /// The axle twists.
    Torsion {
        /// From 1.
        order: usize,
        /// How the discs between the wheels move, where they carry most of the energy.
        discs: Option<DiscMotion>,
    },
    /// The axle is stretched.
    Stretch {
        /// From 1.
        order: usize,
    },
    /// A mode of which only the motion of the contacts is known.
    Elastic {
        /// From 1.
        order: usize,
    },
}

/// A motion of a rigid wheelset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RigidMotion {
    /// Along the rail.
    Longitudinal,
    /// Across the track.
    Lateral,
    /// Up and down.
    Bounce,
    /// About the direction of travel.
    Roll,
    /// About the vertical.
    Yaw,
}

/// A plane of bending.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BendingPlane {
    /// Vertical and horizontal plane at one frequency: a double mode.
    Both,
    /// The vertical plane across the track.
    Vertical,
    /// The horizontal plane.
    Horizontal,
}

/// How discs between the wheels turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DiscMotion {
    /// Together, against the wheels.
    AgainstWheels,
    /// Against each other.
    AgainstEachOther,
}

impl fmt::Display for ModeName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::RigidBody(motion) => write!(f, "rigid body: {motion}"),
            Self::Bending { symmetric, order, plane } => {
                let symmetry = if symmetric { "symmetric" } else { "antisymmetric" };
                write!(f, "{} {symmetry} bending", Ordinal(order))?;
                f.write_str(match plane {
                    BendingPlane::Both => "",
                    BendingPlane::Vertical => ", vertical",
                    BendingPlane::Horizontal => ", horizontal",
                })
            }
            Self::Torsion { order, discs } => {
                write!(f, "{} torsion", Ordinal(order))?;
                f.write_str(match discs {
                    None => "",
                    Some(DiscMotion::AgainstWheels) => " (discs against wheels)",
                    Some(DiscMotion::AgainstEachOther) => " (discs against each other)",
                })
            }
            Self::Stretch { order } => write!(f, "{} stretch", Ordinal(order)),
            Self::Elastic { order } => write!(f, "{} elastic mode", Ordinal(order)),
        }
    }
}

impl fmt::Display for RigidMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Longitudinal => "longitudinal",
            Self::Lateral => "lateral",
            Self::Bounce => "bounce",
            Self::Roll => "roll",
            Self::Yaw => "yaw",
        })
    }
}

/// A number of order in words, as far as they are usual.
struct Ordinal(usize);

impl fmt::Display for Ordinal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const WORDS: [&str; 6] = ["first", "second", "third", "fourth", "fifth", "sixth"];
        let Self(order) = *self;
        match WORDS.get(order.wrapping_sub(1)) {
            Some(word) => f.write_str(word),
            None => {
                let ending = match (order % 10, order % 100 / 10) {
                    (1, tens) if tens != 1 => "st",
                    (2, tens) if tens != 1 => "nd",
                    (3, tens) if tens != 1 => "rd",
                    _ => "th",
                };
                write!(f, "{order}{ending}")
            }
        }
    }
}
