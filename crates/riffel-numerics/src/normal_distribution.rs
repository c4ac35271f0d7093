//! Standard normal distribution.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2, TAU};

use statrs::function::erf::erfc_inv;

/// Standard deviations either way between which 50 % lies.
pub const HALF_OF_50: f64 = 0.674_489_750_196_081_7;
/// Standard deviations either way between which 80 % lies.
pub const HALF_OF_80: f64 = 1.281_551_565_544_600_4;
/// Standard deviations either way between which 95 % lies.
pub const HALF_OF_95: f64 = 1.959_963_984_540_054;

/// Probability Φ(z) of a number below z, to rounding also in the lower tail. Method: the complementary error function of `libm`,
/// as that of `statrs` 0.19 is right to 10⁻¹⁰ only.
pub fn below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}

/// Probability Φ(−z) of a number above z, to rounding also in the upper tail.
pub fn above(z: f64) -> f64 {
    below(-z)
}

/// Number z below which a share 0 < u < 1 lies, Φ⁻¹(u), to 10⁻¹⁴ in both tails.
pub fn quantile(u: f64) -> f64 {
    -SQRT_2 * erfc_inv(2.0 * u)
}

/// Probability density φ(z).
pub fn density(z: f64) -> f64 {
    (-0.5 * z * z).exp() / TAU.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz & Stegun (1964), tables 26.1, 26.2 and 26.5.
    #[test]
    fn values_are_those_of_the_tables() {
        let quantiles = [(0.5, 0.0), (0.75, HALF_OF_50), (0.9, HALF_OF_80), (0.975, HALF_OF_95)];
        for (u, z) in quantiles.into_iter().chain([(0.995, 2.575_829_303_548_901), (1e-6, -4.753_424_308_822_899)]) {
            assert!((quantile(u) - z).abs() < 1e-14, "{u}: {}", quantile(u));
        }
        assert!((below(1.0) - 0.841_344_746_068_543).abs() < 1e-15);
        assert!((above(5.0) / 2.866_515_719_e-7 - 1.0).abs() < 1e-9);
        assert!((density(1.0) - 0.241_970_724_519_143).abs() < 1e-15);
    }

    /// The probability itself is rounded, which weighs more the flatter it is.
    #[test]
    fn a_quantile_is_the_inverse() {
        for step in -70..=50 {
            let z = 0.1 * f64::from(step);
            let rounding = f64::EPSILON * below(z) / density(z);
            assert!((quantile(below(z)) - z).abs() < 1e-14 + 20.0 * rounding, "{z}");
        }
    }
}
