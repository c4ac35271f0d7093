//! Documents of the program as dicts and lists.

use pyo3::prelude::*;
use pythonize::pythonize;
use serde::Serialize;

use crate::errors::wrong;

/// What the program prints with `--json`: numbers to the last bit, and nothing for those that are not finite.
pub(crate) fn document<'py>(py: Python<'py>, document: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let document = serde_json::to_value(document).map_err(|error| wrong(error.to_string()))?;
    Ok(pythonize(py, &document)?)
}
