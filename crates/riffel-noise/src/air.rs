//! The air into which sound goes.

use std::f64::consts::TAU;

/// Air at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Air {
    /// Density ρ \[kg/m³\].
    pub density: f64,
    /// Speed of sound c \[m/s\].
    pub sound_speed: f64,
}

impl Default for Air {
    /// Dry air at 20 °C and 101.325 kPa: 1.204 kg/m³, 343.2 m/s (ISO 9613-1:1993, equation of c; ideal gas).
    fn default() -> Self {
        Self { density: 1.204, sound_speed: 343.2 }
    }
}

impl Air {
    /// Characteristic impedance ρc \[Pa s/m\].
    pub fn impedance(&self) -> f64 {
        self.density * self.sound_speed
    }

    /// Wave number k \[rad/m\] at a frequency \[Hz\].
    pub fn wavenumber(&self, frequency: f64) -> f64 {
        TAU * frequency / self.sound_speed
    }
}
