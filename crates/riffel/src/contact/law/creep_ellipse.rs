//! The contact ellipse as a creep law sees it, and Kalker's linear theory on it.

use std::f64::consts::PI;

use super::{CreepForces, Creepages};
use crate::contact::KalkerCoefficients;
use crate::{Error, HertzContact};

/// Contact ellipse under a reference load, with Kalker's creep coefficients.
///
/// Under another load the semi-axes follow Hertz, a and b ∝ P^{1/3}; the coefficients depend on a/b
/// and Poisson's ratio alone and stay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepEllipse {
    /// Reference normal force P₀ \[N\].
    pub normal_force: f64,
    /// Semi-axis a₀ along the rail under P₀ \[m\].
    pub semi_axis_longitudinal: f64,
    /// Semi-axis b₀ across the rail under P₀ \[m\].
    pub semi_axis_lateral: f64,
    /// Shear modulus G of both bodies \[Pa\].
    pub shear_modulus: f64,
    /// Kalker's longitudinal creep coefficient C₁₁ \[-\].
    pub c11: f64,
    /// Kalker's lateral creep coefficient C₂₂ \[-\].
    pub c22: f64,
    /// Kalker's coefficient C₂₃ of the lateral force of spin \[-\].
    pub c23: f64,
}

impl CreepEllipse {
    /// The ellipse of a Hertz contact with its creep coefficients.
    pub fn new(hertz: HertzContact, kalker: KalkerCoefficients) -> Self {
        Self {
            normal_force: hertz.normal_force(),
            semi_axis_longitudinal: hertz.semi_axis_longitudinal(),
            semi_axis_lateral: hertz.semi_axis_lateral(),
            shear_modulus: hertz.material().shear_modulus(),
            c11: kalker.c11,
            c22: kalker.c22,
            c23: kalker.c23,
        }
    }

    /// An ellipse with the linear forces of given creep coefficients f₁₁, f₂₂ \[N\] and f₂₃ \[N m\] under the normal force
    /// P₀ \[N\]: f₁₁, f₂₂ ∝ P^{2/3}, f₂₃ ∝ P. Its size is a mere unit.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless f₁₁, f₂₂ and P₀ are positive and f₂₃ is not negative.
    pub fn of_coefficients(longitudinal: f64, lateral: f64, spin: f64, normal_force: f64) -> Result<Self, Error> {
        let ellipse = Self {
            normal_force,
            semi_axis_longitudinal: 1.0,
            semi_axis_lateral: 1.0,
            shear_modulus: 1.0,
            c11: longitudinal,
            c22: lateral,
            c23: spin,
        };
        ellipse.check()?;
        Ok(ellipse)
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        Error::unless_positive("normal force", self.normal_force, "N")?;
        Error::unless_positive("longitudinal semi-axis", self.semi_axis_longitudinal, "m")?;
        Error::unless_positive("lateral semi-axis", self.semi_axis_lateral, "m")?;
        Error::unless_positive("shear modulus", self.shear_modulus, "Pa")?;
        Error::unless_positive("creep coefficient C11", self.c11, "")?;
        Error::unless_positive("creep coefficient C22", self.c22, "")?;
        Error::unless_not_negative("creep coefficient C23", self.c23, "")
    }

    /// Ellipse under another normal force P > 0 \[N\].
    pub fn under(&self, normal_force: f64) -> Self {
        let scale = (normal_force / self.normal_force).cbrt();
        Self {
            normal_force,
            semi_axis_longitudinal: scale * self.semi_axis_longitudinal,
            semi_axis_lateral: scale * self.semi_axis_lateral,
            ..*self
        }
    }

    /// Area πab of the ellipse \[m²\].
    pub fn area(&self) -> f64 {
        PI * self.semi_axis_longitudinal * self.semi_axis_lateral
    }

    /// Kalker's linear theory \[N\]: F_x = G a b C₁₁ ξ, F_y = G a b (C₂₂ η + √(ab) C₂₃ φ).
    ///
    /// Source: Kalker (1967; 1990). Range of validity: vanishing slip. It knows no
    /// friction, and every other law of this crate starts with it and bends away below it.
    pub fn linear_forces(&self, creepages: Creepages) -> CreepForces {
        let [by_longitudinal, by_lateral] = self.linear_slopes();
        let product = self.semi_axis_longitudinal * self.semi_axis_lateral;
        CreepForces {
            longitudinal: by_longitudinal * creepages.longitudinal,
            lateral: by_lateral * creepages.lateral
                + self.shear_modulus * product * product.sqrt() * self.c23 * creepages.spin,
        }
    }

    /// \[∂F_x/∂ξ, ∂F_y/∂η\] of the linear theory \[N\].
    pub(super) fn linear_slopes(&self) -> [f64; 2] {
        let stiffness = self.shear_modulus * self.semi_axis_longitudinal * self.semi_axis_lateral;
        [stiffness * self.c11, stiffness * self.c22]
    }
}
