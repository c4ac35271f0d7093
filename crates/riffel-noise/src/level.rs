//! Levels of sound power and of sound pressure.

/// Reference of levels of sound power, 1 pW \[W\].
pub const REFERENCE_POWER: f64 = 1e-12;

/// Reference of levels of sound pressure, 20 µPa \[Pa\].
pub const REFERENCE_PRESSURE: f64 = 20e-6;

/// Level 10 lg(W/1 pW) \[dB\] of a sound power \[W\]; −∞ for none.
pub fn power_level(power: f64) -> f64 {
    10.0 * (power / REFERENCE_POWER).log10()
}

/// Level 10 lg(p²/(20 µPa)²) \[dB\] of a mean square pressure \[Pa²\]; −∞ for none.
pub fn pressure_level(mean_square: f64) -> f64 {
    10.0 * (mean_square / REFERENCE_PRESSURE.powi(2)).log10()
}
