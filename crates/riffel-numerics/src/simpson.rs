//! Quadrature by Simpson's rule.

/// Places from 0 to 1 with weights that sum to one, for an even number of equal panels: exact for cubics, with an error of
/// (1/panels)⁴/180 of the fourth derivative.
pub fn simpson(panels: usize) -> impl Iterator<Item = (f64, f64)> {
    debug_assert!(panels.is_multiple_of(2) && panels > 0);
    let count = panels as f64;
    (0..=panels).map(move |place| {
        let weight = match place {
            0 => 1.0,
            _ if place == panels => 1.0,
            _ if place % 2 == 1 => 4.0,
            _ => 2.0,
        };
        (place as f64 / count, weight / (3.0 * count))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ x³ = ¼, and ∫ x⁴ = ⅕ but for (1/panels)⁴ · 4!/180.
    #[test]
    fn powers_are_summed() {
        for panels in [2, 4, 16] {
            let sum = |power: i32| simpson(panels).map(|(x, weight)| weight * x.powi(power)).sum::<f64>();
            assert!((sum(0) - 1.0).abs() < 1e-15 && (sum(3) - 0.25).abs() < 1e-15);
            let error = 24.0 / 180.0 / (panels as f64).powi(4);
            assert!((sum(4) - 0.2 - error).abs() < 1e-15, "{panels}");
        }
    }
}
