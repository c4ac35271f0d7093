//! Motion of the wheel's surface in the plane of contact.

use std::sync::Arc;

use num_complex::Complex64;

use crate::Receptance;
use crate::tile::{Frequencies, SplitComplex};

/// How the surface of a wheel moves along one axis of creepage under the oscillating creep force.
///
/// The creepage that belongs to a receptance H along the axis is ξ₁ = −iωH Q₁/V. Both limits are of interest, and
/// neither is a number: they are constraints.
#[derive(Clone, Default)]
pub enum Motion<Compliance = Arc<dyn Receptance>> {
    /// The surface yields by a receptance \[m/N\].
    Compliant(Compliance),
    /// The surface keeps its speed, and the creepage is constant: a wheel of infinite inertia.
    #[default]
    Held,
    /// The surface follows every oscillation, and the creep force is constant: a wheel without inertia.
    Free,
}

/// Oscillation of creep force and of the speed of the surface as a ratio, Q₁ : iωu₁.
///
/// A ratio, because either side may vanish.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ForceToSpeed {
    /// Share of the force: one, or zero where the force is constant.
    pub(crate) force: f64,
    /// Share of the speed \[m/s per N, or any\].
    pub(crate) speed: Complex64,
}

impl Motion {
    /// A surface that yields by a receptance.
    pub fn compliant(structure: impl Receptance + 'static) -> Self {
        Self::Compliant(Arc::new(structure))
    }

    /// The ratio at one frequency ω \[rad/s\] and speed of travel \[m/s\].
    pub(crate) fn ratio(&self, angular_frequency: f64, speed: f64) -> ForceToSpeed {
        let speed = match self {
            Self::Compliant(structure) => {
                Complex64::new(0.0, angular_frequency) * structure.receptance(angular_frequency, speed)
            }
            Self::Held => Complex64::ZERO,
            Self::Free => Complex64::ONE,
        };
        ForceToSpeed { force: self.force(), speed }
    }

    /// The share of the force, whatever the frequency.
    pub(crate) fn force(&self) -> f64 {
        match self {
            Self::Compliant(_) | Self::Held => 1.0,
            Self::Free => 0.0,
        }
    }

    /// The shares of the speed at a tile of frequencies.
    pub(crate) fn speeds(&self, frequencies: &Frequencies, speed: f64, speeds: &mut SplitComplex) {
        match self {
            Self::Compliant(structure) => {
                structure.receptances(frequencies, speed, speeds);
                let parts = speeds.re.iter_mut().zip(&mut speeds.im);
                for ((re, im), angular) in parts.zip(&frequencies.angular) {
                    (*re, *im) = (-angular * *im, angular * *re);
                }
            }
            Self::Held => *speeds = SplitComplex::ZERO,
            Self::Free => speeds.set(&frequencies.angular, |_| Complex64::ONE),
        }
    }
}
