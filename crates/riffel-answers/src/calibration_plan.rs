//! What a plan of a calibration asks for, as data.

use riffel_calibrate::file::DataFile;
use riffel_calibrate::{Plan, Uncertain};
use riffel_keys::Message;
use serde::Serialize;

use crate::calibration::Sampler;

/// What a plan asks for.
#[derive(Serialize)]
pub struct CalibrationPlan {
    riffel_version: &'static str,
    title: Option<String>,
    sampler: Sampler,
    parameters: Vec<Uncertain>,
    data: Vec<Measurement>,
    /// Numbers that were measured.
    numbers: usize,
    remarks: Vec<Message>,
    /// The plan itself.
    text: String,
}

/// A table of measurements.
#[derive(Serialize)]
struct Measurement {
    name: String,
    kind: &'static str,
    file: String,
}

impl Measurement {
    fn of(data: &DataFile) -> Self {
        Self {
            name: data.name.as_deref().unwrap_or(data.kind.name()).to_owned(),
            kind: data.kind.name(),
            file: data.file.clone(),
        }
    }
}

impl From<&Plan> for CalibrationPlan {
    fn from(plan: &Plan) -> Self {
        Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            title: plan.file.title.clone(),
            sampler: Sampler::from(&plan.file.sampler),
            parameters: plan.uncertain(),
            data: plan.file.data.iter().map(Measurement::of).collect(),
            numbers: plan.posterior.observed().iter().map(Vec::len).sum(),
            remarks: plan.remarks.clone(),
            text: plan.text.clone(),
        }
    }
}
