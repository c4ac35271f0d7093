//! What a case is pickled as.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::{PyTuple, PyType};

/// What makes a case anew elsewhere: it is pickled as the strings that it is made of.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct PortableCase(pub(super) riffel_case::PortableCase);

#[pymethods]
impl PortableCase {
    #[new]
    pub(super) fn new(
        name: String,
        text: String,
        keys: String,
        overrides: Vec<(String, String)>,
        folder: Option<PathBuf>,
    ) -> Self {
        Self(riffel_case::PortableCase { name, text, keys, overrides, folder })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyType>, Bound<'py, PyTuple>)> {
        let written = self.0.clone();
        let arguments =
            (written.name, written.text, written.keys, written.overrides, written.folder.map(PathBuf::into_os_string));
        Ok((py.get_type::<Self>(), arguments.into_pyobject(py)?))
    }
}
