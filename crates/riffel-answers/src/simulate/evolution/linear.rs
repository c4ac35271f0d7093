//! The linear loop on the same rail.

use std::f64::consts::TAU;
use std::ops::Range;

use riffel::Complex64;
use riffel::passage::Evolution;
use riffel::roughness::{Profile, ThirdOctave, level};
use riffel_case::Case;

use super::WornProfile;
use super::bands::Bands;

/// Waves of a rail that grow as the linear loop says.
pub(super) struct Linear(Vec<LinearBand>);

/// Those of a band.
pub(super) struct LinearBand {
    pub(super) band: ThirdOctave,
    /// In the waves of the ring.
    places: Range<usize>,
    waves: Vec<LinearWave>,
}

struct LinearWave {
    /// Mean square before any wheel \[m²\].
    mean_square: f64,
    /// Growth of the amplitude in a passage \[-\].
    growth: f64,
    /// Shift along the rail in a passage \[m\].
    shift: f64,
}

impl Linear {
    /// The waves of a ring before any wheel, of heights \[m\] at equal distances \[m\].
    pub(super) fn new(
        case: &Case,
        speed: f64,
        bands: &Bands,
        heights: &[f64],
        spacing: f64,
    ) -> Self {
        let ring = Profile::new(0.0, spacing, heights.to_vec());
        // A case in time has that loop, and a ring that rolls its heights.
        let (Some(feedback), Ok(ring)) = (case.feedback.longitudinal(), ring) else {
            return Self(Vec::new());
        };
        let waves = Evolution::new(&ring).waves();
        let grown = |&(wavelength, amplitude): &(f64, Complex64)| {
            let state = feedback.at(wavelength, speed);
            let energy = state.dissipation_at_rail / speed / feedback.amplitude;
            let rate = -feedback.wear.depth_per_energy() * energy;
            LinearWave {
                mean_square: 0.5 * amplitude.norm_sqr(),
                growth: rate.re,
                shift: -rate.im * wavelength / TAU,
            }
        };
        let of_band = |(band, places): (ThirdOctave, Range<usize>)| LinearBand {
            band,
            waves: waves[places.clone()].iter().map(grown).collect(),
            places,
        };
        Self(bands.iter().map(of_band).collect())
    }

    pub(super) fn bands(&self) -> &[LinearBand] {
        &self.0
    }

    /// Heights \[m\] at places \[m\] of a profile, with the waves of the bands alone.
    pub(super) fn heights(&self, profile: &WornProfile, spacing: f64, places: &[f64]) -> Vec<f64> {
        let Ok(ring) = Profile::new(0.0, spacing, profile.heights_m.clone()) else {
            return vec![f64::NAN; places.len()];
        };
        let waves = Evolution::new(&ring).waves();
        let waves: Vec<(f64, Complex64)> = self
            .0
            .iter()
            .flat_map(|band| waves[band.places.clone()].iter().copied())
            .collect();
        let height = |place: &f64| {
            let of_wave = |(wavelength, amplitude): &(f64, Complex64)| {
                (amplitude * Complex64::from_polar(1.0, TAU * place / wavelength)).re
            };
            waves.iter().map(of_wave).sum()
        };
        places.iter().map(height).collect()
    }
}

impl LinearBand {
    /// Mean square after some passages \[m²\].
    pub(super) fn mean_square(&self, passages: u64) -> f64 {
        let waves = self.waves.iter();
        waves
            .map(|wave| wave.mean_square * (2.0 * wave.growth * passages as f64).exp())
            .sum()
    }

    /// Level after some passages \[dB re 1 µm\].
    pub(super) fn level(&self, passages: u64) -> f64 {
        level(self.mean_square(passages))
    }

    /// Shift in a passage of the rail before any wheel \[m\], in the mean of the power.
    pub(super) fn shift(&self) -> f64 {
        let moment: f64 = self
            .waves
            .iter()
            .map(|wave| wave.mean_square * wave.shift)
            .sum();
        moment / self.mean_square(0)
    }
}
