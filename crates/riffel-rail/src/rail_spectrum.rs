//! The levels of a rail.

use riffel::roughness::Spectrum;

/// The levels of a rail.
#[derive(Debug, Clone, PartialEq)]
pub struct RailSpectrum {
    /// Its name; `None` if rails are not named.
    pub rail: Option<String>,
    /// Its levels now.
    pub spectrum: Spectrum,
}

impl From<Spectrum> for RailSpectrum {
    /// A rail without a name.
    fn from(spectrum: Spectrum) -> Self {
        Self { rail: None, spectrum }
    }
}
