//! The wave's own geometry in time.

use std::f64::consts::TAU;

use super::evolution::{series, spectrum};
use crate::contact::WaveGeometry;
use crate::feedback::Contact;
use crate::roughness::Profile;

/// The geometry of the waves under a contact that answers at once, see [`WaveGeometry`].
///
/// Where the profile r has the curvature κ, R k²Φ r of each of its waves, the contact rolls by the factor 1/(1 + κ) slower than the wheel:
/// creepages are slip per metre rolled, c = (1 + κ) s/V, exact but for the place x − x_c = R r' at which they are read, which is of second
/// order. Creep forces change by Q_κ κ under the same load and creepages, of first order in κ, up to friction.
#[derive(Debug, Clone)]
pub struct WaveInTime {
    geometry: WaveGeometry,
    /// Q_κ \[N\].
    by_radius: [f64; 2],
    /// Energy left on a metre of rail \[J/m\] by κ at constant load and slip speed.
    energy: f64,
}

impl WaveInTime {
    /// That of a contact of the linear loop; none where the wave's geometry has no part there, where the contact answers late, which
    /// needs its own response, and where it slides everywhere, whose load and wear are averaged.
    pub fn of(contact: &Contact) -> Option<Self> {
        /// Any: a contact that answers at once answers all waves alike.
        const WAVELENGTH: f64 = 0.1;
        let geometry = contact.wave.clone().filter(|wave| !wave.is_sliding())?;
        let response = contact.rolling.response(WAVELENGTH);
        let by_curvature = response.by_curvature?;
        if by_curvature.energy_at_rail.is_some() {
            return None;
        }
        let by_creepages = response.force_by_creepages(contact.rolling.steady().creepages);
        Some(Self {
            geometry,
            by_radius: [0, 1].map(|axis| (by_curvature.force[axis] - by_creepages[axis]).re),
            energy: by_curvature.energy.re,
        })
    }

    /// κ \[1/m\] over the amplitude of a wave \[m\].
    pub(super) fn per_metre(&self, wavelength: f64) -> f64 {
        self.geometry.curvature(TAU / wavelength)
    }

    /// Change of the creep forces under the same load and creepages \[N\].
    pub(super) fn force(&self, curvature: f64) -> [f64; 2] {
        self.by_radius.map(|force| force * curvature)
    }

    /// Energy left on a metre of rail \[J/m\] over κ, at constant load and slip speed.
    pub(super) fn energy(&self) -> f64 {
        self.energy
    }

    /// κ at equidistant heights around a ring.
    pub(super) fn around(&self, heights: &[f64], spacing: f64) -> Vec<f64> {
        let length = heights.len() as f64 * spacing;
        let mut waves = spectrum(heights);
        for (n, wave) in waves.iter_mut().enumerate() {
            *wave *= self.geometry.curvature(TAU * n as f64 / length);
        }
        series(waves, heights.len())
    }

    /// κ at the heights of a profile, which goes on beyond its ends mirrored in them, so that nothing bends there.
    pub(super) fn along(&self, profile: &Profile) -> Vec<f64> {
        let heights = profile.heights();
        let last = heights.len() - 1;
        let rise = (heights[last] - heights[0]) / last as f64;
        let over_line = |index: usize| heights[index] - heights[0] - rise * index as f64;
        let there = (0..=last).map(over_line);
        let back = (1..last).rev().map(|index| -over_line(index));
        let ring: Vec<f64> = there.chain(back).collect();
        let mut curvatures = self.around(&ring, profile.spacing());
        curvatures.truncate(heights.len());
        curvatures
    }
}
