//! Wheel–rail contact: its size and stiffness, the steady creep law, and the response of creep
//! force and dissipation to small oscillations of load and creepage.

mod carter3d;
mod contact_filter;
mod creep_law;
mod elliptic;
mod elliptic_contact;
mod half_space;
mod hertz;
mod kalker;
mod kalker_coefficients;
mod kalker_table;
mod non_steady;
mod spring_dashpot;
mod unit_ellipse;

pub use carter3d::Carter3d;
pub use contact_filter::ContactFilter;
pub use creep_law::{
    Carter2d, ContactCell, CreepDerivatives, CreepEllipse, CreepForces, CreepLaw, Creepages,
    FallingFriction, Fastsim, ForceLimit, JohnsonVermeulen, LineContact, Polach, QuasiStatic,
    ShenHedrickElkins, SlopeReduction, TractionBound, TractionDistribution,
};
pub use elliptic::EllipticIntegrals;
pub use elliptic_contact::{ContactBody, EllipticContact};
pub use half_space::{
    ContactElement, ContactGrid, HalfSpace, HalfSpaceRolling, NormalContact, NormalState,
    TransientRolling, TransientStep,
};
pub use hertz::HertzContact;
pub use kalker::creep_coefficient;
pub use kalker_coefficients::KalkerCoefficients;
pub use non_steady::{NonSteady, SlowHalfSpace};
pub use spring_dashpot::SpringDashpot;

use num_complex::Complex64;

/// The steady rolling state about which corrugation is a small perturbation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyRolling {
    /// Normal force P₀ \[N\].
    pub normal_force: f64,
    /// Coefficient of friction μ \[-\].
    pub friction: f64,
    /// Creepage ξ₀ = 1 − Ω₀R/V \[-\], positive in braking.
    pub creepage: f64,
    /// Tangential force Q₀ \[N\], positive with positive creepage.
    pub tangential_force: f64,
}

impl SteadyRolling {
    /// Tractive ratio τ = Q₀/μP₀ \[-\].
    pub fn tractive_ratio(&self) -> f64 {
        self.tangential_force / (self.friction * self.normal_force)
    }

    /// Energy dissipated per metre of rail, e₀ = ξ₀Q₀ \[J/m\]; the power is W₀ = V e₀, equation (8).
    pub fn energy_per_metre(&self) -> f64 {
        self.creepage * self.tangential_force
    }

    /// The energy per metre μP₀ξ₀ \[J/m\] that makes Ŵ₁ of equation (20) dimensionless.
    ///
    /// This is the dissipation of full slip at the same creepage, 1/τ times
    /// [`energy_per_metre`](Self::energy_per_metre).
    pub fn full_slip_energy_per_metre(&self) -> f64 {
        self.friction * self.normal_force * self.creepage
    }
}

/// Linear response of a rolling contact at one wavelength.
///
/// Complex, because a non-steady contact answers late; a quasi-static one has no imaginary part.
/// Dissipation is the energy e = W/V left on a metre of rail \[J/m\]: unlike the power W it does not
/// depend on speed, so neither does any of the four derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactResponse {
    /// ∂Q/∂P at constant creepage \[-\].
    pub dq_dp: Complex64,
    /// ∂Q/∂ξ at constant normal force \[N\].
    pub dq_dxi: Complex64,
    /// ∂e/∂P at constant creepage \[m/m\].
    pub de_dp: Complex64,
    /// ∂e/∂ξ at constant normal force \[J/m\].
    pub de_dxi: Complex64,
    /// The energy that a point of the rail receives, where the contact resolves its patch; none where
    /// the place of wear is a joint of its own.
    pub at_rail: Option<RailDissipation>,
}

/// Energy left at a point of the rail over the whole passage of the patch, relative to the input at the
/// instant at which the wheel centre passes the point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RailDissipation {
    /// ∂e/∂P at constant creepage \[m/m\].
    pub de_dp: Complex64,
    /// ∂e/∂ξ at constant normal force \[J/m\].
    pub de_dxi: Complex64,
}

impl ContactResponse {
    /// The energy that a point of the rail receives: as the contact resolves it, or that at the wheel
    /// centre later by an angle \[rad\].
    pub fn at_rail(&self, lag: f64) -> RailDissipation {
        self.at_rail.unwrap_or_else(|| {
            let phase = Complex64::cis(-lag);
            RailDissipation {
                de_dp: self.de_dp * phase,
                de_dxi: self.de_dxi * phase,
            }
        })
    }
}

/// Joint of the loop: a wheel rolling on a rail with longitudinal creepage.
pub trait RollingContact: Send + Sync {
    /// The mean state.
    fn steady(&self) -> SteadyRolling;

    /// Response to oscillations of normal force and creepage of the given wavelength \[m\],
    /// referred to the instant at which the wheel centre passes.
    fn response(&self, wavelength: f64) -> ContactResponse;
}
