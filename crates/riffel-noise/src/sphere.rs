//! A compact body that oscillates to and fro: a wheel that moves as a rigid body.

use std::f64::consts::PI;

use riffel::Error;

use super::Air;

/// A sphere that oscillates along a line.
///
/// Radiation efficiency σ = (ka)⁴/(4 + (ka)⁴). Source: P. M. Morse & K. U. Ingard, *Theoretical Acoustics* (1968),
/// section 7.2. Power W = ρc · 4πa² · σ · v²/3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OscillatingSphere {
    radius: f64,
}

impl OscillatingSphere {
    /// A sphere of the radius a \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless a > 0.
    pub fn new(radius: f64) -> Result<Self, Error> {
        Error::unless_positive("radius of a radiating sphere", radius, "m")?;
        Ok(Self { radius })
    }

    /// The sphere as large as the tread of a wheel of the rolling radius R and the width w \[m\]: 4πa² = 2πRw. A wheel
    /// that moves up and down as a rigid body does not radiate from its sides. Which sphere is best is open by some
    /// decibels; what a wheel radiates as a rigid body is small beside its modes and the rail.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn of_wheel(rolling_radius: f64, width: f64) -> Result<Self, Error> {
        Error::unless_positive("rolling radius", rolling_radius, "m")?;
        Error::unless_positive("width of the wheel", width, "m")?;
        Self::new((0.5 * rolling_radius * width).sqrt())
    }

    /// Radiation efficiency σ \[-\] at a frequency \[Hz\].
    pub fn efficiency(&self, air: &Air, frequency: f64) -> f64 {
        let fourth = (air.wavenumber(frequency) * self.radius).powi(4);
        fourth / (4.0 + fourth)
    }

    /// Sound power per mean square velocity \[W per (m/s)²\].
    pub fn power(&self, air: &Air, frequency: f64) -> f64 {
        let area = 4.0 * PI * self.radius * self.radius;
        air.impedance() * area * self.efficiency(air, frequency) / 3.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small body is a dipole: it moves the air that it displaces and drags along, 1.5 of its volume.
    #[test]
    fn a_small_sphere_is_a_dipole() -> Result<(), Error> {
        let air = Air::default();
        let sphere = OscillatingSphere::new(0.05)?;
        let frequency = 20.0;
        let w = 2.0 * PI * frequency;
        let strength = 1.5 * air.density * 4.0 / 3.0 * PI * 0.05f64.powi(3);
        // A force F = iω·1.5ρVv on the air radiates ω²F²/(12πρc³).
        let dipole = (w * w * strength).powi(2) / (12.0 * PI * air.density * air.sound_speed.powi(3));
        assert!((sphere.power(&air, frequency) / dipole - 1.0).abs() < 1e-6);
        assert!((sphere.efficiency(&air, 1e5) - 1.0).abs() < 1e-3);
        Ok(())
    }
}
