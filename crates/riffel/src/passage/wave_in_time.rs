//! The wave's own geometry in time.

use std::f64::consts::TAU;
use std::sync::Arc;

use num_complex::Complex64;

use super::LateContact;
use crate::contact::{ContactFilter, RollingContact, WaveGeometry};
use crate::feedback::Contact;

/// The geometry of the waves under a contact, see [`WaveGeometry`].
///
/// Where the profile r has the curvature κ, R k²Φ r of each of its waves, the contact rolls by the factor 1/(1 + κ) slower than the wheel:
/// creepages are slip per metre rolled, c = (1 + κ) s/V, exact but for the place x − x_c = R r' at which they are read, which is of second
/// order. Creep forces change by Q_κ κ under the same load and creepages, of first order in κ, up to friction.
///
/// A contact that [answers late](Self::late_of) resolves its patch: what its response makes of each wave at constant load and slip speed is added to what
/// it makes of both. One that slides everywhere presses and wears by the mean over its patch.
#[derive(Clone)]
pub struct WaveInTime {
    geometry: WaveGeometry,
    /// Q_κ \[N\].
    by_radius: [f64; 2],
    /// Energy left on a metre of rail \[J/m\] by κ at constant load and slip speed.
    energy: f64,
    late: Option<Late>,
}

/// The response of a contact that answers late.
#[derive(Clone)]
struct Late {
    rolling: Arc<dyn RollingContact>,
    /// How far behind the centre the place is whose energy is told \[m\].
    behind: f64,
    /// Shortest and longest wave that it tells \[m\].
    range: [f64; 2],
}

impl WaveInTime {
    /// That of a contact of the linear loop which answers at once; `None` if the wave's geometry has no part there, and where the contact
    /// answers late.
    pub fn of(contact: &Contact) -> Option<Self> {
        /// Any: a contact that answers at once answers all waves alike.
        const WAVELENGTH: f64 = 0.1;
        let geometry = contact.wave.clone()?;
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
            late: None,
        })
    }

    /// That of a contact which answers late along the rail, by a response that tells what waves do, from `shortest` to `longest` \[m\]: longer ones
    /// do what the longest does by their curvature, shorter ones nothing.
    pub fn late_of(
        geometry: WaveGeometry,
        rolling: Arc<dyn RollingContact>,
        late: &LateContact,
        range: [f64; 2],
    ) -> Self {
        Self { geometry, by_radius: [0.0; 2], energy: 0.0, late: Some(Late { rolling, behind: late.behind(), range }) }
    }

    /// κ \[1/m\] over the amplitude of a wave \[m\].
    pub(super) fn per_metre(&self, wavelength: f64) -> f64 {
        match &self.late {
            Some(late) if wavelength < late.range[0] => 0.0,
            _ => self.geometry.curvature(TAU / wavelength),
        }
    }

    /// κ \[1/m\] by which the patch changes its shape.
    pub(super) fn patch_per_metre(&self, wavelength: f64) -> f64 {
        self.geometry.patch_curvature(TAU / wavelength)
    }

    /// Creep force along the rail \[N/m\], and energy of the place behind \[J/m²\], that a late contact makes of a wave.
    pub(super) fn late(&self, wavelength: f64) -> [Complex64; 2] {
        let curvature = self.per_metre(wavelength);
        let Some(late) = self.late.as_ref().filter(|_| curvature > 0.0) else {
            return [Complex64::ZERO; 2];
        };
        let told = late.rolling.response(wavelength.min(late.range[1]));
        told.by_curvature.map_or([Complex64::ZERO; 2], |by| {
            let behind = Complex64::cis(-TAU * late.behind / wavelength);
            [by.force[0] * curvature, by.at_rail(0.0) * curvature * behind]
        })
    }

    /// What a contact that slides everywhere presses and wears by.
    pub(super) fn filter(&self) -> Option<ContactFilter> {
        self.geometry.filter()
    }

    /// Whether the contact slides everywhere.
    pub(super) fn is_sliding(&self) -> bool {
        self.geometry.is_sliding()
    }

    /// F of a wave.
    pub(super) fn pressed(&self, wavelength: f64) -> f64 {
        self.geometry.pressed(TAU / wavelength)
    }

    /// Change of the creep forces under the same load and creepages \[N\].
    pub(super) fn force(&self, curvature: f64) -> [f64; 2] {
        self.by_radius.map(|force| force * curvature)
    }

    /// Energy left on a metre of rail \[J/m\] over κ, at constant load and slip speed.
    pub(super) fn energy(&self) -> f64 {
        self.energy
    }
}
