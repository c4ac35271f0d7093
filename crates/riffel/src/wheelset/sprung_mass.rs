//! A mass on a spring that rolls on the surface.

use std::f64::consts::PI;

use num_complex::Complex64;

use crate::{Error, Receptance};

/// A mass m that rides on a spring k and a damper c in parallel, whose lower end follows the surface:
/// H = 1/(k + iωc) − 1/(mω²).
///
/// On a rigid surface of the profile Δ, upward, it presses with P₁ = Δ/H = −mω²(k + iωc)/(k − mω² + iωc) Δ.
///
/// Source: J. A. Both, D. C. Hong, D. A. Kurtze, *Physica A* 301 (2001), a vehicle on a washboard road. Range of
/// validity: no mass below the spring, so frequencies at which the inertia of the wheel is small against k.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SprungMass {
    mass: f64,
    stiffness: f64,
    damping: f64,
}

impl SprungMass {
    /// A mass \[kg\] on a stiffness \[N/m\] and a viscous damping \[N s/m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless mass and stiffness are positive and the damping is not negative.
    pub fn new(mass: f64, stiffness: f64, damping: f64) -> Result<Self, Error> {
        Error::unless_positive("sprung mass", mass, "kg")?;
        Error::unless_positive("stiffness of its spring", stiffness, "N/m")?;
        if !(0.0..f64::INFINITY).contains(&damping) {
            return Err(Error::OutOfRange {
                quantity: "damping of its spring",
                value: damping,
                unit: "N s/m",
                rule: "must be zero or more",
            });
        }
        Ok(Self { mass, stiffness, damping })
    }

    /// Natural frequency √(k/m)/2π \[Hz\] on a surface at rest, without damping.
    pub fn natural_frequency(&self) -> f64 {
        (self.stiffness / self.mass).sqrt() / (2.0 * PI)
    }
}

impl Receptance for SprungMass {
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        let spring = Complex64::new(self.stiffness, angular_frequency * self.damping);
        spring.inv() - 1.0 / (self.mass * angular_frequency * angular_frequency)
    }

    fn free(&self) -> f64 {
        self.mass.recip()
    }
}
