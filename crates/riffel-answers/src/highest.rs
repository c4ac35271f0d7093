//! The wavelength that grows fastest at one speed.

use std::f64::consts::LN_2;

use serde::Serialize;

/// The wavelength that grows fastest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Highest {
    /// Wavelength \[m\], one of those of the answer.
    pub wavelength: f64,
    /// Frequency \[Hz\].
    pub frequency: f64,
    /// Growth rate per passage \[-\].
    pub rate: f64,
    /// It is the first or the last of the wavelengths: a shorter or longer one may grow faster.
    pub at_edge: bool,
}

impl Highest {
    /// Of rates at wavelengths \[m\] and one speed \[m/s\]; none where none is above zero.
    pub(crate) fn of(wavelengths: &[f64], rates: &[f64], speed: f64) -> Option<Self> {
        let rates = rates.iter().enumerate();
        let (place, &rate) = rates.max_by(|a, b| a.1.total_cmp(b.1))?;
        let wavelength = *wavelengths.get(place)?;
        (rate > 0.0).then(|| Self {
            wavelength,
            frequency: speed / wavelength,
            rate,
            at_edge: place == 0 || place + 1 == wavelengths.len(),
        })
    }

    /// Passages in which the amplitude doubles.
    pub fn doubling_passages(&self) -> f64 {
        LN_2 / self.rate
    }
}

/// The fastest wavelength, as documents hold it.
#[derive(Serialize)]
pub(crate) struct HighestDocument {
    wavelength_m: f64,
    frequency_hz: f64,
    growth_rate_per_passage: f64,
    doubling_passages: f64,
    /// It sits at an end of the wavelengths: another may grow faster.
    at_edge: bool,
}

impl From<Highest> for HighestDocument {
    fn from(highest: Highest) -> Self {
        Self {
            wavelength_m: highest.wavelength,
            frequency_hz: highest.frequency,
            growth_rate_per_passage: highest.rate,
            doubling_passages: highest.doubling_passages(),
            at_edge: highest.at_edge,
        }
    }
}
