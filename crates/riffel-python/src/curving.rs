//! Profiles, and vehicles in curves.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel_answers::curve::CurveAnswer;
use riffel_answers::profile::{OnTrackAnswer, OutlineAnswer, UnderLoadAnswer};
use riffel_case::file::ProfileOrientation;
use riffel_case::{CurvingCase, ProfileReading};

use crate::case::{Case, assignments};
use crate::document::document;
use crate::errors::{of_answer, of_case, wrong};
use crate::interrupt::interruptible;
use crate::tables;

/// A case of curving: an ordinary case, a file or the keys of one.
#[derive(FromPyObject)]
pub(crate) enum GivenCase<'py> {
    Case(PyRef<'py, Case>),
    Keys(Bound<'py, PyDict>),
    File(PathBuf),
}

impl GivenCase<'_> {
    fn read(&self, overrides: &Bound<'_, PyDict>) -> PyResult<CurvingCase> {
        let overrides = assignments(overrides)?;
        let case = match self {
            Self::Case(case) => case.case.curving(&overrides),
            Self::Keys(keys) => CurvingCase::parse("", &tables::table(keys, "")?.to_string(), &overrides),
            Self::File(path) => CurvingCase::read(path, &overrides),
        };
        case.map_err(of_case)
    }
}

/// What `riffel curve --json` prints, with the title of the case.
#[pyfunction]
pub(crate) fn curve<'py>(
    py: Python<'py>,
    case: GivenCase<'py>,
    overrides: &Bound<'py, PyDict>,
    radii: Option<Vec<f64>>,
) -> PyResult<(Option<String>, Bound<'py, PyAny>)> {
    let case = case.read(overrides)?;
    if let Some((radius, rule)) = radii.as_ref().and_then(|radii| case.radius_that_no_curve_has(radii)) {
        return Err(wrong(format!("radius is {radius} m, but must be {rule}")));
    }
    let title = case.file.title.clone();
    let answer = interruptible(py, move || CurveAnswer::new(&case, radii.as_deref()))?;
    Ok((title, document(py, &answer.map_err(of_case)?)?))
}

/// How a file is read.
fn reading(scatter: Option<f64>, orientation: Option<&str>) -> PyResult<ProfileReading> {
    let orientation = orientation.map(|name| {
        ProfileOrientation::named(name).ok_or_else(|| {
            let known = ProfileOrientation::ALL.map(|(name, _)| name).join(", ");
            wrong(format!("orientation is \"{name}\", but must be one of {known}"))
        })
    });
    Ok(ProfileReading { scatter, orientation: orientation.transpose()?, ..ProfileReading::default() })
}

/// What `riffel profile FILE --json` prints, and the remarks.
#[pyfunction]
pub(crate) fn profile<'py>(
    py: Python<'py>,
    file: PathBuf,
    scatter: Option<f64>,
    orientation: Option<&str>,
) -> PyResult<(Bound<'py, PyAny>, Vec<String>)> {
    let reading = reading(scatter, orientation)?;
    let answer = interruptible(py, move || OutlineAnswer::new([(file, reading)]))?;
    let answer = answer.map_err(of_case)?;
    let remarks = answer.remarks.iter().map(ToString::to_string).collect();
    Ok((document(py, &answer)?, remarks))
}

/// What `riffel profile CASE --wheelset --json` prints, with the title of the case.
#[pyfunction]
pub(crate) fn contact_geometry<'py>(
    py: Python<'py>,
    case: GivenCase<'py>,
    overrides: &Bound<'py, PyDict>,
    shifts: Vec<f64>,
    yaw: f64,
) -> PyResult<(Option<String>, Bound<'py, PyAny>)> {
    let case = case.read(overrides)?;
    let title = case.file.title.clone();
    let answer = interruptible(py, move || OnTrackAnswer::new(&case, &shifts, yaw))?;
    Ok((title, document(py, &answer.map_err(of_answer)?)?))
}

/// What `riffel profile CASE --wheelset --load P --json` prints, with the remarks.
#[pyfunction]
pub(crate) fn contact_under_load<'py>(
    py: Python<'py>,
    case: GivenCase<'py>,
    overrides: &Bound<'py, PyDict>,
    load: f64,
    shifts: Vec<f64>,
    yaw: f64,
) -> PyResult<(Option<String>, Bound<'py, PyAny>, Vec<String>)> {
    let case = case.read(overrides)?;
    let title = case.file.title.clone();
    let answer = interruptible(py, move || UnderLoadAnswer::new(&case, &shifts, yaw, load))?;
    let answer = answer.map_err(of_answer)?;
    let remarks = answer.own_remarks.iter().map(ToString::to_string).collect();
    Ok((title, document(py, &answer)?, remarks))
}
