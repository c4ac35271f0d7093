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
