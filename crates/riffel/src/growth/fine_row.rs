//! Re Ŵ₁ over wavelength at one speed, as finely as its lines are narrow.

use num_complex::Complex64;
use rayon::prelude::*;

use super::{Axis, RowEvaluator};
use crate::cancel::check;

/// Largest step over the wavelength before any is halved: a resonance of 0.1 % of the critical damping, as of an axle, is then
/// at most two and a half of its half-widths from a value, where it still shows with a third of its height.
const STEP: f64 = 0.005;
/// Shortest step over the wavelength.
const SHORTEST: f64 = 1e-6;
/// Deviation from a straight line between two values up to which a step is left whole, over the size of the row.
const STRAIGHT: f64 = 0.01;
/// How often in a row a step must be straight: the middle of a resonance that turns its phase may lie on the line by chance.
const LOOKS: usize = 2;
/// Size of a row over its largest value, at least: growth below that beside the decay elsewhere is not resolved for its own sake.
const LEAST_SIZE: f64 = 1e-3;
/// Most values of a row after the first ones: some hundred lines.
const MOST: usize = 6000;

/// Re Ŵ₁ at rising wavelengths of a window, close together where it changes fast.
///
/// Method: equal steps in ln λ of at most half a per cent, each of which is halved until the
/// value in its middle lies on the straight line between its ends, twice in a row, to 1 % of the largest growth of the row. What a row
/// says does therefore not depend on the points of a map. A resonance of less than 0.02 % of the critical damping may be
/// missed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FineRow {
    pub(super) wavelengths: Vec<f64>,
    pub(super) values: Vec<f64>,
}

/// The first wavelengths of a window, both ends exact, at which rows of many speeds are evaluated together.
pub(super) fn first_wavelengths(window: Axis) -> Vec<f64> {
    let [from, to] = [window.min(), window.max()];
    let steps = ((to / from).ln() / STEP).ceil().max(2.0) as usize;
    let inner = |index: usize| from * (to / from).powf(index as f64 / steps as f64);
    let mut all: Vec<f64> = (0..steps).map(inner).collect();
    all[0] = from;
    all.push(to);
    all
}

impl FineRow {
    /// The row of an evaluator of the [`first_wavelengths`], refined on the function that it samples.
    pub(super) fn evaluated(
        evaluator: &mut RowEvaluator,
        wavelengths: &[f64],
        speed: f64,
        value: impl Fn(f64) -> f64,
    ) -> Self {
        let mut row = vec![Complex64::ZERO; wavelengths.len()];
        evaluator.evaluate(speed, &mut row);
        Self { wavelengths: wavelengths.to_vec(), values: row.iter().map(|value| value.re).collect() }.refined(value)
    }

    /// The row of a function over a window, which is asked from several threads.
    pub(super) fn of(window: Axis, value: impl Fn(f64) -> f64 + Sync) -> Self {
        let wavelengths = first_wavelengths(window);
        let values = wavelengths.par_iter().map(|&wavelength| {
            check();
            value(wavelength)
        });
        Self { values: values.collect(), wavelengths }.refined(value)
    }

    /// The row over a window of a map of rising wavelengths, filled up to the same steps and refined on the function that it
    /// samples.
    pub(super) fn filled<'a>(
        window: Axis,
        of_map: impl Iterator<Item = (f64, &'a Complex64)>,
        value: impl Fn(f64) -> f64,
    ) -> Self {
        let mut filled = Self { wavelengths: vec![window.min()], values: vec![value(window.min())] };
        let inside = |(wavelength, _): &(f64, &Complex64)| window.min() < *wavelength && *wavelength < window.max();
        let known = of_map.filter(inside).map(|(wavelength, value)| (wavelength, value.re));
        let last = std::iter::once_with(|| (window.max(), value(window.max())));
        let mut before = window.min();
        for (wavelength, at) in known.chain(last) {
            let steps = ((wavelength / before).ln() / STEP).ceil() as usize;
            for step in 1..steps {
                let between = before * (wavelength / before).powf(step as f64 / steps as f64);
                filled.wavelengths.push(between);
                filled.values.push(value(between));
            }
            filled.wavelengths.push(wavelength);
            filled.values.push(at);
            before = wavelength;
        }
        filled.refined(value)
    }

    fn refined(self, value: impl Fn(f64) -> f64) -> Self {
        let size = self.size();
        let Self { wavelengths: first, values } = self;
        if size == 0.0 || first.len() < 3 {
            return Self { wavelengths: first, values };
        }
        let last = first.len() - 1;
        let bends = |at: usize| {
            let at = at.clamp(1, last - 1);
            let bend = values[at - 1] - 2.0 * values[at] + values[at + 1];
            0.125 * bend.abs() > straight(size, &values[at - 1..=at + 1])
        };
        let mut refined = Self { wavelengths: vec![first[0]], values: vec![values[0]] };
        for index in 1..=last {
            let mut here = (first[index - 1], values[index - 1]);
            // Ends still ahead, the nearest last; each with how often the step to it is still looked into.
            let looks = if bends(index - 1) || bends(index) { LOOKS } else { 0 };
            let mut ahead = vec![(first[index], values[index], looks)];
            while let Some(&(wavelength, at_end, looks)) = ahead.last() {
                let added = refined.wavelengths.len() + ahead.len() - index;
                if looks > 0 && added < MOST && wavelength / here.0 > 1.0 + SHORTEST {
                    let middle = (here.0 * wavelength).sqrt();
                    let in_middle = value(middle);
                    let off = (in_middle - 0.5 * (here.1 + at_end)).abs();
                    let left = match off > straight(size, &[here.1, in_middle, at_end]) {
                        true => LOOKS,
                        false => looks - 1,
                    };
                    if let Some(end) = ahead.last_mut() {
                        end.2 = left;
                    }
                    ahead.push((middle, in_middle, left));
                } else {
                    refined.wavelengths.push(wavelength);
                    refined.values.push(at_end);
                    here = (wavelength, at_end);
                    ahead.pop();
                }
            }
        }
        refined
    }

    /// The largest growth, or a thousandth of the largest value.
    fn size(&self) -> f64 {
        let values = self.values.iter().filter(|value| value.is_finite());
        values.fold(0.0, |size: f64, &value| size.max(-value).max(LEAST_SIZE * value.abs()))
    }
}

/// By how much the middle of three values may lie off the line between the others; where all decay, a tenth of the least of them.
fn straight(size: f64, values: &[f64]) -> f64 {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    (STRAIGHT * size).max(0.1 * least)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A broad hill of growth, and a line upon it that is three times as high and of any width, wherever it lies between the
    /// first steps: its height is found to 1 %.
    #[test]
    fn finds_a_narrow_line_wherever_it_lies() {
        let window = Axis::new(0.02, 0.3, 141).unwrap();
        let first = first_wavelengths(window);
        for half_width in [3e-4, 1e-3, 1e-2] {
            for place in 0..40 {
                let at = 0.0217 * (1.0 + 0.0005 * f64::from(place));
                let value = |wavelength: f64| {
                    let hill = -1.0 / (1.0 + (wavelength / 0.168).ln().powi(2) / 0.1);
                    let off = (wavelength / at).ln() / half_width;
                    // As a resonance turns its phase: both parts of 1/(1 + ix).
                    hill - 3.0 * (1.0 + off) / (1.0 + off * off)
                };
                let row = FineRow {
                    values: first.iter().map(|&wavelength| value(wavelength)).collect(),
                    wavelengths: first.clone(),
                }
                .refined(value);
                let least = row.values.iter().copied().fold(0.0, f64::min);
                // (1 + x)/(1 + x²) is at most (1 + √2)/2.
                let highest = -3.0 * 0.5 * (1.0 + 2f64.sqrt());
                assert!((least - highest).abs() < 0.06, "{half_width} {at}: {least}");
                assert!(row.wavelengths.is_sorted() && row.wavelengths.len() < 1500);
            }
        }
    }

    /// What is smooth or constant costs no more than its first values; what is not a number ends.
    #[test]
    fn a_smooth_row_stays_as_it_is() {
        let first = first_wavelengths(Axis::new(0.02, 0.3, 2).unwrap());
        let of = |value: &dyn Fn(f64) -> f64| {
            FineRow { values: first.iter().map(|&wavelength| value(wavelength)).collect(), wavelengths: first.clone() }
                .refined(value)
                .values
                .len()
        };
        assert_eq!(of(&|wavelength| -(wavelength / 0.1).sin()), first.len());
        assert_eq!(of(&|_| 0.0), first.len());
        assert_eq!(of(&|_| f64::NAN), first.len());
        // A step is no line: it is followed to the shortest step and left.
        assert!(of(&|wavelength| if wavelength < 0.1 { -1.0 } else { 1.0 }) < first.len() + 100);
    }
}
