//! Documents of the program as dicts and lists, its messages as sentences.

use pyo3::prelude::*;
use pythonize::pythonize;
use riffel_keys::Message;
use serde::Serialize;

use crate::errors::wrong;

/// What the program prints with `--json`: numbers to the last bit, and nothing for those that are not finite.
pub(crate) fn document<'py>(py: Python<'py>, document: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let document = serde_json::to_value(document).map_err(|error| wrong(error.to_string()))?;
    Ok(pythonize(py, &document)?)
}

/// Messages as English sentences.
pub(crate) fn sentences<'a>(messages: impl IntoIterator<Item = &'a Message>) -> Vec<String> {
    messages.into_iter().map(ToString::to_string).collect()
}
