//! Directions and places of forces and displacements.

/// The direction of a force or a displacement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Along the rail, in the direction of travel.
    Longitudinal,
    /// Across the track, to the right.
    Lateral,
    /// Downward.
    Vertical,
}

impl Direction {
    /// All three, in the order x, y, z.
    pub const ALL: [Self; 3] = [Self::Longitudinal, Self::Lateral, Self::Vertical];
}

/// One of the two rails, as seen in the direction of travel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Rail {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

impl Rail {
    /// Left, then right.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// "left" or "right", as in documents and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }

    /// The rail on the other side.
    pub fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// −1 on the left, +1 on the right: the side of the track to which it lies.
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }
}

/// Where on a structure, and along which of its axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Distance along the rail \[m\], positive in the direction of travel.
    pub along: f64,
    /// The rail.
    pub rail: Rail,
    /// The axis.
    pub direction: Direction,
}
