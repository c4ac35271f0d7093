//! The ridge: the wavelength of highest growth at each speed.

use num_complex::Complex64;
use rayon::prelude::*;

use super::{Axis, GrowthMap, RowEvaluator};
use crate::FeedbackLoop;
use crate::golden_section::golden_section;

/// The highest growth at one speed within the window of wavelengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RidgePoint {
    /// Speed V \[m/s\].
    pub speed: f64,
    /// Wavelength λ of the smallest Re Ŵ₁ \[m\].
    pub wavelength: f64,
    /// Frequency V/λ \[Hz\].
    pub frequency: f64,
    /// Re Ŵ₁ there \[-\]; growth only if negative.
    pub normalized_dissipation: f64,
    /// Growth rate per passage there \[-\].
    pub growth_rate: f64,
    /// The minimum sits at an end of the window, so a longer or shorter wavelength would grow
    /// faster.
    pub at_edge: bool,
}

impl RidgePoint {
    /// The point of the ridge in a row that a [`RowEvaluator`] computed for the wavelengths at one speed
    /// \[m/s\]: what [`Ridge::search`] finds there, for those who keep the rows too.
    pub fn of_row(
        feedback: &FeedbackLoop,
        wavelength: Axis,
        speed: f64,
        row: &[Complex64],
    ) -> Self {
        refined_on(feedback, wavelength, speed, lowest(row))
    }
}

/// Ridge points in order of speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Ridge {
    /// One point per speed.
    pub points: Vec<RidgePoint>,
}

impl Ridge {
    /// Search the ridge row by row, keeping no map: the smallest Re Ŵ₁ on the grid of wavelengths,
    /// then refined between its neighbours by golden-section search to 1e-7 of the window, some 35
    /// evaluations a speed. A second minimum narrower than the grid's step is missed.
    pub fn search(feedback: &FeedbackLoop, wavelength: Axis, speed: Axis) -> Self {
        Self::search_at(feedback, wavelength, &speed.values())
    }

    /// [`search`](Self::search) at any speeds \[m/s\], in their order.
    pub fn search_at(feedback: &FeedbackLoop, wavelength: Axis, speeds: &[f64]) -> Self {
        let evaluator = RowEvaluator::for_map(feedback, &wavelength.values(), speeds);
        let row = vec![Complex64::ZERO; wavelength.points()];
        let points = speeds
            .par_iter()
            .map_with((evaluator, row), |(evaluator, row), &speed| {
                evaluator.evaluate(speed, row);
                RidgePoint::of_row(feedback, wavelength, speed, row)
            })
            .collect();
        Self { points }
    }

    /// The ridge of a map of the same loop, as [`search`](Self::search) without computing the rows anew.
    pub fn of_map(feedback: &FeedbackLoop, map: &GrowthMap) -> Self {
        let steady = feedback.contact.steady();
        Self::refined_from(map, |wavelength, speed| {
            feedback.normalized_dissipation(&steady, wavelength, speed)
        })
    }

    /// The ridge of a map, refined between its points on the function Ŵ₁ of wavelength and speed
    /// that the map samples.
    pub(super) fn refined_from(
        map: &GrowthMap,
        normalized: impl Fn(f64, f64) -> Complex64 + Sync,
    ) -> Self {
        let rate = map.growth_rate_per_dissipation();
        let points = (0..map.speed().points())
            .into_par_iter()
            .map(|index| {
                let speed = map.speed().value(index);
                let lowest = lowest(map.row(index));
                refined(map.wavelength(), speed, lowest, rate, |wavelength| {
                    normalized(wavelength, speed)
                })
            })
            .collect();
        Self { points }
    }

    /// Every line of growth at one speed \[m/s\]: the local minima of Re Ŵ₁ < 0 over the wavelengths,
    /// in order of wavelength, refined as in [`search`](Self::search).
    ///
    /// A track with supports has lines besides the ridge; each is a wavelength that may dominate
    /// where another mechanism filters the ridge out.
    pub fn lines_at(feedback: &FeedbackLoop, wavelength: Axis, speed: f64) -> Vec<RidgePoint> {
        let mut row = vec![Complex64::ZERO; wavelength.points()];
        RowEvaluator::new(feedback, &wavelength.values()).evaluate(speed, &mut row);
        let last = row.len() - 1;
        (0..=last)
            .filter(|&j| {
                let lower_left = j == 0 || row[j].re < row[j - 1].re;
                let lower_right = j == last || row[j].re <= row[j + 1].re;
                row[j].re < 0.0 && lower_left && lower_right
            })
            .map(|j| refined_on(feedback, wavelength, speed, j))
            .collect()
    }

    /// Frequency \[Hz\] of the ray λ = V/f that fits the ridge best: least absolute deviations in
    /// wavelength over the points that grow and do not sit at the edge of the window. A ridge that
    /// changes from one line to another is fitted by the longer one, not by a ray between them.
    ///
    /// Σ|λ − V/f| = ΣV|λ/V − 1/f| is least where 1/f is the median of λ/V with the weights V.
    /// `None` where no point qualifies.
    pub fn best_fit_frequency(&self) -> Option<f64> {
        let mut inner: Vec<&RidgePoint> = self
            .points
            .iter()
            .filter(|point| !point.at_edge && point.normalized_dissipation < 0.0)
            .collect();
        inner.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        let half = inner.iter().map(|point| point.speed).sum::<f64>() / 2.0;
        let mut sum = 0.0;
        inner
            .iter()
            .find(|point| {
                sum += point.speed;
                sum >= half
            })
            .map(|point| point.frequency)
    }

    /// The point of highest growth rate per passage.
    pub fn highest(&self) -> Option<&RidgePoint> {
        self.points
            .iter()
            .max_by(|a, b| a.growth_rate.total_cmp(&b.growth_rate))
    }
}

/// Index of the smallest Re Ŵ₁.
fn lowest(row: &[Complex64]) -> usize {
    (0..row.len())
        .min_by(|&a, &b| row[a].re.total_cmp(&row[b].re))
        .unwrap_or(0)
}

/// The minimum between the neighbours of a point of the grid; `rate` is the growth rate for Ŵ₁ = 1.
fn refined(
    wavelength: Axis,
    speed: f64,
    lowest: usize,
    rate: f64,
    normalized: impl Fn(f64) -> Complex64,
) -> RidgePoint {
    let last = wavelength.points() - 1;
    let bracket = [
        wavelength.value(lowest.saturating_sub(1)),
        wavelength.value((lowest + 1).min(last)),
    ];
    let tolerance = 1e-7 * (wavelength.max() - wavelength.min());
    let minimum = golden_section(bracket, tolerance, |wavelength| normalized(wavelength).re);
    // At an end of the window the search walks to that end.
    let at_edge = minimum - wavelength.min() < 2.0 * tolerance
        || wavelength.max() - minimum < 2.0 * tolerance;
    let end = if lowest == 0 {
        wavelength.min()
    } else {
        wavelength.max()
    };
    let place = if at_edge { end } else { minimum };
    let normalized_dissipation = normalized(place).re;
    RidgePoint {
        speed,
        wavelength: place,
        frequency: speed / place,
        normalized_dissipation,
        growth_rate: rate * normalized_dissipation,
        at_edge,
    }
}

/// [`refined`] on the loop itself.
fn refined_on(feedback: &FeedbackLoop, wavelength: Axis, speed: f64, lowest: usize) -> RidgePoint {
    let steady = feedback.contact.steady();
    let rate = feedback.growth_rate_per_dissipation();
    refined(wavelength, speed, lowest, rate, |wavelength| {
        feedback.normalized_dissipation(&steady, wavelength, speed)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(speed: f64, frequency: f64, at_edge: bool) -> RidgePoint {
        RidgePoint {
            speed,
            wavelength: speed / frequency,
            frequency,
            normalized_dissipation: -1.0,
            growth_rate: 1.0,
            at_edge,
        }
    }

    #[test]
    fn best_fit_keeps_to_the_longer_line() {
        let points = vec![
            point(10.0, 180.0, false),
            point(15.0, 185.0, false),
            point(20.0, 500.0, false),
            point(30.0, 501.0, false),
            point(40.0, 900.0, true),
        ];
        assert_eq!(Ridge { points }.best_fit_frequency(), Some(500.0));
        assert_eq!(Ridge { points: vec![] }.best_fit_frequency(), None);
    }
}
