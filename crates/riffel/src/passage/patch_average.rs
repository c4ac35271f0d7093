//! What contacts feel of a wave.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::fourier_series::{series, spectrum};
use super::{ContactInTime, PassageModel};
use crate::contact::ContactFilter;
use crate::roughness::Profile;

/// Number of the effects of a wave.
const EFFECTS: usize = 5;

/// Effects of a wave on a contact at a place, each linear in its height.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PatchAverage {
    /// Height \[m\], as it presses.
    pub(super) height: f64,
    /// r' \[-\], along which the normal force is turned.
    pub(super) slope: f64,
    /// κ \[-\].
    pub(super) curvature: f64,
    /// What a contact that answers late makes of the wave under its mean load and slip speed: creep force along the rail \[N\].
    pub(super) force: f64,
    /// Energy that the place behind it receives \[J/m\].
    pub(super) energy: f64,
}

impl PatchAverage {
    fn parts(self) -> [f64; EFFECTS] {
        [self.height, self.slope, self.curvature, self.force, self.energy]
    }

    fn of([height, slope, curvature, force, energy]: [f64; EFFECTS]) -> Self {
        Self { height, slope, curvature, force, energy }
    }

    /// A multiple.
    pub(super) fn times(self, factor: f64) -> Self {
        Self::of(self.parts().map(|part| factor * part))
    }

    /// What lies between four of them at equal distances, each part by itself.
    pub(super) fn between(four: [Self; 4], by: impl Fn([f64; 4]) -> f64, beside_height: bool) -> Self {
        let height = by(four.map(|averaged| averaged.height));
        if !beside_height {
            return Self { height, ..Self::default() };
        }
        let four = four.map(Self::parts);
        let mut parts: [f64; EFFECTS] = std::array::from_fn(|part| by(std::array::from_fn(|index| four[index][part])));
        parts[0] = height;
        Self::of(parts)
    }
}

/// The effects of a wave by its complex height, the height itself first.
#[derive(Debug, Clone, Copy)]
pub(super) struct PatchAverageWave(pub(super) [Complex64; EFFECTS]);

impl PatchAverageWave {
    /// A multiple.
    pub(super) fn times(self, factor: f64) -> Self {
        Self(self.0.map(|part| factor * part))
    }

    /// Where the wave has the given phase, e^{ikx}.
    pub(super) fn at(&self, phase: Complex64) -> PatchAverage {
        PatchAverage::of(self.0.map(|part| (part * phase).re))
    }
}

impl PassageModel {
    /// Whether a contact feels more of waves than their height.
    pub(super) fn feels_more_than_height(&self, contact: &ContactInTime) -> bool {
        contact.wave.is_some() || self.structures.direction().is_some()
    }

    /// The filter that a contact presses by: that of the model, or its own where it slides everywhere.
    pub(super) fn filter_of(&self, contact: &ContactInTime) -> Option<ContactFilter> {
        let own = contact.wave.as_ref().and_then(|wave| wave.filter());
        own.or(self.contact_filter)
    }

    /// The effects of a wave on a contact, over its amplitude.
    pub(super) fn average_of_wave(&self, contact: &ContactInTime, wavelength: f64) -> PatchAverageWave {
        let wavenumber = TAU / wavelength;
        let filter = self.filter_of(contact);
        let mut parts = [Complex64::ZERO; EFFECTS];
        parts[0] = filter.map_or(1.0, |filter| filter.amplitude(wavenumber, 0.0)).into();
        if self.structures.direction().is_some() {
            parts[1] = Complex64::new(0.0, wavenumber);
        }
        if let Some(wave) = &contact.wave {
            parts[2] = wave.per_metre(wavelength).into();
            [parts[3], parts[4]] = wave.late(wavelength);
        }
        PatchAverageWave(parts)
    }

    /// The effects on a contact of equidistant heights around a ring.
    pub(super) fn averages_around(&self, contact: &ContactInTime, heights: &[f64], spacing: f64) -> Vec<PatchAverage> {
        let plain = self.filter_of(contact).is_none();
        let mut averaged: Vec<PatchAverage> =
            heights.iter().map(|&height| PatchAverage { height, ..PatchAverage::default() }).collect();
        if plain && !self.feels_more_than_height(contact) {
            return averaged;
        }
        let length = heights.len() as f64 * spacing;
        let waves = spectrum(heights);
        let effects: Vec<PatchAverageWave> =
            (1..waves.len()).map(|n| self.average_of_wave(contact, length / n as f64)).collect();
        for part in usize::from(plain)..EFFECTS {
            let mut waves = waves.clone();
            if part > 0 {
                waves[0] = Complex64::ZERO;
            }
            for (wave, PatchAverageWave(effects)) in waves.iter_mut().skip(1).zip(&effects) {
                *wave *= effects[part];
            }
            for (averaged, value) in averaged.iter_mut().zip(series(waves, heights.len())) {
                let mut parts = averaged.parts();
                parts[part] = value;
                *averaged = PatchAverage::of(parts);
            }
        }
        averaged
    }

    /// What of the effects on a contact is not height, at the heights of a profile, which goes on beyond its ends mirrored in them, so that
    /// nothing bends there.
    pub(super) fn averages_along(&self, contact: &ContactInTime, profile: &Profile) -> Vec<PatchAverage> {
        let heights = profile.heights();
        if !self.feels_more_than_height(contact) {
            return vec![PatchAverage::default(); heights.len()];
        }
        let last = heights.len() - 1;
        let rise = (heights[last] - heights[0]) / last as f64;
        let over_line = |index: usize| heights[index] - heights[0] - rise * index as f64;
        let there = (0..=last).map(over_line);
        let back = (1..last).rev().map(|index| -over_line(index));
        let ring: Vec<f64> = there.chain(back).collect();
        let mut averaged = self.averages_around(contact, &ring, profile.spacing());
        averaged.truncate(heights.len());
        averaged
    }
}
