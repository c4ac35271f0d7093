//! Levels of a spectrum as data.

use riffel::roughness::Spectrum;
use serde::{Serialize, Serializer};

/// A level of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Level {
    /// Wavelength of the band.
    pub wavelength_m: f64,
    /// Level re 1 µm.
    pub level_db: f64,
}

/// The levels of a spectrum.
pub(crate) fn levels(spectrum: &Spectrum) -> Vec<Level> {
    let levels = spectrum.levels().iter();
    levels.map(|level| Level { wavelength_m: level.band.wavelength(), level_db: level.level }).collect()
}

/// A spectrum as its levels.
pub(super) fn as_levels<S: Serializer>(spectrum: &Spectrum, serializer: S) -> Result<S::Ok, S::Error> {
    levels(spectrum).serialize(serializer)
}
