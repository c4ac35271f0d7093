//! Free infinite beam under a stationary load.

use std::f64::consts::FRAC_1_SQRT_2;

use num_complex::Complex64;

use super::{EulerBernoulliBeam, Frequencies, Receptance};
use crate::tile::SplitComplex;

/// Infinite Euler–Bernoulli beam without support, equation (23):
/// H = e^{−3πi/4} / (2√2 (m³ EI)^{1/4} ω^{3/2}).
///
/// Source: Afferrante & Ciavarella (2009, equation 23). Range of validity: above the resonances of
/// rail on pad and sleeper, in practice above about 500 Hz, and below the frequencies at which the
/// rail shears. Exact to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeBeam {
    /// Real part times ω^{3/2}; the imaginary part is the same.
    coefficient: f64,
}

impl FreeBeam {
    /// The rail without support.
    pub fn new(beam: EulerBernoulliBeam) -> Self {
        Self { coefficient: -FRAC_1_SQRT_2 / (2.0 * 2f64.sqrt() * beam.fourth_root()) }
    }
}

impl Receptance for FreeBeam {
    #[inline]
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        let part = self.coefficient / (angular_frequency * angular_frequency.sqrt());
        Complex64::new(part, part)
    }

    fn receptances(&self, frequencies: &Frequencies, _speed: f64, receptances: &mut SplitComplex) {
        receptances.set(&frequencies.reciprocal, |reciprocal| {
            let part = self.coefficient * reciprocal * reciprocal.sqrt();
            Complex64::new(part, part)
        });
    }
}
