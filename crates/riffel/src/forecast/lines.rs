//! The wavelengths that stand for a band.

use crate::roughness::ThirdOctave;

/// Lines in each one-third octave.
///
/// Where the rates rise evenly from one edge of the band to the other and its lines have grown 20 dB apart,
/// 16 lines give its level to 0.02 dB; 100 dB apart, to 0.4 dB. See the test
/// `sixteen_lines_stand_for_a_band`.
pub const LINES_PER_BAND: usize = 16;

/// Wavelengths \[m\] of the lines of some bands, band by band, the shortest of a band first: the middles of
/// [`LINES_PER_BAND`] equal parts of its range in ln λ.
///
/// A level does not say where in its band the energy lies: it is spread evenly over ln λ.
pub fn band_lines(bands: &[ThirdOctave]) -> Vec<f64> {
    bands
        .iter()
        .flat_map(|band| {
            let (shortest, longest) = band.wavelength_range();
            (0..LINES_PER_BAND).map(move |line| {
                let part = (line as f64 + 0.5) / LINES_PER_BAND as f64;
                shortest * (longest / shortest).powf(part)
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forecast::GrowingSum;

    /// Lines that grow 0 to x dB: the mean of 10^(t/10) over 0 ≤ t ≤ x is (10^(x/10) − 1)/(x ln 10/10).
    #[test]
    fn sixteen_lines_stand_for_a_band() {
        for (apart, tolerance) in [(1.0, 1e-4), (20.0, 0.02), (100.0, 0.4)] {
            let exponent = apart * std::f64::consts::LN_10 / 10.0;
            let rate = |line: usize| 0.5 * exponent * (line as f64 + 0.5) / LINES_PER_BAND as f64;
            let sum = GrowingSum::new((0..LINES_PER_BAND).map(|line| (1.0, rate(line))));
            let expected = 10.0 * (exponent.exp_m1() / exponent).log10();
            let error = sum.level_change(1.0) - expected;
            assert!(error.abs() < tolerance, "{apart} dB: {error}");
        }
    }

    #[test]
    fn lines_lie_in_their_band_in_order() {
        let bands = [ThirdOctave::new(-17), ThirdOctave::new(-16)];
        let lines = band_lines(&bands);
        assert_eq!(lines.len(), 2 * LINES_PER_BAND);
        assert!(lines.is_sorted());
        for (index, line) in lines.iter().enumerate() {
            let band = ThirdOctave::containing(*line).unwrap();
            assert_eq!(band, bands[index / LINES_PER_BAND]);
        }
    }
}
