//! Sums over all waves that a load at one place is made of.

use std::f64::consts::TAU;

use num_complex::Complex64;

use crate::Error;

/// ∫ f(k) dk/2π of several functions that decay on both sides, whose poles stand off the real axis.
///
/// Method: the trapezoidal rule, whose error falls exponentially once it resolves the decay of the waves; its step is cut
/// in three until that changes nothing that counts, so that what is left after it is the cube of the last change. No point of
/// the rule lies at k = 0, nor when a step is cut.
pub(super) struct QuadratureOverWavenumbers {
    /// First step \[1/m\].
    pub(super) first: f64,
    /// The functions are nothing beyond \[1/m\].
    pub(super) reach: f64,
    /// How often the step may be cut.
    pub(super) cuts: u32,
}

impl QuadratureOverWavenumbers {
    /// The integrals of as many functions as `count`: `add` adds their values at k to sums, and `is_enough` is shown the integrals
    /// before and after a cut.
    ///
    /// # Errors
    /// [`Error::UndampedWaves`] at the frequency told \[rad/s\] where the last cut is not enough.
    pub(super) fn integrals(
        &self,
        angular_frequency: f64,
        count: usize,
        mut add: impl FnMut(f64, &mut [Complex64]),
        is_enough: impl Fn(&[Complex64], &[Complex64]) -> bool,
    ) -> Result<Vec<Complex64>, Error> {
        let steps = (self.reach / self.first).ceil() as i64;
        let mut sums = vec![Complex64::ZERO; count];
        for index in -steps..steps {
            add((index as f64 + 0.5) * self.first, &mut sums);
        }
        let integrals =
            |sums: &[Complex64], step: f64| -> Vec<Complex64> { sums.iter().map(|sum| sum * (step / TAU)).collect() };
        let mut step = self.first;
        let mut before = integrals(&sums, step);
        for cut in 0..self.cuts {
            let steps = steps * 3i64.pow(cut);
            for index in -steps..steps {
                let middle = (index as f64 + 0.5) * step;
                add(middle - step / 3.0, &mut sums);
                add(middle + step / 3.0, &mut sums);
            }
            step /= 3.0;
            let now = integrals(&sums, step);
            if is_enough(&before, &now) {
                return Ok(now);
            }
            before = now;
        }
        Err(Error::UndampedWaves { frequency: angular_frequency / TAU })
    }
}
