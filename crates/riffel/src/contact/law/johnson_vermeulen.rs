//! The cubic law of Vermeulen and Johnson for an elliptic patch.

use super::{CreepDerivatives, CreepEllipse, CreepForces, CreepLaw, Creepages, ForceLimit, ShenHedrickElkins};
use crate::Error;

/// Creep law of Vermeulen & Johnson, longitudinal and lateral, without spin.
///
/// |F| = μP \[1 − (1 − u/3)³\] for u ≤ 3, else μP, with u = G a b √((C₁₁ξ)² + (C₂₂η)²)/μP, in the
/// direction of Kalker's linear force. Vermeulen and Johnson write the slopes as π/Φ and π/Ψ₁, from
/// an elliptic stick region that touches the leading edge; Kalker's exact coefficients stand in for
/// them here, as has become usual. Spin is ignored.
///
/// Source: Vermeulen & Johnson (1964, Journal of Applied Mechanics 31, 338–340). Range of validity:
/// no spin. Deviation of Q/μP from CONTACT in pure longitudinal creepage at a/b = 1.59: −2.2 % to 0.
/// Test: `deviation_from_exact_theory_is_as_documented`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JohnsonVermeulen {
    cubic: ShenHedrickElkins,
}

impl JohnsonVermeulen {
    /// The law on an ellipse, with the coefficient of friction μ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all values are positive.
    pub fn new(ellipse: CreepEllipse, friction: f64) -> Result<Self, Error> {
        ShenHedrickElkins::new(ellipse, friction).map(|cubic| Self { cubic })
    }
}

/// Without spin Shen, Hedrick and Elkins is this law.
fn without_spin(creepages: Creepages) -> Creepages {
    Creepages { spin: 0.0, ..creepages }
}

impl CreepLaw for JohnsonVermeulen {
    fn friction(&self) -> f64 {
        self.cubic.friction()
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        self.cubic.forces(normal_force, without_spin(creepages))
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        self.cubic.derivatives(normal_force, without_spin(creepages))
    }

    fn limit(&self, normal_force: f64) -> ForceLimit {
        self.cubic.limit(normal_force)
    }
}

#[cfg(test)]
mod tests {
    use super::super::checks::{ELLIPSE, derivatives_match, grows_to_limit, stays_below_friction};
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn slopes_bounds_and_growth(
            force in 5e3..150e3, friction in 0.05..0.8, xi in -0.01..0.01, eta in -0.01..0.01,
        ) {
            let law = JohnsonVermeulen::new(ELLIPSE, friction).unwrap();
            let creepages = Creepages { longitudinal: xi, lateral: eta, spin: 0.0 };
            derivatives_match(&law, force, creepages, 1e-5, 1e-6);
            stays_below_friction(&law, force, creepages);
            grows_to_limit(&law, force);
        }

        /// Q/μP = 1 − (1 − ξ/ξ_max)³ in pure longitudinal creepage.
        #[test]
        fn is_the_cubic(force in 5e3..150e3, x in 0.0..1.0f64) {
            let law = JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap();
            let xi = x * law.limit(force).creepage();
            let ratio = law.forces(force, Creepages::longitudinal(xi)).longitudinal / (0.4 * force);
            assert_relative_eq!(ratio, 1.0 - (1.0 - x).powi(3), epsilon = 1e-14);
        }
    }
}
