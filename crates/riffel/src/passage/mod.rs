//! A wheel that rolls along a rail in time: large amplitudes, loss of contact, wear over many passages.
//!
//! The loop of [`feedback`](crate::feedback) is linear in the amplitude of the profile. Here the same wheel, track and
//! creep law are followed through time with the contact as it is: the normal force of Hertz, which ends where the
//! surfaces part, and the creep force at the normal force and creepage of the instant. Small amplitudes give the linear
//! loop again.
//!
//! [`LoopInTime`] is a loop of either kind. Of one wheel along one axis [`ImpulseResponse`] is the track in time, [`PassageModel`] track, wheel and contact together, [`March`] their motion,
//! and [`Settled`] the state over a sinusoid that repeats itself with every wave;
//! [`GeneralPassage`] is any number of contacts on all axes.

mod all_axes;
mod along_profile;
mod eigenvalues;
mod evolution;
mod hertz_spring;
mod impulse_response;
mod late_contact;
mod least_squares;
mod loop_in_time;
mod march;
mod model;
mod on_rail;
mod over_supports;
mod ring;
mod settled;
mod step_weights;
mod track_motion;
mod transient_contact;
mod vector_fitting;

pub use all_axes::{
    ContactInTime, ContactSwing, GeneralMarch, GeneralPassage, Outcome, SmoothRail,
    StructuresInTime,
};
pub use along_profile::Passage;
pub use evolution::{Evolution, EvolutionStep, PassageExtremes, PassingWheel, WearOfPassages};
pub use hertz_spring::HertzSpring;
pub use impulse_response::ImpulseResponse;
pub use late_contact::LateContact;
pub use loop_in_time::LoopInTime;
pub use march::{ContactInstant, March};
pub use model::{PassageModel, Turning};
pub use settled::{Harmonic, Settled, Sinusoid};
pub use transient_contact::{TransientContact, TransientSettled};
