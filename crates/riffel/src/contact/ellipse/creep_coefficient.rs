//! Kalker's creep coefficient.

/// Longitudinal creep coefficient C₀₀ ≈ 2.84 + 1.2 a/b \[-\], equation (7).
///
/// `axis_ratio` is a/b, the semi-axis along the rail over the one across it. Range of validity:
/// ellipses that are not slender, at ν ≈ 0.3. Against Kalker (1990, table E.3) at ν = 0.3 the line is
/// −10 % to +5 % off for 0.5 ≤ a/b ≤ 3.3 (−3 % at the paper's own 1.59), −14 % at 0.2 and +11 % at 5.
pub fn creep_coefficient(axis_ratio: f64) -> f64 {
    2.84 + 1.2 * axis_ratio
}

#[cfg(test)]
mod tests {
    use super::creep_coefficient;

    /// Kalker (1990), table E.3, C₁₁: a/b, then ν = 0, 0.25 and 0.5.
    const TABLE: [[f64; 4]; 5] = [
        [0.5, 2.88, 3.62, 4.83],
        [1.0, 3.40, 4.12, 5.20],
        [1.0 / 0.6, 4.06, 4.78, 5.80],
        [2.0, 4.37, 5.10, 6.11],
        [1.0 / 0.3, 5.57, 6.34, 7.34],
    ];

    #[test]
    fn within_ten_percent_of_kalkers_table() {
        for [axis_ratio, at_000, at_025, at_050] in TABLE {
            // Quadratic interpolation of 1/C to ν = 0.3.
            let table = 1.0 / (-0.08 / at_000 + 0.96 / at_025 + 0.12 / at_050);
            let error = creep_coefficient(axis_ratio) / table - 1.0;
            assert!((-0.10..0.05).contains(&error), "a/b = {axis_ratio}: {error}");
        }
    }
}
