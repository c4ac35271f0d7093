//! Bands of wavelength in which track engineers judge a rail.

use crate::Error;

/// Wavelengths from one to another \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WavelengthBand {
    from: f64,
    to: f64,
}

impl WavelengthBand {
    /// 10–30, 30–100, 100–300 and 300–1000 mm, the bands of grinding acceptance (Grassie, Saxon & Smith,
    /// Journal of Sound and Vibration 227 (1999) 949, and EN 13231).
    pub const GRINDING: [Self; 4] =
        [Self::of(0.010, 0.030), Self::of(0.030, 0.100), Self::of(0.100, 0.300), Self::of(0.300, 1.000)];

    const fn of(from: f64, to: f64) -> Self {
        Self { from, to }
    }

    /// Wavelengths between two \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < `from` < `to`.
    pub fn new(from: f64, to: f64) -> Result<Self, Error> {
        Error::unless_positive("shortest wavelength of a band", from, "m")?;
        Error::unless_positive("longest wavelength of a band", to, "m")?;
        if from >= to {
            return Err(Error::OutOfRange {
                quantity: "longest wavelength of a band",
                value: to,
                unit: "m",
                rule: "must be above the shortest",
            });
        }
        Ok(Self { from, to })
    }

    /// Shortest wavelength \[m\].
    pub const fn from(&self) -> f64 {
        self.from
    }

    /// Longest wavelength \[m\].
    pub const fn to(&self) -> f64 {
        self.to
    }

    /// Whether a record of this length \[m\] is long enough: four of the longest wavelength, as EN 15610
    /// asks of a spectrum.
    pub fn fits_into(&self, length: f64) -> bool {
        // A record of 4000 samples of 1 mm reaches 3.999 m from its first to its last.
        4.0 * self.to <= length * (1.0 + 1e-3)
    }

    /// Length of the window for moving statistics \[m\] where nothing else is asked for: ten of the longest
    /// wavelength, at least 1 m. Riffel's own choice; standards differ.
    pub fn default_window(&self) -> f64 {
        (10.0 * self.to).max(1.0)
    }
}
