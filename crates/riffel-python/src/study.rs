//! Studies: plans, chunks and what they say together.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyFileNotFoundError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel_study::sensitivity::{Intervals, SobolIndices, Tornado};
use riffel_study::{Design, ParameterValue, ResultFolder, Shard, Stop, Summary};

use crate::array::owned;
use crate::errors::{of_study, wrong};
use crate::interrupt::interruptible;
use crate::tables;

/// How often a running study tells how far it is.
const NEWS: Duration = Duration::from_millis(100);

/// A plan on its case.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct Study {
    study: Arc<riffel_study::Study>,
}

#[pymethods]
impl Study {
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        if !path.exists() {
            let sentence = format!("there is no plan {}", path.display());
            return Err(PyFileNotFoundError::new_err(sentence));
        }
        interruptible(py, move || riffel_study::Study::read(&path))?.map(Self::new).map_err(of_study)
    }

    #[staticmethod]
    fn parse(py: Python<'_>, text: String, case: PathBuf) -> PyResult<Self> {
        interruptible(py, move || riffel_study::Study::parse("plan", &text, &case))?.map(Self::new).map_err(of_study)
    }

    #[staticmethod]
    fn from_dict(py: Python<'_>, keys: &Bound<'_, PyDict>, case: PathBuf) -> PyResult<Self> {
        Self::parse(py, tables::table(keys, "")?.to_string(), case)
    }

    /// The study that a folder of results records.
    #[staticmethod]
    fn open(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        interruptible(py, move || ResultFolder::open(&folder))?.map(|(study, _)| Self::new(study)).map_err(of_study)
    }

    #[getter]
    fn title(&self) -> Option<String> {
        self.study.plan.file.title.clone()
    }

    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.study.plan.remarks.clone()
    }

    #[getter]
    fn fingerprint(&self) -> String {
        self.study.fingerprint.clone()
    }

    #[getter]
    fn samples(&self) -> u64 {
        self.study.samples()
    }

    #[getter]
    fn samples_per_chunk(&self) -> u64 {
        self.study.samples_per_chunk()
    }

    #[getter]
    fn chunks(&self) -> u64 {
        self.study.chunks()
    }

    #[getter]
    fn is_saltelli(&self) -> bool {
        matches!(self.study.plan.design, Design::Saltelli(_))
    }

    /// Key, unit and description of each parameter, and whether it is a number.
    fn parameters(&self) -> Vec<(String, Option<&'static str>, String, bool)> {
        self.study
            .parameters()
            .iter()
            .map(|parameter| {
                let unit = parameter.key.quantity.map(|kind| match kind.unit {
                    "" => "1",
                    unit => unit,
                });
                let description = parameter.key.description.to_string();
                (parameter.key.key.clone(), unit, description, parameter.is_number())
            })
            .collect()
    }

    /// Values of each parameter in the samples from one number to another.
    fn design<'py>(&self, py: Python<'py>, from: u64, to: u64) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let study = self.study.clone();
        let samples: Vec<Vec<ParameterValue>> =
            interruptible(py, move || (from..to.min(study.samples())).map(|sample| study.values(sample)).collect())?;
        (0..self.study.parameters().len())
            .map(|index| column(py, samples.iter().map(|sample| &sample[index])))
            .collect()
    }

    /// Make the folder of results, or check that it is this study's.
    fn begin(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        let study = self.study.clone();
        interruptible(py, move || ResultFolder::begin(&study, &folder))?.map(|_| ()).map_err(of_study)
    }

    /// Chunks of a shard that are missing or damaged, in order.
    fn pending(&self, py: Python<'_>, folder: PathBuf, shard: &str) -> PyResult<Vec<u64>> {
        let (study, shard) = (self.study.clone(), parse_shard(shard)?);
        let pending = move || ResultFolder::begin(&study, &folder)?.pending(shard);
        interruptible(py, pending)?.map_err(of_study)
    }

    /// Compute chunks one after the other on this thread and finish each.
    fn compute(&self, py: Python<'_>, folder: PathBuf, chunks: Vec<u64>) -> PyResult<()> {
        let last = self.study.chunks();
        if let Some(chunk) = chunks.iter().find(|chunk| **chunk >= last) {
            return Err(wrong(format!("chunk {chunk} is not one of the {last}")));
        }
        let study = self.study.clone();
        // The caller is a task of a cluster, in a thread of its own, where no signal arrives.
        py.detach(move || {
            let folder = ResultFolder::begin(&study, &folder)?;
            chunks.into_iter().try_for_each(|chunk| folder.commit(&study.compute(chunk)))
        })
        .map_err(of_study)
    }

    /// Compute all pending chunks of a shard on all cores. `progress` is called with the number of samples done and
    /// of those to do.
    fn run(&self, py: Python<'_>, folder: PathBuf, shard: &str, progress: Option<Bound<'_, PyAny>>) -> PyResult<()> {
        let study = self.study.clone();
        let chunks = self.pending(py, folder.clone(), shard)?;
        let samples = |chunk: &u64| {
            let range = self.study.samples_of(*chunk);
            range.end - range.start
        };
        let all: u64 = chunks.iter().map(samples).sum();
        let (done, stop) = (Arc::new(AtomicU64::new(0)), Arc::new(Stop::default()));
        let (counted, asked) = (done.clone(), stop.clone());
        let work = std::thread::spawn(move || {
            let folder = ResultFolder::begin(&study, &folder)?;
            let count = || {
                counted.fetch_add(1, Ordering::Relaxed);
            };
            study.run(&folder, &chunks, &count, &asked)
        });
        let mut outcome = Ok(());
        loop {
            if let Some(progress) = &progress
                && outcome.is_ok()
            {
                let called = progress.call1((done.load(Ordering::Relaxed), all));
                outcome = called.map(|_| ());
            }
            if work.is_finished() {
                break;
            }
            if outcome.is_ok() {
                outcome = py.check_signals();
            }
            if outcome.is_err() {
                stop.ask();
            }
            py.detach(|| std::thread::sleep(NEWS));
        }
        match work.join() {
            Ok(ended) => ended.map_err(of_study)?,
            Err(panic) => std::panic::resume_unwind(panic),
        }
        outcome
    }

    /// Each parameter from its low to its high quantile, the others at their medians: values of the parameter and of
    /// an output at both, and the output at the medians.
    fn tornado<'py>(
        &self,
        py: Python<'py>,
        output: String,
        shares: [f64; 2],
    ) -> PyResult<(Vec<[Bound<'py, PyAny>; 2]>, Vec<[f64; 2]>, f64)> {
        let place = self.place(&output)?;
        let study = self.study.clone();
        let tornado = interruptible(py, move || Tornado::new(&study, shares))?;
        let value = |outputs: &Result<Vec<f64>, String>| outputs.as_ref().map_or(f64::NAN, |outputs| outputs[place]);
        let values: PyResult<Vec<_>> = tornado
            .swings
            .iter()
            .map(|swing| {
                let [low, high] = &swing.values;
                Ok([object(py, low)?, object(py, high)?])
            })
            .collect();
        let outputs = tornado.swings.iter();
        let outputs = outputs.map(|swing| [value(&swing.outputs[0]), value(&swing.outputs[1])]);
        Ok((values?, outputs.collect(), value(&tornado.middle)))
    }
}

fn parse_shard(shard: &str) -> PyResult<Shard> {
    shard.parse().map_err(|rule: String| wrong(format!("shard is \"{shard}\": {rule}")))
}

impl Study {
    fn new(study: riffel_study::Study) -> Self {
        Self { study: Arc::new(study) }
    }

    /// Where a scalar output stands among all numbers of a sample.
    fn place(&self, name: &str) -> PyResult<usize> {
        let outputs = self.study.outputs();
        let mut place = 0;
        for variable in outputs.variables() {
            let length = outputs.length(variable);
            if variable.name == name {
                return match length {
                    1 => Ok(place),
                    _ => Err(wrong(format!("{name} is no single number of each sample"))),
                };
            }
            place += length;
        }
        let known: Vec<&str> = outputs.variables().iter().map(|v| v.name.as_str()).collect();
        Err(wrong(format!("the study has no output {name}, but {}", known.join(", "))))
    }
}

/// What the finished chunks of a folder hold.
#[pyfunction]
pub(crate) fn study_summary(py: Python<'_>, folder: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let summary = interruptible(py, move || ResultFolder::open(&folder).and_then(|(_, folder)| folder.summary()))?;
    as_dict(py, &summary.map_err(of_study)?)
}

/// First-order and total indices of each parameter with their intervals: rows of value, low and high.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "what goes to Python is tuples")]
pub(crate) fn sobol_indices(
    py: Python<'_>,
    values: PyReadonlyArray1<'_, f64>,
    parameters: usize,
    confidence: f64,
    resamples: usize,
    seed: u64,
) -> PyResult<(Vec<[f64; 3]>, Vec<[f64; 3]>, f64, usize)> {
    let values = owned(&values);
    let intervals = Intervals { confidence, resamples, seed };
    let found = interruptible(py, move || SobolIndices::new(&values, parameters, intervals))?.map_err(of_study)?;
    let row = |estimate: &riffel_study::sensitivity::Estimate| [estimate.value, estimate.low, estimate.high];
    Ok((
        found.parameters.iter().map(|p| row(&p.first)).collect(),
        found.parameters.iter().map(|p| row(&p.total)).collect(),
        found.variance,
        found.left_out,
    ))
}

fn as_dict<'py>(py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("samples", summary.samples)?;
    dict.set_item("samples_finished", summary.samples_finished)?;
    dict.set_item("chunks", summary.chunks)?;
    dict.set_item("chunks_finished", summary.chunks_finished)?;
    dict.set_item("samples_failed", summary.samples_failed)?;
    let reasons = summary.reasons.iter();
    let reasons: Vec<(u64, &str)> = reasons.map(|r| (r.count, r.example.as_str())).collect();
    dict.set_item("reasons", reasons)?;
    Ok(dict)
}

fn object<'py>(py: Python<'py>, value: &ParameterValue) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        ParameterValue::Number(number) => number.into_pyobject(py)?.into_any(),
        ParameterValue::Text(text) => text.into_pyobject(py)?.into_any(),
    })
}

/// Values of one parameter: an array of numbers, or a list of texts.
fn column<'py, 'a>(
    py: Python<'py>,
    values: impl Iterator<Item = &'a ParameterValue> + Clone,
) -> PyResult<Bound<'py, PyAny>> {
    let numbers: Option<Vec<f64>> = values.clone().map(ParameterValue::number).collect();
    Ok(match numbers {
        Some(numbers) => numbers.into_pyarray(py).into_any(),
        None => {
            let texts: Vec<String> = values.map(ToString::to_string).collect();
            texts.into_pyobject(py)?.into_any()
        }
    })
}
