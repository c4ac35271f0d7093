//! Ripples that a second hit of the hammer leaves.

use std::f64::consts::{PI, TAU};

use riffel::Complex64;

use super::Line;

/// Lines that are looked at; of more, means of neighbours.
const MOST_LINES: usize = 1024;
/// Fewest lines, and fewest ripples over them.
const LEAST_LINES: usize = 64;
const LEAST_RIPPLES: usize = 12;
/// Share by which steps of frequencies may differ that are even: they are printed with few digits.
const EVEN: f64 = 0.1;
/// Half-width of the mean that is taken off, in shares of the lines.
const COURSE: usize = 12;
/// Amplitude of ln |H| that counts in full, and how far above its surroundings a ripple stands; the highest of 200 without one was 2.3.
const FULL: f64 = 0.1;
const LEAST_HEIGHT: f64 = 5.0;

/// The time \[s\] between two hits, where ln |H| has one ripple that is even over frequency: a peak of its cepstrum.
///
/// A second hit after τ leaves 1 + a e^−iωτ. Method: Fourier transform of ln |H| less its course, under Hann's window; the greatest
/// amplitude beside the median of those around it, of 0.6 to 1.6 times τ. Source: Bogert, Healy & Tukey (1963), *The quefrency alanysis of
/// time series for echoes*. Accuracy, of 200 made-up responses each with noise of 1 to 5 % (test `double_hits_are_found`): none
/// without a second hit is taken for one, and 197 with a = 0.2 to 0.7 are found, τ within 5 %. Range: even steps of frequency, 64 lines or more, 12
/// ripples or more, 3 lines or more a ripple. Cost: some milliseconds.
pub(super) fn time_between_hits(lines: &[Line]) -> Option<f64> {
    let step = (lines.last()?.0 - lines.first()?.0) / (lines.len().max(2) - 1) as f64;
    let even = lines.windows(2).all(|pair| ((pair[1].0 - pair[0].0) / step - 1.0).abs() < EVEN);
    if !even || lines.len() < LEAST_LINES {
        return None;
    }
    let together = lines.len().div_ceil(MOST_LINES);
    let levels: Vec<f64> = lines
        .chunks_exact(together)
        .map(|lines| lines.iter().map(|(_, h)| h.norm().max(f64::MIN_POSITIVE).ln()).sum::<f64>() / together as f64)
        .collect();
    let count = levels.len();
    let ripples: Vec<f64> = less_course(&levels);
    // Amplitudes at quefrencies k/(2 count) of a step.
    let amplitude = |k: usize| {
        let turn = Complex64::from_polar(1.0, -PI * k as f64 / count as f64);
        let (sum, _) = ripples
            .iter()
            .fold((Complex64::ZERO, Complex64::ONE), |(sum, phase), value| (sum + phase * value, phase * turn));
        4.0 * sum.norm() / count as f64
    };
    let amplitudes: Vec<f64> = (0..=2 * count / 3).map(amplitude).collect();
    let height = |k: usize| {
        let (low, high) = (2 * k * 10 / 32, (k * 16 / 10 + 8).min(amplitudes.len()));
        let mut around: Vec<f64> = amplitudes[low..k - 5].iter().chain(amplitudes.get(k + 6..high)?).copied().collect();
        let middle = around.len() / 2;
        let (_, &mut median, _) = around.select_nth_unstable_by(middle, f64::total_cmp);
        Some(amplitudes[k] / median * (amplitudes[k] / FULL).min(1.0))
    };
    let heights = (2 * LEAST_RIPPLES..amplitudes.len()).filter_map(|k| Some((k, height(k)?)));
    let (k, _) = heights.filter(|(_, height)| *height > LEAST_HEIGHT).max_by(|one, other| one.1.total_cmp(&other.1))?;
    Some(k as f64 / (2.0 * count as f64 * step * together as f64))
}

/// Levels less their weighted mean around, under Hann's window.
fn less_course(levels: &[f64]) -> Vec<f64> {
    let count = levels.len();
    let reach = (count / COURSE).max(2) as isize;
    let weight = |off: isize| 0.5 + 0.5 * (PI * off as f64 / (reach + 1) as f64).cos();
    let sum: f64 = (-reach..=reach).map(weight).sum();
    let at = |index: isize| levels[index.clamp(0, count as isize - 1) as usize];
    (0..count)
        .map(|index| {
            let around = (-reach..=reach).map(|off| weight(off) * at(index as isize + off));
            let window = 0.5 - 0.5 * (TAU * (index as f64 + 0.5) / count as f64).cos();
            window * (levels[index] - around.sum::<f64>() / sum)
        })
        .collect()
}
