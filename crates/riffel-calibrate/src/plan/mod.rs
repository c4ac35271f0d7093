//! Plans: what is uncertain, what was measured, read and checked.

mod comparison;
mod data;
pub(crate) mod decision;
mod discrepancy;
mod moved;
mod parameter;
mod pass_by;
mod uncertain;
mod usual;

use std::path::{Path, PathBuf};

use riffel::STANDARD_GRAVITY;
use riffel_case::traffic::{DAYS_PER_YEAR, Line, Traffic};
use riffel_case::{Case, settings};
use riffel_keys::{CaseError, KeyFile, Message, say, text_file};
use riffel_numerics::distribution::Distribution;

use crate::file::{DataFile, PlanFile, SamplerKind};
use crate::model::{Model, Parameter, Vehicle, VehicleKey, View};
use crate::posterior::{Named, Posterior};
use crate::prior::Prior;

pub use uncertain::Uncertain;
pub use usual::Measured;

/// Standard deviations of a prior from its median beyond which it excludes what the case says.
const EXCLUDES: f64 = 4.0;
/// Keys of a plan that no draw follows from: for comparisons and for decisions.
const OF_OTHERS: [&str; 5] = ["compare", "hold_out", "action", "measurement", "cost"];

/// A plan, read and checked against its case and its data.
pub struct Plan {
    /// The keys as written.
    pub file: PlanFile,
    /// What it asks for.
    pub posterior: Posterior,
    /// What the reader should know.
    pub remarks: Vec<Message>,
    /// The text of the plan.
    pub text: String,
    /// Every file that the numbers follow from, the plan first.
    pub inputs: Vec<PathBuf>,
    /// Axle passages of a day, if the traffic says how many there are.
    pub passages_per_day: Option<f64>,
    /// The traffic, if it names one.
    pub traffic: Option<Traffic>,
    /// The view of the case that trains have.
    pub(crate) trains: usize,
    /// The other models of the plan, in its order.
    pub(crate) models: Vec<Plan>,
    /// What of the data is left out, in a word of its own.
    pub(crate) left_out: Option<String>,
    source: KeyFile,
}

/// A plan while it is being read.
struct Reading<'a> {
    source: &'a KeyFile,
    file: &'a PlanFile,
    folder: &'a Path,
    case: &'a Case,
    vehicles: &'a [Vehicle],
    parameters: Vec<Parameter>,
    views: Vec<View>,
    remarks: Vec<Message>,
    inputs: Vec<PathBuf>,
}

impl Plan {
    /// Read a plan, its case, its traffic and its data.
    ///
    /// # Errors
    /// [`CaseError`] with the key or the file, the value and the rule.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        Self::of_text(path, text_file::read_keys(path, "plan")?)
    }

    /// Plan of a text, read as if it stood at a path.
    fn of_text(path: &Path, text: String) -> Result<Self, CaseError> {
        let source = KeyFile::parse(&path.display().to_string(), &text)?;
        let mut plan = Self::of(path, text, source)?;
        let compared = plan.file.compare.iter().enumerate();
        let models = compared.map(|(index, written)| plan.compared(index, written));
        plan.models = models.collect::<Result<Vec<Self>, CaseError>>()?;
        if plan.compares() {
            plan.groups()?;
        }
        Ok(plan)
    }

    /// Whether it asks how well models predict what is left out.
    pub fn compares(&self) -> bool {
        !self.models.is_empty() || self.file.hold_out.is_some()
    }

    fn of(path: &Path, text: String, source: KeyFile) -> Result<Self, CaseError> {
        let file: PlanFile = source.deserialize()?;
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        check_sampler(&source, &file)?;
        let case_path = beside(folder, &file.case);
        let mut case = Case::read_with(&case_path, &settings(&file.set))
            .map_err(|error| match error {
                CaseError::Changed { key, message } => source.refuse(&format!("set.{key}"), &message),
                error => error,
            })?
            .sharing_profiles();
        let mut inputs = vec![path.to_owned(), case_path];
        let mut traffic = None;
        let vehicles = match &file.traffic {
            None => Vec::new(),
            Some(name) => {
                inputs.push(beside(folder, name));
                let read = traffic.insert(Traffic::read(&beside(folder, name))?);
                case = read.wearing_as_measured(&case)?.into_owned();
                Vehicle::all(read).map_err(|(index, key)| {
                    let message = say!(not_for_calibration, index, key);
                    source.refuse("traffic", message.about(name))
                })?
            }
        };
        inputs.extend(file.data.iter().map(|data| beside(folder, &data.file)));
        let roughness = file.data.iter();
        let roughness = roughness.flat_map(|data| data.roughness.iter().chain(&data.wheel_roughness));
        let roughness = roughness.map(|name| beside(folder, name));
        inputs.extend(roughness.filter(|path| path.exists()));
        let mut reading = Reading {
            source: &source,
            file: &file,
            folder,
            case: &case,
            vehicles: &vehicles,
            parameters: Vec::new(),
            views: Vec::new(),
            remarks: Vec::new(),
            inputs,
        };
        for (index, parameter) in file.parameter.iter().enumerate() {
            let parameter = reading.parameter(index, parameter)?;
            if reading.parameters.iter().any(|other| other.name == parameter.name) {
                let rule = say!(is_a_second_time, text = parameter.name);
                return Err(source.invalid(&format!("parameter[{index}]"), rule, ""));
            }
            reading.parameters.push(parameter);
        }
        let mut blocks = reading.blocks()?;
        if reading.parameters.is_empty() {
            return Err(source.missing("parameter", say!(write_one_parameter_or_more)));
        }
        let levels = blocks.iter().find_map(|named| named.block.as_levels());
        let trains = match levels {
            Some(levels) => levels.view(),
            None => reading.view_of_all(),
        };
        let Reading { parameters, views, remarks, inputs, .. } = reading;
        let line = traffic.as_ref().map(|traffic| traffic.file.line);
        let passages_per_day = line.and_then(|line| passages_per_day(&line, &vehicles, &case));
        let model = Model { parameters, views, vehicles, speed: None };
        touch(&source, &model, &mut blocks)?;
        let posterior = Posterior { model, blocks };
        let plan = Self {
            file,
            posterior,
            remarks,
            text,
            inputs,
            passages_per_day,
            traffic,
            trains,
            models: Vec::new(),
            left_out: None,
            source,
        };
        plan.check_actions()?;
        Ok(plan)
    }

    /// Compute what actions change, before minutes of sampling.
    fn check_actions(&self) -> Result<(), CaseError> {
        if self.file.cost.is_none() && self.file.action.is_empty() {
            return Ok(());
        }
        let choices = self.choices()?;
        let Ok((_, levels)) = self.levels() else {
            return Ok(());
        };
        let actions = choices.actions.iter();
        for changes in actions.filter_map(|action| action.changes.as_ref()) {
            self.posterior.model.changed(levels.view(), changes)?;
        }
        Ok(())
    }

    /// The text that draws follow from: without the keys of comparisons and decisions.
    pub(crate) fn of_draws(&self) -> String {
        let mut source = self.source.clone();
        OF_OTHERS.iter().for_each(|key| source.remove(key));
        source.table().to_string() + self.left_out.as_deref().unwrap_or_default()
    }
}

/// Axle passages of a day on a line, if it says how many there are.
fn passages_per_day(line: &Line, vehicles: &[Vehicle], case: &Case) -> Option<f64> {
    let axle_mass = vehicles.iter().map(|vehicle| {
        let own = vehicle.number(&VehicleKey::OfCase("contact.normal_load".to_owned(), 1.0));
        let own = own.map(|load| 2.0 * load / STANDARD_GRAVITY);
        vehicle.share * own.unwrap_or_else(|| case.mean_wear().axle_mass)
    });
    let axle_mass: f64 = axle_mass.sum();
    let of_mgt = line.mgt_per_year.map(|mgt| 1e9 * mgt / axle_mass / DAYS_PER_YEAR);
    line.passages_per_day.or(of_mgt)
}

fn check_sampler(source: &KeyFile, file: &PlanFile) -> Result<(), CaseError> {
    let sampler = &file.sampler;
    for (key, value, least, most) in [
        ("sampler.chains", sampler.chains, 1, 1000),
        ("sampler.warmup", sampler.warmup, 100, 1_000_000),
        ("sampler.draws", sampler.draws, 10, 1_000_000),
    ] {
        if !(least..=most).contains(&value) {
            let [value, low, high] = [value, least, most].map(|it| it as f64);
            let rule = say!(is_outside, value, low, high);
            return Err(source.invalid(key, rule, ""));
        }
    }
    if sampler.kind == SamplerKind::Smc && source.has("sampler.warmup") {
        let value = sampler.warmup as f64;
        let rule = say!(is_but_must_be, value, rule = say!(left_out_with_smc));
        return Err(source.invalid("sampler.warmup", rule, ""));
    }
    Ok(())
}

/// The path of a file that a plan in a folder names. Of a folder that is not there yet the system knows no parent.
fn beside(folder: &Path, name: &str) -> PathBuf {
    let (mut folder, mut name) = (folder.to_owned(), Path::new(name));
    while !folder.exists()
        && let Ok(rest) = name.strip_prefix("..")
        && folder.pop()
    {
        name = rest;
    }
    folder.join(name)
}

/// The name of data in the results.
pub(crate) fn name_of(data: &DataFile) -> &str {
    data.name.as_deref().unwrap_or(data.kind.name())
}

/// Whether a value lies beyond the ends or far out in the tails of a prior.
fn excludes(prior: &Prior, value: f64) -> bool {
    let [low, high] = prior.ends();
    let far = match *prior {
        Prior::Of(Distribution::Normal { .. }) => prior.place(value).abs(),
        Prior::Of(Distribution::Lognormal { log_mean, log_deviation, .. }) if value > 0.0 => {
            ((value.ln() - log_mean) / log_deviation).abs()
        }
        _ => 0.0,
    };
    value < low || value > high || far > EXCLUDES
}

/// Whether predictions differ by rounding alone.
fn is_same(here: &[f64], there: &[f64]) -> bool {
    const ROUNDING: f64 = 1e-10;
    let mut pairs = here.iter().zip(there);
    pairs.all(|(here, there)| (here - there).abs() <= ROUNDING * (1.0 + here.abs()))
}

/// Find which parameters each block depends on: those whose change by a tenth in z changes a prediction at one of some places.
fn touch(source: &KeyFile, model: &Model, blocks: &mut [Named]) -> Result<(), CaseError> {
    const PLACES: [f64; 3] = [0.5, 0.35, 0.7];
    const CHANGE: f64 = 0.1;
    for named in blocks {
        let acting: Vec<usize> =
            named.block.views().into_iter().flat_map(|view| model.views[view].acting.clone()).collect();
        let mut reason = None;
        for share in PLACES {
            let values: Vec<f64> = model.parameters.iter().map(|it| it.prior.quantile(share)).collect();
            let here = match named.block.predict(&model.trial(&values)) {
                Ok(here) => here,
                Err(error) => {
                    reason = Some(error);
                    continue;
                }
            };
            for &index in &acting {
                if named.touched_by.contains(&index) {
                    continue;
                }
                let prior = &model.parameters[index].prior;
                let mut moved = values.clone();
                moved[index] = prior.value(prior.place(values[index]) + CHANGE);
                let there = named.block.predict(&model.trial(&moved));
                if !there.is_ok_and(|there| is_same(&here, &there)) {
                    named.touched_by.push(index);
                }
            }
        }
        if let (Some(reason), true) = (reason, named.touched_by.is_empty()) {
            let message = say!(middle_of_the_priors, reason);
            return Err(source.refuse("parameter", message));
        }
        named.touched_by.sort_unstable();
    }
    Ok(())
}
