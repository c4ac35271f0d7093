//! Steady curving: how a wheelset, a two-axle bogie or a vehicle on two bogies stands in a curve, and what creepages and
//! forces its contacts have. Where the wheels touch the rails is in [`profile`].
//!
//! Axes of the track: x forward, y to the right, z down. A radius above zero turns to the right. A lateral shift is
//! positive to the right, a yaw angle with the nose to the right. Wheelset 1 leads. The frame is measured from the
//! middle of the chord between the points of the centre line under both axles, yaw from the tangent in the middle of
//! the bogie. Longitudinal creepage is positive in braking, and forces on the rail go along the slip.
//!
//! Where the contact of a wheel jumps from one place to another the wheel stands on both, at one lateral shift: both normal
//! forces are unknown, neither below zero, each with creepages, spin and forces of its own. Wheel and rail are rigid.
//!
//! A lone wheelset runs in a [frame that follows the track](FollowingFrame). Two bogies carry a [`Body`], measured as a frame is:
//! from the middle of the chord between the middles of the bogies, and from the tangent in the middle of the vehicle.
//! Its secondary suspension turns the leading bogie out of the curve and the trailing one into it, by the angle l/R
//! that either has to the body.
//!
//! Left out: roll of wheelsets, frames and body, and the moment of spin.
//!
//! ```
//! use std::sync::Arc;
//! use riffel::contact::{CreepEllipse, ShenHedrickElkins};
//! use riffel_curving::*;
//!
//! # fn main() -> Result<(), riffel::Error> {
//! let ellipse = CreepEllipse::of_coefficients(10.5e6, 9.2e6, 22e3, 54e3)?;
//! let creep = Creep::Law(Arc::new(ShenHedrickElkins::new(ellipse, 0.4)?));
//! let vehicle = VehicleInCurve {
//!     curve: Curve { radius: 300.0, cant: 0.1, speed: 20.0 },
//!     axle: Axle {
//!         primary_spacing: 2.0,
//!         primary_longitudinal_stiffness: 10e6,
//!         primary_lateral_stiffness: 5e6,
//!         mass_per_axle: 11_000.0,
//!         wheelset_mass: 1400.0,
//!         rolling_radii: [0.46, 0.46],
//!         contact_spacing: 1.5,
//!         centre_of_mass_height: 1.7,
//!     },
//!     running_gear: RunningGear::Bogie(BogieFrame { wheelbase: 2.5, yaw_moment: 0.0 }),
//!     drive_torque: vec![0.0, 0.0],
//!     kinematics: Kinematics::Nonlinear {
//!         surfaces: Arc::new(ConeWithFlangePlane { conicity: 0.05, slope: 2.5, shift: 0.007, width: 0.4e-3 }),
//!         contact_plane: ContactPlane::Tilted { shift_moment: true },
//!         flange: None,
//!     },
//!     creep: [creep.clone(), creep],
//! };
//! let state = vehicle.equilibrium()?;
//! // The leading wheelset runs on the flange of the high rail, its nose to the outside.
//! assert!(state.wheelsets[0].lateral_shift < -6e-3 && state.wheelsets[0].yaw < 0.0);
//! assert!(state.residual < 1e-9);
//! # Ok(())
//! # }
//! ```

mod axle;
mod balance;
mod closed_form;
mod creep;
mod curve;
mod equilibrium;
mod kinematics;
mod limits;
mod newton;
pub mod profile;
mod running_gear;
mod running_surfaces;
mod state;
mod two_point_path;
mod vehicle;
mod wheel_on_rail;

pub use axle::Axle;
pub use closed_form::{LinearWheelset, LinearWheelsetState, free_curving_shift};
pub use creep::{Creep, LawOnEllipse};
pub use curve::{Curve, GRAVITY};
pub use kinematics::{ContactPlane, FlangeSpring, Kinematics};
pub use running_gear::{Body, BogieFrame, FollowingFrame, RunningGear};
pub use running_surfaces::{Cone, ConeWithFlangePlane, RollingPosition, RunningSurfaces, TwoPoints};
pub use state::{BodyState, ContinuationStep, FrameState, SecondContact, VehicleState, WheelState, WheelsetState};
pub use vehicle::VehicleInCurve;

#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_of_vehicles;

#[cfg(test)]
#[expect(dead_code, reason = "other crates test with the rest")]
#[path = "../../riffel/tests/physics/fixtures.rs"]
mod fixtures;
