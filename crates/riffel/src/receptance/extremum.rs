//! Peaks and dips of a receptance that is known by its values alone.

use num_complex::Complex64;

use riffel_numerics::normal_distribution::HALF_OF_50;

/// Least height of a peak over the higher of the two saddles beside it \[dB\]: less is within what an amplitude
/// of a hammer test is good to.
const PROMINENCE: f64 = 1.0;

/// Least height of a peak in scatters of a line: noise of ten thousand lines spans less.
const PROMINENCE_IN_SCATTERS: f64 = 8.0;

/// Half the power \[dB\].
const HALF_POWER: f64 = 3.010_299_956_639_812;

/// A peak or a dip of a receptance.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Extremum {
    /// Angular frequency ω \[rad/s\]: the vertex of the parabola through three lines, of the level over ln ω.
    pub angular_frequency: f64,
    /// Receptance at the line nearest to it \[m/N\].
    pub receptance: Complex64,
    /// Damping ratio ζ = Δω/2ω \[-\], Δω the width at half power, or at twice the power of a dip. `None` if the level does not change
    /// as far on both sides, or where the width is below two distances of lines.
    pub damping_ratio: Option<f64>,
    /// Distance of the lines there \[rad/s\].
    pub resolution: f64,
}

impl Extremum {
    /// Peaks of the modulus over lines (ω, H) with rising ω, lowest first.
    ///
    /// A peak stands at least 1 dB over its saddles, and eight times the scatter of one line, which the fourth
    /// differences of the level tell. The first and the last line are none.
    ///
    /// Cost: one look at each line, and for each local maximum one at those up to the next higher line.
    pub fn peaks(lines: &[(f64, Complex64)]) -> Vec<Self> {
        Self::find(lines, 1.0)
    }

    /// Dips of the modulus (antiresonances), as [`peaks`](Self::peaks) of its reciprocal.
    pub fn dips(lines: &[(f64, Complex64)]) -> Vec<Self> {
        Self::find(lines, -1.0)
    }

    fn find(lines: &[(f64, Complex64)], sign: f64) -> Vec<Self> {
        let levels: Vec<f64> =
            lines.iter().map(|(_, h)| sign * 20.0 * h.norm().max(f64::MIN_POSITIVE).log10()).collect();
        let least = PROMINENCE.max(PROMINENCE_IN_SCATTERS * scatter(&levels));
        (1..lines.len().saturating_sub(1))
            .filter(|&at| levels[at] > levels[at - 1] && levels[at] >= levels[at + 1])
            .filter(|&at| prominence(&levels, at) >= least)
            .map(|at| Self::at(lines, &levels, at))
            .collect()
    }

    fn at(lines: &[(f64, Complex64)], levels: &[f64], at: usize) -> Self {
        let place = |line: usize| lines[line].0.ln();
        let [x0, x1, x2] = [place(at - 1), place(at), place(at + 1)];
        let rise = (levels[at] - levels[at - 1]) / (x1 - x0);
        let fall = (levels[at + 1] - levels[at]) / (x2 - x1);
        let curvature = (fall - rise) / (x2 - x0);
        let vertex = (0.5 * (x0 + x1) - 0.5 * rise / curvature).clamp(x0, x2);
        let angular_frequency = vertex.exp();
        let resolution = 0.5 * (lines[at + 1].0 - lines[at - 1].0);
        let half = levels[at] - HALF_POWER;
        // Where the level has fallen by half, from the line before there to the one beyond.
        let crossing = |inner: usize, outer: usize| {
            let share = (levels[inner] - half) / (levels[inner] - levels[outer]);
            (place(inner) + share * (place(outer) - place(inner))).exp()
        };
        let is_over = |line: &usize| levels[*line] > levels[at];
        let is_below = |line: &usize| levels[*line] <= half;
        let left = (0..at).rev().find(|line| is_over(line) || is_below(line));
        let right = (at + 1..levels.len()).find(|line| is_over(line) || is_below(line));
        let width = match (left.filter(is_below), right.filter(is_below)) {
            (Some(left), Some(right)) => Some(crossing(right - 1, right) - crossing(left + 1, left)),
            _ => None,
        };
        Self {
            angular_frequency,
            receptance: lines[at].1,
            damping_ratio: width
                .filter(|width| *width >= 2.0 * resolution)
                .map(|width| 0.5 * width / angular_frequency),
            resolution,
        }
    }
}

/// Height over the higher of the two lowest levels that lie between a line and a higher one, or the end.
fn prominence(levels: &[f64], at: usize) -> f64 {
    let lowest = |side: &mut dyn Iterator<Item = &f64>| {
        side.take_while(|&&level| level <= levels[at]).fold(levels[at], |low, &level| low.min(level))
    };
    let left = lowest(&mut levels[..at].iter().rev());
    let right = lowest(&mut levels[at + 1..].iter());
    levels[at] - left.max(right)
}

/// Standard deviation of one level \[dB\], if neighbours scatter on their own: from the median of the fourth
/// differences, which a smooth curve leaves small and a few sharp peaks do not move.
fn scatter(levels: &[f64]) -> f64 {
    /// √(1 + 16 + 36 + 16 + 1), and the median of the modulus of a normal number.
    const OF_FOURTH_DIFFERENCES: f64 = 8.366_600_265_340_756 * HALF_OF_50;
    let mut differences: Vec<f64> =
        levels.windows(5).map(|l| (l[0] - 4.0 * l[1] + 6.0 * l[2] - 4.0 * l[3] + l[4]).abs()).collect();
    if differences.is_empty() {
        return 0.0;
    }
    let middle = differences.len() / 2;
    let (_, median, _) = differences.select_nth_unstable_by(middle, f64::total_cmp);
    *median / OF_FOURTH_DIFFERENCES
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_numerics::random_numbers::unit;
    use std::f64::consts::TAU;

    /// Two oscillators in series, at 100 Hz with ζ = 5 % and at 500 Hz with 2 %, on even lines of `step` \[Hz\].
    fn two_modes(step: f64) -> Vec<(f64, Complex64)> {
        let mode = |w: f64, hertz: f64, damping: f64, stiffness: f64| {
            let ratio = w / (TAU * hertz);
            (Complex64::new(1.0 - ratio * ratio, 2.0 * damping * ratio) * stiffness).inv()
        };
        let count = (1000.0 / step) as u32;
        ((20.0 / step) as u32 + 1..count)
            .map(|line| TAU * step * f64::from(line))
            .map(|w| (w, mode(w, 100.0, 0.05, 1e8) + mode(w, 500.0, 0.02, 1e9)))
            .collect()
    }

    #[test]
    fn peaks_and_dips_with_their_damping() {
        let lines = two_modes(1.0);
        let peaks = Extremum::peaks(&lines);
        assert_eq!(peaks.len(), 2, "{peaks:?}");
        // The other mode is there as well and moves a peak by less than a line, its width by some percent.
        for (peak, hertz, damping) in [(peaks[0], 100.0, 0.05), (peaks[1], 500.0, 0.02)] {
            assert!((peak.angular_frequency / TAU - hertz).abs() < 1.0, "{peak:?}");
            let found = peak.damping_ratio.unwrap();
            assert!((found / damping - 1.0).abs() < 0.1, "{found} {damping}");
            assert!((peak.resolution / TAU - 1.0).abs() < 1e-9);
        }
        // Without loss 1/k₁(1 − f²/f₁²) + 1/k₂(1 − f²/f₂²) is zero at 309.3 Hz.
        let zero = ((1e9 + 1e8) / (1e9 / 500f64.powi(2) + 1e8 / 100f64.powi(2))).sqrt();
        let dips = Extremum::dips(&lines);
        assert_eq!(dips.len(), 1, "{dips:?}");
        assert!((dips[0].angular_frequency / TAU / zero - 1.0).abs() < 0.01, "{dips:?} {zero}");
    }

    /// Lines too far apart show a peak, not its width.
    #[test]
    fn a_width_below_the_lines_is_not_read() {
        let peaks = Extremum::peaks(&two_modes(12.5));
        assert_eq!(peaks.len(), 2, "{peaks:?}");
        assert_eq!(peaks[1].damping_ratio, None);
        assert!((peaks[1].resolution / TAU - 12.5).abs() < 1e-9);
    }

    /// Noise is no peak, however long it lasts.
    #[test]
    fn noise_has_no_peaks() {
        // Linear congruential numbers, of which twelve make one that is nearly normal.
        let mut state = 1u64;
        let mut even = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            unit(state)
        };
        let lines: Vec<(f64, Complex64)> = (1..5000)
            .map(|line| {
                let normal: f64 = (0..12).map(|_| even()).sum::<f64>() - 6.0;
                let modulus = 1e-9 * 10f64.powf(0.5 * normal / 20.0);
                (f64::from(line), Complex64::from(modulus))
            })
            .collect();
        assert_eq!(Extremum::peaks(&lines), []);
        assert_eq!(Extremum::dips(&lines), []);
    }
}
