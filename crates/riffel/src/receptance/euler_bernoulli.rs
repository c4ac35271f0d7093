//! The paper's rail.

use crate::{ElasticMaterial, Error};

/// An infinite rail that bends without shear and without loss: bending stiffness EI and mass per
/// length m. A [`Beam`](super::Beam) is made of it by `into()`.
///
/// Range of validity: shear and rotary inertia soften a rail. Against a free Timoshenko beam of the
/// paper's rail (shear coefficient 0.4) the receptance is 9° and 2 % off at 500 Hz, 24° and 14 % at
/// 1500 Hz; the pinned-pinned frequency must not be taken from this beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerBernoulliBeam {
    bending_stiffness: f64,
    mass_per_length: f64,
}

impl EulerBernoulliBeam {
    /// A rail of second moment of area I \[m⁴\] and mass per length m \[kg/m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn new(material: ElasticMaterial, second_moment: f64, mass_per_length: f64) -> Result<Self, Error> {
        Error::unless_positive("second moment of area", second_moment, "m4")?;
        Error::unless_positive("mass per length", mass_per_length, "kg/m")?;
        Ok(Self { bending_stiffness: material.youngs_modulus() * second_moment, mass_per_length })
    }

    /// Bending stiffness EI \[N m²\].
    pub fn bending_stiffness(&self) -> f64 {
        self.bending_stiffness
    }

    /// Mass per length m \[kg/m\].
    pub fn mass_per_length(&self) -> f64 {
        self.mass_per_length
    }

    /// √(EI/m) \[m²/s\]: bending waves of angular frequency ω travel at √(ω √(EI/m)).
    pub(crate) fn dispersion(&self) -> f64 {
        (self.bending_stiffness / self.mass_per_length).sqrt()
    }

    /// (m³ EI)^{1/4}, the only combination of the two in the receptance of the free beam.
    pub(crate) fn fourth_root(&self) -> f64 {
        let m = self.mass_per_length;
        (m * m * m * self.bending_stiffness).sqrt().sqrt()
    }
}
