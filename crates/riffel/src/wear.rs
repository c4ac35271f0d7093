//! From dissipated energy to depth of wear.

use crate::{Error, STEEL_DENSITY};

/// Wear in proportion to dissipated energy (Archard's law written for energy).
///
/// A wheel that dissipates e joules on a metre of rail removes the mass k_w e; spread over the
/// width 2b of the running band of one contact it lowers the rail by k_w e / (ρ · 2b).
///
/// How uncertain: growth rates are proportional to k_w. Corrugation studies commonly take
/// 2.5e-9 kg/J in the mild regime; a twin-disc fit for R8T wheel on 900A rail steel has twice that
/// (5.3 µg/(N m), Lewis & Dwyer-Joyce 2004), severe wear far more, a lubricated rail far less.
/// Treat a growth rate per passage as an order of magnitude until the coefficient is fitted to two
/// dated measurements; its sign and its dependence on wavelength do not depend on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyWear {
    coefficient: f64,
    density: f64,
    width: f64,
}

impl EnergyWear {
    /// Wear coefficient of the mild regime \[kg/J\] used where nothing better is known.
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
        Ok(Self {
            coefficient,
            density,
            width: 2.0 * semi_axis_lateral,
        })
    }

    /// Depth worn per passage for each joule per metre, k_w / (ρ · 2b) \[m²/J\].
    pub fn depth_per_energy(&self) -> f64 {
        self.coefficient / (self.density * self.width)
    }
}
