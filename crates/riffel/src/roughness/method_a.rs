//! One-third-octave levels by Fourier transform: method A of EN 15610.

use rayon::prelude::*;
use realfft::RealFftPlanner;

use super::{Profile, Spectrum, ThirdOctave, level};
use crate::Error;

/// Shortest segment \[m\] that EN 15610 allows.
const SHORTEST_SEGMENT: f64 = 1.0;
/// Length of a segment in the longest wavelengths that are asked for. The main lobe of the window is
/// four lines wide, and a band at the twentieth line as well: it keeps a sinusoid. At ten lines half a
/// decibel would go to its neighbours.
const WAVES_PER_SEGMENT: f64 = 20.0;
/// Segments whose powers are added before the sums are added, whatever the number of threads.
const BATCH: usize = 8;

/// Power of a record over wavenumber, averaged over segments.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct PowerSpectrum {
    /// Distance of two lines \[1/m\].
    line_spacing: f64,
    /// Mean square \[m²\] of each line; the sum is that of the record without its trend.
    lines: Vec<f64>,
    segments: usize,
    /// \[m\].
    record_length: f64,
    /// \[m\].
    sample_spacing: f64,
}

impl PowerSpectrum {
    /// Average |DFT|² over all stretches of one record, in segments long enough for wavelengths up to
    /// `longest` \[m\].
    ///
    /// Method A of EN 15610:2009: segments of at least 1 m that overlap by half or more, mean and trend
    /// removed, Hann window, |DFT|² averaged. A segment has twenty of the longest wavelength, or the whole
    /// stretch where that is shorter; the last one ends where its stretch ends, so that no sample is
    /// lost. Stretches shorter than a segment are left out. Cost: two transforms for each length of a
    /// segment, some nanoseconds a sample; parallel.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where no stretch is as long as 1 m; [`Error::Measurement`] without a stretch
    /// or where their spacings differ.
    pub fn of_record(stretches: &[Profile], longest: f64) -> Result<Self, Error> {
        Error::unless_positive("longest wavelength", longest, "m")?;
        let Some(first) = stretches.first() else {
            return Err(Error::Measurement {
                index: 0,
                rule: "a record must have a stretch without gaps",
            });
        };
        let spacing = first.spacing();
        if let Some(index) = stretches
            .iter()
            .position(|stretch| stretch.spacing() != spacing)
        {
            return Err(Error::Measurement {
                index,
                rule: "all stretches of a record must have one spacing",
            });
        }
        let length = stretches.iter().map(Profile::length).fold(0.0, f64::max);
        // A record of 1000 samples of 1 mm is 0.999 m from its first to its last.
        if length < SHORTEST_SEGMENT * (1.0 - 2e-3) {
            return Err(Error::OutOfRange {
                quantity: "longest stretch without gaps",
                value: length,
                unit: "m",
                rule: "a record must have at least 1 m",
            });
        }
        let wanted = (WAVES_PER_SEGMENT * longest).max(SHORTEST_SEGMENT);
        let samples = segment_samples(wanted.min(length), spacing);
        Ok(Self::averaged(stretches, samples))
    }

    fn averaged(stretches: &[Profile], samples: usize) -> Self {
        let segments: Vec<&[f64]> = stretches
            .iter()
            .flat_map(|stretch| segments(stretch.heights(), samples))
            .collect();
        let transform = RealFftPlanner::<f64>::new().plan_fft_forward(samples);
        let window: Vec<f64> = (0..samples)
            .map(|index| {
                let phase = std::f64::consts::TAU * index as f64 / samples as f64;
                0.5 - 0.5 * phase.cos()
            })
            .collect();
        let energy: f64 = window.iter().map(|weight| weight * weight).sum();
        let batches: Vec<Vec<f64>> = segments
            .par_chunks(BATCH)
            .map(|batch| {
                let mut sum = vec![0.0; samples / 2 + 1];
                let mut input = transform.make_input_vec();
                let mut output = transform.make_output_vec();
                let mut scratch = transform.make_scratch_vec();
                for segment in batch {
                    input.copy_from_slice(segment);
                    remove_trend(&mut input);
                    for (height, weight) in input.iter_mut().zip(&window) {
                        *height *= weight;
                    }
                    // Fails only for a buffer of another length.
                    let transformed =
                        transform.process_with_scratch(&mut input, &mut output, &mut scratch);
                    debug_assert!(transformed.is_ok());
                    for (sum, line) in sum.iter_mut().zip(&output) {
                        *sum += line.norm_sqr();
                    }
                }
                sum
            })
            .collect();
        let mut lines = vec![0.0; samples / 2 + 1];
        for batch in &batches {
            for (line, part) in lines.iter_mut().zip(batch) {
                *line += part;
            }
        }
        let scale = 1.0 / (samples as f64 * energy * segments.len() as f64);
        for (index, line) in lines.iter_mut().enumerate() {
            // Negative wavenumbers have the same power; zero and the highest have no counterpart.
            let both = index > 0 && 2 * index != samples;
            *line *= if both { 2.0 * scale } else { scale };
        }
        let spacing = stretches[0].spacing();
        Self {
            line_spacing: 1.0 / (samples as f64 * spacing),
            lines,
            segments: segments.len(),
            record_length: stretches.iter().map(Profile::length).fold(0.0, f64::max),
            sample_spacing: spacing,
        }
    }

    /// Number of segments averaged.
    pub fn segments(&self) -> usize {
        self.segments
    }

    /// Length of a segment \[m\].
    pub fn segment_length(&self) -> f64 {
        self.line_spacing.recip()
    }

    /// Wavenumber \[1/m\] and mean square \[m²\] of each line.
    pub fn lines(&self) -> impl Iterator<Item = (f64, f64)> {
        let lines = self.lines.iter().enumerate();
        lines.map(|(index, &power)| (index as f64 * self.line_spacing, power))
    }

    /// Levels of the one-third octaves up to `longest` \[m\], at most a quarter of the longest stretch, and
    /// down to the last that lies wholly above two samples.
    ///
    /// A line stands for half a step to either side; where it straddles the edge of a band, each band has
    /// its share (EN 15610:2009, Annex C).
    ///
    /// # Errors
    /// [`Error::Measurement`] where no band is left.
    pub fn third_octaves(&self, longest: f64) -> Result<Spectrum, Error> {
        // The record is known to a sample at either end.
        let longest = longest.min(0.25 * (self.record_length + self.sample_spacing)) * (1.0 + 1e-9);
        let longest = (10.0 * longest.log10()).floor() as i32;
        let nyquist = 0.5 / self.sample_spacing * (1.0 + 1e-9);
        let bands = (-60..=longest)
            .map(ThirdOctave::new)
            .filter(|band| band.wavenumber_range().1 <= nyquist);
        Spectrum::new(bands.map(|band| (band, level(self.power_of(band)))))
    }

    fn power_of(&self, band: ThirdOctave) -> f64 {
        let (low, high) = band.wavenumber_range();
        let (low, high) = (low / self.line_spacing, high / self.line_spacing);
        let (first, last) = (low.round() as usize, high.round() as usize);
        (first..=last.min(self.lines.len() - 1))
            .map(|line| {
                let (from, to) = (line as f64 - 0.5, line as f64 + 0.5);
                let share = (to.min(high) - from.max(low)).max(0.0);
                share * self.lines[line]
            })
            .sum()
    }
}

/// Samples of a segment of about this length: a number whose transform is quick, or all there are.
fn segment_samples(length: f64, spacing: f64) -> usize {
    (length / spacing).round().max(2.0) as usize
}

/// Segments that overlap by half or more and cover all samples.
fn segments(heights: &[f64], samples: usize) -> impl Iterator<Item = &[f64]> {
    let room = heights.len().checked_sub(samples);
    let steps = room.map_or(0, |room| room.div_ceil((samples / 2).max(1)));
    (0..=steps).filter_map(move |step| {
        let room = room?;
        let start = (room * step).checked_div(steps).unwrap_or(0);
        Some(&heights[start..start + samples])
    })
}

/// Subtract the straight line of least squares.
fn remove_trend(heights: &mut [f64]) {
    let count = heights.len() as f64;
    let middle = 0.5 * (count - 1.0);
    let mean = heights.iter().sum::<f64>() / count;
    let places = || (0..heights.len()).map(|index| index as f64 - middle);
    let moment: f64 = places()
        .zip(heights.iter())
        .map(|(place, height)| place * height)
        .sum();
    // Sum of the squares of the places.
    let slope = moment / (count * (count * count - 1.0) / 12.0);
    for (index, height) in heights.iter_mut().enumerate() {
        *height -= mean + slope * (index as f64 - middle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sinusoid(samples: usize, wavelength: f64) -> Result<Profile, Error> {
        let wave =
            |i: usize| 3e-6 * (std::f64::consts::TAU * i as f64 * 1e-3 / wavelength + 0.3).sin();
        Profile::new(0.0, 1e-3, (0..samples).map(wave).collect())
    }

    #[test]
    fn a_sinusoid_keeps_to_its_band() -> Result<(), Error> {
        for index in [-22, -17, -13, -10, -5] {
            let band = ThirdOctave::new(index);
            let record = [sinusoid(20_011, band.wavelength())?];
            let spectrum = PowerSpectrum::of_record(&record, 2.0)?.third_octaves(2.0)?;
            for level in spectrum.levels() {
                let away = (level.band.index() - index).abs();
                match away {
                    0 => assert!((level.level - 6.532).abs() < 0.01, "{level:?}"),
                    1 => {}
                    _ => assert!(level.level < -60.0, "{index}: {level:?}"),
                }
            }
        }
        Ok(())
    }

    #[test]
    fn power_is_that_of_the_record_without_its_trend() -> Result<(), Error> {
        let mut profile = sinusoid(10_000, 0.1)?;
        for (index, height) in profile.heights.iter_mut().enumerate() {
            *height += 1e-4 + 1e-8 * index as f64;
        }
        let spectrum = PowerSpectrum::of_record(&[profile], 0.25)?;
        let sum: f64 = spectrum.lines().map(|(_, power)| power).sum();
        assert!((sum / 4.5e-12 - 1.0).abs() < 1e-3, "{sum}");
        assert_eq!(spectrum.segments(), 3);
        assert!((spectrum.segment_length() - 5.0).abs() < 1e-12);
        Ok(())
    }

    #[test]
    fn every_sample_counts_once_or_more() {
        let heights: Vec<f64> = (0..1003).map(f64::from).collect();
        let segments: Vec<&[f64]> = segments(&heights, 200).collect();
        assert_eq!(segments[0][0], 0.0);
        assert_eq!(segments.last().unwrap()[199], 1002.0);
        for pair in segments.windows(2) {
            assert!(pair[1][0] - pair[0][0] <= 100.0);
        }
    }

    #[test]
    fn bands_end_at_a_quarter_of_the_record_and_at_two_samples() -> Result<(), Error> {
        let record = [sinusoid(10_000, 0.1)?];
        let spectrum = PowerSpectrum::of_record(&record, 100.0)?.third_octaves(100.0)?;
        let (first, last) = (
            spectrum.levels()[0].band,
            spectrum.levels().last().unwrap().band,
        );
        assert_eq!(first.nominal_millimetres(), 2.5);
        // 2.512 m is longer than a quarter of 10 m.
        assert_eq!(last.nominal_millimetres(), 2000.0);
        assert!(PowerSpectrum::of_record(&[sinusoid(900, 0.1)?], 0.1).is_err());
        assert!(PowerSpectrum::of_record(&[], 0.1).is_err());
        Ok(())
    }
}
