//! Rolling contact as a joint of the loop.

use super::{ContactResponse, MeanRolling};

/// Joint of the loop: a wheel rolling on a rail.
pub trait RollingContact: Send + Sync {
    /// The mean state.
    fn steady(&self) -> MeanRolling;

    /// Response to oscillations of normal force and creepages of the given wavelength \[m\],
    /// referred to the instant at which the wheel centre passes.
    fn response(&self, wavelength: f64) -> ContactResponse;

    /// The wavelength \[m\] from which on the response is known.
    fn known_from(&self) -> f64 {
        0.0
    }
}
