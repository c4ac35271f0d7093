//! Growth of a case over wavelength, as a prediction of where corrugation stands.

use num_complex::Complex64;

use super::{TrafficSpeeds, normal};
use crate::feedback::Loop;
use crate::growth::RowEvaluator;

/// Growth rate per passage over wavelength, averaged over the speeds of the traffic.
///
/// As a prediction, a wavelength is as likely as it grows: the positive part of the mean growth rate over
/// ln λ, divided by its integral. Real growth is exponential and sharpens this; the linear measure is the
/// careful one.
#[derive(Debug, Clone, PartialEq)]
pub struct GrowthDensity {
    /// Wavelengths \[m\], equally spaced in their logarithm.
    wavelengths: Vec<f64>,
    /// Mean growth rate per passage at each \[-\].
    rates: Vec<f64>,
    /// ∫ of the positive part over ln λ.
    integral: f64,
    /// Mean speed \[m/s\].
    mean_speed: f64,
}

impl GrowthDensity {
    /// Mean growth of a loop between two wavelengths \[m\].
    ///
    /// 200 wavelengths a decade. A receptance that does not exist at some speed and wavelength (a load that
    /// outruns its waves) counts as no growth.
    pub fn new(feedback: impl Into<Loop>, from: f64, to: f64, speeds: &TrafficSpeeds) -> Self {
        const A_DECADE: f64 = 200.0;
        let steps = (A_DECADE * (to / from).log10()).ceil().max(2.0);
        let wavelengths: Vec<f64> = (0..=steps as usize)
            .map(|step| from * (to / from).powf(step as f64 / steps))
            .collect();
        let feedback = feedback.into();
        let per_dissipation = feedback.growth_rate_per_dissipation();
        let mut evaluator = RowEvaluator::new(&feedback, &wavelengths);
        let mut row = vec![Complex64::ZERO; wavelengths.len()];
        let mut rates = vec![0.0; wavelengths.len()];
        for &(speed, share) in speeds.shares() {
            evaluator.evaluate(speed, &mut row);
            for (rate, value) in rates.iter_mut().zip(&row) {
                let growth = per_dissipation * value.re;
                if growth.is_finite() {
                    *rate += share * growth;
                }
            }
        }
        let step = (to / from).ln() / steps;
        let integral = rates.iter().map(|rate| rate.max(0.0) * step).sum();
        Self {
            wavelengths,
            rates,
            integral,
            mean_speed: speeds.mean(),
        }
    }

    /// Wavelength \[m\] and mean growth rate per passage \[-\] of each place.
    pub fn rates(&self) -> impl Iterator<Item = (f64, f64)> {
        self.wavelengths
            .iter()
            .copied()
            .zip(self.rates.iter().copied())
    }

    /// Mean growth rate per passage \[-\] at a wavelength \[m\]; None outside the wavelengths asked for.
    pub fn rate_at(&self, wavelength: f64) -> Option<f64> {
        let above = self
            .wavelengths
            .iter()
            .position(|&other| other >= wavelength)?;
        if above == 0 {
            return (self.wavelengths[0] == wavelength).then(|| self.rates[0]);
        }
        let (low, high) = (self.wavelengths[above - 1], self.wavelengths[above]);
        let share = (wavelength / low).ln() / (high / low).ln();
        Some(self.rates[above - 1] + share * (self.rates[above] - self.rates[above - 1]))
    }

    /// Wavelength \[m\] of the highest mean growth rate and that rate, where anything grows.
    pub fn peak(&self) -> Option<(f64, f64)> {
        let peak = self.rates().max_by(|a, b| a.1.total_cmp(&b.1))?;
        (peak.1 > 0.0).then_some(peak)
    }

    /// Frequency \[Hz\] of the highest growth at the mean speed.
    pub fn peak_frequency(&self) -> Option<f64> {
        self.peak()
            .map(|(wavelength, _)| self.mean_speed / wavelength)
    }

    /// Wavelengths \[m\] about the peak that grow at least half as fast.
    pub fn range(&self) -> Option<(f64, f64)> {
        let (place, highest) = self.peak()?;
        let peak = self.wavelengths.iter().position(|&other| other == place)?;
        let grows = |index: &usize| self.rates[*index] >= 0.5 * highest;
        let first = (0..=peak).rev().take_while(grows).last()?;
        let last = (peak..self.rates.len()).take_while(grows).last()?;
        Some((self.wavelengths[first], self.wavelengths[last]))
    }

    /// Density of ln λ at a wavelength \[m\] known to ±`uncertainty` of ln λ; zero where nothing grows.
    pub fn at(&self, wavelength: f64, uncertainty: f64) -> f64 {
        if self.integral <= 0.0 {
            return 0.0;
        }
        // A measured wavelength sharper than the grid is between its points all the same.
        let step = (self.wavelengths[1] / self.wavelengths[0]).ln();
        let spread = uncertainty.max(step);
        let sum: f64 = self
            .rates()
            .map(|(place, rate)| {
                rate.max(0.0) * step * normal::density((place / wavelength).ln(), spread)
            })
            .sum();
        sum / self.integral
    }
}
