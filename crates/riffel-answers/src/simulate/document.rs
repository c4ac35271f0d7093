//! What `riffel simulate --json` prints.

use riffel::Complex64;
use riffel::passage::Harmonic;
use serde::Serialize;

use super::Course;

/// The settled state over a sinusoid.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SinusoidDocument {
    /// Wavelength of the profile.
    pub wavelength_m: f64,
    /// Speed.
    pub speed_m_per_s: f64,
    /// Amplitude of the profile.
    pub amplitude_m: f64,
    /// Step of the march.
    pub step_m: f64,
    /// Harmonics n = 0 … 5.
    pub harmonics: Vec<HarmonicDocument>,
    /// Share of the time without contact.
    pub contact_loss_fraction: f64,
    /// Least normal force.
    pub minimum_normal_force_n: f64,
    /// Largest normal force.
    pub maximum_normal_force_n: f64,
    /// Mean square of the relative error of the track in time.
    pub track_share_cut: f64,
}

/// One passage along a profile.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PassageDocument {
    /// Speed.
    pub speed_m_per_s: f64,
    /// Step of the march.
    pub step_m: f64,
    /// Run-in before the profile.
    pub run_in_m: f64,
    /// Mean energy dissipated per metre.
    pub mean_dissipation_j_per_m: f64,
    /// Mean creepage.
    pub mean_creepage: f64,
    /// Share of the time without contact.
    pub contact_loss_fraction: f64,
    /// Least normal force at any step.
    pub minimum_normal_force_n: f64,
    /// Largest normal force at any step.
    pub maximum_normal_force_n: f64,
    /// Mean square of the relative error of the track in time.
    pub track_share_cut: f64,
    /// Place by place.
    #[serde(flatten)]
    pub course: Course,
}

/// One harmonic: complex amplitudes for exp(+inωt) relative to the profile Δ cos ωt upward; of harmonic zero the means.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HarmonicDocument {
    /// Normal force.
    pub normal_force_n: [f64; 2],
    /// Creep force.
    pub tangential_force_n: [f64; 2],
    /// Creepage.
    pub creepage: [f64; 2],
    /// Energy dissipated per metre at the wheel centre.
    pub dissipation_j_per_m: [f64; 2],
}

impl From<&Harmonic> for HarmonicDocument {
    fn from(harmonic: &Harmonic) -> Self {
        let pair = |value: Complex64| [value.re, value.im];
        Self {
            normal_force_n: pair(harmonic.normal_force),
            tangential_force_n: pair(harmonic.tangential_force),
            creepage: pair(harmonic.creepage),
            dissipation_j_per_m: pair(harmonic.dissipation),
        }
    }
}
