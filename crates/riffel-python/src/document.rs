//! Documents of the program as dicts and lists.

use pyo3::prelude::*;
use serde::Serialize;

use crate::errors::wrong;

/// What the program prints with `--json`, by the reader of JSON that comes with Python: both write and read numbers to
/// the last bit.
pub(crate) fn document<'py>(py: Python<'py>, document: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = serde_json::to_string(document).map_err(|error| wrong(error.to_string()))?;
    py.import("json")?.call_method1("loads", (text,))
}
