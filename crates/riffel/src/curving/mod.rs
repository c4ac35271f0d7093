//! Steady curving: how a two-axle bogie stands in a curve, and what creepages and forces its four contacts have.
//!
//! Axes of the track: x forward, y to the right, z down. A radius above zero turns to the right. A lateral shift is
//! positive to the right, a yaw angle with the nose to the right. Wheelset 1 leads. The frame is measured from the
//! middle of the chord between the points of the centre line under both axles, yaw from the tangent in the middle of
//! the bogie. Longitudinal creepage is positive in braking, and forces on the rail go along the slip.
//!
//! Where the contact of a wheel jumps from one place to another the wheel stands on both, at one lateral shift: both normal
//! forces are unknown, neither below zero, each with creepages, spin and forces of its own. Wheel and rail are rigid.
//!
//! Left out: roll of the wheelset and of the frame, the moment of spin, stiffness of the secondary suspension against yaw
//! (a moment on the frame stands for it).
//!
//! ```
//! use std::sync::Arc;
//! use riffel::contact::{CreepEllipse, ShenHedrickElkins};
//! use riffel::curving::*;
//!
//! # fn main() -> Result<(), riffel::Error> {
//! let ellipse = CreepEllipse::of_coefficients(10.5e6, 9.2e6, 22e3, 54e3)?;
//! let creep = Creep::Law(Arc::new(ShenHedrickElkins::new(ellipse, 0.4)?));
//! let vehicle = BogieInCurve {
//!     curve: Curve { radius: 300.0, cant: 0.1, speed: 20.0 },
//!     bogie: Bogie {
//!         wheelbase: 2.5,
//!         primary_spacing: 2.0,
//!         primary_longitudinal_stiffness: 10e6,
//!         primary_lateral_stiffness: 5e6,
//!         mass_per_axle: 11_000.0,
//!         wheelset_mass: 1400.0,
//!         rolling_radii: [0.46, 0.46],
//!         contact_spacing: 1.5,
//!         centre_of_mass_height: 1.7,
//!         frame_yaw_moment: 0.0,
//!         drive_torque: [0.0, 0.0],
//!     },
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

mod bogie;
mod closed_form;
mod creep;
mod curve;
mod equilibrium;
mod limits;
mod newton;
mod running_surfaces;
mod state;
mod way;
mod wheel_on_rail;

pub use bogie::Bogie;
pub use closed_form::{LinearWheelset, LinearWheelsetState, free_curving_shift};
pub use creep::Creep;
pub use curve::{Curve, GRAVITY};
pub use equilibrium::{BogieInCurve, ContactPlane, FlangeSpring, Kinematics};
pub use limits::{FARTHEST_SHIFT, LARGEST_YAW};
pub use running_surfaces::{
    Cone, ConeWithFlangePlane, RollingPosition, RunningSurfaces, TwoPoints,
};
pub use state::{
    BogieState, ContinuationStep, FrameState, SecondContact, WheelState, WheelsetState,
};

#[cfg(test)]
mod tests;
