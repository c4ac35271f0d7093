//! A wheel that rolls along a rail in time: large amplitudes, loss of contact, wear over many passages.
//!
//! The loop of [`feedback`](crate::feedback) is linear in the amplitude of the profile. Here the same wheel, track and
//! creep law are followed through time with the contact as it is: the normal force of Hertz, which ends where the
//! surfaces part, and the creep force at the normal force and creepage of the instant. Small amplitudes give the linear
//! loop again.
//!
//! [`StructuresInTime`] are track and wheels in time, of which [`ImpulseResponse`] is one axis, [`PassageModel`] they and their
//! contacts, [`March`] their motion, and [`Settled`] the state over a sinusoid that repeats itself with every wave;
//! [`SmoothRail`] is what becomes of a loop that is unstable without any profile.

mod along_profile;
mod damage_in_time;
mod direction_in_time;
mod evolution;
mod fourier_series;
mod hertz_spring;
mod impulse_response;
mod late_contact;
mod march;
mod memory;
mod model;
mod over_supports;
mod patch_average;
mod pole_search;
mod rail_in_time;
mod ring;
mod settled;
mod smooth_rail;
mod step_weights;
mod structures;
mod structures_motion;
mod structures_samples;
mod tangent_equation;
mod track_motion;
mod transient_contact;
mod vector_fitting;
mod wave_in_time;

pub use along_profile::Passage;
pub use damage_in_time::DamageInTime;
pub use evolution::{Evolution, EvolutionStep, PassageExtremes, PassingWheel, WearOfPassages};
pub use hertz_spring::HertzSpring;
pub use impulse_response::ImpulseResponse;
pub use late_contact::LateContact;
pub use march::{ContactInstant, March};
pub use model::{ContactInTime, PassageModel};
pub use settled::{Harmonic, Settled, Sinusoid};
pub use smooth_rail::{ContactSwing, Outcome, SmoothRail};
pub use structures::StructuresInTime;
pub use transient_contact::{TransientContact, TransientSettled};
pub use wave_in_time::WaveInTime;
