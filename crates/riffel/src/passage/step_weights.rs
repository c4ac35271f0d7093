//! What a force that is linear over a step leaves of itself in an oscillation that decays.

use num_complex::Complex64;

/// ∫ e^{z(1−τ)} f dτ over a step of length one for f = 1 − τ and f = τ, and e^z.
pub(super) struct Weights {
    pub(super) decay: Complex64,
    pub(super) old: Complex64,
    pub(super) new: Complex64,
}

impl Weights {
    pub(super) fn new(z: Complex64) -> Self {
        /// Below, the closed forms lose more than six digits, and six terms of the series none.
        const SMALL: f64 = 0.01;
        let decay = z.exp();
        if z.norm() < SMALL {
            // Σ zᵏ/(k + 2)! and Σ (k + 1) zᵏ/(k + 2)!
            let (mut new, mut old) = (Complex64::ZERO, Complex64::ZERO);
            let mut term = Complex64::from(0.5);
            for k in 0..6 {
                new += term;
                old += f64::from(k + 1) * term;
                term *= z / f64::from(k + 3);
            }
            return Self { decay, old, new };
        }
        let square = z * z;
        Self { decay, old: ((z - 1.0) * decay + 1.0) / square, new: (decay - 1.0 - z) / square }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both sides of the change from series to closed form: a force of one gives (e^z − 1)/z.
    #[test]
    fn weights_of_a_constant_force() {
        for size in [1e-6, 9.9e-3, 1.01e-2, 0.5, 40.0] {
            for angle in [1.7, 2.5, std::f64::consts::PI] {
                let z = Complex64::from_polar(size, angle);
                let Weights { decay, old, new } = Weights::new(z);
                let exact = (0..40).rev().fold(Complex64::ZERO, |sum, k| (sum * z) / f64::from(k + 2) + 1.0);
                let exact = if size < 2.0 { exact } else { (decay - 1.0) / z };
                assert!((old + new - exact).norm() < 1e-10 * exact.norm(), "{z}");
            }
        }
    }
}
