//! What a wheel has felt of a rail.

use super::segment::FADE;
use crate::roughness::{Profile, ThirdOctave, WavelengthBand};

/// The roughness that a wheel has felt along a piece of line.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct PatchAverageProfile {
    /// Heights, positive upward.
    pub profile: Profile,
    /// The wavelengths that it holds; others are weaker or not there.
    pub known: WavelengthBand,
    /// Lowest, mean and highest speed \[m/s\].
    pub speeds: [f64; 3],
}

impl PatchAverageProfile {
    /// Whether every other height tells as much: the shortest waves, which fade, become none of a known wavelength.
    pub(super) fn is_told_by_half(&self) -> bool {
        let [slowest, _, fastest] = self.speeds;
        let known = self.known.from().recip();
        let fading = known * 10f64.powf(ThirdOctave::HALF_WIDTH_DECADES) * FADE * fastest / slowest;
        known + fading <= 0.5 / self.profile.spacing()
    }

    /// Whether two records of one length of rail are one signal, each a multiple of the other: two axle boxes feel the rail one after
    /// the other, and each its own wheel and noise.
    pub fn is_multiple(&self, other: &Self) -> bool {
        /// Correlation of two channels that nothing but one sensor has.
        const ONE_SIGNAL: f64 = 0.999;
        let pairs = self.profile.heights().iter().zip(other.profile.heights());
        let (mut own, mut others, mut both) = (0.0, 0.0, 0.0);
        for (a, b) in pairs {
            (own, others, both) = (own + a * a, others + b * b, both + a * b);
        }
        both.abs() > ONE_SIGNAL * (own * others).sqrt()
    }
}
