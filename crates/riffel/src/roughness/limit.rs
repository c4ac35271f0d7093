//! Limits of roughness, as numbers; who set them stands with the data.

use super::{Spectrum, ThirdOctave, WavelengthBand};
use crate::Error;

/// Highest levels of a spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelLimit {
    spectrum: Spectrum,
}

/// A band held against its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct LevelExcess {
    /// The band.
    pub band: ThirdOctave,
    /// Its level \[dB re 1 µm\].
    pub level: f64,
    /// The limit \[dB re 1 µm\].
    pub limit: f64,
}

impl LevelExcess {
    /// Level less limit \[dB\]: above zero the limit is broken.
    pub fn excess(&self) -> f64 {
        self.level - self.limit
    }
}

impl LevelLimit {
    /// A limit of the levels of a spectrum.
    pub fn new(spectrum: Spectrum) -> Self {
        Self { spectrum }
    }

    /// The limit as a spectrum.
    pub fn spectrum(&self) -> &Spectrum {
        &self.spectrum
    }

    /// Every band that both have, the shortest wavelength first.
    pub fn compare(&self, spectrum: &Spectrum) -> Vec<LevelExcess> {
        let bands = spectrum.levels().iter();
        bands
            .filter_map(|level| {
                Some(LevelExcess { band: level.band, level: level.level, limit: self.spectrum.level(level.band)? })
            })
            .collect()
    }
}

/// Highest RMS in bands of wavelength.
#[derive(Debug, Clone, PartialEq)]
pub struct RmsLimit {
    bands: Vec<(WavelengthBand, f64)>,
    share: f64,
}

impl RmsLimit {
    /// Limits of the RMS \[m\] by band, and the share of length \[-\] that may be over them.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for an RMS that is not above zero or a share outside 0–1.
    pub fn new(bands: Vec<(WavelengthBand, f64)>, share: f64) -> Result<Self, Error> {
        for (_, rms) in &bands {
            Error::unless_positive("limit of the RMS", *rms, "m")?;
        }
        if !(0.0..=1.0).contains(&share) {
            return Err(Error::OutOfRange {
                quantity: "share of length that may be over a limit",
                value: share,
                unit: "",
                rule: "must be between 0 and 1",
            });
        }
        Ok(Self { bands, share })
    }

    /// Limit of a band \[m\].
    pub fn of(&self, band: WavelengthBand) -> Option<f64> {
        let same = |limit: &&(WavelengthBand, f64)| {
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
            near(limit.0.from(), band.from()) && near(limit.0.to(), band.to())
        };
        self.bands.iter().find(same).map(|limit| limit.1)
    }

    /// Bands with their limits \[m\].
    pub fn bands(&self) -> &[(WavelengthBand, f64)] {
        &self.bands
    }

    /// Share of length that may be over the limit \[-\].
    pub fn share(&self) -> f64 {
        self.share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_bands_with_a_limit_are_compared() -> Result<(), Error> {
        let band = ThirdOctave::new;
        let limit = LevelLimit::new(Spectrum::new([(band(-17), -6.0), (band(-16), -5.0)])?);
        let spectrum = Spectrum::new([(band(-18), 3.0), (band(-17), -4.5)])?;
        let compared = limit.compare(&spectrum);
        assert_eq!(compared.len(), 1);
        assert_eq!(compared[0].excess(), 1.5);
        Ok(())
    }

    #[test]
    fn limits_are_found_by_their_band() -> Result<(), Error> {
        let limit = RmsLimit::new(vec![(WavelengthBand::GRINDING[0], 3e-6)], 0.05)?;
        let written = WavelengthBand::new(10.0 * 1e-3, 30.0 * 1e-3)?;
        assert_eq!(limit.of(written), Some(3e-6));
        assert_eq!(limit.of(WavelengthBand::GRINDING[1]), None);
        assert!(RmsLimit::new(vec![], 1.5).is_err());
        Ok(())
    }
}
