//! What a patch of finite size feels of the curvature of a wave.

use riffel_numerics::spherical_bessel::spherical_bessel_functions;

use super::HertzContact;
use super::polynomial_punch::{PolynomialPunch, TERMS};
use crate::Error;

/// Largest ka for which [`TERMS`] are enough, a wave of a tenth of the semi-axis; from there on Φ is taken to fall as 1/ka.
const FARTHEST: f64 = 55.0;

/// Φ(ka): the share of the curvature k²Δ of a wave that an elliptic patch on half-spaces feels.
///
/// Under constant load a patch that slides everywhere leaves e₁/e₀ = R k²Φ Δ on the wave Δ cos kx, in phase with it. With S the tangent
/// operator of the normal contact, displacement to pressure, and φ = e^{ikx} over the patch,
/// P₀ R k²Φ = ⟨φ, Sφ⟩ − |⟨1, Sφ⟩|²/⟨1, S1⟩, never negative; one for long waves.
///
/// Method: e^{ikx} in polynomials of x that are orthogonal under the pressure of a flat punch, of which S makes itself over √(1 − ρ²):
///
/// ```text
/// Φ = (9/z²) Σ_{n ≥ 1} (s_n/s₁) j_n(z)²,   z = ka,   s_n = (2n + 1) 1ᵀ I_n⁻¹ 1
/// (I_n)_{mm'} = ∫ cos mψ cos m'ψ / √(b² cos²ψ/a² + sin²ψ) dψ over a turn,   m, m' = n, n − 2, … ≥ 0
/// ```
///
/// For a circle s_n/s₁ = (2n + 1)(n + 1)/6. Source: derived in the book, after L. A. Galin's theorem of polynomial punches. Error: 1e-12 up to
/// ka = 55.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvatureFilter {
    semi_axis: f64,
    /// 9 s_n/s₁ from n = 1 on.
    weights: Vec<f64>,
}

impl CurvatureFilter {
    /// The filter of an ellipse with the semi-axes a along and b across the rail \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn new(semi_axis_longitudinal: f64, semi_axis_lateral: f64) -> Result<Self, Error> {
        let (a, b) = (semi_axis_longitudinal, semi_axis_lateral);
        Error::unless_positive("semi-axis of the patch along the rail", a, "m")?;
        Error::unless_positive("semi-axis of the patch across the rail", b, "m")?;
        let stiffnesses = PolynomialPunch::new(a / b).stiffnesses();
        let weights = stiffnesses.iter().map(|stiffness| 9.0 * stiffness / stiffnesses[0]);
        Ok(Self { semi_axis: a, weights: weights.collect() })
    }

    /// The filter of a Hertz contact.
    ///
    /// # Errors
    /// None for a contact that is one.
    pub fn of(contact: &HertzContact) -> Result<Self, Error> {
        Self::new(contact.semi_axis_longitudinal(), contact.semi_axis_lateral())
    }

    /// Semi-axis a along the rail \[m\].
    pub fn semi_axis(&self) -> f64 {
        self.semi_axis
    }

    /// Φ \[-\] of a wave of the number k along the rail \[rad/m\].
    pub fn share(&self, wavenumber: f64) -> f64 {
        /// Below it the square of ka is rounding.
        const NOTHING: f64 = 1e-7;
        let z = wavenumber.abs() * self.semi_axis;
        if z < NOTHING {
            return 1.0;
        }
        let inside = z.min(FARTHEST);
        let functions = spherical_bessel_functions(inside, TERMS + 1);
        let terms = self.weights.iter().zip(&functions[1..]);
        let sum: f64 = terms.map(|(weight, j)| weight * j * j).sum();
        sum / (inside * inside) * (inside / z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_circle_has_whole_numbers() {
        let circle = CurvatureFilter::new(5e-3, 5e-3).unwrap();
        for (index, weight) in circle.weights.iter().enumerate() {
            let n = (index + 1) as f64;
            let exact = 1.5 * (2.0 * n + 1.0) * (n + 1.0);
            assert!((weight / exact - 1.0).abs() < 1e-10, "{n}");
        }
    }

    proptest! {
        /// Long waves are felt whole, none more, and the end of the series is no step.
        #[test]
        fn is_a_share(ratio in 0.05..20.0f64, z in 1e-6..200.0f64) {
            let filter = CurvatureFilter::new(1.0, 1.0 / ratio).unwrap();
            let share = filter.share(z);
            prop_assert!(share > 0.0 && share <= 1.0 + 1e-12);
            prop_assert!((filter.share(1e-3 * ratio.min(1.0)) - 1.0).abs() < 1e-5);
            let ends = [0.999, 1.001].map(|by| filter.share(by * FARTHEST));
            prop_assert!((ends[0] / ends[1] - 1.0).abs() < 0.02, "{:?}", ends);
        }
    }
}
