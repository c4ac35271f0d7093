//! Cases of profiles and of vehicles in curves.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::case::{Case, assignments};
use crate::errors::of_case;
use crate::tables;

/// A case of curving: an ordinary case, a file or the keys of one.
#[derive(FromPyObject)]
pub(crate) enum CaseArg<'py> {
    Case(PyRef<'py, Case>),
    Keys(Bound<'py, PyDict>),
    File(PathBuf),
}

/// The tables of curving of a case.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct CurvingCase(pub(crate) Arc<riffel_case::CurvingCase>);

#[pymethods]
impl CurvingCase {
    #[new]
    fn new(case: CaseArg<'_>, overrides: &Bound<'_, PyDict>) -> PyResult<Self> {
        let overrides = assignments(overrides)?;
        let case = match case {
            CaseArg::Case(case) => case.case.curving(&overrides),
            CaseArg::Keys(keys) => {
                riffel_case::CurvingCase::parse("", &tables::table(&keys, "")?.to_string(), &overrides)
            }
            CaseArg::File(path) => riffel_case::CurvingCase::read(&path, &overrides),
        };
        Ok(Self(Arc::new(case.map_err(of_case)?)))
    }

    #[getter]
    fn title(&self) -> Option<String> {
        self.0.file.title.clone()
    }
}
