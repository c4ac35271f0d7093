//! Bands of wavelength as coordinates.

use crate::{Array, Values};

/// `band`, `band_from` and `band_to` of bands from and to wavelengths (m), with their values. The first names the
/// dimension; the other two are its further coordinates.
pub fn band_axes(bands: &[[f64; 2]]) -> [(Array, Values); 3] {
    let axis = |name, words, value: fn(&[f64; 2]) -> f64| {
        let array = Array::axis(name, "band", bands.len() as u64, "m", words);
        (array, Values::Numbers(bands.iter().map(value).collect()))
    };
    let centre = "centre of the band in the logarithm of wavelength";
    [
        axis("band", centre, |[from, to]| (from * to).sqrt()),
        axis("band_from", "shortest wavelength of the band", |band| band[0]),
        axis("band_to", "longest wavelength of the band", |band| band[1]),
    ]
}
