//! Growth of a case over wavelength, as a prediction of where corrugation stands.

use num_complex::Complex64;
use riffel_numerics::normal_distribution::density;

use super::TrafficSpeeds;
use crate::feedback::Loop;
use crate::growth::{Axis, GrowthSpectrum, RowEvaluator};

/// Speeds at which narrow lines are looked for.
const FEW: usize = 3;

/// Growth rate per passage over wavelength, averaged over the speeds of the traffic.
///
/// Growth rate as a prediction, by which a wavelength is as likely as it grows: the positive part of the mean growth rate over
/// ln λ, divided by its integral. Real growth is exponential and sharpens this; the linear measure is the
/// careful one.
#[derive(Debug, Clone, PartialEq)]
pub struct GrowthDensity {
    /// Wavelengths \[m\], equally spaced in their logarithm.
    wavelengths: Vec<f64>,
    /// Mean growth rate per passage at each \[-\].
    rates: Vec<f64>,
    /// Mean growth rate with its narrow lines, under a few speeds: many blur them.
    spectrum: Option<GrowthSpectrum>,
    /// ∫ of the positive part over ln λ.
    integral: f64,
    /// Mean speed \[m/s\].
    mean_speed: f64,
}

impl GrowthDensity {
    /// Mean growth of a loop between two wavelengths \[m\].
    ///
    /// 200 wavelengths a decade; under no more than three speeds each has the mean about it of a [`GrowthSpectrum`], which finds
    /// narrow lines. A receptance that does not exist at some speed and wavelength (a load that
    /// outruns its waves) counts as no growth.
    pub fn new(feedback: impl Into<Loop>, from: f64, to: f64, speeds: &TrafficSpeeds) -> Self {
        const A_DECADE: f64 = 200.0;
        let steps = (A_DECADE * (to / from).log10()).ceil().max(2.0);
        let wavelengths: Vec<f64> =
            (0..=steps as usize).map(|step| from * (to / from).powf(step as f64 / steps)).collect();
        let feedback = feedback.into();
        if speeds.of_growth().len() <= FEW
            && let Ok(window) = Axis::new(from, to, 2)
        {
            let spectrum = GrowthSpectrum::of(window, |wavelength| {
                let shares = speeds.of_growth().iter();
                let rates = shares.map(|&(speed, share)| share * feedback.complex_growth_rate(wavelength, speed).re);
                rates.filter(|rate| rate.is_finite()).sum()
            });
            return Self::of_spectrum(spectrum, wavelengths, speeds);
        }
        let per_dissipation = feedback.growth_rate_per_dissipation();
        let mut evaluator = RowEvaluator::new(&feedback, &wavelengths);
        let mut row = vec![Complex64::ZERO; wavelengths.len()];
        let mut rates = vec![0.0; wavelengths.len()];
        for &(speed, share) in speeds.of_growth() {
            evaluator.evaluate(speed, &mut row);
            for (rate, value) in rates.iter_mut().zip(&row) {
                let growth = per_dissipation * value.re;
                if growth.is_finite() {
                    *rate += share * growth;
                }
            }
        }
        Self { integral: integral(&wavelengths, &rates), wavelengths, rates, spectrum: None, mean_speed: speeds.mean() }
    }

    /// At each wavelength the mean over ln λ of what is nearest to it.
    fn of_spectrum(spectrum: GrowthSpectrum, wavelengths: Vec<f64>, speeds: &TrafficSpeeds) -> Self {
        let half = 0.5 * (wavelengths[1] / wavelengths[0]).ln();
        let last = wavelengths.len() - 1;
        let rates = wavelengths.iter().enumerate();
        let rates = rates.map(|(index, place)| {
            let below = if index == 0 { 0.0 } else { half };
            let above = if index == last { 0.0 } else { half };
            mean_over(&spectrum, place * (-below).exp(), place * above.exp())
        });
        let rates: Vec<f64> = rates.collect();
        Self {
            integral: integral(&wavelengths, &rates),
            wavelengths,
            rates,
            spectrum: Some(spectrum),
            mean_speed: speeds.mean(),
        }
    }

    /// Wavelength \[m\] and mean growth rate per passage \[-\] of each place.
    pub fn rates(&self) -> impl Iterator<Item = (f64, f64)> {
        self.wavelengths.iter().copied().zip(self.rates.iter().copied())
    }

    /// Mean growth rate per passage \[-\] at a wavelength \[m\]; None outside the wavelengths asked for.
    pub fn rate_at(&self, wavelength: f64) -> Option<f64> {
        let above = self.wavelengths.iter().position(|&other| other >= wavelength)?;
        if above == 0 {
            return (self.wavelengths[0] == wavelength).then(|| self.rates[0]);
        }
        let (low, high) = (self.wavelengths[above - 1], self.wavelengths[above]);
        let share = (wavelength / low).ln() / (high / low).ln();
        Some(self.rates[above - 1] + share * (self.rates[above] - self.rates[above - 1]))
    }

    /// Wavelength \[m\] of the highest mean growth rate and that rate, where anything grows.
    pub fn peak(&self) -> Option<(f64, f64)> {
        if let Some(spectrum) = &self.spectrum {
            let place = spectrum.highest();
            let peak = (spectrum.wavelengths[place], spectrum.rates[place]);
            return (peak.1 > 0.0).then_some(peak);
        }
        let peak = self.rates().max_by(|a, b| a.1.total_cmp(&b.1))?;
        (peak.1 > 0.0).then_some(peak)
    }

    /// Frequency \[Hz\] of the highest growth at the mean speed.
    pub fn peak_frequency(&self) -> Option<f64> {
        self.peak().map(|(wavelength, _)| self.mean_speed / wavelength)
    }

    /// Wavelengths \[m\] about the peak that grow at least half as fast.
    pub fn range(&self) -> Option<(f64, f64)> {
        let (place, highest) = self.peak()?;
        let (wavelengths, rates) = match &self.spectrum {
            Some(spectrum) => (&spectrum.wavelengths, &spectrum.rates),
            None => (&self.wavelengths, &self.rates),
        };
        let peak = wavelengths.iter().position(|&other| other == place)?;
        let grows = |index: &usize| rates[*index] >= 0.5 * highest;
        let first = (0..=peak).rev().take_while(grows).last()?;
        let last = (peak..rates.len()).take_while(grows).last()?;
        Some((wavelengths[first], wavelengths[last]))
    }

    /// Whether a wavelength \[m\] known to ±`uncertainty` of ln λ grows at least half as fast as any: somewhere within the
    /// uncertainty.
    pub(super) fn covers(&self, wavelength: f64, uncertainty: f64) -> bool {
        let Some((_, highest)) = self.peak() else {
            return false;
        };
        let room = uncertainty.exp();
        let (from, to) = (wavelength / room, wavelength * room);
        let (wavelengths, rates) = match &self.spectrum {
            Some(spectrum) => (&spectrum.wavelengths, &spectrum.rates),
            None => (&self.wavelengths, &self.rates),
        };
        let mut places = wavelengths.iter().zip(rates);
        places.any(|(place, rate)| (from..=to).contains(place) && *rate >= 0.5 * highest)
            || self.rate_at(wavelength).is_some_and(|rate| rate >= 0.5 * highest)
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
            .map(|(place, rate)| rate.max(0.0) * step * density((place / wavelength).ln() / spread) / spread)
            .sum();
        sum / self.integral
    }
}

/// ∫ of the positive part over ln λ, of wavelengths in equal ratios.
fn integral(wavelengths: &[f64], rates: &[f64]) -> f64 {
    let step = (wavelengths[1] / wavelengths[0]).ln();
    rates.iter().map(|rate| rate.max(0.0) * step).sum()
}

/// Mean of the positive part over ln λ between two wavelengths \[m\], by the trapezoidal rule; of none, as it is.
fn mean_over(spectrum: &GrowthSpectrum, from: f64, to: f64) -> f64 {
    let inside = spectrum.wavelengths.iter().zip(&spectrum.rates);
    let inside = inside.filter(|(place, _)| from < **place && **place < to);
    let mut before = (from, spectrum.at(from));
    let mut sum = 0.0;
    let end = (to, spectrum.at(to));
    for after in inside.map(|(place, rate)| (*place, *rate)).chain([end]) {
        sum += 0.5 * (before.1.max(0.0) + after.1.max(0.0)) * (after.0 / before.0).ln();
        before = after;
    }
    match sum > 0.0 {
        true => sum / (to / from).ln(),
        // What decays everywhere tells how fast.
        false => spectrum.at((from * to).sqrt()).min(0.0),
    }
}
