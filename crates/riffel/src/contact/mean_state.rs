//! The steady state about which corrugation is a small perturbation.

use super::{CreepForces, Creepages};
use crate::Error;

/// What is known of the steady state: the force, or the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MeanState {
    /// Tractive ratio τ = Q₀/μP₀ \[-\] of longitudinal creepage alone.
    TractiveRatio(f64),
    /// Creepages.
    Creepages(Creepages),
}

impl MeanState {
    /// Longitudinal creepage ξ₀ \[-\] alone.
    pub fn creepage(creepage: f64) -> Self {
        Self::Creepages(Creepages::longitudinal(creepage))
    }

    /// `Ok` if a tractive ratio lies between 0 and 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] with the rule.
    pub(super) fn check_tractive_ratio(ratio: f64) -> Result<(), Error> {
        if ratio > 0.0 && ratio < 1.0 {
            return Ok(());
        }
        Err(Error::OutOfRange {
            quantity: "tractive ratio",
            value: ratio,
            unit: "",
            rule: "must lie between 0 and 1, both excluded",
        })
    }
}

/// The steady rolling state about which corrugation is a small perturbation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanRolling {
    /// Normal force P₀ \[N\].
    pub normal_force: f64,
    /// Coefficient of friction μ \[-\].
    pub friction: f64,
    /// Creepages; the longitudinal one, ξ₀ = 1 − Ω₀R/V \[-\], is positive in braking.
    pub creepages: Creepages,
    /// Creep forces; each is positive with its positive creepage.
    pub forces: CreepForces,
}

impl MeanRolling {
    /// Tractive ratio τ = |Q₀|/μP₀ \[-\].
    pub fn tractive_ratio(&self) -> f64 {
        self.forces.magnitude() / (self.friction * self.normal_force)
    }

    /// Whether all of the contact slides: its tractive ratio is 1, which belongs to no creepage.
    pub fn slides(&self) -> bool {
        self.tractive_ratio() > 1.0 - 1e-6
    }

    /// Energy dissipated per metre of rail, e₀ = ξ₀·Q₀ \[J/m\], without the work of a spin moment; the power is
    /// W₀ = V e₀, equation (8).
    pub fn energy_per_metre(&self) -> f64 {
        self.creepages.longitudinal * self.forces.longitudinal + self.creepages.lateral * self.forces.lateral
    }

    /// The energy per metre μP₀|ξ₀| \[J/m\] that makes Ŵ₁ of equation (20) dimensionless.
    ///
    /// This is the dissipation of full slip at the same creepages; in longitudinal creepage alone 1/τ times
    /// [`energy_per_metre`](Self::energy_per_metre).
    pub fn full_slip_energy_per_metre(&self) -> f64 {
        self.friction * self.normal_force * self.creepages.magnitude()
    }
}
