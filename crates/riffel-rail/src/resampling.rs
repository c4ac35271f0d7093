//! Heights at uneven positions, brought to even steps.

use riffel_numerics::cubic::{cubic_at, hermite};

/// Heights at `start`, `start + spacing` and so on up to the last position, by cubic interpolation between the samples
/// about each place: exact for parabolas whatever the steps, with an error of order (2πh/λ)³ for a wave of length λ in
/// steps of h. Positions rise; where a height is missing, those beside it are missing too.
///
/// The tangents are those of the parabola through a sample and its two neighbours (Hermite form; Bessel's tangents, de
/// Boor, *A Practical Guide to Splines*, 1978, chapter IV).
pub(super) fn resampled(positions: &[f64], heights: &[f64], spacing: f64) -> Vec<f64> {
    let (Some(&first), Some(&last)) = (positions.first(), positions.last()) else {
        return Vec::new();
    };
    // The last place may miss the last sample by rounding.
    let count = ((last - first) / spacing + 1e-6).floor() as usize + 1;
    let slope = |a: usize, b: usize| (heights[b] - heights[a]) / (positions[b] - positions[a]);
    let tangent = |at: usize| -> f64 {
        if at == 0 {
            return slope(0, 1);
        }
        if at + 1 == positions.len() {
            return slope(at - 1, at);
        }
        let (before, behind) = (positions[at] - positions[at - 1], positions[at + 1] - positions[at]);
        let (left, right) = (slope(at - 1, at), slope(at, at + 1));
        let parabola = (behind * left + before * right) / (before + behind);
        match (left.is_finite(), right.is_finite()) {
            (false, true) => right,
            (true, false) => left,
            _ => parabola,
        }
    };
    let mut at = 0;
    (0..count)
        .map(|sample| {
            let place = (first + sample as f64 * spacing).min(last);
            while at + 2 < positions.len() && positions[at + 1] <= place {
                at += 1;
            }
            if positions.len() < 2 {
                return heights[0];
            }
            let step = positions[at + 1] - positions[at];
            let t = (place - positions[at]) / step;
            let slopes = [step * tangent(at), step * tangent(at + 1)];
            cubic_at(hermite([heights[at], heights[at + 1]], slopes), t)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Steps of 1 mm with deterministic jitter of up to 0.3 mm either way.
    fn uneven(count: usize) -> Vec<f64> {
        let jitter = |n: usize| 0.3e-3 * (n as f64 * 12.9898).sin();
        (0..count).map(|n| 5.0 + 1e-3 * n as f64 + jitter(n)).collect()
    }

    /// A wave of 20 mm comes back with the error of the tangents, (2π/20)³/6 times a seventh; without resampling the error
    /// is that of the positions, 0.3 · 2π/20.
    #[test]
    fn a_wave_comes_back_from_uneven_positions() {
        let wave = |x: f64| (TAU * x / 0.02).sin();
        let positions = uneven(2000);
        let heights: Vec<f64> = positions.iter().map(|&x| wave(x)).collect();
        let even = resampled(&positions, &heights, 1e-3);
        let error = |heights: &[f64]| {
            let errors = heights.iter().enumerate().skip(2).take(1990);
            errors.map(|(n, height)| (height - wave(positions[0] + 1e-3 * n as f64)).abs()).fold(0.0, f64::max)
        };
        assert!(error(&even) < 5e-3, "{}", error(&even));
        assert!(error(&heights) > 5e-2);
    }

    #[test]
    fn parabolas_are_exact_and_missing_heights_stay_missing() {
        let positions = uneven(50);
        let parabola = |x: f64| 3.0 * (x - 5.0).powi(2) - (x - 5.0);
        let mut heights: Vec<f64> = positions.iter().map(|&x| parabola(x)).collect();
        let even = resampled(&positions, &heights, 1e-3);
        for (n, height) in even.iter().enumerate().skip(2).take(45) {
            assert!((height - parabola(positions[0] + 1e-3 * n as f64)).abs() < 1e-15);
        }
        heights[20] = f64::NAN;
        let missing = resampled(&positions, &heights, 1e-3);
        let count = missing.iter().filter(|height| height.is_nan()).count();
        assert!((1..=3).contains(&count), "{count}");
    }

    #[test]
    fn short_records_do_not_panic() {
        assert!(resampled(&[], &[], 1.0).is_empty());
        assert_eq!(resampled(&[2.0], &[7.0], 1.0), [7.0]);
        assert_eq!(resampled(&[0.0, 2.0], &[0.0, 2.0], 1.0), [0.0, 1.0, 2.0]);
    }
}
