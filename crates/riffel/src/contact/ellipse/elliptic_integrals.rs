//! Complete elliptic integrals by the arithmetic-geometric mean.

use std::f64::consts::PI;

use crate::Error;

/// Complete elliptic integrals of one modulus k, with the complementary modulus k' = √(1 − k²).
///
/// K = ∫₀^{π/2} (1 − k² sin²θ)^{−1/2} dθ and E = ∫₀^{π/2} (1 − k² sin²θ)^{1/2} dθ; the argument is
/// the modulus k, not the parameter m = k².
///
/// Method: the arithmetic-geometric mean of 1 and k' (Abramowitz & Stegun 1964, 17.6), whose error
/// is squared by every step: at most eight steps for k' ≥ 1e-8, thirteen for any k'. K, E and D
/// are accurate to 1e-15 relative, B to the part of it that the difference K − D leaves, 1e-14
/// for k' ≥ 1e-4. Beside K and E the method gives, without the difference of nearly equal numbers
/// at small k, the integrals D and B of which the half-axes of a Hertz contact are made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipticIntegrals {
    first_kind: f64,
    d: f64,
    complementary: f64,
}

impl EllipticIntegrals {
    /// The arithmetic-geometric mean has then converged for every k' that is a normal number.
    const MOST_STEPS: usize = 16;

    /// The integrals of modulus k \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 ≤ k < 1; K is infinite at k = 1.
    pub fn of_modulus(modulus: f64) -> Result<Self, Error> {
        if !(0.0..1.0).contains(&modulus) {
            return Err(Error::OutOfRange {
                quantity: "modulus of the elliptic integrals",
                value: modulus,
                unit: "",
                rule: "must be 0 or more and less than 1",
            });
        }
        Ok(Self::evaluate(((1.0 - modulus) * (1.0 + modulus)).sqrt()))
    }

    /// The integrals of complementary modulus k' = √(1 − k²) \[-\], the ratio of the short to the
    /// long axis of an ellipse of eccentricity k.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < k' ≤ 1; K is infinite at k' = 0.
    pub fn of_complementary_modulus(complementary_modulus: f64) -> Result<Self, Error> {
        if !(complementary_modulus > 0.0 && complementary_modulus <= 1.0) {
            return Err(Error::OutOfRange {
                quantity: "complementary modulus of the elliptic integrals",
                value: complementary_modulus,
                unit: "",
                rule: "must be greater than 0 and at most 1",
            });
        }
        Ok(Self::evaluate(complementary_modulus))
    }

    /// The integrals for 0 < k' ≤ 1.
    pub(crate) fn evaluate(complementary: f64) -> Self {
        let (mut arithmetic, mut geometric) = (1.0, complementary);
        // cₙ = (aₙ₋₁ − gₙ₋₁)/2, and cₙ²/k² without k, since k² = (1 − k')(1 + k').
        let mut difference = 0.5 * (1.0 - complementary);
        let mut square_over_modulus = 0.5 * difference / (1.0 + complementary);
        let mut weight = 1.0;
        // D/K = ½ + ½ Σ 2ⁿ cₙ²/k².
        let mut ratio = 0.5;
        for _ in 0..Self::MOST_STEPS {
            (arithmetic, geometric) = (0.5 * (arithmetic + geometric), (arithmetic * geometric).sqrt());
            ratio += weight * square_over_modulus;
            // The next difference is a quarter of the square of this one.
            if difference <= 1e-9 * arithmetic {
                break;
            }
            let shrink = 0.5 * difference / (arithmetic + geometric);
            square_over_modulus *= shrink * shrink;
            difference *= shrink;
            weight *= 2.0;
        }
        let first_kind = PI / (arithmetic + geometric);
        Self { first_kind, d: first_kind * ratio, complementary }
    }

    /// K \[-\], of the first kind.
    pub fn first_kind(&self) -> f64 {
        self.first_kind
    }

    /// E = B + k'² D \[-\], of the second kind.
    pub fn second_kind(&self) -> f64 {
        self.b() + self.complementary * self.complementary * self.d
    }

    /// D = (K − E)/k² \[-\]; π/4 at k = 0.
    pub fn d(&self) -> f64 {
        self.d
    }

    /// B = K − D = (E − k'² K)/k² \[-\]; π/4 at k = 0.
    pub fn b(&self) -> f64 {
        self.first_kind - self.d
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    #[test]
    fn circle_is_exact() {
        let integrals = EllipticIntegrals::of_modulus(0.0).unwrap();
        assert_eq!(integrals.first_kind(), FRAC_PI_2);
        assert_eq!(integrals.second_kind(), FRAC_PI_2);
        assert_eq!((integrals.b(), integrals.d()), (FRAC_PI_4, FRAC_PI_4));
    }

    /// Abramowitz & Stegun (1964), tables 17.1 and 17.2: m = k² = 0.5 and 0.9.
    #[test]
    fn tabulated_values() {
        for (parameter, first, second) in [
            (0.5_f64, 1.854_074_677_301_371_9, 1.350_643_881_047_675_5),
            (0.9, 2.578_092_113_348_173_2, 1.104_774_732_704_073_2),
        ] {
            let integrals = EllipticIntegrals::evaluate((1.0 - parameter).sqrt());
            assert_relative_eq!(integrals.first_kind(), first, max_relative = 1e-15);
            assert_relative_eq!(integrals.second_kind(), second, max_relative = 1e-15);
        }
    }

    /// k → 1: K = ln(4/k') + (ln(4/k') − 1) k'²/4, E = 1 + (ln(4/k') − ½) k'²/2, next terms k'⁴.
    #[test]
    fn slender_limit() {
        for complementary in [1e-4, 1e-6, 1e-9, 1e-100] {
            let integrals = EllipticIntegrals::of_complementary_modulus(complementary).unwrap();
            let (logarithm, square) = ((4.0 / complementary).ln(), complementary * complementary);
            let first = logarithm + (logarithm - 1.0) * square / 4.0;
            let second = 1.0 + (logarithm - 0.5) * square / 2.0;
            assert_relative_eq!(integrals.first_kind(), first, max_relative = 4e-15);
            assert_relative_eq!(integrals.second_kind(), second, max_relative = 1e-13);
        }
    }

    #[test]
    fn moduli_without_integrals_are_refused() {
        for modulus in [-0.1, 1.0, f64::NAN] {
            assert!(EllipticIntegrals::of_modulus(modulus).is_err());
        }
        for complementary in [0.0, 1.1, f64::NAN] {
            assert!(EllipticIntegrals::of_complementary_modulus(complementary).is_err());
        }
    }

    proptest! {
        /// Legendre: E K' + E' K − K K' = π/2. The three terms are up to 20 near the ends.
        #[test]
        fn legendre_relation(modulus in 1e-3..0.999_999f64) {
            let one = EllipticIntegrals::of_modulus(modulus).unwrap();
            let other = EllipticIntegrals::of_complementary_modulus(modulus).unwrap();
            let (k, e) = (one.first_kind(), one.second_kind());
            let (k_other, e_other) = (other.first_kind(), other.second_kind());
            assert_relative_eq!(
                e * k_other + e_other * k - k * k_other,
                FRAC_PI_2,
                epsilon = 3e-14
            );
        }

        /// K and E as the mean of their integrand over a period, which converges exponentially.
        #[test]
        fn quadrature(modulus in 0.0..0.99f64) {
            let points = 200;
            let mean = |power: f64| {
                (0..points)
                    .map(|i| {
                        let sine = (PI * f64::from(i) / f64::from(points)).sin();
                        (1.0 - (modulus * sine).powi(2)).powf(power)
                    })
                    .sum::<f64>()
                    / f64::from(points)
                    * FRAC_PI_2
            };
            let integrals = EllipticIntegrals::of_modulus(modulus).unwrap();
            assert_relative_eq!(integrals.first_kind(), mean(-0.5), max_relative = 1e-13);
            assert_relative_eq!(integrals.second_kind(), mean(0.5), max_relative = 1e-13);
        }
    }
}
