//! Roughness spectra in one-third octaves.

use super::{ThirdOctave, WavelengthBand, level, mean_square};
use crate::Error;

/// Level of one band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandLevel {
    /// The band.
    pub band: ThirdOctave,
    /// Level \[dB re 1 µm\].
    pub level: f64,
}

impl BandLevel {
    /// Mean square of the band \[m²\].
    pub fn mean_square(&self) -> f64 {
        mean_square(self.level)
    }

    /// Amplitude \[m\] of the sinusoid that has this level.
    pub fn amplitude(&self) -> f64 {
        (2.0 * self.mean_square()).sqrt()
    }
}

/// One-third-octave levels of roughness, in dB re 1 µm.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Spectrum {
    /// By wavelength, the shortest first.
    levels: Vec<BandLevel>,
}

impl Spectrum {
    /// A spectrum of bands with their levels \[dB re 1 µm\], in any order.
    ///
    /// # Errors
    /// [`Error::Measurement`] where there is no band, a level is not finite, or a band is there twice.
    pub fn new(levels: impl IntoIterator<Item = (ThirdOctave, f64)>) -> Result<Self, Error> {
        let mut levels: Vec<BandLevel> = levels.into_iter().map(|(band, level)| BandLevel { band, level }).collect();
        let wrong = |index, rule| Err(Error::Measurement { index, rule });
        if levels.is_empty() {
            return wrong(0, "a spectrum must have a band");
        }
        if let Some(index) = levels.iter().position(|band| !band.level.is_finite()) {
            return wrong(index, "a level must be finite");
        }
        levels.sort_by_key(|band| band.band);
        match levels.windows(2).position(|pair| pair[0].band == pair[1].band) {
            Some(index) => wrong(index + 1, "a band must be there once"),
            None => Ok(Self { levels }),
        }
    }

    /// The bands with their levels, the shortest wavelength first.
    pub fn levels(&self) -> &[BandLevel] {
        &self.levels
    }

    /// Level of a band \[dB re 1 µm\], if the spectrum has it.
    pub fn level(&self, band: ThirdOctave) -> Option<f64> {
        let place = self.levels.binary_search_by_key(&band, |level| level.band);
        place.ok().map(|index| self.levels[index].level)
    }

    /// The spectrum with each level changed to what `level` makes of it \[dB re 1 µm\]: growth, a filter.
    ///
    /// # Errors
    /// [`Error::Measurement`] where a new level is not finite.
    pub fn map(&self, mut level: impl FnMut(BandLevel) -> f64) -> Result<Self, Error> {
        Self::new(self.levels.iter().map(|&band| (band.band, level(band))))
    }

    /// Mean of several spectra on mean squares, as EN 15610 averages records; None without a spectrum.
    /// Each band is averaged over the spectra that have it.
    pub fn energy_mean(spectra: &[Self]) -> Option<Self> {
        Self::mean(spectra, mean_square, level)
    }

    /// Mean of the levels themselves, which lies below the energy mean; None without a spectrum.
    pub fn arithmetic_mean(spectra: &[Self]) -> Option<Self> {
        Self::mean(spectra, |level| level, |level| level)
    }

    fn mean(spectra: &[Self], to: fn(f64) -> f64, from: fn(f64) -> f64) -> Option<Self> {
        let bands = || spectra.iter().flat_map(|spectrum| &spectrum.levels);
        let shortest = bands().map(|level| level.band).min()?;
        let longest = bands().map(|level| level.band).max()?;
        let levels = ThirdOctave::between(shortest, longest).filter_map(|band| {
            let levels = spectra.iter().filter_map(|spectrum| spectrum.level(band));
            let (count, sum) = levels.fold((0, 0.0), |(count, sum), level| (count + 1, sum + to(level)));
            (count > 0).then(|| (band, from(sum / f64::from(count))))
        });
        Self::new(levels).ok()
    }

    /// Root mean square \[m\] of all that lies between two wavelengths; a one-third octave that is cut
    /// counts with its share of the logarithm of wavelength.
    pub fn root_mean_square(&self, within: WavelengthBand) -> f64 {
        let sum: f64 = self
            .levels
            .iter()
            .map(|level| {
                let (shortest, longest) = level.band.wavelength_range();
                let from = shortest.max(within.from());
                let to = longest.min(within.to());
                let share = (to / from).log10().max(0.0) / (2.0 * ThirdOctave::HALF_WIDTH_DECADES);
                share * level.mean_square()
            })
            .sum();
        sum.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn band(millimetres: f64) -> ThirdOctave {
        ThirdOctave::containing(1e-3 * millimetres).unwrap()
    }

    #[test]
    fn means_are_those_of_energy_or_of_levels() -> Result<(), Error> {
        let one = Spectrum::new([(band(20.0), 0.0), (band(40.0), 3.0)])?;
        let two = Spectrum::new([(band(20.0), 10.0)])?;
        let both = [one, two];
        let energy = Spectrum::energy_mean(&both).unwrap();
        assert!((energy.level(band(20.0)).unwrap() - 10.0 * 5.5f64.log10()).abs() < 1e-12);
        assert!((energy.level(band(40.0)).unwrap() - 3.0).abs() < 1e-12);
        assert_eq!(energy.level(band(31.5)), None);
        let levels = Spectrum::arithmetic_mean(&both).unwrap();
        assert!((levels.level(band(20.0)).unwrap() - 5.0).abs() < 1e-12);
        assert_eq!(Spectrum::energy_mean(&[]), None);
        Ok(())
    }

    #[test]
    fn what_is_no_spectrum_is_refused() {
        assert!(Spectrum::new([]).is_err());
        assert!(Spectrum::new([(band(20.0), f64::NAN)]).is_err());
        assert!(Spectrum::new([(band(20.0), 1.0), (band(20.0), 2.0)]).is_err());
    }

    #[test]
    fn bands_add_up() -> Result<(), Error> {
        let flat = Spectrum::new((-30..=0).map(|index| (ThirdOctave::new(index), 0.0)))?;
        // Ten bands in a decade, each of 1 µm.
        let decade = flat.root_mean_square(WavelengthBand::new(0.01, 0.1)?);
        assert!((decade - 10f64.sqrt() * 1e-6).abs() < 1e-15);
        assert!((flat.levels()[0].amplitude() - 2f64.sqrt() * 1e-6).abs() < 1e-18);
        let grown = flat.map(|band| band.level + 2.0)?;
        assert_eq!(grown.levels()[3].level, 2.0);
        Ok(())
    }
}
