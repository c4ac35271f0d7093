//! Presets with their sources.

use pyo3::prelude::*;
use riffel_case::Preset;
use serde_json::Value;

use crate::document::document;

/// Every preset: kind, name, title, and its values as written and in SI, with their sources.
#[pyfunction]
pub(crate) fn presets(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let presets: Vec<Value> = riffel_case::presets().iter().map(Preset::document).collect();
    document(py, &presets)
}
