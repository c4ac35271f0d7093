//! The wavelengths that stand for a band.

use crate::roughness::ThirdOctave;

/// Lines in each one-third octave.
///
/// The rates of a band differ by some ten per cent of the highest from edge to edge; with 16 lines the
/// level of a band whose lines have grown apart by 20 dB is within 0.1 dB of that of 512, see the test
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
