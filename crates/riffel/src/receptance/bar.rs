//! The rail as a bar that stretches.

use num_complex::Complex64;

use super::waves::{Wave, Waveguide, Waves, outgoing};
use crate::{ElasticMaterial, Error};

/// An infinite rail under forces along itself: EA(1 + iη) u'' = Ku − F δ(x) with
/// K = κ + iωc − mω²; one wave α = √(K/EA), and u = F e^{−α|x|}/(2EAα).
///
/// Range of validity: waves much longer than the section is high, for a rail below some 5 kHz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    stiffness: f64,
    mass_per_length: f64,
    loss_factor: f64,
    damping: f64,
}

impl Bar {
    /// A rail of cross-section A \[m²\] and mass per length m \[kg/m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn new(material: ElasticMaterial, area: f64, mass_per_length: f64) -> Result<Self, Error> {
        Error::unless_positive("cross-section", area, "m2")?;
        Error::unless_positive("mass per length", mass_per_length, "kg/m")?;
        Ok(Self { stiffness: material.youngs_modulus() * area, mass_per_length, loss_factor: 0.0, damping: 0.0 })
    }

    /// Bar with a loss factor η \[-\]: E becomes E(1 + iη).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if η is negative.
    pub fn with_loss_factor(self, loss_factor: f64) -> Result<Self, Error> {
        Error::unless_not_negative("rail loss factor", loss_factor, "")?;
        Ok(Self { loss_factor, ..self })
    }

    /// Bar with viscous damping c per length \[N s/m²\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if c is negative.
    pub fn with_damping(self, damping: f64) -> Result<Self, Error> {
        Error::unless_not_negative("rail damping", damping, "N s/m2")?;
        Ok(Self { damping, ..self })
    }
}

impl Waveguide for Bar {
    fn mass_per_length(&self) -> f64 {
        self.mass_per_length
    }

    fn waves(&self, w: f64, foundation: Complex64) -> Waves {
        let elastic = Complex64::new(self.stiffness, self.stiffness * self.loss_factor);
        let stiffness = foundation + Complex64::new(-w * w * self.mass_per_length, w * self.damping);
        let propagation = outgoing(stiffness / elastic, || elastic.inv());
        Waves::Bar(Wave { propagation, amplitude: (2.0 * elastic * propagation).inv() })
    }

    fn point_receptance(&self, angular_frequency: f64, foundation: Complex64) -> Complex64 {
        let waves = self.waves(angular_frequency, foundation);
        waves.as_slice().iter().map(|wave| wave.amplitude).sum()
    }
}
