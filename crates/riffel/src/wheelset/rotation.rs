//! Rotation of the wheel under the oscillating tangential force.

use num_complex::Complex64;

use crate::{
    Error,
    tile::{Frequencies, SplitComplex},
};

/// Rotational response of a wheel at one frequency as the ratio Ω₁ : Q₁ = `lever` : `impedance`.
///
/// A ratio, because both limits of the inertia are of interest and either side may vanish: no
/// impedance holds the tangential force constant, no lever the angular velocity. Only the quotient
/// has a meaning; both must not be zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationRatio {
    /// Proportional to Ω₁; R for a rigid wheel \[m\].
    pub lever: Complex64,
    /// Proportional to Q₁; iωI_w for a rigid wheel \[kg m²/s\].
    pub impedance: Complex64,
}

/// Joint of the loop: how the angular velocity answers the tangential force.
///
/// Q acts on the wheel so that I dΩ/dt = (Q − Q₀)R, braking positive, equation (15).
pub trait WheelRotation: Send + Sync {
    /// Ω₁ : Q₁ at the angular frequency ω > 0 \[rad/s\].
    fn ratio(&self, angular_frequency: f64) -> RotationRatio;

    /// Ratios at a tile of frequencies.
    fn ratios(
        &self,
        frequencies: &Frequencies,
        levers: &mut SplitComplex,
        impedances: &mut SplitComplex,
    ) {
        levers.set(&frequencies.angular, |w| self.ratio(w).lever);
        impedances.set(&frequencies.angular, |w| self.ratio(w).impedance);
    }
}

/// Rigid wheel of inertia I_w, equation (16): iωI_w Ω₁ = Q₁R.
///
/// Range of validity: below the torsional modes of the wheelset, or where these are well damped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidInertia {
    inertia: f64,
    rolling_radius: f64,
}

impl RigidInertia {
    /// A wheel of inertia I_w \[kg m²\] and rolling radius R \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn new(inertia: f64, rolling_radius: f64) -> Result<Self, Error> {
        Error::unless_positive("inertia", inertia, "kg m2")?;
        Error::unless_positive("rolling radius", rolling_radius, "m")?;
        Ok(Self {
            inertia,
            rolling_radius,
        })
    }

    /// The paper's reduced inertia of a wheel of mass m_w \[kg\]: I_w = 0.75 m_w R²/2 \[kg m²\].
    pub fn reduced_inertia(mass: f64, rolling_radius: f64) -> f64 {
        0.75 * mass * rolling_radius * rolling_radius / 2.0
    }

    /// Inertia I_w \[kg m²\].
    pub fn inertia(&self) -> f64 {
        self.inertia
    }
}

impl WheelRotation for RigidInertia {
    #[inline]
    fn ratio(&self, angular_frequency: f64) -> RotationRatio {
        RotationRatio {
            lever: Complex64::from(self.rolling_radius),
            impedance: Complex64::new(0.0, angular_frequency * self.inertia),
        }
    }
}

/// Limit I_w → 0: the wheel follows every oscillation and the tangential force stays constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConstantTangentialForce;

impl WheelRotation for ConstantTangentialForce {
    #[inline]
    fn ratio(&self, _angular_frequency: f64) -> RotationRatio {
        RotationRatio {
            lever: Complex64::ONE,
            impedance: Complex64::ZERO,
        }
    }
}

/// Limit I_w → ∞: the wheel turns evenly and the creepage stays constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConstantCreepage;

impl WheelRotation for ConstantCreepage {
    #[inline]
    fn ratio(&self, _angular_frequency: f64) -> RotationRatio {
        RotationRatio {
            lever: Complex64::ZERO,
            impedance: Complex64::ONE,
        }
    }
}
