//! How the wheels of a wheelset roll.

use std::sync::Arc;

use super::{RunningSurfaces, TwoPoints};

/// How the wheels roll.
#[derive(Clone)]
pub enum Kinematics {
    /// Linear steering theory: cones of conicity λ \[-\] on a level plane, small angles, no flange. Source: Boocock (1969),
    /// Newland (1969).
    Linear {
        /// Conicity λ \[-\].
        conicity: f64,
    },
    /// Any running surfaces, yaw and rotation without linearisation.
    Nonlinear {
        /// Rolling radius and contact angle over lateral shift.
        surfaces: Arc<dyn RunningSurfaces>,
        /// In which plane the contact forces act.
        contact_plane: ContactPlane,
        /// A flange that is a spring without friction.
        flange: Option<FlangeSpring>,
    },
}

/// In which plane the contact forces act.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactPlane {
    /// In that of the track: the contact angle enters the spin alone.
    Horizontal,
    /// In that of the contact, under its angle.
    Tilted {
        /// Whether contacts that lie ahead of the axle have a yaw moment: a flange runs ahead, and a yawed axle carries
        /// its contacts along. Both nearly cancel.
        shift_moment: bool,
    },
}

/// A flange that meets its rail like a spring, without friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlangeSpring {
    /// Lateral shift that it leaves free \[m\], to either side.
    pub clearance: f64,
    /// Lateral stiffness beyond \[N/m\].
    pub stiffness: f64,
}

impl Kinematics {
    /// Shifts at which a wheel stands on two points.
    pub(super) fn two_points(&self) -> &[TwoPoints] {
        match self {
            Self::Linear { .. } => &[],
            Self::Nonlinear { surfaces, .. } => surfaces.two_points(),
        }
    }

    /// Lateral shift of the axle \[m\] at a shift \[m\] at the level of the rails; none off the track.
    pub(super) fn axle_shift(&self, shift: f64) -> Option<f64> {
        match self {
            Self::Linear { .. } => Some(shift),
            Self::Nonlinear { surfaces, .. } => surfaces.axle_shift(shift),
        }
    }

    /// Lateral force \[N\] of a flange that is a spring at a lateral shift \[m\].
    pub(super) fn flange_force(&self, lateral_shift: f64) -> f64 {
        match self {
            Self::Nonlinear { flange: Some(spring), .. } => {
                let beyond = (lateral_shift.abs() - spring.clearance).max(0.0);
                -spring.stiffness * beyond * lateral_shift.signum()
            }
            _ => 0.0,
        }
    }
}
