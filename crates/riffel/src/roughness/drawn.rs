//! Profiles drawn from a spectrum.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use riffel_numerics::fourier::Plans;
use riffel_numerics::random_numbers::unit;

use super::{BandLevel, Profile, Spectrum, mean_square};
use crate::Error;

impl Spectrum {
    /// Length of a profile in longest wavelengths, so that the longest band, of a width of 0.23/λ, has three waves.
    const LEAST_LENGTH: f64 = 13.0;

    /// A profile of about the given length \[m\] that has these levels, each exactly, and goes on where it ends.
    ///
    /// A Fourier series with the phases of a seed, the same on every machine (Shinozuka & Deodatis, Applied Mechanics Reviews 44
    /// (1991) 191, amplitudes not random): within a band the power follows the straight lines between the levels over the
    /// logarithm of wavelength. There is nothing outside the bands. The spacing \[m\] is made a whole part of the length.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a length below 13 of the longest wavelengths, and a spacing above a quarter of the shortest.
    pub fn drawn(&self, length: f64, spacing: f64, seed: u64) -> Result<Profile, Error> {
        Error::unless_positive("length of the profile", length, "m")?;
        Error::unless_positive("sample spacing", spacing, "m")?;
        let levels = self.levels();
        // A spectrum has a band.
        let longest = levels[levels.len() - 1].band.wavelength();
        if length < Self::LEAST_LENGTH * longest {
            return Err(Error::OutOfRange {
                quantity: "length of the profile",
                value: length,
                unit: "m",
                rule: "must be 13 times the longest wavelength of its spectrum, so that every band has three waves",
            });
        }
        if spacing > 0.25 * levels[0].band.wavelength_range().0 {
            return Err(Error::OutOfRange {
                quantity: "sample spacing",
                value: spacing,
                unit: "m",
                rule: "must be a quarter of the shortest wavelength of the spectrum or less",
            });
        }
        let count = (length / spacing).round() as usize;
        let transform = Plans::default().real_inverse(count);
        let mut lines = transform.make_input_vec();
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        for band in levels {
            let (low, high) = band.band.wavelength_range();
            let first = (length / high).floor() as usize + 1;
            let places = first..=(length / low).floor() as usize;
            // Density over wavenumber: the level's power over a band that is as wide as its wavenumber.
            let weight = |n: usize| mean_square(self.between(length / n as f64)) / n as f64;
            let scale = band.mean_square() / places.clone().map(weight).sum::<f64>();
            for n in places {
                let phase = TAU * unit(random.next_u64());
                // Mean square of a line 2|X|².
                lines[n] = Complex64::from_polar((0.5 * scale * weight(n)).sqrt(), phase);
            }
        }
        let mut heights = transform.make_output_vec();
        // Fails only for buffers of another length, or an imaginary part where there is none.
        let done = transform.process(&mut lines, &mut heights);
        debug_assert!(done.is_ok());
        Profile::new(0.0, length / count as f64, heights)
    }

    /// Level at any wavelength \[dB re 1 µm\]: straight lines over its logarithm, level beyond the ends.
    fn between(&self, wavelength: f64) -> f64 {
        let levels = self.levels();
        let after = levels.partition_point(|level| level.band.wavelength() < wavelength);
        let at = |level: &BandLevel| level.band.wavelength().ln();
        match (after.checked_sub(1).map(|before| &levels[before]), levels.get(after)) {
            (Some(before), Some(after)) => {
                let share = (wavelength.ln() - at(before)) / (at(after) - at(before));
                before.level + share * (after.level - before.level)
            }
            (Some(end), None) | (None, Some(end)) => end.level,
            (None, None) => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roughness::ThirdOctave;

    fn sloping() -> Result<Spectrum, Error> {
        let bands = (-19..=-10).map(|index| (ThirdOctave::new(index), 0.8 * f64::from(index)));
        Spectrum::new(bands)
    }

    /// By the method of EN 15610 the levels come back to 0.3 dB: its window moves some of a band of three waves to
    /// the next. The same seed draws the same.
    #[test]
    fn a_drawn_profile_has_its_spectrum() -> Result<(), Error> {
        let spectrum = sloping()?;
        let profile = spectrum.drawn(50.0, 1e-3, 5)?;
        assert_eq!(profile, spectrum.drawn(50.0, 1e-3, 5)?);
        assert_ne!(profile, spectrum.drawn(50.0, 1e-3, 6)?);
        let found = Spectrum::of_record(std::slice::from_ref(&profile), 0.1)?;
        for level in &spectrum.levels()[1..8] {
            let error = found.level(level.band).unwrap_or(f64::NAN) - level.level;
            assert!(error.abs() < 0.3, "{level:?}: {error}");
        }
        // Parseval: the whole power to rounding.
        let power: f64 = spectrum.levels().iter().map(BandLevel::mean_square).sum();
        let heights = profile.heights();
        let of_heights = heights.iter().map(|h| h * h).sum::<f64>() / heights.len() as f64;
        assert!((of_heights / power - 1.0).abs() < 1e-12);
        Ok(())
    }

    #[test]
    fn a_profile_that_is_too_short_or_too_coarse_is_not_drawn() -> Result<(), Error> {
        let spectrum = sloping()?;
        assert!(spectrum.drawn(1.3, 1e-3, 1).is_ok());
        assert!(spectrum.drawn(1.29, 1e-3, 1).is_err());
        assert!(spectrum.drawn(2.0, 4e-3, 1).is_err());
        Ok(())
    }
}
