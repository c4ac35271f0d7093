//! Calibrations and decisions.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::exceptions::{PyFileNotFoundError, PyOSError};
use pyo3::prelude::*;
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

/// Draw the chains of a plan and write their folder; remarks on the plan, and doubts of the chains.
#[pyfunction]
pub(crate) fn calibrate(
    py: Python<'_>,
    plan: PathBuf,
    folder: PathBuf,
    restart: bool,
) -> PyResult<(Vec<String>, Vec<String>)> {
    let stop = Arc::new(Stop::default());
    let asked = Arc::clone(&stop);
    let work = move || -> Result<(Vec<String>, Vec<String>), CalibrationError> {
        let plan = Plan::read(&plan)?;
        let folder = Folder::begin(&plan, &folder, restart)?;
        let Some(chains) = folder.run(&|_| (), &asked)? else {
            return Ok((Vec::new(), Vec::new()));
        };
        let summary = chains.summary(&plan);
        folder.write(&plan, &chains, &summary)?;
        Ok((plan.remarks, summary.doubts()))
    };
    // Finished parts of chains stay for a restart.
    let done = interruptible(py, work).inspect_err(|_| stop.ask())?;
    done.map_err(of_calibration)
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
