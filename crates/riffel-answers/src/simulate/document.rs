//! What `riffel simulate --json` prints.

use riffel::Complex64;
use riffel::passage::{ContactSwing, Harmonic};
use riffel_case::ContactName;
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
    /// Those of the energy that a place of the rail receives, of a transient contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_at_rail_j_per_m: Option<[[f64; 2]; 6]>,
    /// Share of the time without contact.
    pub contact_loss_fraction: f64,
    /// Least normal force.
    pub minimum_normal_force_n: f64,
    /// Largest normal force.
    pub maximum_normal_force_n: f64,
    /// Mean square of the relative error of the track in time, with the wheels of a loop on all axes.
    pub track_share_cut: f64,
    /// Every contact of a loop on all axes, the one above first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<ContactOverSinusoidDocument>,
}

/// One of several contacts over a sinusoid.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactOverSinusoidDocument {
    /// Which.
    #[serde(flatten)]
    pub name: ContactName,
    /// Harmonics n = 0 … 5.
    pub harmonics: Vec<HarmonicDocument>,
    /// Share of the time without contact.
    pub contact_loss_fraction: f64,
    /// Least normal force.
    pub minimum_normal_force_n: f64,
    /// Largest normal force.
    pub maximum_normal_force_n: f64,
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
    /// All other contacts of a loop on all axes, each at its own places.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub other_contacts: Vec<ContactCourseDocument>,
}

/// One of several contacts place by place.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactCourseDocument {
    /// Which.
    #[serde(flatten)]
    pub name: ContactName,
    /// Place by place.
    #[serde(flatten)]
    pub course: Course,
}

/// What wheels on a smooth rail do after a push.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SmoothRailDocument {
    /// Speed.
    pub speed_m_per_s: f64,
    /// Step of the march.
    pub step_m: f64,
    /// `at-rest`, `limit-cycle`, `runs-away` or `irregular`.
    pub outcome: &'static str,
    /// Time rolled until that was seen.
    pub rolled_s: f64,
    /// Frequency with which all forces repeat themselves; none at rest.
    pub frequency_hz: Option<f64>,
    /// Roots of the linear loop in the half-plane of growing oscillations.
    pub linear_unstable_roots: Option<usize>,
    /// Frequency that grows in the linear loop.
    pub linear_frequency_hz: Option<f64>,
    /// How fast its amplitude grows.
    pub linear_growth_rate_per_s: Option<f64>,
    /// Every contact, that of the first wheel on the rail under study first.
    pub contacts: Vec<ContactSwingDocument>,
    /// Mean square of the relative error of track and wheels in time.
    pub track_share_cut: f64,
    /// The first contact over a few periods at the end.
    #[serde(flatten)]
    pub course: Course,
}

/// Least and largest of what a contact did over the last half second.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactSwingDocument {
    /// Which.
    #[serde(flatten)]
    pub name: ContactName,
    /// Normal force.
    pub normal_force_n: [f64; 2],
    /// Longitudinal creep force.
    pub tangential_force_n: [f64; 2],
    /// Lateral creep force.
    pub lateral_force_n: [f64; 2],
    /// Longitudinal creepage.
    pub creepage: [f64; 2],
    /// Lateral creepage.
    pub lateral_creepage: [f64; 2],
    /// Share of the time below the creepage of the greatest creep force.
    pub stick_fraction: f64,
    /// Mean energy dissipated per metre.
    pub mean_dissipation_j_per_m: f64,
}

impl ContactSwingDocument {
    pub(super) fn new(name: ContactName, swing: &ContactSwing) -> Self {
        Self {
            name,
            normal_force_n: swing.normal_force,
            tangential_force_n: swing.tangential_force,
            lateral_force_n: swing.lateral_force,
            creepage: swing.creepage,
            lateral_creepage: swing.lateral_creepage,
            stick_fraction: swing.stick,
            mean_dissipation_j_per_m: swing.dissipation,
        }
    }
}

/// One harmonic: complex amplitudes for exp(+inωt) relative to the profile Δ cos ωt upward; of harmonic zero the means.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HarmonicDocument {
    /// Normal force.
    pub normal_force_n: [f64; 2],
    /// Creep force.
    pub tangential_force_n: [f64; 2],
    /// Creep force across the rail, of a loop on all axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lateral_force_n: Option<[f64; 2]>,
    /// Creepage.
    pub creepage: [f64; 2],
    /// Lateral creepage, of a loop on all axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lateral_creepage: Option<[f64; 2]>,
    /// Energy dissipated per metre at the wheel centre.
    pub dissipation_j_per_m: [f64; 2],
}

impl HarmonicDocument {
    /// With what is across the rail where the loop is `on_all_axes`.
    pub(super) fn new(harmonic: &Harmonic, on_all_axes: bool) -> Self {
        let pair = |value: Complex64| [value.re, value.im];
        let across = |value| on_all_axes.then(|| pair(value));
        Self {
            normal_force_n: pair(harmonic.normal_force),
            tangential_force_n: pair(harmonic.tangential_force),
            lateral_force_n: across(harmonic.lateral_force),
            creepage: pair(harmonic.creepage),
            lateral_creepage: across(harmonic.lateral_creepage),
            dissipation_j_per_m: pair(harmonic.dissipation),
        }
    }
}
