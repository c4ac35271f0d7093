//! Heights and levels of rails as arrays give them.

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel::roughness::{Profile, Spectrum, ThirdOctave};

use crate::array::owned;
use crate::errors::of_physics;

/// A stretch without gaps: where it begins \[m\], and its heights.
pub(crate) type Stretch<'py> = (f64, PyReadonlyArray1<'py, f64>);

/// The stretches of a rail with this spacing \[m\].
pub(crate) fn profiles(stretches: &[Stretch<'_>], spacing: f64) -> PyResult<Vec<Profile>> {
    let profile = |(start, heights): &Stretch<'_>| Profile::new(*start, spacing, owned(heights)).map_err(of_physics);
    stretches.iter().map(profile).collect()
}

/// A spectrum of wavelengths \[m\] and levels.
pub(crate) fn spectrum(wavelengths: &[f64], levels: &[f64]) -> PyResult<Spectrum> {
    let bands = wavelengths.iter().zip(levels);
    let bands: Result<Vec<_>, _> =
        bands.map(|(&wavelength, &level)| Ok((ThirdOctave::centred(wavelength)?, level))).collect();
    bands.and_then(Spectrum::new).map_err(of_physics)
}
