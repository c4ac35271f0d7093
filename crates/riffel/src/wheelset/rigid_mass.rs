//! The wheel as a concentrated mass.

use num_complex::Complex64;

use crate::tile::{Frequencies, SplitComplex};
use crate::{Error, Receptance};

/// Unsprung mass m_w, equation (25): H = −1/(m_w ω²).
///
/// Range of validity: above the primary suspension (some 10 Hz) and below the first bending of the
/// wheelset (some 60–100 Hz for an axle, where its modes begin to add narrow resonances).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidMass {
    mass: f64,
}

impl RigidMass {
    /// A mass \[kg\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is positive.
    pub fn new(mass: f64) -> Result<Self, Error> {
        Error::unless_positive("mass", mass, "kg")?;
        Ok(Self { mass })
    }

    /// Mass \[kg\].
    pub fn mass(&self) -> f64 {
        self.mass
    }
}

impl Receptance for RigidMass {
    #[inline]
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        Complex64::from(-1.0 / (self.mass * angular_frequency * angular_frequency))
    }

    fn receptances(&self, frequencies: &Frequencies, _speed: f64, receptances: &mut SplitComplex) {
        let per_mass = -self.mass.recip();
        receptances.set(&frequencies.reciprocal, |reciprocal| Complex64::from(per_mass * reciprocal * reciprocal));
    }

    fn free(&self) -> f64 {
        self.mass.recip()
    }
}
