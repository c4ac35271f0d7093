//! Growth under the traffic of a line.

use pyo3::prelude::*;
use riffel_answers::LineGrowth;

use crate::case::Case;
use crate::document::document;
use crate::errors::of_case;
use crate::traffic::Traffic;

/// By the keys of `under_traffic` of `riffel map --json`.
#[pyfunction]
#[pyo3(signature = (case, traffic = None))]
pub(crate) fn line_growth<'py>(py: Python<'py>, case: &Case, traffic: Option<&Traffic>) -> PyResult<Bound<'py, PyAny>> {
    let traffic = traffic.map(|given| given.0.clone());
    let growth = case.compute(py, move |case| LineGrowth::new(case, traffic.as_deref()))?;
    document(py, &growth.map_err(of_case)?)
}
