//! Presets with their sources.

use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Every preset: kind, name, title, and its values with their sources.
#[pyfunction]
pub(crate) fn presets(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    riffel_case::presets()
        .iter()
        .map(|preset| {
            let values = PyDict::new(py);
            for value in &preset.values {
                let entry = PyDict::new(py);
                entry.set_item("value", &value.value)?;
                entry.set_item("badge", value.badge.to_string())?;
                entry.set_item("source", &value.source)?;
                values.set_item(&value.key, entry)?;
            }
            let dict = PyDict::new(py);
            dict.set_item("kind", preset.kind.name())?;
            dict.set_item("name", &preset.name)?;
            dict.set_item("aliases", &preset.aliases)?;
            dict.set_item("title", &preset.title)?;
            dict.set_item("values", values)?;
            Ok(dict)
        })
        .collect()
}
