//! Axle-box acceleration: from what a wheel on a train feels to the roughness of the rail under it.
//!
//! Roughness r between wheel and rail, positive upward out of the rail, shakes the wheel with the upward acceleration
//!
//! ```text
//! a = −ω² H_w P,   P = r/(H_r + H_w + 1/k_H),   so that   T = a/r = −ω² H_w/(H_r + H_w + 1/k_H)   [1/s²]
//! ```
//!
//! with the receptances of rail and wheel under the contact and its stiffness ([`AxleBoxTransfer`]). The transfer is one of
//! time, whatever the speed does: a [`Run`] divides by it in time, regularised where it is small ([`Inverse`]), and lays
//! the roughness out along the rail by the odometer afterwards. What comes out is a [`PatchAverageProfile`], which goes where the
//! profile of a trolley goes, within the wavelengths that it knows.
//!
//! What the wheel feels is the sum of the roughness of rail and wheel, averaged over the patch. Not told apart are
//!
//! * the wheel's own roughness, whose orders have the wavelengths 2πR/n;
//! * what the other wheel of the axle feels. Of a rigid wheelset of the mass M and the roll inertia J with contacts at ±s it comes
//!   over by (1/M − s²/J)/(1/M + s²/J), which is nothing where the mass is at the wheels; axles that bend bring it over about
//!   their resonances;
//! * the waves that neighbouring wheels send along the rail, |H_r(d)/(H_r + H_w + 1/k_H)| of their roughness at the distance d.

mod counted_steps;
mod inverse;
mod patch_average_profile;
mod run;
mod sample;
mod segment;
mod transfer;
mod transforms;
mod wheel_pattern;

pub use counted_steps::LONGEST_STEP;
pub use inverse::{Inverse, REGULARISATION};
pub use patch_average_profile::PatchAverageProfile;
pub use run::{Run, RunSettings};
pub use sample::Sample;
pub use transfer::AxleBoxTransfer;
pub use wheel_pattern::WheelPattern;
