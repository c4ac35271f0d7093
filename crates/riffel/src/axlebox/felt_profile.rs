//! What a wheel has felt of a rail.

use crate::roughness::{Profile, WavelengthBand};

/// The roughness that a wheel has felt along a piece of line.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct FeltProfile {
    /// Heights, positive upward.
    pub profile: Profile,
    /// The wavelengths that it holds; others are weaker or not there.
    pub known: WavelengthBand,
    /// Lowest, mean and highest speed \[m/s\].
    pub speeds: [f64; 3],
}
