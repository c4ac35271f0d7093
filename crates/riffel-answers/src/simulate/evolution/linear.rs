//! The linear loop on the same rail.

use std::f64::consts::TAU;
use std::ops::Range;

use rayon::prelude::*;
use riffel::Complex64;
use riffel::passage::Evolution;
use riffel::roughness::{Profile, ThirdOctave, level};
use riffel_case::traffic::VehicleInTime;
use riffel_case::{Case, ask};
use riffel_keys::CaseError;

use super::WornProfile;
use super::bands::Bands;
use crate::Result;

/// Waves of a rail that grow as the linear loop says.
pub(super) struct Linear(Vec<LinearBand>);

/// Waves of one band.
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

/// Growth of a wave \[m\] under a wheel: −k_w/ρ2b of the energy at the rail by the height, in a passage.
type Growth<'a> = dyn Fn(f64) -> Result<Complex64, CaseError> + Sync + 'a;

impl Linear {
    /// The waves of a ring before any wheel, of heights \[m\] at equal distances \[m\], under the mean of the wheels.
    ///
    /// On discrete supports the growth is that of a wave [alone](riffel::growth::GrowthWithNeighbours::alone); on all axes, the mean of
    /// that at places of the bay, each as if the wheels stayed there.
    ///
    /// # Errors
    /// Errors of [`ask::growth_with_neighbours`](riffel_case::ask::growth_with_neighbours).
    pub(super) fn new(vehicles: &[VehicleInTime], bands: &Bands, heights: &[f64], spacing: f64) -> Result<Self> {
        let ring = Profile::new(0.0, spacing, heights.to_vec())?;
        let waves = Evolution::new(&ring).waves();
        let growth: &Growth<'_> = &|wavelength| {
            let mut mean = Complex64::ZERO;
            for vehicle in vehicles {
                for wheel in &vehicle.wheels {
                    let rate = rate(&vehicle.case, wavelength, wheel.model.speed)?;
                    let patch_average = wheel.model.patch_average(wavelength);
                    mean += wheel.share * wheel.traction_share * patch_average * rate;
                }
            }
            Ok(mean)
        };
        let grown = |&(wavelength, amplitude): &(f64, Complex64)| {
            let rate = growth(wavelength)?;
            Ok(LinearWave {
                mean_square: 0.5 * amplitude.norm_sqr(),
                growth: rate.re,
                shift: -rate.im * wavelength / TAU,
            })
        };
        let of_band = |(band, places): (ThirdOctave, Range<usize>)| {
            let waves: Result<Vec<LinearWave>, CaseError> = waves[places.clone()].par_iter().map(grown).collect();
            Ok(LinearBand { band, waves: waves?, places })
        };
        let linear: Result<Vec<LinearBand>> = bands.iter().map(of_band).collect();
        Ok(Self(linear?))
    }

    pub(super) fn bands(&self) -> &[LinearBand] {
        &self.0
    }

    /// Levels of the bands of a profile \[dB re 1 µm\].
    pub(super) fn levels(&self, profile: &WornProfile, spacing: f64) -> Vec<f64> {
        let Ok(ring) = Profile::new(0.0, spacing, profile.heights_m.clone()) else {
            return vec![f64::NAN; self.0.len()];
        };
        let waves = Evolution::new(&ring).waves();
        let power = |(_, amplitude): &(f64, Complex64)| 0.5 * amplitude.norm_sqr();
        let bands = self.0.iter();
        bands.map(|band| level(waves[band.places.clone()].iter().map(power).sum())).collect()
    }

    /// Heights \[m\] at places \[m\] of a profile, with the waves of the bands alone.
    pub(super) fn heights(&self, profile: &WornProfile, spacing: f64, places: &[f64]) -> Vec<f64> {
        let Ok(ring) = Profile::new(0.0, spacing, profile.heights_m.clone()) else {
            return vec![f64::NAN; places.len()];
        };
        let waves = Evolution::new(&ring).waves();
        let waves: Vec<(f64, Complex64)> =
            self.0.iter().flat_map(|band| waves[band.places.clone()].iter().copied()).collect();
        let height = |place: &f64| {
            let of_wave = |(wavelength, amplitude): &(f64, Complex64)| {
                (amplitude * Complex64::from_polar(1.0, TAU * place / wavelength)).re
            };
            waves.iter().map(of_wave).sum()
        };
        places.iter().map(height).collect()
    }
}

fn rate(case: &Case, wavelength: f64, speed: f64) -> Result<Complex64, CaseError> {
    /// Neighbours of a wave on each side, where these have a wavelength.
    const NEIGHBOURS: usize = 3;
    /// Of a bay: harmonics of it from this one on, some 10⁻³, stay in the mean.
    const PLACES: u32 = 16;
    let feedback = &case.feedback;
    let Some(spacing) = case.track.support_spacing() else {
        return Ok(feedback.complex_growth_rate(wavelength, speed));
    };
    if feedback.is_along_one_axis() {
        let most = (0.99 * spacing / wavelength) as usize;
        let most = most.min(NEIGHBOURS);
        let growth = ask::growth_with_neighbours(case, wavelength, speed, most)?;
        return Ok(growth.alone());
    }
    let at = |place: u32| {
        let position = spacing * f64::from(place) / f64::from(PLACES);
        let there = feedback.clone().at_position(position);
        there.complex_growth_rate(wavelength, speed)
    };
    Ok((0..PLACES).map(at).sum::<Complex64>() / f64::from(PLACES))
}

impl LinearBand {
    /// Mean square after some passages \[m²\].
    pub(super) fn mean_square(&self, passages: u64) -> f64 {
        let waves = self.waves.iter();
        waves.map(|wave| wave.mean_square * (2.0 * wave.growth * passages as f64).exp()).sum()
    }

    /// Level after some passages \[dB re 1 µm\].
    pub(super) fn level(&self, passages: u64) -> f64 {
        level(self.mean_square(passages))
    }

    /// Shift in a passage of the rail before any wheel \[m\], in the mean of the power.
    pub(super) fn shift(&self) -> f64 {
        let moment: f64 = self.waves.iter().map(|wave| wave.mean_square * wave.shift).sum();
        moment / self.mean_square(0)
    }
}
