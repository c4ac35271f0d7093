//! Profiles made to a recipe, for tests, benchmarks and teaching.

use std::f64::consts::TAU;

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use riffel_numerics::fourier::Plans;
use riffel_numerics::random_numbers::normal_pair;

use super::{ThirdOctave, mean_square};
use crate::Error;

/// Most samples of a recipe: 100 km at 1 mm.
const MOST_SAMPLES: f64 = 1e8;

/// What a profile is made of. All lengths, heights and positions in metres.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Recipe {
    /// Length of the profile.
    pub length: f64,
    /// Step between two samples.
    pub spacing: f64,
    /// Seed of the noise: the same seed gives the same profile on every machine, to rounding.
    pub seed: u64,
    /// Waves.
    pub sinusoids: Vec<Sinusoid>,
    /// Noise below everything.
    pub noise: Option<ColouredNoise>,
    /// Upward triangles.
    pub spikes: Vec<Irregularity>,
    /// Flat-bottomed pits: a recess with vertical sides.
    pub pits: Vec<Irregularity>,
    /// Where the sensor gave nothing.
    pub dropouts: Vec<Dropout>,
}

/// A wave from one place to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoid {
    /// Wavelength.
    pub wavelength: f64,
    /// Amplitude.
    pub amplitude: f64,
    /// Phase at position zero \[rad\].
    pub phase: f64,
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

/// Gaussian noise whose one-third-octave level is a straight line over the logarithm of wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColouredNoise {
    /// Level of the one-third octave about `wavelength` \[dB re 1 µm\].
    pub level: f64,
    /// Wavelength to which the level belongs.
    pub wavelength: f64,
    /// Change of the level in a decade of wavelength \[dB\]: −10 is white noise, 20 a worn rail.
    pub slope: f64,
    /// Longest wavelength; there is nothing above.
    pub longest: f64,
}

/// A spike or a pit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Irregularity {
    /// Position of its middle.
    pub at: f64,
    /// Height of the spike or depth of the pit, positive.
    pub height: f64,
    /// Width at its foot.
    pub width: f64,
}

/// A length without readings.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Dropout {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

impl ColouredNoise {
    /// One-third-octave level at a wavelength \[dB re 1 µm\].
    pub fn level_at(&self, wavelength: f64) -> f64 {
        self.level + self.slope * (wavelength / self.wavelength).log10()
    }

    /// Power density C k^(q−1) \[m³\] over wavenumber, as C and q: the level falls by 10 q dB in a decade of
    /// wavelength, and the integral over the band about `wavelength` has the level asked for.
    fn density(&self) -> (f64, f64) {
        let q = -self.slope / 10.0;
        let half = std::f64::consts::LN_10 * ThirdOctave::HALF_WIDTH_DECADES;
        // ∫ k^(q−1) over the band, divided by k₀^q.
        let integral = if q == 0.0 { 2.0 * half } else { 2.0 * (q * half).sinh() / q };
        let power = mean_square(self.level);
        (power * self.wavelength.powf(q) / integral, q)
    }
}

impl Recipe {
    /// Heights \[m\] from position zero on; not a number where the sensor gave nothing.
    ///
    /// Noise is a Fourier sum of independent normal coefficients (Shinozuka & Deodatis, Applied Mechanics
    /// Reviews 44 (1991) 191) on twice the length or less, so that its ends do not meet. Spikes are
    /// triangles, pits have flat bottoms and vertical sides.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a length, spacing, wavelength or width that is not above zero, or more than
    /// 10⁸ samples.
    pub fn heights(&self) -> Result<Vec<f64>, Error> {
        self.check()?;
        let samples = (self.length / self.spacing).round() as usize;
        let mut heights = match &self.noise {
            Some(noise) => self.noise(noise, samples),
            None => vec![0.0; samples],
        };
        for wave in &self.sinusoids {
            let from = self.sample(wave.from, samples);
            let to = self.sample(wave.to, samples);
            for (index, height) in heights.iter_mut().enumerate().take(to).skip(from) {
                let place = index as f64 * self.spacing;
                *height += wave.amplitude * (TAU * place / wave.wavelength + wave.phase).sin();
            }
        }
        for (irregularities, sign) in [(&self.spikes, 1.0), (&self.pits, -1.0)] {
            for shape in irregularities {
                let half = 0.5 * shape.width;
                let from = self.sample(shape.at - half, samples).saturating_sub(1);
                let to = (self.sample(shape.at + half, samples) + 2).min(samples);
                for (index, height) in heights.iter_mut().enumerate().take(to).skip(from) {
                    let away = (index as f64 * self.spacing - shape.at).abs() / half;
                    // A place on the foot belongs to neither, whatever its rounding.
                    let inside = away < 1.0 - 1e-6;
                    let share = if sign > 0.0 { 1.0 - away } else { 1.0 };
                    *height += if inside { sign * shape.height * share } else { 0.0 };
                }
            }
        }
        for dropout in &self.dropouts {
            let (from, to) = (self.sample(dropout.from, samples), self.sample(dropout.to, samples));
            heights[from.min(to)..to].fill(f64::NAN);
        }
        Ok(heights)
    }

    /// `Ok` for a recipe that can be made.
    ///
    /// # Errors
    /// Errors of [`heights`](Self::heights).
    pub fn check(&self) -> Result<(), Error> {
        Error::unless_positive("length of the profile", self.length, "m")?;
        Error::unless_positive("sample spacing", self.spacing, "m")?;
        if !(2.0..=MOST_SAMPLES).contains(&(self.length / self.spacing).round()) {
            return Err(Error::OutOfRange {
                quantity: "length over spacing",
                value: self.length / self.spacing,
                unit: "",
                rule: "must be between 2 and 100 million samples",
            });
        }
        for wave in &self.sinusoids {
            Error::unless_positive("wavelength of a sinusoid", wave.wavelength, "m")?;
        }
        for shape in self.spikes.iter().chain(&self.pits) {
            Error::unless_positive("width of a spike or pit", shape.width, "m")?;
            Error::unless_positive("height of a spike or depth of a pit", shape.height, "m")?;
        }
        if let Some(noise) = &self.noise {
            Error::unless_positive("wavelength of the noise", noise.wavelength, "m")?;
            Error::unless_positive("longest wavelength of the noise", noise.longest, "m")?;
        }
        Ok(())
    }

    fn sample(&self, position: f64, samples: usize) -> usize {
        ((position / self.spacing).round().max(0.0) as usize).min(samples)
    }

    fn noise(&self, noise: &ColouredNoise, samples: usize) -> Vec<f64> {
        let size = samples.next_power_of_two().max(4);
        let line_spacing = 1.0 / (size as f64 * self.spacing);
        let (density, q) = noise.density();
        let mut random = Xoshiro256PlusPlus::seed_from_u64(self.seed);
        let transform = Plans::default().real_inverse(size);
        let mut lines = transform.make_input_vec();
        for (index, line) in lines.iter_mut().enumerate().take(size / 2).skip(1) {
            let normal = normal_pair(&mut random);
            let k = index as f64 * line_spacing;
            if k * noise.longest >= 1.0 {
                // Mean square of the line 2|X|², of which each part of X has a quarter.
                *line = normal * (0.25 * density * k.powf(q - 1.0) * line_spacing).sqrt();
            }
        }
        let mut heights = transform.make_output_vec();
        // Fails only for buffers of another length, or an imaginary part where there is none.
        let done = transform.process(&mut lines, &mut heights);
        debug_assert!(done.is_ok());
        heights.truncate(samples);
        heights
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roughness::{Profile, Spectrum};

    fn recipe(length: f64) -> Recipe {
        Recipe { length, spacing: 1e-3, seed: 1, ..Recipe::default() }
    }

    /// White and coloured noise return their spectrum within 0.3 dB: 1 km has 2 300 lines a band at 100 mm
    /// and 0.09 dB of chance.
    #[test]
    fn noise_has_the_levels_it_was_made_with() -> Result<(), Error> {
        for slope in [-10.0, 0.0, 20.0] {
            let noise = ColouredNoise { level: 0.0, wavelength: 0.1, slope, longest: 3.0 };
            let made = Recipe { noise: Some(noise), ..recipe(1000.0) };
            let profile = Profile::new(0.0, 1e-3, made.heights()?)?;
            let spectrum = Spectrum::of_record(&[profile], 0.1)?;
            assert!(spectrum.levels().len() > 10);
            for level in spectrum.levels() {
                let expected = noise.level_at(level.band.wavelength());
                assert!((level.level - expected).abs() < 0.3, "{slope} {level:?} {expected}");
            }
        }
        Ok(())
    }

    #[test]
    fn a_recipe_gives_what_it_names() -> Result<(), Error> {
        let shape = Irregularity { at: 1.0, height: 50e-6, width: 4e-3 };
        let made = Recipe {
            spikes: vec![shape],
            pits: vec![Irregularity { at: 2.0, ..shape }],
            dropouts: vec![Dropout { from: 3.0, to: 3.1 }],
            sinusoids: vec![Sinusoid { wavelength: 0.1, amplitude: 2e-6, phase: 0.0, from: 4.0, to: 5.0 }],
            ..recipe(6.0)
        };
        let heights = made.heights()?;
        assert_eq!(heights.len(), 6000);
        assert!((heights[1000] - 50e-6).abs() < 1e-15 && (heights[1001] - 25e-6).abs() < 1e-12);
        assert_eq!(heights[1002], 0.0);
        assert_eq!(heights[1998..2003], [0.0, -50e-6, -50e-6, -50e-6, 0.0]);
        assert_eq!(heights.iter().filter(|height| height.is_nan()).count(), 100);
        assert!((heights[4025] - 2e-6).abs() < 1e-12);
        assert_eq!(made.heights()?[..1000], heights[..1000]);
        assert!(recipe(-1.0).heights().is_err());
        Ok(())
    }
}
