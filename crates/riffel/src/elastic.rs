//! The elastic material of wheel and rail.

use crate::Error;

/// A linear elastic, isotropic material; wheel and rail are made of the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticMaterial {
    youngs_modulus: f64,
    poisson_ratio: f64,
}

impl ElasticMaterial {
    /// A material of Young's modulus E \[Pa\] and Poisson's ratio ν \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless E > 0 and −1 < ν < 0.5, the range in which the strain energy
    /// of a compressible solid is positive.
    pub fn new(youngs_modulus: f64, poisson_ratio: f64) -> Result<Self, Error> {
        Error::unless_positive("Young's modulus", youngs_modulus, "Pa")?;
        if !(poisson_ratio > -1.0 && poisson_ratio < 0.5) {
            return Err(Error::OutOfRange {
                quantity: "Poisson's ratio",
                value: poisson_ratio,
                unit: "",
                rule: "must lie between -1 and 0.5",
            });
        }
        Ok(Self { youngs_modulus, poisson_ratio })
    }

    /// Young's modulus E \[Pa\].
    pub fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    /// Poisson's ratio ν \[-\].
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// Shear modulus G = E / 2(1 + ν) \[Pa\].
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }
}
