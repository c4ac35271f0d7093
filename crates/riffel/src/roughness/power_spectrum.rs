//! Power of a record over wavenumber.

use super::Profile;
use super::hann_window::{SHORTEST_RECORD, line_powers, spacing_and_longest};
use crate::Error;

/// Length of a segment in the longest wavelengths that are asked for.
const WAVES_PER_SEGMENT: f64 = 20.0;

/// Power of a record over wavenumber, averaged over segments.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct PowerSpectrum {
    /// Distance of two lines \[1/m\].
    line_spacing: f64,
    /// Mean square \[m²\] of each line; the sum is that of the record without its trend.
    lines: Vec<f64>,
    segments: usize,
}

impl PowerSpectrum {
    /// Average |DFT|² over all stretches of one record, in segments long enough for wavelengths up to
    /// `longest` \[m\].
    ///
    /// Segments of at least 1 m that overlap by half or more, mean and trend removed, Hann window, |DFT|² averaged. A
    /// segment has twenty of the longest wavelength, or the whole stretch where that is shorter; the last one ends
    /// where its stretch ends. What lies within a quarter of a segment of an end is seen weakly:
    /// [`Spectrum::of_record`](super::Spectrum::of_record) is for levels. Stretches shorter than a segment are left
    /// out. Cost: two transforms for each length of a segment, some nanoseconds a sample; parallel.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where no stretch is as long as 1 m; [`Error::Measurement`] without a stretch
    /// or where their spacings differ.
    pub fn of_record(stretches: &[Profile], longest: f64) -> Result<Self, Error> {
        Error::unless_positive("longest wavelength", longest, "m")?;
        let (spacing, length) = spacing_and_longest(stretches)?;
        let wanted = (WAVES_PER_SEGMENT * longest).max(SHORTEST_RECORD);
        let samples = (wanted.min(length) / spacing).round().max(2.0) as usize;
        let all = stretches.iter().map(Profile::heights);
        let mut parts: Vec<(&[f64], f64)> =
            all.flat_map(|heights| segments(heights, samples)).map(|segment| (segment, 1.0)).collect();
        let count = parts.len();
        for (_, share) in &mut parts {
            *share = (count as f64).recip();
        }
        Ok(Self {
            line_spacing: 1.0 / (samples as f64 * spacing),
            lines: line_powers(&parts, samples),
            segments: count,
        })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_is_that_of_the_record_without_its_trend() -> Result<(), Error> {
        let height = |i: usize| {
            let wave = (std::f64::consts::TAU * i as f64 * 1e-3 / 0.1 + 0.3).sin();
            3e-6 * wave + 1e-4 + 1e-8 * i as f64
        };
        let profile = Profile::new(0.0, 1e-3, (0..10_000).map(height).collect())?;
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
}
