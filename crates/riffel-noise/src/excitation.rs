//! What shakes wheel and rail: roughness at a speed.

use riffel::Error;
use riffel::contact::ContactFilter;
use riffel::roughness::{Spectrum, ThirdOctave, WavelengthBand};

use super::FrequencyBand;

/// Roughness under a wheel at a speed, as far as the contact patch feels it.
///
/// A wave of the length λ shakes at f = V/λ. One-third octaves of wavelength become those of frequency by their shares on
/// a logarithmic axis, within which the energy is taken to be spread evenly: a tone in one band of wavelength may stand
/// in two bands of frequency. The filter is [`ContactFilter::approximate`].
#[derive(Debug, Clone)]
pub struct Excitation {
    spectrum: Spectrum,
    filter: ContactFilter,
    speed: f64,
}

impl Excitation {
    /// The roughness of a rail, with that of the wheel where it is known, at a speed V \[m/s\]. Bands that only one of the
    /// two has are left out.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless V > 0; [`Error::Measurement`] where rail and wheel share no band.
    pub fn new(rail: &Spectrum, wheel: Option<&Spectrum>, filter: ContactFilter, speed: f64) -> Result<Self, Error> {
        Error::unless_positive("speed", speed, "m/s")?;
        let spectrum = match wheel {
            None => rail.clone(),
            Some(wheel) => Spectrum::new(rail.levels().iter().filter_map(|level| {
                let other = riffel::roughness::mean_square(wheel.level(level.band)?);
                let sum = level.mean_square() + other;
                Some((level.band, riffel::roughness::level(sum)))
            }))?,
        };
        Ok(Self { spectrum, filter, speed })
    }

    /// Speed V \[m/s\].
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Whether the wavelengths of a band are known to its edges.
    pub fn covers(&self, band: FrequencyBand) -> bool {
        let (low, high) = band.range();
        // Edges that meet within rounding do.
        let ends = [self.speed / high * (1.0 + 1e-9), self.speed / low * (1.0 - 1e-9)];
        match ends.map(ThirdOctave::containing) {
            [Ok(shortest), Ok(longest)] => {
                ThirdOctave::between(shortest, longest).all(|band| self.spectrum.level(band).is_some())
            }
            _ => false,
        }
    }

    /// Mean square \[m²\] between two frequencies \[Hz\] that lie close together, behind the filter.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < `low` < `high`.
    pub fn mean_square(&self, low: f64, high: f64) -> Result<f64, Error> {
        let within = WavelengthBand::new(self.speed / high, self.speed / low)?;
        let filter = self.filter.approximate(self.speed / (low * high).sqrt())?;
        Ok(filter * self.spectrum.root_mean_square(within).powi(2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Energy is neither lost nor made where bands of wavelength become bands of frequency.
    #[test]
    fn energy_is_kept() -> Result<(), Error> {
        let one = (-40..=0).map(|index| (ThirdOctave::new(index), if index == -17 { 10.0 } else { -200.0 }));
        // A patch of 1 nm filters nothing.
        let filter = ContactFilter::new(1e-9, 1e-9)?;
        let excitation = Excitation::new(&Spectrum::new(one)?, None, filter, 37.3)?;
        let mut bands = 0;
        let sum: f64 = FrequencyBand::all()
            .map(|band| {
                let (low, high) = band.range();
                let found = excitation.mean_square(low, high).unwrap();
                bands += u32::from(found > 1e-14);
                found
            })
            .sum();
        assert!((sum / 1e-11 - 1.0).abs() < 1e-9, "{sum}");
        assert_eq!(bands, 2);
        assert!(Excitation::new(&Spectrum::new([(ThirdOctave::new(-17), 0.0)])?, None, filter, 0.0).is_err());
        Ok(())
    }

    #[test]
    fn a_band_is_covered_to_its_edges() -> Result<(), Error> {
        let filter = ContactFilter::new(5e-3, 5e-3)?;
        let spectrum = Spectrum::new((-18..=-16).map(|index| (ThirdOctave::new(index), 0.0)))?;
        // At 10^1.5 m/s the bands meet: 10^-1.7 m is 10^3.2 Hz.
        let excitation = Excitation::new(&spectrum, None, filter, 10f64.powf(1.5))?;
        let covered: Vec<i32> =
            FrequencyBand::all().filter(|band| excitation.covers(*band)).map(FrequencyBand::index).collect();
        assert_eq!(covered, [31, 32, 33]);
        let faster = Excitation::new(&spectrum, None, filter, 10f64.powf(1.52))?;
        assert!(!faster.covers(FrequencyBand::new(31)));
        // Wheel and rail alike: 3 dB more.
        let both = Excitation::new(&spectrum, Some(&spectrum), filter, 10f64.powf(1.5))?;
        let ratio = both.mean_square(1500.0, 1600.0)? / excitation.mean_square(1500.0, 1600.0)?;
        assert!((ratio - 2.0).abs() < 1e-9);
        Ok(())
    }
}
