//! # Riffel: the physics of rail corrugation
//!
//! **Start with [`paper`]**: equations (1) to (33) of Afferrante & Ciavarella (2009) on one page, in their symbols and order.
//!
//! Which wavelengths grow on a rail under rolling wheels, how fast, and why. One feedback loop,
//! [`Loop`], ties small interchangeable joints together:
//!
//! | joint | trait | equations of Afferrante & Ciavarella (2009) |
//! |---|---|---|
//! | structure | [`Receptance`] | (23) [`FreeBeam`], (25) [`RigidMass`], (27)–(33) [`MovingBeam`]; [`ContinuousTrack`], [`PeriodicTrack`], [`MovingLoadTrack`], [`MeasuredReceptance`] |
//! | contact patch | [`HertzContact`], [`EllipticContact`], [`KalkerCoefficients`]; [`NormalContact`], [`ContactFilter`] | (22), (26) |
//! | rolling contact | [`RollingContact`] | (1)–(14) [`Carter3d`], (7) [`creep_coefficient`]; [`CreepLaw`], [`HalfSpace`], [`NonSteady`] |
//! | wheel rotation | [`Motion`] of a [`Receptance`] along the rail | (15)–(18) [`RigidInertia`] |
//! | place of wear | [`PlaceOfWear`] | below (22) |
//! | wear | [`EnergyWear`] | |
//! | the loop closed | [`Loop::at`], of one wheel [`OneWheel`](feedback::OneWheel) | (4), (16)–(21), (24) |
//!
//! What is on the rail already, measured, is in [`roughness`]; as a train feels it, in [`axlebox`]; what may have made it, in
//! [`diagnosis`]; what becomes of it under traffic, in [`forecast`]. Large amplitudes, followed through time, are in [`passage`]. How loud
//! it is, is in the crate `riffel-noise`; how a bogie stands in a curve, the creepages of its contacts and where wheels touch rails, in
//! `riffel-curving`.
//!
//! Conventions: time factor exp(+iωt); receptances positive downward, Im H ≤ 0 for passive
//! structures; braking positive, ξ = 1 − ΩR/V > 0; SI units throughout. Growth ⇔ Re Ŵ₁ < 0; a
//! growth rate is positive when corrugation grows.
//!
//! ```
//! use std::sync::Arc;
//! use riffel::contact::{MeanState, QuasiStatic};
//! use riffel::feedback::OneWheel;
//! use riffel::receptance::{EulerBernoulliBeam, FreeBeam};
//! use riffel::wheelset::{Motion, RigidInertia, RigidMass};
//! use riffel::*;
//!
//! # fn main() -> Result<(), riffel::Error> {
//! let steel = ElasticMaterial::new(207e9, 0.3)?;
//! let hertz = HertzContact::new(steel, 0.46, 0.23, 50e3)?;
//! let law = Carter3d::new(hertz, 0.4)?;
//! let contact = QuasiStatic::new(law, hertz.normal_force(), MeanState::TractiveRatio(0.1))?;
//! let rail = EulerBernoulliBeam::new(steel, 2.35e-5, 56.0)?;
//! let inertia = RigidInertia::reduced_inertia(350.0, 0.46);
//! let feedback = OneWheel {
//!     track: Arc::new(FreeBeam::new(rail)),
//!     wheel: Arc::new(RigidMass::new(350.0)?),
//!     contact_stiffness: hertz.stiffness(),
//!     contact: Arc::new(contact),
//!     rotation: Motion::compliant(RigidInertia::new(inertia, 0.46)?),
//!     wave: None,
//!     place_of_wear: PlaceOfWear::new(
//!         DissipationPhase::Lag,
//!         hertz.semi_axis_longitudinal(),
//!         contact.steady().tractive_ratio(),
//!     ),
//!     wear: EnergyWear::new(
//!         EnergyWear::DEFAULT_COEFFICIENT,
//!         EnergyWear::DEFAULT_DENSITY,
//!         hertz.semi_axis_lateral(),
//!     )?,
//!     amplitude: 31.5e-6,
//! }
//! .close()?;
//! let ridge = Ridge::search(
//!     &feedback,
//!     Axis::new(0.020, 0.080, 241)?,
//!     Axis::new(20.0, 40.0, 5)?,
//! );
//! for point in &ridge.points {
//!     assert!(point.growth_rate > 0.0);
//!     assert!((530.0..545.0).contains(&point.frequency));
//! }
//! # Ok(())
//! # }
//! ```
//!
//! [`ContactFilter`]: contact::ContactFilter
//! [`ContinuousTrack`]: receptance::ContinuousTrack
//! [`CreepLaw`]: contact::CreepLaw
//! [`EllipticContact`]: contact::EllipticContact
//! [`FreeBeam`]: receptance::FreeBeam
//! [`HalfSpace`]: contact::HalfSpace
//! [`KalkerCoefficients`]: contact::KalkerCoefficients
//! [`MeasuredReceptance`]: receptance::MeasuredReceptance
//! [`MovingBeam`]: receptance::MovingBeam
//! [`MovingLoadTrack`]: receptance::MovingLoadTrack
//! [`NonSteady`]: contact::NonSteady
//! [`NormalContact`]: contact::NormalContact
//! [`PeriodicTrack`]: receptance::PeriodicTrack
//! [`RigidInertia`]: wheelset::RigidInertia
//! [`RigidMass`]: wheelset::RigidMass
//! [`Motion`]: wheelset::Motion
//! [`creep_coefficient`]: contact::creep_coefficient

pub mod axlebox;
pub mod cancel;
mod constants;
pub mod contact;
pub mod damage;
pub mod diagnosis;
mod direction;
mod elastic;
pub mod error;
pub mod feedback;
pub mod forecast;
pub mod growth;
mod mean_wear;
mod memory;
pub mod paper;
pub mod passage;
mod place_of_wear;
pub mod receptance;
pub mod roughness;
pub mod tile;
mod vector;
mod wear;
mod wear_regime;
pub mod wheelset;

pub use constants::{FARTHEST_SHIFT, LARGEST_YAW, STANDARD_GRAVITY, STEEL_DENSITY};
pub use contact::{Carter3d, HertzContact, RollingContact};
pub use direction::{Direction, Place, Rail};
pub use elastic::ElasticMaterial;
pub use error::Error;
pub use feedback::{Loop, LoopState};
pub use growth::{Axis, GrowthMap, Ridge};
pub use mean_wear::MeanWear;
pub use num_complex::Complex64;
pub use place_of_wear::{DissipationPhase, PlaceOfWear};
pub use receptance::Receptance;
pub use wear::EnergyWear;
pub use wear_regime::{WearCorners, WearRegimes};

/// The listings of the book, compiled and run.
#[cfg(test)]
extern crate self as riffel;

#[cfg(test)]
#[expect(dead_code, reason = "other tests use the rest")]
#[path = "../tests/physics/fixtures.rs"]
mod fixtures;

#[cfg(doctest)]
mod book {
    #[doc = include_str!("../../../docs/src/adding-a-track-model.md")]
    mod track_model {}
    #[doc = include_str!("../../../docs/src/adding-a-creep-law.md")]
    mod creep_law {}
    #[doc = include_str!("../../../docs/src/wheelset.md")]
    mod wheelset {}
}
