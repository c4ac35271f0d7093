//! Displacement of the track under a force that is given from step to step.

use num_complex::Complex64;

use super::ImpulseResponse;

/// Displacement u(t) = ∫ g(t − τ) f(τ) dτ of a track at rest before, under a force that is linear over every step:
/// exact for g as a sum of decaying oscillations, with one complex number of memory for each.
#[derive(Debug, Clone)]
pub(super) struct TrackMotion {
    /// e^{ph} of each term.
    decay: Vec<Complex64>,
    /// What the force at the beginning and at the end of a step leaves in the next state.
    by_force: Vec<Complex64>,
    /// State of each term at the end of the step, but for the force there.
    states: Vec<Complex64>,
    /// Displacement by the force at the end of the step \[m/N\].
    by_new_force: f64,
}

impl TrackMotion {
    /// The track at rest, for steps of the given time \[s\].
    pub(super) fn new(response: &ImpulseResponse, step: f64) -> Self {
        let mut motion = Self {
            decay: Vec::new(),
            by_force: Vec::new(),
            states: Vec::new(),
            by_new_force: 0.0,
        };
        for (pole, residue) in response.terms() {
            let Weights { decay, old, new } = Weights::new(pole * step);
            let scale = residue * step;
            motion.decay.push(decay);
            motion.by_force.push(scale * (decay * new + old));
            motion.states.push(Complex64::ZERO);
            motion.by_new_force += (scale * new).re;
        }
        motion
    }

    /// Displacement by the force at the end of a step \[m/N\].
    pub(super) fn by_new_force(&self) -> f64 {
        self.by_new_force
    }

    /// A step begins with the force at its start; returns the displacement at its end but for the force there \[m\].
    pub(super) fn advance(&mut self, force: f64) -> f64 {
        let mut sum = 0.0;
        let constants = self.decay.iter().zip(&self.by_force);
        for (state, (decay, by_force)) in self.states.iter_mut().zip(constants) {
            *state = decay * *state + by_force * force;
            sum += state.re;
        }
        sum
    }
}

/// ∫ e^{z(1−τ)} f dτ over a step of length one for f = 1 − τ and f = τ, and e^z.
struct Weights {
    decay: Complex64,
    old: Complex64,
    new: Complex64,
}

impl Weights {
    fn new(z: Complex64) -> Self {
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
        Self {
            decay,
            old: ((z - 1.0) * decay + 1.0) / square,
            new: (decay - 1.0 - z) / square,
        }
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
                let exact = (0..40)
                    .rev()
                    .fold(Complex64::ZERO, |sum, k| (sum * z) / f64::from(k + 2) + 1.0);
                let exact = if size < 2.0 { exact } else { (decay - 1.0) / z };
                assert!((old + new - exact).norm() < 1e-10 * exact.norm(), "{z}");
            }
        }
    }
}
