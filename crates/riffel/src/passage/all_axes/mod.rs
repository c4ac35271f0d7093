//! Wheels on all axes in time: lateral creepage, wheelsets that twist and bend, both rails, several wheels.
//!
//! [`StructuresInTime`] are track and wheels together in time, [`GeneralPassage`] they and their contacts, and
//! [`GeneralMarch`] their motion; [`SmoothRail`] is what becomes of a loop that is unstable without any profile.

mod march;
mod model;
mod motion;
mod over_supports;
mod settled;
mod smooth_rail;
mod structures;

pub use march::GeneralMarch;
pub use model::{ContactInTime, GeneralPassage};
pub use smooth_rail::{ContactSwing, Outcome, SmoothRail};
pub use structures::StructuresInTime;
