//! Rolling noise: from the roughness of rail and wheel to the level beside the track.
//!
//! Roughness between wheel and rail makes them vibrate ([`RollingSource`]); rail, sleepers and wheel radiate
//! ([`OscillatingCylinder`], [`Piston`], [`OscillatingSphere`]); a train of such sources is heard beside the track
//! ([`PassBy`]). The source model of the European directive, Commission Directive (EU) 2015/996, section 2.3.2, is a
//! [`TransferFunction`] of the track and one of the vehicle, each for one wheelset: L_W,0 = L_R,tot + L_H; superstructure, joints,
//! squeal, traction and air are left out.
//!
//! Bands are [`FrequencyBand`]s; sound power is in watts, mean square pressure in Pa², roughness as a
//! [`Spectrum`](riffel::roughness::Spectrum).
//!
//! The modes of the wheel's web and tyre, which radiate most of what a wheel does above some 1.6 kHz, are [`WheelModes`]; without
//! them a wheel is a rigid body.
//!
//! Left out: rails that vibrate sideways; sleepers that move together, which matters below some 300 Hz; screening by
//! vehicles and platforms; noise of engines, of air and of joints; squeal.

mod a_weighting;
mod air;
mod cylinder;
mod disc;
mod energies;
mod excitation;
mod frequency_band;
mod level;
mod pass_by;
mod piston;
mod rolling_source;
mod sphere;
mod transfer;
mod wheel_modes;

pub use a_weighting::a_weighting;
pub use air::Air;
pub use cylinder::OscillatingCylinder;
pub use disc::VibratingDisc;
pub use energies::{BandEnergies, Energies, Energy, Part};
pub use excitation::Excitation;
pub use frequency_band::FrequencyBand;
pub use level::{REFERENCE_POWER, REFERENCE_PRESSURE, power_level, pressure_level};
pub use pass_by::{PassBy, Surroundings};
pub use piston::Piston;
pub use rolling_source::{BandRadiation, RailDecay, RollingSource, Sleepers, SoundPower};
pub use sphere::OscillatingSphere;
pub use transfer::TransferFunction;
pub use wheel_modes::{WheelMode, WheelModes};

#[cfg(test)]
#[expect(dead_code, reason = "other crates test with the rest")]
#[path = "../../riffel/tests/physics/fixtures.rs"]
mod fixtures;
