//! The growth map.

use num_complex::Complex64;
use rayon::prelude::*;

use super::{Axis, RowEvaluator};
use crate::FeedbackLoop;

/// Normalised dissipation Ŵ₁ over wavelength and speed, as in Figs. 4 and 5 of the paper.
#[derive(Debug, Clone, PartialEq)]
pub struct GrowthMap {
    wavelength: Axis,
    speed: Axis,
    normalized_dissipation: Vec<Complex64>,
    growth_rate_per_dissipation: f64,
}

impl GrowthMap {
    /// Evaluate the loop on a grid, rows of equal speed in parallel on the current rayon pool.
    ///
    /// `progress` is called from any thread with the number of rows just finished, one at a time.
    /// Memory: 16 bytes a point. A point agrees with [`FeedbackLoop::at`] to rounding, or to 1e-9
    /// where a large map reads the track from a [`Tabulated`](crate::Tabulated) receptance.
    pub fn compute(
        feedback: &FeedbackLoop,
        wavelength: Axis,
        speed: Axis,
        progress: impl Fn(usize) + Sync,
    ) -> Self {
        let evaluator = RowEvaluator::for_map(feedback, wavelength, speed);
        let mut values = vec![Complex64::ZERO; wavelength.points() * speed.points()];
        values
            .par_chunks_exact_mut(wavelength.points())
            .enumerate()
            .for_each_with(evaluator, |evaluator, (index, row)| {
                evaluator.evaluate(speed.value(index), row);
                progress(1);
            });
        let steady = feedback.contact.steady();
        Self {
            wavelength,
            speed,
            normalized_dissipation: values,
            growth_rate_per_dissipation: feedback.growth_rate(&steady, Complex64::ONE),
        }
    }

    /// Wavelengths \[m\], the fast axis.
    pub fn wavelength(&self) -> Axis {
        self.wavelength
    }

    /// Speeds \[m/s\], the slow axis.
    pub fn speed(&self) -> Axis {
        self.speed
    }

    /// Ŵ₁ in rows of equal speed: `[speed][wavelength]`, flattened.
    pub fn normalized_dissipation(&self) -> &[Complex64] {
        &self.normalized_dissipation
    }

    /// Growth rate per passage for a value of Ŵ₁: g = this factor · Re Ŵ₁, negative factor.
    pub fn growth_rate_per_dissipation(&self) -> f64 {
        self.growth_rate_per_dissipation
    }

    /// Rows of the map: speed \[m/s\] and Ŵ₁ over the wavelengths.
    pub fn rows(&self) -> impl Iterator<Item = (f64, &[Complex64])> {
        self.normalized_dissipation
            .chunks_exact(self.wavelength.points())
            .enumerate()
            .map(|(index, row)| (self.speed.value(index), row))
    }
}
