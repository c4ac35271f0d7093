//! Linear response of a rolling contact to small oscillations.

use num_complex::Complex64;

use super::{CreepForces, Creepages, MeanRolling};

/// Linear response of a rolling contact at one wavelength: to the normal force and to each creepage, the other inputs
/// held constant.
///
/// Complex, because a non-steady contact answers late; a quasi-static one has no imaginary part.
/// Dissipation is the energy e = W/V left on a metre of rail \[J/m\]: unlike the power W it does not
/// depend on speed, so neither does any of the derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactResponse {
    /// By the normal force P \[N\].
    pub by_load: ContactDerivative,
    /// By the longitudinal creepage ξ \[-\].
    pub by_longitudinal: ContactDerivative,
    /// By the lateral creepage η \[-\]; `None` if the contact does not tell it.
    pub by_lateral: Option<ContactDerivative>,
    /// By the spin φ \[1/m\]; `None` if the contact does not tell it.
    pub by_spin: Option<ContactDerivative>,
    /// By the curvature κ \[-\] of a [wave](super::WaveGeometry) at constant load and slip speed, where every creepage is c₀(1 + κ);
    /// `None` if the contact does not tell it.
    pub by_curvature: Option<ContactDerivative>,
}

/// The creepages whose oscillation a response is asked about, besides the load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OscillatingCreepages {
    /// The longitudinal one alone: all that a loop along the rail asks for.
    Longitudinal,
    /// Longitudinal and lateral: what a loop on all axes asks for.
    InPlane,
    /// Spin as well.
    All,
}

/// What oscillates, besides the load, where a response is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Oscillating {
    pub(super) creepages: OscillatingCreepages,
    /// The rail has a wave of its own geometry.
    pub(super) profile: bool,
}

impl OscillatingCreepages {
    /// These, and the curvature of a wave.
    pub fn on_waves(self) -> Oscillating {
        Oscillating { creepages: self, profile: true }
    }
}

impl From<OscillatingCreepages> for Oscillating {
    fn from(creepages: OscillatingCreepages) -> Self {
        Self { creepages, profile: false }
    }
}

/// What one input does to a rolling contact, per unit of the input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactDerivative {
    /// Creep force along and across the rail \[N per unit\].
    pub force: [Complex64; 2],
    /// Energy left on a metre of rail, as the whole patch spends it at this instant \[J/m per unit\].
    pub energy: Complex64,
    /// Energy left at a point of the rail over the whole passage of the patch \[J/m per unit\], relative to the input
    /// at the instant at which the wheel centre passes the point; `None` if the contact does not resolve its patch
    /// and the place of wear is a joint of its own.
    pub energy_at_rail: Option<Complex64>,
    /// What the grid of a contact that is cut into elements may miss; none for a law that has no grid.
    pub error: Option<GridError>,
}

/// Estimate of what a grid misses of a derivative, an upper bound of the modulus of the complex error, in the units of
/// the derivative.
///
/// Three times the typical error. Tested against grids of twice as many elements, at states that were not used to
/// find it (see the test `errors_are_bounded`); it says nothing of what the theory itself leaves out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridError {
    /// Of the creep force along and across the rail \[N per unit\].
    pub force: f64,
    /// Of the energy, both at this instant and at a point of the rail \[J/m per unit\].
    pub energy: f64,
}

impl ContactResponse {
    /// The response with that of a contact about a mean state to the curvature of a wave, whose forces under constant load and
    /// creepages \[N\] are `by_radius`: F_κ + F_c c₀ for the force, (F_κ + F_c c₀)·c₀ + F₀·c₀ for the energy. Without the moment of spin.
    pub(super) fn with_curvature(mut self, by_radius: CreepForces, steady: &MeanRolling) -> Self {
        let (mean, forces) = (steady.creepages, steady.forces);
        let [along, across] = self.force_by_creepages(mean);
        let force = [by_radius.longitudinal + along, by_radius.lateral + across];
        let energy = mean.longitudinal * (force[0] + forces.longitudinal) + mean.lateral * (force[1] + forces.lateral);
        self.by_curvature = Some(ContactDerivative { force, energy, energy_at_rail: None, error: None });
        self
    }
}

impl ContactResponse {
    /// F_c c \[N\]: what creepages in proportion to `creepages` make of the creep force.
    pub(crate) fn force_by_creepages(&self, creepages: Creepages) -> [Complex64; 2] {
        let inputs = [
            (Some(self.by_longitudinal), creepages.longitudinal),
            (self.by_lateral, creepages.lateral),
            (self.by_spin, creepages.spin),
        ];
        let told = inputs.into_iter().filter_map(|(by, creepage)| Some((by?, creepage)));
        told.fold([Complex64::ZERO; 2], |sum, (by, creepage)| [0, 1].map(|axis| sum[axis] + by.force[axis] * creepage))
    }
}

impl ContactDerivative {
    /// The energy that a point of the rail receives: as the contact resolves it, or that at the wheel
    /// centre later by an angle \[rad\].
    pub fn at_rail(&self, lag: f64) -> Complex64 {
        self.energy_at_rail.unwrap_or_else(|| self.energy * Complex64::cis(-lag))
    }
}
