//! A case by the models of the field.

use pyo3::prelude::*;
use riffel_answers::models::{ModelsAnswer, ModelsRequest};
use riffel_case::model::FieldModel;

use crate::case::Case;
use crate::document::document;
use crate::errors::{of_answer, wrong};

/// What `riffel compare --models --json` prints.
#[pyfunction]
pub(crate) fn compare_models<'py>(
    py: Python<'py>,
    case: &Case,
    models: Option<Vec<String>>,
    speed: Option<f64>,
) -> PyResult<Bound<'py, PyAny>> {
    let models = models.unwrap_or_default();
    let models = FieldModel::named(models.iter().map(String::as_str));
    let models = models.map_err(|error| wrong(error.to_string()))?;
    let answer = case.compute(py, move |case| ModelsAnswer::new(case, &ModelsRequest { models, speed }, &|_| ()))?;
    document(py, &answer.map_err(of_answer)?)
}
