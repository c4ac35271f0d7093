//! The wheel as a rigid body that turns about its axle.

use num_complex::Complex64;

use crate::tile::{Frequencies, SplitComplex};
use crate::{Error, Receptance};

/// Rigid wheel of inertia I_w under a tangential force at its rim: H = −R²/(I_w ω²) \[m/N\] along the rail.
///
/// Equations (15) and (16), I dΩ/dt = (Q − Q₀)R with braking positive, seen at the contact, where the rim moves by
/// R times the angle. Range of validity: below the torsional modes of the wheelset, or where these are well damped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidInertia {
    /// −R²/I_w \[1/kg\].
    per_mass: f64,
    inertia: f64,
}

impl RigidInertia {
    /// A wheel of inertia I_w \[kg m²\] and rolling radius R \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn new(inertia: f64, rolling_radius: f64) -> Result<Self, Error> {
        Error::unless_positive("inertia", inertia, "kg m2")?;
        Error::unless_positive("rolling radius", rolling_radius, "m")?;
        Ok(Self { per_mass: -rolling_radius * rolling_radius / inertia, inertia })
    }

    /// Wheel whose hub moves along the rail as a mass \[kg\], too: H = −(R²/I_w + 1/m)/ω².
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is positive.
    pub fn with_moving_hub(self, mass: f64) -> Result<Self, Error> {
        Error::unless_positive("mass", mass, "kg")?;
        Ok(Self { per_mass: self.per_mass - mass.recip(), ..self })
    }

    /// The paper's reduced inertia of a wheel of mass m_w \[kg\]: I_w = 0.75 m_w R²/2 \[kg m²\].
    pub fn reduced_inertia(mass: f64, rolling_radius: f64) -> f64 {
        0.75 * mass * rolling_radius * rolling_radius / 2.0
    }

    /// Inertia I_w \[kg m²\].
    pub fn inertia(&self) -> f64 {
        self.inertia
    }

    /// I/R² \[kg\] where the hub stays, the mass that moves along the rail as the surface of the wheel does.
    pub fn mass_along(&self) -> f64 {
        -self.per_mass.recip()
    }
}

impl Receptance for RigidInertia {
    #[inline]
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        Complex64::from(self.per_mass / (angular_frequency * angular_frequency))
    }

    fn receptances(&self, frequencies: &Frequencies, _speed: f64, receptances: &mut SplitComplex) {
        receptances.set(&frequencies.reciprocal, |reciprocal| Complex64::from(self.per_mass * reciprocal * reciprocal));
    }

    fn free(&self) -> f64 {
        -self.per_mass
    }
}
