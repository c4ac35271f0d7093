//! Calibrations and decisions.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use riffel_answers::Answer;
use riffel_answers::competing_models::CompetingModels;
use riffel_calibrate::{CalibrationError, Folder, Measured, Plan};
use riffel_study::Stop;

use crate::case::Case;
use crate::document::{document, sentences};
use crate::errors::{of_calibration, of_case, wrong};
use crate::interrupt::{interruptible, stoppable};

/// Draw the chains of a plan, or of a case and tables of measurements, and write their folder; remarks on the plan, doubts of the
/// chains, and how its models compare.
#[pyfunction]
pub(crate) fn calibrate(
    py: Python<'_>,
    plan: PathBuf,
    folder: PathBuf,
    tables: Vec<PathBuf>,
    traffic: Option<PathBuf>,
    restart: bool,
) -> PyResult<(Vec<String>, Vec<String>, Option<Bound<'_, PyAny>>)> {
    let stop = Arc::new(Stop::default());
    let asked = Arc::clone(&stop);
    let work = move || -> Result<_, CalibrationError> {
        let measured = Measured { case: &plan, traffic: traffic.as_deref(), tables: &tables };
        let plan = measured.plan_for(&folder)?;
        let own = Folder::begin(&plan, &folder, restart)?;
        own.write_plan(&plan)?;
        let sample = |folder: &Folder<'_>, _: &str| folder.run(&|_| (), &asked);
        let Some(chains) = sample(&own, "")? else {
            return Ok((Vec::new(), Vec::new(), None));
        };
        let summary = chains.summary(&plan);
        own.results(&plan, &chains, &summary)?.publish()?;
        let models = match plan.compares() {
            true => CompetingModels::new(&plan, &chains, (&*folder, restart), &sample)?,
            false => None,
        };
        let of_models = models.as_ref().map_or(&[][..], Answer::remarks);
        let remarks = sentences(plan.remarks.iter().chain(of_models));
        let doubts = sentences(&summary.doubts());
        Ok((remarks, doubts, models))
    };
    // Finished parts of chains stay for a restart.
    let done = stoppable(py, work, || stop.ask())?;
    let (remarks, doubts, models) = done.map_err(of_calibration)?;
    let models = models.map(|models| document(py, &models)).transpose()?;
    Ok((remarks, doubts, models))
}

/// Cases with the values of draws, each with the keys of its traffic.
#[pyfunction]
pub(crate) fn draws(py: Python<'_>, folder: PathBuf, count: usize) -> PyResult<Vec<(Case, Option<Bound<'_, PyAny>>)>> {
    let work = move || {
        let (plan, chains) = riffel_calibrate::finished(&folder, None)?;
        plan.drawn(&chains, count)
    };
    let drawn = interruptible(py, work)?.map_err(of_calibration)?;
    let drawn = drawn.into_iter().map(|drawn| {
        let traffic = drawn.traffic.map(|traffic| document(py, &traffic.file));
        Ok((Case::new(drawn.case), traffic.transpose()?))
    });
    drawn.collect()
}

/// How likely values of a plan are after its data.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct LogPosterior {
    plan: Plan,
}

#[pymethods]
impl LogPosterior {
    #[new]
    fn new(plan: PathBuf) -> PyResult<Self> {
        let plan = Plan::read(&plan).map_err(of_case)?;
        Ok(Self { plan })
    }

    /// Name and unit of each parameter.
    #[getter]
    fn parameters(&self) -> Vec<(String, String)> {
        let parameters = self.plan.posterior.parameters().iter();
        parameters.map(|it| (it.name.clone(), it.unit.clone())).collect()
    }

    fn log_density(&self, py: Python<'_>, place: Vec<f64>) -> PyResult<f64> {
        self.check(&place)?;
        let density = py.detach(|| self.plan.posterior.log_density(&place));
        Ok(density.unwrap_or(f64::NEG_INFINITY))
    }

    fn gradient(&self, py: Python<'_>, place: Vec<f64>) -> PyResult<Option<Vec<f64>>> {
        self.check(&place)?;
        Ok(py.detach(|| self.plan.posterior.at(&place)).map(|point| point.gradient))
    }

    fn log_likelihood(&self, py: Python<'_>, values: Vec<f64>) -> PyResult<Vec<(String, f64)>> {
        self.check(&values)?;
        py.detach(|| self.plan.posterior.log_likelihood(&values)).map_err(wrong)
    }

    fn values(&self, place: Vec<f64>) -> PyResult<Vec<f64>> {
        self.check(&place)?;
        Ok(self.plan.posterior.values(&place))
    }

    fn place(&self, values: Vec<f64>) -> PyResult<Vec<f64>> {
        self.check(&values)?;
        Ok(self.plan.posterior.place(&values))
    }

    fn prior_quantile(&self, share: f64) -> PyResult<Vec<f64>> {
        if !(share > 0.0 && share < 1.0) {
            return Err(wrong(format!("`share` is {share}, but must be between 0 and 1")));
        }
        let parameters = self.plan.posterior.parameters().iter();
        Ok(parameters.map(|it| it.prior.quantile(share)).collect())
    }
}

impl LogPosterior {
    fn check(&self, numbers: &[f64]) -> PyResult<()> {
        let count = self.plan.posterior.parameters().len();
        match numbers.len() == count {
            true => Ok(()),
            false => Err(wrong(format!("{} numbers are given, but the plan has {count} parameters", numbers.len()))),
        }
    }
}
