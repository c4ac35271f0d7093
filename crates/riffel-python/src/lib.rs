//! The Python package `riffel`: cases, maps and curves as arrays, without a formula of its own.
//!
//! `python/riffel` turns what stands here into `xarray` and checks what comes from users.

#![expect(
    clippy::too_many_arguments,
    clippy::type_complexity,
    reason = "keywords come from Python one by one, and tuples of arrays go there, named where they are unpacked"
)]

mod array;
mod arrays_of_rails;
mod ask;
mod axlebox;
mod calibrate;
mod case;
mod curving;
mod document;
mod errors;
mod forecast;
mod interrupt;
mod line_growth;
mod program;
mod quantity;
mod receptance_arg;
mod records;
mod roughness;
mod simulate;
mod study;
mod tables;
mod traffic;
mod wheels;

/// The extension `riffel._riffel`.
#[pyo3::pymodule]
mod _riffel {
    #[pymodule_export]
    use crate::ask::ask;
    #[pymodule_export]
    use crate::axlebox::AxleBoxRun;
    #[pymodule_export]
    use crate::calibrate::{LogPosterior, calibrate, draws};
    #[pymodule_export]
    use crate::case::{Case, PortableCase};
    #[pymodule_export]
    use crate::curving::CurvingCase;
    #[pymodule_export]
    use crate::errors::{ConvergenceError, ReceptanceError};
    #[pymodule_export]
    use crate::forecast::{fit_wear, forecast};
    #[pymodule_export]
    use crate::line_growth::line_growth;
    #[pymodule_export]
    use crate::program::program;
    #[pymodule_export]
    use crate::quantity::si;
    #[pymodule_export]
    use crate::receptance_arg::Universal;
    #[pymodule_export]
    use crate::records::Record;
    #[pymodule_export]
    use crate::roughness::{
        analyse, axis, band_pass, compare_with_limit, dominant_of_profile, dominant_of_spectra, energy_mean, level,
        limits, mean_square, moving_peak_to_peak, moving_rms, read_roughness, remove_spikes, roll_over, synthesise,
        third_octaves,
    };
    #[pymodule_export]
    use crate::simulate::{evolve, on_smooth_rail, simulate};
    #[pymodule_export]
    use crate::study::{Study, sobol_indices, study_summary};
    #[pymodule_export]
    use crate::traffic::Traffic;
    #[pymodule_export]
    use crate::wheels::wheels_of_curve;
    /// Rows of a map are filled up to a multiple of this.
    #[pymodule_export]
    const TILE: usize = riffel::tile::TILE;
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
