//! Steady creep laws: tangential force of a rolling contact against creepage.

mod carter2d;
mod carter3d;
mod catalogue;
mod creep_ellipse;
mod fastsim;
mod full_sliding;
mod johnson_vermeulen;
mod polach;
mod shen_hedrick_elkins;

pub use carter2d::{Carter2d, LineContact};
pub use carter3d::Carter3d;
pub use catalogue::{CATALOGUE, CreepLawEntry, CreepLawInputs};
pub use creep_ellipse::CreepEllipse;

pub use fastsim::{ContactCell, Fastsim, TractionBound, TractionDistribution};
pub use full_sliding::FullSliding;
pub use johnson_vermeulen::JohnsonVermeulen;
pub use polach::{FallingFriction, Polach, SlopeReduction};
pub use shen_hedrick_elkins::ShenHedrickElkins;

use std::sync::Arc;

use riffel_numerics::bisection::bisection;

/// Relative rigid motion of wheel and rail, per metre rolled.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Creepages {
    /// Longitudinal creepage ξ \[-\], positive in braking.
    pub longitudinal: f64,
    /// Lateral creepage η \[-\].
    pub lateral: f64,
    /// Spin φ \[1/m\]; positive spin alone gives a positive lateral force.
    pub spin: f64,
}

impl Creepages {
    /// Longitudinal creepage ξ \[-\] alone.
    pub fn longitudinal(creepage: f64) -> Self {
        Self { longitudinal: creepage, ..Self::default() }
    }

    /// Slip of the rigid bodies along and across per metre rolled, (ξ − φy, η + φx), at a place of a flat patch \[m\].
    pub fn rigid_slip(self, x: f64, y: f64) -> [f64; 2] {
        [self.longitudinal - self.spin * y, self.lateral + self.spin * x]
    }

    /// Magnitude |ξ| of longitudinal and lateral creepage \[-\].
    pub fn magnitude(self) -> f64 {
        self.longitudinal.hypot(self.lateral)
    }
}

/// Tangential force in the plane of contact, or a rate of it. A positive creepage gives a positive
/// force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CreepForces {
    /// Along the rail, Q \[N\].
    pub longitudinal: f64,
    /// Across the rail \[N\].
    pub lateral: f64,
}

impl CreepForces {
    /// Magnitude of the force \[N\].
    pub fn magnitude(self) -> f64 {
        self.longitudinal.hypot(self.lateral)
    }

    fn dot(self, other: Self) -> f64 {
        self.longitudinal * other.longitudinal + self.lateral * other.lateral
    }

    /// `factor` times this plus `other_factor` times the other.
    pub(crate) fn combine(self, factor: f64, other: Self, other_factor: f64) -> Self {
        Self {
            longitudinal: factor * self.longitudinal + other_factor * other.longitudinal,
            lateral: factor * self.lateral + other_factor * other.lateral,
        }
    }
}

/// Partial derivatives of both creep forces, the other arguments held constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepDerivatives {
    /// By normal force P, at constant creepages \[-\].
    pub by_normal_force: CreepForces,
    /// By longitudinal creepage ξ, at constant normal force \[N\].
    pub by_longitudinal: CreepForces,
    /// By lateral creepage η, at constant normal force \[N\].
    pub by_lateral: CreepForces,
}

impl CreepDerivatives {
    /// Completes the two derivatives by creepage for a law of the form
    /// F = P Φ(ξ P^{−1/3}, η P^{−1/3}, φ), to which every frictional contact of a Hertzian ellipse
    /// belongs: P ∂F/∂P = F − (ξ ∂F/∂ξ + η ∂F/∂η)/3.
    pub(in crate::contact) fn of_ellipse(
        normal_force: f64,
        creepages: Creepages,
        forces: CreepForces,
        by_longitudinal: CreepForces,
        by_lateral: CreepForces,
    ) -> Self {
        let along_creepages =
            by_longitudinal.combine(creepages.longitudinal / 3.0, by_lateral, creepages.lateral / 3.0);
        Self {
            by_normal_force: forces.combine(1.0 / normal_force, along_creepages, -1.0 / normal_force),
            by_longitudinal,
            by_lateral,
        }
    }
}

/// Where the longitudinal force of a creep law stops growing with longitudinal creepage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ForceLimit {
    /// The patch slips everywhere from this creepage \[-\] on, and the force is μP; zero for a law of full sliding.
    FullSlip(f64),
    /// The force has its first maximum at this creepage \[-\] and falls beyond it.
    AdhesionMaximum(f64),
    /// The force grows at every creepage up to one, the locked wheel.
    None,
}

impl ForceLimit {
    /// The creepage \[-\] below which the force grows, at most that of a locked wheel if the law
    /// sets no limit.
    pub fn creepage(self) -> f64 {
        match self {
            Self::FullSlip(creepage) | Self::AdhesionMaximum(creepage) => creepage,
            Self::None => 1.0,
        }
    }
}

/// A slope of its own at zero creepage, in place of Kalker's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OwnSlope {
    /// Creep coefficient of the patch \[-\].
    pub creep_coefficient: f64,
    /// Saturation creepage ξ_max \[-\] under the load of the contact, where the patch begins to slip everywhere.
    pub saturation_creepage: f64,
}

/// A steady creep law: tangential force against normal force and creepages.
///
/// Every law is odd in the creepages and bounded by friction, and, unless it says otherwise, its
/// slope at zero creepage is that of Kalker's linear theory, [`CreepEllipse::linear_forces`].
pub trait CreepLaw: Send + Sync {
    /// Coefficient of friction μ \[-\] to which tractive ratios refer. The force never exceeds μP.
    fn friction(&self) -> f64;

    /// Creep forces \[N\] under any normal force P > 0 \[N\]. The patch grows with the load; the
    /// semi-axes of an ellipse are proportional to P^{1/3}.
    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces;

    /// Derivatives of [`forces`](Self::forces). At a corner, such as the onset of full slip, the
    /// value is that of one side or a mean of both.
    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives;

    /// Where the longitudinal force stops growing, in pure longitudinal creepage under the normal
    /// force P > 0 \[N\].
    fn limit(&self, normal_force: f64) -> ForceLimit;

    /// The slope of a law that begins with another than Kalker's.
    fn own_slope(&self) -> Option<OwnSlope> {
        None
    }

    /// The longitudinal creepage \[-\] of the tractive ratio τ = Q/μP \[-\], 0 < τ < 1, below
    /// [`limit`](Self::limit); `None` if the law does not reach it.
    ///
    /// Provided: bracketed between zero and the limit and bisected to rounding, some sixty forces.
    fn creepage(&self, normal_force: f64, tractive_ratio: f64) -> Option<f64> {
        let tangential_force = tractive_ratio * self.friction() * normal_force;
        let force = |creepage: f64| self.forces(normal_force, Creepages::longitudinal(creepage)).longitudinal;
        let limit = self.limit(normal_force).creepage();
        if force(limit) <= tangential_force {
            return None;
        }
        let [_, first] = bisection([0.0, limit], 0.0, |creepage| force(creepage) >= tangential_force);
        Some(first)
    }
}

impl<L: CreepLaw + ?Sized> CreepLaw for Arc<L> {
    fn friction(&self) -> f64 {
        (**self).friction()
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        (**self).forces(normal_force, creepages)
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        (**self).derivatives(normal_force, creepages)
    }

    fn limit(&self, normal_force: f64) -> ForceLimit {
        (**self).limit(normal_force)
    }

    fn own_slope(&self) -> Option<OwnSlope> {
        (**self).own_slope()
    }

    fn creepage(&self, normal_force: f64, tractive_ratio: f64) -> Option<f64> {
        (**self).creepage(normal_force, tractive_ratio)
    }
}

#[cfg(test)]
pub(super) mod checks;
#[cfg(test)]
mod comparison;
