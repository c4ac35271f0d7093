//! Roughness levels.

/// Reference of roughness levels r₀ = 1 µm \[m\], EN 15610.
pub const REFERENCE_ROUGHNESS: f64 = 1e-6;

/// Least mean square \[m²\] that has a level: −3000 dB, below the rounding of any transform.
const LEAST: f64 = 1e-306;

/// Level 10 lg(r²/r₀²) \[dB re 1 µm\] of a mean square \[m²\]; nothing counts as −2940 dB.
pub fn level(mean_square: f64) -> f64 {
    10.0 * (mean_square.max(LEAST) / REFERENCE_ROUGHNESS.powi(2)).log10()
}

/// Mean square r₀² 10^(L/10) \[m²\] of a level \[dB re 1 µm\].
pub fn mean_square(level: f64) -> f64 {
    REFERENCE_ROUGHNESS.powi(2) * 10f64.powf(level / 10.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_micrometre_is_nought_decibels() {
        assert!(level(1e-12).abs() < 1e-12);
        // A sinusoid of 3 µm: 10 lg(9/2).
        assert!((level(0.5 * 3e-6 * 3e-6) - 6.532).abs() < 1e-3);
        for decibels in [-40.0, 0.0, 17.1] {
            assert!((level(mean_square(decibels)) - decibels).abs() < 1e-12);
        }
        assert!(level(0.0).is_finite());
    }
}
