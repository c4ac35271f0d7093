//! The program `riffel` as a script of the package.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Run the program; its exit status.
///
/// `again` is a command that runs it once more in a process of its own.
#[pyfunction]
pub(crate) fn program(py: Python<'_>, arguments: Vec<OsString>, again: Vec<OsString>) -> u8 {
    py.detach(|| riffel_cli::run(arguments, &again))
}
