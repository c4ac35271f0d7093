//! Traffic as users give it.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel::forecast::SpeedDistribution;
use riffel_case::traffic::{Line, UsualTraffic};

use crate::case::Case;
use crate::errors::{of_case, of_physics};
use crate::tables;

/// A traffic file, its keys, or the wheel of the case at speeds of a mean and a standard deviation.
#[derive(FromPyObject)]
pub(crate) enum TrafficArg<'py> {
    File(PathBuf),
    Keys(Bound<'py, PyDict>),
    Speeds((f64, f64)),
}

/// A traffic in memory, in place of a file.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct Traffic(pub(crate) Arc<riffel_case::traffic::Traffic>);

#[pymethods]
impl Traffic {
    /// What is given, or the usual traffic of the line of the case, of which no amount is assumed.
    #[new]
    fn new(case: &Case, given: Option<TrafficArg<'_>>) -> PyResult<Self> {
        let traffic = match given {
            Some(TrafficArg::File(path)) => riffel_case::traffic::Traffic::read(&path).map_err(of_case)?,
            Some(TrafficArg::Keys(keys)) => {
                let text = tables::table(&keys, "")?.to_string();
                riffel_case::traffic::Traffic::parse("", &text).map_err(of_case)?
            }
            Some(TrafficArg::Speeds((mean, deviation))) => {
                let speeds = SpeedDistribution::normal(mean, deviation);
                riffel_case::traffic::Traffic::of_case(speeds.map_err(of_physics)?)
            }
            None => {
                let mut traffic = UsualTraffic::of(&case.case).traffic().map_err(of_case)?;
                traffic.file.line = Line::default();
                traffic
            }
        };
        Ok(Self(Arc::new(traffic)))
    }
}
