//! Wheel–rail contact: its size and stiffness, the steady creep laws, and the response of creep
//! force and dissipation to small oscillations of load and creepage.

mod conformity;
mod ellipse;
mod half_space;
mod half_space_curve;
mod law;
mod load_wear;
mod mean_state;
mod moving_contact;
mod non_steady;
mod quasi_static;
mod quasi_static_half_space;
mod response;
mod rolling;
mod spring_dashpot;
mod virtual_penetration;
mod wave_geometry;

pub use conformity::Conformity;
pub use ellipse::{
    ContactBody, ContactFilter, CurvatureFilter, EllipticContact, EllipticIntegrals, HertzContact, KalkerCoefficients,
    creep_coefficient,
};
pub use half_space::{
    ContactElement, ContactGrid, HalfSpace, HalfSpaceRolling, NormalContact, NormalState, PatchRolling, PatchTractions,
    PressedOnRail, TransientRolling, TransientStep,
};
pub use half_space_curve::HalfSpaceCurve;
pub use law::{CATALOGUE as CREEP_LAWS, CreepLawEntry, CreepLawInputs};
pub use law::{
    Carter2d, Carter3d, ContactCell, CreepDerivatives, CreepEllipse, CreepForces, CreepLaw, Creepages, FallingFriction,
    Fastsim, ForceLimit, FullSliding, JohnsonVermeulen, LineContact, OwnSlope, Polach, ShenHedrickElkins,
    SlopeReduction, TractionBound, TractionDistribution,
};
pub use load_wear::LoadWear;
pub use mean_state::{MeanRolling, MeanState};
pub use moving_contact::{MovingContact, ShiftEffects};
pub use non_steady::NonSteady;
pub use quasi_static::QuasiStatic;
pub use quasi_static_half_space::QuasiStaticHalfSpace;
pub use response::{ContactDerivative, ContactResponse, GridError, Oscillating, OscillatingCreepages};
pub use rolling::RollingContact;
pub use spring_dashpot::SpringDashpot;
pub use virtual_penetration::{GapStrip, PenetrationState, VirtualPenetration};
pub use wave_geometry::{WaveGeometry, WavePatch};
