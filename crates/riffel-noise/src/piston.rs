//! A flat face that moves in a wide plane: the top of a sleeper in its ballast.

use std::f64::consts::PI;

use libm::j1;
use riffel::Error;

use super::Air;

/// A round piston in a rigid plane that radiates to one side.
///
/// Radiation efficiency σ = 1 − J₁(2ka)/(ka), which is (ka)²/2 for ka ≪ 1 and 1 for ka ≫ 1. Source: P. M. Morse &
/// K. U. Ingard, *Theoretical Acoustics* (1968), section 7.4. Of a sleeper it has the area, not the length; below the
/// frequency at which the length is half a wave of sound they radiate alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piston {
    area: f64,
}

impl Piston {
    /// A piston of the area S \[m²\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless S > 0.
    pub fn new(area: f64) -> Result<Self, Error> {
        Error::unless_positive("radiating area of a sleeper", area, "m²")?;
        Ok(Self { area })
    }

    /// Radiation efficiency σ \[-\] at a frequency \[Hz\].
    pub fn efficiency(&self, air: &Air, frequency: f64) -> f64 {
        let x = air.wavenumber(frequency) * (self.area / PI).sqrt();
        1.0 - j1(2.0 * x) / x
    }

    /// Sound power per mean square velocity \[W per (m/s)²\]: ρcSσ.
    pub fn power(&self, air: &Air, frequency: f64) -> f64 {
        air.impedance() * self.area * self.efficiency(air, frequency)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small piston is a monopole over a hard plane: W = ρck²S²v²/(2π), whatever its shape.
    #[test]
    fn a_small_piston_is_a_monopole() -> Result<(), Error> {
        let (air, piston) = (Air::default(), Piston::new(0.3)?);
        let (frequency, area) = (5.0, 0.3);
        let monopole = air.impedance() * (air.wavenumber(frequency) * area).powi(2) / (2.0 * PI);
        assert!((piston.power(&air, frequency) / monopole - 1.0).abs() < 2e-3);
        assert!((piston.efficiency(&air, 2e4) - 1.0).abs() < 5e-3);
        Ok(())
    }
}
