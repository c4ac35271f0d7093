//! The contact patch, as a dict.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel::HertzContact;
use riffel::contact::KalkerCoefficients;
use riffel_answers::contact::SteadyDocument;

/// The contact patch, its coefficients and its steady state.
pub(super) fn patch<'py>(
    py: Python<'py>,
    hertz: &HertzContact,
    kalker: KalkerCoefficients,
    steady: &SteadyDocument,
) -> PyResult<Bound<'py, PyDict>> {
    let KalkerCoefficients { c11, c22, c23, c33 } = kalker;
    let contact = PyDict::new(py);
    for (key, value) in [
        ("semi_axis_longitudinal_m", hertz.semi_axis_longitudinal()),
        ("semi_axis_lateral_m", hertz.semi_axis_lateral()),
        ("approach_m", hertz.approach()),
        ("peak_pressure_pa", hertz.peak_pressure()),
        ("stiffness_n_per_m", hertz.stiffness()),
    ] {
        contact.set_item(key, value)?;
    }
    let kalker = PyDict::new(py);
    for (key, value) in [("c11", c11), ("c22", c22), ("c23", c23), ("c33", c33)] {
        kalker.set_item(key, value)?;
    }
    contact.set_item("kalker", kalker)?;
    let document = PyDict::new(py);
    document.set_item("force_n", steady.force_n.to_vec())?;
    document.set_item("spin_moment_nm", steady.spin_moment_nm)?;
    document.set_item("dissipation_j_per_m", steady.dissipation_j_per_m)?;
    contact.set_item("steady", document)?;
    Ok(contact)
}
