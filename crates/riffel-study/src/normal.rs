//! The standard normal distribution.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use statrs::function::erf::{erfc, erfc_inv};

/// Φ(z).
pub fn cumulative(z: f64) -> f64 {
    0.5 * erfc(-z * FRAC_1_SQRT_2)
}

/// Φ⁻¹(u) for 0 < u < 1, good to rounding in both tails.
pub fn quantile(u: f64) -> f64 {
    -SQRT_2 * erfc_inv(2.0 * u)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of Abramowitz & Stegun (1964), Table 26.5, and the inverse against the function itself.
    #[test]
    fn quantiles_and_probabilities_agree() {
        for (u, z) in
            [(0.5, 0.0), (0.975, 1.959_963_984_540_054), (0.995, 2.575_829_303_548_901), (1e-6, -4.753_424_308_822_899)]
        {
            assert!((quantile(u) - z).abs() < 1e-9, "{u}: {}", quantile(u));
        }
        for step in -70..=70 {
            let z = 0.1 * f64::from(step);
            let u = cumulative(z);
            // The probability itself is rounded, which weighs more the flatter it is.
            let rounding = 1e-16 / (-0.5 * z * z).exp().max(1e-300);
            if z < 5.0 {
                assert!((quantile(u) - z).abs() < 1e-9 + 10.0 * rounding, "{z}");
            }
        }
    }
}
