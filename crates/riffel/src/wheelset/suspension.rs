//! The primary suspension between wheelset and bogie frame.

use num_complex::Complex64;

use crate::{Direction, Error};

/// Springs and dampers of the primary suspension, alike on both sides, from the axle's centre line at (0, ±s_b, 0) to a
/// frame at rest. They do not resist the spin of the axle.
///
/// Range of validity: above the modes of the bogie frame (some 10 Hz), where the frame stands still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Suspension {
    stiffness: [f64; 3],
    damping: [f64; 3],
    half_spacing: f64,
}

impl Suspension {
    /// Stiffness \[N/m\] and viscous damping \[N s/m\] of one side along x, y, z, and the distance 2s_b between the sides
    /// \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if a stiffness or a damping is negative or the spacing is not positive.
    pub fn new(stiffness: [f64; 3], damping: [f64; 3], spacing: f64) -> Result<Self, Error> {
        for value in stiffness {
            Error::unless_not_negative("suspension stiffness", value, "N/m")?;
        }
        for value in damping {
            Error::unless_not_negative("suspension damping", value, "N s/m")?;
        }
        Error::unless_positive("suspension spacing", spacing, "m")?;
        Ok(Self { stiffness, damping, half_spacing: 0.5 * spacing })
    }

    /// Half the distance of the two sides, s_b \[m\].
    pub(super) fn half_spacing(&self) -> f64 {
        self.half_spacing
    }

    /// Stiffness \[N/m\] and damping \[N s/m\] of one side along an axis.
    pub(super) fn along(&self, direction: Direction) -> [f64; 2] {
        let axis = direction as usize;
        [self.stiffness[axis], self.damping[axis]]
    }

    /// Dynamic stiffness k + iωc of one side along an axis \[N/m\].
    pub(super) fn dynamic_stiffness(&self, direction: Direction, w: f64) -> Complex64 {
        let [stiffness, damping] = self.along(direction);
        Complex64::new(stiffness, w * damping)
    }
}
