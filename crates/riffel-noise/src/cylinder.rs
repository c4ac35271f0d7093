//! A long body that oscillates across its length: the rail.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use libm::{jn, yn};
use riffel::Error;

use super::Air;

/// A long cylinder that oscillates across its axis, all of it in phase: a line of dipoles.
///
/// Radiation efficiency, the power over that of as large a plane with the mean square normal velocity of the surface:
/// σ = 2/(πka |H₁⁽²⁾′(ka)|²), which is (π/2)(ka)³ for ka ≪ 1 and 1 for ka ≫ 1. Source: P. M. Morse & K. U. Ingard,
/// *Theoretical Acoustics* (1968), section 7.3; that a rail may be taken for a cylinder D. J. Thompson, *Railway Noise and
/// Vibration* (2009), chapter 6. Range of validity: waves on the rail longer than those of air, which holds for bending
/// waves of rails above some 100 Hz, and decay by little over a wavelength of sound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OscillatingCylinder {
    radius: f64,
}

impl OscillatingCylinder {
    /// A cylinder of the radius a \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless a > 0.
    pub fn new(radius: f64) -> Result<Self, Error> {
        Error::unless_positive("radius of a radiating cylinder", radius, "m")?;
        Ok(Self { radius })
    }

    /// The cylinder that radiates at low frequencies what a rail does that moves up and down, from the breadth of its
    /// foot b \[m\] and the area of its section A \[m²\].
    ///
    /// A small body is a dipole as strong as the air it displaces and the air it drags along: 2πa² for a cylinder; for a
    /// rail A + πb²/4, of which the second is that of a strip as broad as its foot. At high frequencies, where a rail
    /// radiates from all its horizontal faces, the cylinder is up to 3 dB low.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn of_rail(foot_breadth: f64, area: f64) -> Result<Self, Error> {
        Error::unless_positive("breadth of the rail foot", foot_breadth, "m")?;
        Error::unless_positive("area of the rail section", area, "m²")?;
        let dipole = area + FRAC_PI_4 * foot_breadth * foot_breadth;
        Self::new((dipole / TAU).sqrt())
    }

    /// Radius a \[m\].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Radiation efficiency σ \[-\] at a frequency \[Hz\].
    pub fn efficiency(&self, air: &Air, frequency: f64) -> f64 {
        efficiency(1, air.wavenumber(frequency) * self.radius)
    }

    /// Sound power per length and mean square velocity \[W/m per (m/s)²\]: ρc · 2πa · σ · ½, the half for the mean of the
    /// normal velocity around the cylinder.
    pub fn power_per_length(&self, air: &Air, frequency: f64) -> f64 {
        air.impedance() * PI * self.radius * self.efficiency(air, frequency)
    }
}

/// Radiation efficiency 2/(πx|H_n′(x)|²) of a long cylinder with n waves around it, x = ka.
pub(super) fn efficiency(waves: u32, x: f64) -> f64 {
    let order = waves as i32;
    // H_n′ = (n/x)H_n − H_{n+1}.
    let ratio = f64::from(order) / x;
    let derivative = [jn, yn].map(|bessel| ratio * bessel(order, x) - bessel(order + 1, x));
    2.0 / (PI * x * (derivative[0].powi(2) + derivative[1].powi(2)))
}

#[cfg(test)]
mod tests {
    use libm::{j0, j1, y0, y1};

    use super::*;

    #[test]
    fn limits_of_small_and_large_cylinders() -> Result<(), Error> {
        let (air, cylinder) = (Air::default(), OscillatingCylinder::new(0.05)?);
        let frequency_of = |ka: f64| ka * air.sound_speed / (TAU * 0.05);
        let efficiency = |ka: f64| cylinder.efficiency(&air, frequency_of(ka));
        // Next terms are of the order (ka)² ln ka, and 1/(ka)².
        assert!((efficiency(0.01) / (0.5 * PI * 1e-6) - 1.0).abs() < 1e-3);
        assert!((efficiency(50.0) - 1.0).abs() < 1e-3);
        Ok(())
    }

    /// The efficiency is the real part of the radiation impedance −iH₁⁽²⁾/H₁⁽²⁾′, by the Wronskian.
    #[test]
    fn efficiency_is_the_real_part_of_the_impedance() -> Result<(), Error> {
        use riffel::Complex64;
        let (air, cylinder) = (Air::default(), OscillatingCylinder::new(0.0635)?);
        for frequency in [100.0, 860.0, 5000.0] {
            let x = air.wavenumber(frequency) * cylinder.radius();
            let hankel = |j: f64, y: f64| Complex64::new(j, -y);
            let (zero, one) = (hankel(j0(x), y0(x)), hankel(j1(x), y1(x)));
            let impedance = -Complex64::I * one / (zero - one / x);
            let found = cylinder.efficiency(&air, frequency);
            assert!((found - impedance.re).abs() < 1e-9, "{found} {impedance}");
        }
        Ok(())
    }

    /// A flat strip has half the dipole of a cylinder as broad, and so half the radius to the square.
    #[test]
    fn a_strip_is_half_a_cylinder() -> Result<(), Error> {
        let strip = OscillatingCylinder::of_rail(0.15, 1e-12)?;
        assert!((strip.radius() - 0.075 / 8f64.sqrt() * 2.0).abs() < 1e-6);
        let rail = OscillatingCylinder::of_rail(0.15, 76.7e-4)?;
        assert!((rail.radius() - 0.0635).abs() < 1e-4);
        assert!(OscillatingCylinder::of_rail(0.0, 76.7e-4).is_err());
        Ok(())
    }
}
