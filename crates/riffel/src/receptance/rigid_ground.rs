//! A structure that does not move.

use num_complex::Complex64;

use super::Receptance;

/// Ground that no force moves: H = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RigidGround;

impl Receptance for RigidGround {
    fn receptance(&self, _angular_frequency: f64, _speed: f64) -> Complex64 {
        Complex64::ZERO
    }
}
