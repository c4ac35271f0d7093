//! Plans: what varies, how, and what is wanted.

mod bounds;
mod correlation;
mod design;
pub mod file;
mod spread;

pub use spread::distribution;

use std::path::{Path, PathBuf};

use file::{Method, PlanFile};
use riffel_case::{Case, CaseKey, idle_because, settings};
use riffel_keys::{CaseError, KeyFile, say, text_file};

use crate::correlation::GaussianCopula;
use crate::design::Design;
use crate::outputs::Outputs;
use crate::parameter::Parameter;

/// Most bytes of the results of a study: a terabyte.
const MOST_BYTES: u64 = 1_000_000_000_000;
/// Most samples of a chunk.
const MOST_SAMPLES_PER_CHUNK: u64 = 1_000_000;
/// Most samples of a chunk where the plan does not say.
const USUAL_CHUNK: u64 = 1000;
/// Chunks of a study where the plan does not say, unless it is very short or very long.
const USUAL_CHUNKS: u64 = 50;
/// Fewest samples of a chunk where the plan does not say: to synchronise the files of a chunk takes as long as some
/// ten quick samples.
const LEAST_CHUNK: u64 = 10;
/// Bytes of a chunk where the plan does not say.
const USUAL_CHUNK_BYTES: u64 = 16 << 20;

/// A plan, read and checked against its case.
#[derive(Clone)]
pub struct Plan {
    /// The keys as written.
    pub file: PlanFile,
    /// What varies.
    pub parameters: Vec<Parameter>,
    /// The points of the unit cube.
    pub design: Design,
    /// What is computed.
    pub outputs: Outputs,
    /// What the reader should know.
    pub remarks: Vec<String>,
    pub(crate) copula: Option<GaussianCopula>,
    /// The text of the plan.
    pub(crate) text: String,
    /// Its keys, for the fingerprint.
    pub(crate) table: toml::Table,
}

impl Plan {
    /// Read a plan and the case it names, with the overrides of `set` applied.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn read(path: &Path) -> Result<(Self, Case, PathBuf), CaseError> {
        let text = text_file::read_keys(path, "plan")?;
        let source = KeyFile::parse(&path.display().to_string(), &text)?;
        let file: PlanFile = source.deserialize()?;
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        let case = folder.join(&file.case);
        Self::on(source, file, &text, &case)
    }

    /// Read a plan from TOML with a case in another place than the plan says; `name` is shown in errors.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub fn parse(name: &str, text: &str, case: &Path) -> Result<(Self, Case, PathBuf), CaseError> {
        let source = KeyFile::parse(name, text)?;
        let file = source.deserialize()?;
        Self::on(source, file, text, case)
    }

    fn on(source: KeyFile, file: PlanFile, text: &str, path: &Path) -> Result<(Self, Case, PathBuf), CaseError> {
        let case = Case::read_with(path, &settings(&file.set)).map_err(|error| match error {
            CaseError::Changed { key, message } => source.refuse(&format!("set.{key}"), &message),
            CaseError::Read { reason, .. } => source.invalid(
                "case",
                format!("cannot read {}: {reason}", path.display()),
                "the case is looked for beside the plan",
            ),
            error => error,
        })?;
        let parameters = Self::parameters(&source, &file)?;
        let design = Self::design(&source, &file, &parameters)?;
        let copula = Self::copula(&source, &file, &parameters)?;
        let (outputs, of_points) = Outputs::new(&source, &file.outputs, &case)?;
        if outputs.has_axes()
            && let Some(index) = file.parameter.iter().position(|p| p.key.starts_with("map."))
        {
            return Err(source.invalid(
                &format!("parameter[{index}].key"),
                format!(
                    "is \"{}\", but the window of the map gives the results their axes and cannot vary",
                    file.parameter[index].key
                ),
                "ask for ridge and point alone, or make a study for each window",
            ));
        }
        if let Some(chunk) = file.results.samples_per_chunk
            && !(1..=MOST_SAMPLES_PER_CHUNK).contains(&chunk)
        {
            let [value, high] = [chunk, MOST_SAMPLES_PER_CHUNK].map(|it| it as f64);
            let rule = say!(is_outside, value, low = 1.0, high);
            return Err(source.invalid("results.samples_per_chunk", rule, ""));
        }
        let mut plan = Self {
            table: source.table().clone(),
            file,
            parameters,
            design,
            outputs,
            remarks: Vec::new(),
            copula,
            text: text.to_owned(),
        };
        let bytes = plan.bytes();
        if bytes > MOST_BYTES {
            let rule = format!(
                "{} samples of {} bytes make {}, more than the terabyte of the largest study",
                plan.design.samples(),
                plan.bytes_per_sample(),
                in_words(bytes)
            );
            let help = "take fewer samples, or leave out outputs.map";
            return Err(source.invalid("outputs", &rule, help));
        }
        plan.remarks.extend(case.remarks.iter().map(ToString::to_string));
        plan.remarks.extend(of_points.iter().map(ToString::to_string));
        plan.remarks.extend(plan.own_remarks());
        plan.remarks.extend(plan.idle_parameters(&case));
        bounds::check(&source, &mut plan, &case)?;
        Ok((plan, case, path.to_owned()))
    }

    fn parameters(source: &KeyFile, file: &PlanFile) -> Result<Vec<Parameter>, CaseError> {
        if file.parameter.is_empty() {
            return Err(source.missing("parameter", say!(write_one_parameter_or_more)));
        }
        let mut parameters: Vec<Parameter> = Vec::new();
        for (index, written) in file.parameter.iter().enumerate() {
            let place = format!("parameter[{index}].key");
            let Some(key) = CaseKey::find_with_curving(&written.key).filter(|key| key.key != "title") else {
                let nearest = CaseKey::nearest(&written.key);
                return Err(source.invalid(
                    &place,
                    say!(is_no_key_of_the_case, name = &written.key),
                    say!(the_nearest_key_is, key = nearest),
                ));
            };
            if parameters.iter().any(|other| other.key == key) {
                let rule = say!(is_a_second_time, text = &key.key);
                return Err(source.invalid(&place, rule, ""));
            }
            let spread = spread::of(source, index, written, key)?;
            parameters.push(Parameter { key, spread });
        }
        Ok(parameters)
    }

    fn own_remarks(&self) -> Vec<String> {
        let design = &self.file.design;
        let samples = design.samples.unwrap_or(1);
        let balanced = matches!(design.method, Method::Sobol | Method::Saltelli);
        let mut remarks = Vec::new();
        if balanced && !samples.is_power_of_two() {
            remarks.push(format!(
                "a Sobol sequence is balanced for powers of two: {} or {} samples serve better than {samples}",
                samples.next_power_of_two() / 2,
                samples.next_power_of_two()
            ));
        }
        if design.method == Method::LatinHypercube && self.copula.is_some() {
            remarks.push(
                "correlation moves the samples of a Latin hypercube out of their strata, all but those of the \
                 first parameter of a pair"
                    .to_owned(),
            );
        }
        remarks
    }

    /// What parameters of rail and supports the model of the track does not have, unless others choose another model.
    fn idle_parameters(&self, case: &Case) -> Vec<String> {
        if self.parameters.iter().any(|it| it.key.quantity.is_none()) {
            return Vec::new();
        }
        // A place along the bay counts where growth is no mean over it.
        let is_of_track =
            |key: &&String| (key.starts_with("track.") || key.starts_with("rail.")) && *key != "track.position";
        let keys = self.parameters.iter().map(|it| &it.key.key);
        let keys = keys.filter(is_of_track);
        let idle = keys.filter_map(|key| {
            let reason = idle_because(case, key)?;
            Some(say!(key_and_rule, key, rule = reason).to_string())
        });
        idle.collect()
    }

    /// The parameters of a sample as shares of the unit cube, correlations included.
    pub fn point(&self, sample: u64) -> Vec<f64> {
        let mut point = self.design.point(sample);
        if let Some(copula) = &self.copula {
            copula.apply(&mut point);
        }
        point
    }

    /// Bytes of the results of one sample: outputs and parameters.
    pub fn bytes_per_sample(&self) -> u64 {
        let variables = self.outputs.variables().iter();
        let numbers: usize = variables.map(|variable| self.outputs.length(variable)).sum();
        // A text counts as a number, a failure as a number.
        8 * (numbers + self.parameters.len() + 1) as u64
    }

    /// Bytes of all results.
    pub fn bytes(&self) -> u64 {
        self.design.samples().saturating_mul(self.bytes_per_sample())
    }

    /// Size of all results in words, "3.2 MB".
    pub fn size_in_words(&self) -> String {
        in_words(self.bytes())
    }

    /// Samples of a chunk.
    pub(crate) fn samples_per_chunk(&self) -> u64 {
        let samples = self.design.samples();
        self.file.results.samples_per_chunk.unwrap_or_else(|| {
            let by_bytes = USUAL_CHUNK_BYTES / self.bytes_per_sample();
            samples.div_ceil(USUAL_CHUNKS).clamp(LEAST_CHUNK, USUAL_CHUNK).min(by_bytes).max(1)
        })
    }
}

/// A number of bytes in the unit that suits it.
fn in_words(bytes: u64) -> String {
    let bytes = bytes as f64;
    for (size, unit) in [(1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB")] {
        if bytes >= size {
            return format!("{:.1} {unit}", bytes / size);
        }
    }
    format!("{bytes} bytes")
}
