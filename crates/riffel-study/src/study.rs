//! A study: every sample by its number.

use std::path::Path;

use riffel_case::{Case, Setting};
use riffel_keys::text_file;

use crate::StudyError;
use crate::fingerprint::{fingerprint, read_data};
use crate::outputs::Outputs;
use crate::parameter::{Parameter, ParameterValue, Spread};
use crate::plan::Plan;

/// A plan on its case, ready to compute.
#[derive(Clone)]
pub struct Study {
    /// The plan.
    pub plan: Plan,
    /// The case with the keys that the plan sets.
    pub case: Case,
    /// What tells its results from those of other studies.
    pub fingerprint: String,
    /// The text of the case.
    pub(crate) case_text: String,
    /// Files of data that the case reads: their names in the case, and what is in them.
    pub(crate) data: Vec<(String, Vec<u8>)>,
}

/// A sample: its parameters, and its outputs or why there are none.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Values of the parameters in their order.
    pub parameters: Vec<ParameterValue>,
    /// Values of all outputs in the order of [`Outputs::variables`], or a sentence.
    pub outputs: Result<Vec<f64>, String>,
}

/// Some consecutive samples, which are finished together.
#[derive(Debug, Clone, PartialEq)]
pub struct Chunk {
    /// Its number, from zero.
    pub index: u64,
    /// Its samples in order.
    pub samples: Vec<Sample>,
}

impl Study {
    /// Read a plan and its case, and check all that can be checked before anything runs.
    ///
    /// # Errors
    /// [`StudyError::Plan`] with the key, the value and the rule.
    pub fn read(path: &Path) -> Result<Self, StudyError> {
        Self::of(Plan::read(path)?)
    }

    /// A study from the text of a plan with a case in another place than the plan says.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub fn parse(name: &str, text: &str, case: &Path) -> Result<Self, StudyError> {
        Self::of(Plan::parse(name, text, case)?)
    }

    fn of((plan, case, path): (Plan, Case, std::path::PathBuf)) -> Result<Self, StudyError> {
        let case_text = text_file::read_keys(&path, "case file")?;
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        let data = read_data(folder, &data_files(&plan, &case))?;
        let name = path.display().to_string();
        Ok(Self { fingerprint: fingerprint(&plan, &name, &case_text, &data)?, plan, case, case_text, data })
    }

    /// Number of samples.
    pub fn samples(&self) -> u64 {
        self.plan.design.samples()
    }

    /// Samples of a chunk; the last may have fewer.
    pub fn samples_per_chunk(&self) -> u64 {
        self.plan.samples_per_chunk()
    }

    /// Number of chunks.
    pub fn chunks(&self) -> u64 {
        self.samples().div_ceil(self.samples_per_chunk())
    }

    /// The numbers of the samples of a chunk.
    pub fn samples_of(&self, chunk: u64) -> std::ops::Range<u64> {
        let size = self.samples_per_chunk();
        chunk * size..((chunk + 1) * size).min(self.samples())
    }

    /// What varies.
    pub fn parameters(&self) -> &[Parameter] {
        &self.plan.parameters
    }

    /// What is computed.
    pub fn outputs(&self) -> &Outputs {
        &self.plan.outputs
    }

    /// Values of the parameters in a sample.
    pub fn values(&self, sample: u64) -> Vec<ParameterValue> {
        let point = self.plan.point(sample);
        let parameters = self.parameters().iter().zip(point);
        parameters.map(|(parameter, share)| parameter.value(share)).collect()
    }

    /// Compute a sample, on one thread.
    ///
    /// Cost: a case is built anew, some 60 µs, and its outputs; a ridge over 60 speeds and 241 wavelengths takes
    /// 0.25 ms on the free beam.
    pub fn sample(&self, sample: u64) -> Sample {
        let parameters = self.values(sample);
        Sample { outputs: self.evaluate(&parameters), parameters }
    }

    /// All outputs for values of the parameters, or why there are none.
    ///
    /// # Errors
    /// A sentence: the case refuses a value, or an output is not a finite number.
    pub fn evaluate(&self, values: &[ParameterValue]) -> Result<Vec<f64>, String> {
        let settings: Vec<Setting> =
            self.parameters().iter().zip(values).map(|(parameter, value)| parameter.setting(value)).collect();
        let case = self.outputs().on(&self.case, &settings).map_err(|error| error.to_string())?;
        self.outputs().evaluate(&case)
    }

    /// Compute a chunk, sample after sample on one thread.
    pub fn compute(&self, chunk: u64) -> Chunk {
        Chunk { index: chunk, samples: self.samples_of(chunk).map(|sample| self.sample(sample)).collect() }
    }
}

/// The files of data that the case reads in any sample.
fn data_files(plan: &Plan, case: &Case) -> Vec<String> {
    const KEY: &str = "track.measurement.file";
    let varied = plan.parameters.iter().find(|parameter| parameter.key.key == KEY);
    match varied.map(|parameter| &parameter.spread) {
        Some(Spread::Values(values)) => values.iter().map(ToString::to_string).collect(),
        _ => {
            let measurement = case.file.track.measurement.as_ref();
            measurement.map(|measurement| measurement.file.clone()).into_iter().collect()
        }
    }
}
