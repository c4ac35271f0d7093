//! A course as a sum of waves.

use std::f64::consts::TAU;
use std::ops::Range;

use num_complex::Complex64;

use super::super::transforms::{backward, forward, length};
use super::expected::{Expected, MOST_TURNS};

/// A course as a sum of waves.
pub(super) struct Lines {
    /// Wavenumber of a line \[1/m\].
    step: f64,
    /// The first of a transform of `size` heights, mean square one for a height of one; the others are nothing.
    lines: Vec<Complex64>,
    size: usize,
    /// Heights that there are.
    count: usize,
    spacing: f64,
}

impl Lines {
    /// Of every so many heights.
    pub(super) fn of(heights: &[f64], spacing: f64, every: usize) -> Self {
        let short = length((2 * heights.len()).div_ceil(every));
        let mut input = vec![0.0; short];
        for (value, height) in input.iter_mut().zip(heights.iter().step_by(every)) {
            *value = *height;
        }
        let mut lines = forward(&mut input);
        let size = every * short;
        let scale = every as f64 / ((size * heights.len()) as f64).sqrt();
        lines.iter_mut().for_each(|line| *line *= scale);
        Self { step: 1.0 / (size as f64 * spacing), lines, size, count: heights.len(), spacing }
    }

    fn back(&self, mut lines: Vec<Complex64>) -> Vec<f64> {
        lines.resize(self.size / 2 + 1, Complex64::ZERO);
        let mut heights = backward(&mut lines);
        heights.truncate(self.count);
        let scale = (self.count as f64 / self.size as f64).sqrt();
        heights.iter_mut().for_each(|height| *height *= scale);
        heights
    }

    /// Heights that there are.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// The autocorrelation with even power over octaves, one at no distance, at distances below so many steps.
    pub(super) fn whitened_autocorrelation(&self, steps: usize) -> Vec<f64> {
        /// Ratio of wavenumbers to either side over which power is averaged: a one-third octave.
        const WIDE: f64 = 1.122;
        /// Least power beside the greatest: what is filtered out is not made even.
        const LEAST: f64 = 1e-7;
        let mut sums = Vec::with_capacity(self.lines.len() + 1);
        sums.push(0.0);
        for line in &self.lines {
            sums.push(sums[sums.len() - 1] + line.norm_sqr());
        }
        let mean = |index: usize| {
            let low = ((index as f64 / WIDE) as usize).max(1);
            let high = ((index as f64 * WIDE) as usize + 1).min(self.lines.len() - 1);
            (sums[high + 1] - sums[low]) / (high + 1 - low) as f64
        };
        let octaves = (1..self.lines.len()).map(|index| index as f64 * mean(index));
        let octaves: Vec<f64> = std::iter::once(0.0).chain(octaves).collect();
        let most = octaves.iter().copied().fold(0.0, f64::max);
        let even = self.lines.iter().zip(octaves).map(|(line, power)| {
            let kept = power > LEAST * most;
            if kept { line.norm_sqr() / power } else { 0.0 }
        });
        let mut even: Vec<f64> = even.collect();
        even.resize(self.size / 2 + 1, 0.0);
        let found = first_of_back(&even, steps.min(self.count));
        let share = |index: usize| (self.count - index) as f64 / self.count as f64;
        let all = found.iter().enumerate();
        all.map(|(index, value)| value / found[0] / share(index)).collect()
    }

    fn band(&self, order: usize, circumference: f64) -> Range<usize> {
        let line = |order: f64| (order / circumference / self.step) as usize;
        let last = self.lines.len();
        line(order as f64 - 0.5).min(last)..line(order as f64 + 0.5).min(last)
    }

    /// Sum of the waves that each of some lines becomes when its course is moved by up to `turns` turns either way.
    fn comb(&self, lines: Range<usize>, circumference: f64, turns: usize) -> impl Iterator<Item = f64> {
        let all = (2 * turns + 1) as f64;
        // sin(all x)/sin x; the angle x grows from line to line by as much.
        let grows = 0.5 * TAU * self.step * circumference;
        let by = [1.0, all].map(|times| Complex64::cis(times * grows));
        let mut waves = [1.0, all].map(|times| Complex64::cis(times * lines.start as f64 * grows));
        lines.map(move |_| {
            let [one, moved] = waves.map(|wave| wave.im);
            (waves[0], waves[1]) = (waves[0] * by[0], waves[1] * by[1]);
            let sum = if one.abs() < 1e-9 { all } else { moved / one };
            sum - 1.0
        })
    }

    /// Power about an order \[m²\], and how much of it repeats over so many turns.
    pub(super) fn about(&self, order: usize, circumference: f64, turns: usize) -> [f64; 2] {
        let length = self.count as f64 * self.spacing;
        let compared = |turn: usize| 2.0 * (1.0 - turn as f64 * circumference / length);
        let compared: f64 = (1..=turns).map(compared).sum();
        let band = self.band(order, circumference);
        let lines = self.lines[band.clone()].iter();
        let [all, repeating] =
            lines.zip(self.comb(band, circumference, turns)).fold([0.0; 2], |[all, repeating], (line, share)| {
                let power = 2.0 * line.norm_sqr();
                [all + power, repeating + power * share]
            });
        [all, repeating / compared]
    }

    /// The circumference whose orders have the wavenumbers of the highest lines near them, each with the weight of its power
    /// and the square of its order, as its wavenumber tells the circumference by as much.
    pub(super) fn refined(&self, orders: &[usize], circumference: f64) -> f64 {
        let near = self.size.div_ceil(self.count);
        let power = |line: usize| self.lines[line].norm_sqr();
        let (mut sum, mut weights) = (0.0, 0.0);
        for &order in orders {
            let middle = (order as f64 / circumference / self.step).round() as usize;
            let lines = (middle.saturating_sub(near)).max(1)..=(middle + near).min(self.lines.len().saturating_sub(2));
            let Some(highest) = lines.max_by(|one, other| power(*one).total_cmp(&power(*other))) else {
                continue;
            };
            // The top of the parabola through the logarithms of three lines.
            let level = |line: usize| power(line).max(f64::MIN_POSITIVE).ln();
            let [before, at, behind] = [highest - 1, highest, highest + 1].map(level);
            let bend = before - 2.0 * at + behind;
            let at = power(highest);
            let top = if bend < 0.0 { 0.5 * (before - behind) / bend } else { 0.0 };
            sum += at * order as f64 * (highest as f64 + top) * self.step;
            weights += at * (order as f64).powi(2);
        }
        if sum > 0.0 { weights / sum } else { circumference }
    }

    /// What repeats with the turn in the bands of orders, at the heights: what the turns to either side, up to 12 and itself left
    /// out, let expect of a pattern that changes slowly, and as much of the rest as keeps the power of a course that does not repeat.
    pub(super) fn repeating(&self, orders: &[usize], circumference: f64, turns: usize) -> Vec<f64> {
        let turns = turns.min(MOST_TURNS);
        let mut own = vec![Complex64::ZERO; self.lines.len()];
        // Sums over the turns, each times a power of its number.
        let mut sums = [own.clone(), own.clone(), own.clone()];
        for &order in orders {
            for line in self.band(order, circumference) {
                own[line] = self.lines[line];
                let (sine, cosine) = (TAU * line as f64 * self.step * circumference).sin_cos();
                let (once, mut wave) = (Complex64::new(cosine, sine), Complex64::ONE);
                let mut all = [Complex64::ZERO; 3];
                for turn in 1..=turns {
                    wave *= once;
                    let number = turn as f64;
                    all[0].re += 2.0 * wave.re;
                    all[1].im += 2.0 * number * wave.im;
                    all[2].re += 2.0 * number * number * wave.re;
                }
                for (sum, all) in sums.iter_mut().zip(all) {
                    sum[line] = own[line] * all;
                }
            }
        }
        let mut found = self.back(own);
        let sums = sums.map(|sum| self.back(sum));
        let steps = circumference / self.spacing;
        let reached = |heights: usize| ((heights as f64 / steps) as usize).min(turns);
        let mut expected = ([turns; 2], Expected::of([turns; 2]));
        for (index, own) in found.iter_mut().enumerate() {
            let around = [reached(index), reached(self.count - 1 - index)];
            if expected.0 != around {
                expected = (around, Expected::of(around));
            }
            let Expected { weights, variance } = expected.1;
            let of_sum = |(weight, sum): (&f64, &Vec<f64>)| weight * sum[index];
            let mean: f64 = weights.iter().zip(&sums).map(of_sum).sum();
            *own -= (*own - mean) / (1.0 + variance).sqrt();
        }
        found
    }
}

/// The first of the values that real lines become, but for a factor: lines so many apart are the lines of a shorter course, whose
/// transform takes less time.
fn first_of_back(lines: &[f64], count: usize) -> Vec<f64> {
    let size = 2 * (lines.len() - 1);
    let apart = (1..=size / (2 * count)).rev().find(|apart| size.is_multiple_of(2 * apart)).unwrap_or(1);
    let mut found = vec![0.0; count];
    for first in 0..=apart / 2 {
        let all = (first..size).step_by(apart);
        let mut own: Vec<f64> = all.map(|line| lines[line.min(size - line)]).collect();
        // The lines from the other end become the same.
        let times = if 2 * first % apart == 0 { 1.0 } else { 2.0 };
        let by = Complex64::cis(-TAU * first as f64 / size as f64);
        let mut wave = Complex64::new(times, 0.0);
        for (value, own) in found.iter_mut().zip(forward(&mut own)) {
            *value += (wave * own).re;
            wave *= by;
        }
    }
    found
}
