//! From dissipated energy to depth of wear.

use crate::{Error, STEEL_DENSITY};

/// Wear in proportion to dissipated energy (Archard's law written for energy).
///
/// A wheel that dissipates e joules on a metre of rail removes the mass k_w e; spread over the
/// width 2b of the running band of one contact it lowers the rail by k_w e / (ρ · 2b). Wheels of traffic do not all run on
/// one line: in the mean over them that mass comes off the whole width of their band, [`over_band`](Self::over_band).
///
/// How uncertain: growth rates are proportional to k_w. Clean dry discs have 2.5e-9 kg/J (in most studies of corrugation) to
/// 5.3e-9 kg/J (R8T wheel on 900A rail, Lewis & Dwyer-Joyce 2004), severe wear far more. Rails in service wear some ten times
/// less, about 0.3e-9 kg/J within a factor of 3 (80 %): then the low rail of a tight curve loses about 1 mm under 100 million gross
/// tonnes, as profiles over years have it. Treat a growth rate per passage as an order of magnitude until
/// the wear of the rail or two dated spectra are measured; its sign and its dependence on wavelength do not depend on k_w.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyWear {
    coefficient: f64,
    density: f64,
    width: f64,
    /// How a coefficient changes about the mean state; `None` if wear is in proportion to energy alone.
    regime: Option<WearRegime>,
}

/// How wear that is not in proportion to energy alone answers about a mean state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WearRegime {
    /// d ln m/d ln e at constant load \[-\].
    pub(crate) by_energy: f64,
    /// Energy per metre and newton of load \[1/m·J/N\] that wears as much as the load does beside its energy.
    pub(crate) by_load: f64,
    /// Energy per metre \[J/m\] that wears as much as the curvature κ of a wave does beside its energy: the patch has another area.
    pub(crate) by_curvature: f64,
}

impl EnergyWear {
    /// Wear coefficient of clean dry discs \[kg/J\], which models of corrugation take, of a case that says nothing of wear.
    pub const DEFAULT_COEFFICIENT: f64 = 2.5e-9;
    /// Density of rail steel \[kg/m³\].
    pub const DEFAULT_DENSITY: f64 = STEEL_DENSITY;

    /// A law of coefficient k_w \[kg/J\] and density ρ \[kg/m³\] for a contact of semi-axis b across
    /// the rail \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all three are positive.
    pub fn new(coefficient: f64, density: f64, semi_axis_lateral: f64) -> Result<Self, Error> {
        Error::unless_positive("wear coefficient", coefficient, "kg/J")?;
        Error::unless_positive("density", density, "kg/m3")?;
        Error::unless_positive("lateral semi-axis", semi_axis_lateral, "m")?;
        Ok(Self { coefficient, density, width: 2.0 * semi_axis_lateral, regime: None })
    }

    /// The law where the contacts of traffic are spread evenly over a band of a width w \[m\], in place of 2b: each line of it is
    /// under 2b/w of the wheels.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a band narrower than one contact.
    pub fn over_band(self, width: f64) -> Result<Self, Error> {
        if !(width.is_finite() && width >= self.width) {
            return Err(Error::OutOfRange {
                quantity: "width of the band of wear",
                value: width,
                unit: "m",
                rule: "must be at least the width 2b of one contact",
            });
        }
        Ok(Self { width, ..self })
    }

    /// The law with so many times the coefficient.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { coefficient: factor * self.coefficient, ..self }
    }

    /// The law of a coefficient that changes with energy and load about the mean state.
    pub(crate) fn by_regime(self, regime: WearRegime) -> Self {
        Self { regime: Some(regime), ..self }
    }

    /// How its wear answers beside energy; `None` if it is in proportion to energy alone.
    pub(crate) fn regime(&self) -> Option<WearRegime> {
        self.regime
    }

    /// Width that the wear comes off \[m\]: 2b of one contact, or that of the band of traffic.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Depth worn per passage for each joule per metre, k_w / (ρ · 2b) \[m²/J\]; over a band k_w / (ρ w).
    pub fn depth_per_energy(&self) -> f64 {
        self.coefficient / (self.density * self.width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mass k_w e comes off the width: 2.5e-9 kg/J · 244 J/m over 12 and 40 mm of steel.
    #[test]
    fn a_band_takes_the_mass_that_a_contact_takes() -> Result<(), Error> {
        let contact = EnergyWear::new(2.5e-9, 7850.0, 6e-3)?;
        let band = contact.over_band(0.04)?;
        for (law, width) in [(contact, 0.012), (band, 0.04)] {
            let mass = law.depth_per_energy() * 244.0 * width * 7850.0;
            assert!((mass / (2.5e-9 * 244.0) - 1.0).abs() < 1e-14);
        }
        assert_eq!(contact.over_band(0.012)?, contact);
        for narrow in [0.0119, 0.0, f64::NAN] {
            assert!(contact.over_band(narrow).is_err());
        }
        Ok(())
    }
}
