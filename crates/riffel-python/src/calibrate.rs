//! Calibrations and decisions.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::exceptions::{PyFileNotFoundError, PyOSError};
use pyo3::prelude::*;
use riffel_answers::Answer;
use riffel_answers::competing_models::CompetingModels;
use riffel_answers::decide::DecideAnswer;
use riffel_calibrate::{CalibrationError, Folder, Plan};
use riffel_study::Stop;

use crate::document::document;
use crate::errors::{of_case, wrong};
use crate::interrupt::interruptible;

fn of_calibration(error: CalibrationError) -> PyErr {
    match error {
        CalibrationError::Plan(error) => of_case(error),
        CalibrationError::NotThere { .. } => PyFileNotFoundError::new_err(error.to_string()),
        CalibrationError::Read { .. } | CalibrationError::Write { .. } => {
            PyOSError::new_err(error.to_string())
        }
        error => wrong(error.to_string()),
    }
}

/// Draw the chains of a plan and write their folder; remarks on the plan, doubts of the chains, and how its models compare.
#[pyfunction]
pub(crate) fn calibrate(
    py: Python<'_>,
    plan: PathBuf,
    folder: PathBuf,
    restart: bool,
) -> PyResult<(Vec<String>, Vec<String>, Option<Bound<'_, PyAny>>)> {
    let stop = Arc::new(Stop::default());
    let asked = Arc::clone(&stop);
    let work = move || -> Result<_, CalibrationError> {
        let plan = Plan::read(&plan)?;
        let own = Folder::begin(&plan, &folder, restart)?;
        let sample = |folder: &Folder<'_>, _: &str| folder.run(&|_| (), &asked);
        let Some(chains) = sample(&own, "")? else {
            return Ok((Vec::new(), Vec::new(), None));
        };
        let summary = chains.summary(&plan);
        own.write(&plan, &chains, &summary)?;
        let models = match plan.compares() {
            true => CompetingModels::new(&plan, &chains, (&*folder, restart), &sample)?,
            false => None,
        };
        let mut remarks = plan.remarks;
        let of_models = models.as_ref().map_or(&[][..], Answer::remarks);
        remarks.extend(of_models.iter().map(ToString::to_string));
        Ok((remarks, summary.doubts(), models))
    };
    // Finished parts of chains stay for a restart.
    let done = interruptible(py, work).inspect_err(|_| stop.ask())?;
    let (remarks, doubts, models) = done.map_err(of_calibration)?;
    let models = models.map(|models| document(py, &models)).transpose()?;
    Ok((remarks, doubts, models))
}

/// What `riffel decide --json` prints.
#[pyfunction]
pub(crate) fn decide(
    py: Python<'_>,
    folder: PathBuf,
    plan: Option<PathBuf>,
) -> PyResult<Bound<'_, PyAny>> {
    let work = move || {
        let (plan, chains) = riffel_calibrate::finished(&folder, plan.as_deref())?;
        DecideAnswer::new(&plan, &chains)
    };
    document(py, &interruptible(py, work)?.map_err(of_calibration)?)
}
