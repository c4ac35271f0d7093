//! All chains, kept in parts.

use std::fs;
use std::path::{Path, PathBuf, absolute};

use rayon::prelude::*;
use riffel_arrays::{Array, Values, json, whole_file};
use riffel_study::Stop;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::draw::Draw;
use crate::error::CalibrationError;
use crate::file::SamplerKind;
use crate::nuts::Statistics;
use crate::plan::Plan;
use crate::sampling::Sampling;

/// Draws of a part of a chain, which is kept as a whole.
const PART: u64 = 250;
/// Numbers that a draw has beside its place.
const OF_DRAW: usize = 7;
/// Fewest draws of a chain that goes on where it allows no conclusion: shorter ones are meant to be short.
const GOES_ON: u64 = 1000;
/// Most draws of such a chain, over those of the plan. Riffel's choice.
const MOST_TIMES: u64 = 4;
/// The record of what a folder holds.
const RECORD: &str = "calibration.json";

/// The draws of all chains behind their warm-up.
pub struct Chains {
    pub(crate) draws: Vec<Vec<Draw>>,
    /// ln of the evidence as each of them tells it, if they do.
    pub log_evidences: Vec<f64>,
}

/// How a run goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// So many draws more, those that were kept among them.
    Drawn(u64),
    /// The chains allow no conclusion yet, and go on to so many draws each.
    GoesOn {
        /// Draws of a chain that are kept.
        draws: u64,
    },
}

/// A chain on its way.
#[derive(Default)]
struct Going {
    /// Those of the warm-up among them.
    draws: Vec<Draw>,
    /// None before its first draw.
    state: Option<Sampling>,
    /// Parts of it that are kept.
    parts: u64,
}

impl Chains {
    /// Draws that lie evenly in all chains, so many at most.
    pub(crate) fn evenly(&self, most: usize) -> Vec<&Draw> {
        let all: Vec<&Draw> = self.draws.iter().flatten().collect();
        let count = all.len().min(most);
        (0..count)
            .map(|index| all[index * all.len() / count])
            .collect()
    }
}

/// A folder of results.
pub struct Folder<'a> {
    plan: &'a Plan,
    path: PathBuf,
}

impl<'a> Folder<'a> {
    /// The folder for the results of a plan, made if need be. Parts of chains that are there are kept for a restart, and
    /// removed else.
    ///
    /// # Errors
    /// [`CalibrationError`] for a folder of something else, or of another plan if it is to go on.
    pub fn begin(plan: &'a Plan, path: &Path, restart: bool) -> Result<Self, CalibrationError> {
        let record = path.join(RECORD);
        let there = fs::read(&record).ok();
        let is_empty = fs::read_dir(path).map_or(true, |mut entries| entries.next().is_none());
        if there.is_none() && !is_empty {
            let folder = path.to_owned();
            return Err(CalibrationError::NoCalibration { folder });
        }
        let own = plan.inputs[0].as_path();
        let own = json(&json!({
            "fingerprint": fingerprint(plan)?,
            "version": env!("CARGO_PKG_VERSION"),
            "plan": fs::canonicalize(own).or_else(|_| absolute(own)).unwrap_or_default(),
        }));
        if restart && there.is_some_and(|there| !is_of(&there, plan)) {
            let folder = path.to_owned();
            return Err(CalibrationError::OtherPlan { folder });
        }
        let folder = Self {
            plan,
            path: path.to_owned(),
        };
        let chains = folder.chains();
        if !restart && chains.exists() {
            fs::remove_dir_all(&chains).map_err(CalibrationError::write(&chains))?;
        }
        whole_file::write(&record, &own).map_err(CalibrationError::write(&record))?;
        Ok(folder)
    }

    /// The folder of finished chains of a plan.
    ///
    /// # Errors
    /// [`CalibrationError::OtherPlan`], [`CalibrationError::NotThere`].
    fn finished(plan: &'a Plan, path: &Path) -> Result<Self, CalibrationError> {
        let folder = path.to_owned();
        let Ok(there) = fs::read(path.join(RECORD)) else {
            return Err(CalibrationError::NotThere { folder });
        };
        match is_of(&there, plan) {
            true => Ok(Self { plan, path: folder }),
            false => Err(CalibrationError::OtherPlan { folder }),
        }
    }

    /// The chains, if all are there.
    ///
    /// # Errors
    /// [`CalibrationError::Unfinished`].
    fn chains_of_all(&self) -> Result<Chains, CalibrationError> {
        let stop = Stop::default();
        stop.ask();
        let chains = self.run(&|_| (), &stop)?;
        chains.ok_or_else(|| CalibrationError::Unfinished {
            folder: self.path.clone(),
        })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    fn chains(&self) -> PathBuf {
        self.path.join("chains")
    }

    fn part(&self, chain: u64, part: u64) -> PathBuf {
        self.chains().join(format!("{chain}-{part}"))
    }

    /// Draws of each chain, those of the warm-up among them.
    pub fn draws_of_a_chain(&self) -> u64 {
        self.plan.file.sampler.left_out() + self.plan.file.sampler.draws
    }

    /// Draw until every chain is whole, on the current rayon pool; none where a wish to stop came between. Chains of a thousand draws
    /// and more that allow no conclusion go on, up to four times their draws.
    ///
    /// Draws do not depend on the number of threads, nor on whether a chain was stopped on its way.
    ///
    /// # Errors
    /// [`CalibrationError::Write`]; parts that are finished are kept. [`CalibrationError::NoStart`].
    pub fn run(
        &self,
        progress: &(dyn Fn(Progress) + Sync),
        stop: &Stop,
    ) -> Result<Option<Chains>, CalibrationError> {
        let sampler = &self.plan.file.sampler;
        let mut going: Vec<Going> = (0..sampler.chains).map(|_| Going::default()).collect();
        let (mut draws, mut more) = (sampler.draws, self.draws_of_a_chain());
        loop {
            let longer: Result<Vec<Option<Going>>, CalibrationError> = going
                .into_par_iter()
                .enumerate()
                .map(|(index, chain)| self.longer(chain, (index as u64, more), progress, stop))
                .collect();
            let Some(longer) = longer?.into_iter().collect::<Option<Vec<Going>>>() else {
                return Ok(None);
            };
            let posterior = &self.plan.posterior;
            let kept = longer
                .iter()
                .map(|it| sampler.kept(it.draws.clone(), posterior));
            let states = longer.iter().filter_map(|it| it.state.as_ref());
            let chains = Chains {
                draws: kept.collect(),
                log_evidences: states.filter_map(Sampling::log_evidence).collect(),
            };
            let ends = sampler.kind == SamplerKind::Smc
                || sampler.draws < GOES_ON
                || draws >= MOST_TIMES * sampler.draws;
            if ends || chains.summary(self.plan).doubts().is_empty() {
                return Ok(Some(chains));
            }
            (going, more) = (longer, draws);
            draws += more;
            progress(Progress::GoesOn { draws });
        }
    }

    /// A chain after so many draws more; none where a wish to stop came between.
    fn longer(
        &self,
        mut chain: Going,
        (index, more): (u64, u64),
        progress: &(dyn Fn(Progress) + Sync),
        stop: &Stop,
    ) -> Result<Option<Going>, CalibrationError> {
        let posterior = &self.plan.posterior;
        let sampler = &self.plan.file.sampler;
        for begin in (0..more).step_by(PART as usize) {
            let length = PART.min(more - begin);
            let part = chain.parts;
            chain.parts += 1;
            if let Some((kept, state)) = self.kept(index, part, length) {
                progress(Progress::Drawn(length));
                chain.draws.extend(kept);
                chain.state = Some(state);
                continue;
            }
            if stop.is_asked() {
                return Ok(None);
            }
            let mut state = match chain.state.take() {
                Some(state) => state,
                None => Sampling::begin(posterior, sampler, index, stop).ok_or_else(|| {
                    let values = posterior.parameters().iter();
                    let values: Vec<f64> = values.map(|it| it.prior.quantile(0.5)).collect();
                    let reason = posterior.log_likelihood(&values).err();
                    let reason =
                        reason.unwrap_or_else(|| "they are too unlikely for numbers".to_owned());
                    CalibrationError::NoStart { reason }
                })?,
            };
            let mut new = Vec::new();
            for _ in 0..length {
                if stop.is_asked() {
                    return Ok(None);
                }
                new.extend(state.draw(posterior));
                progress(Progress::Drawn(1));
            }
            self.keep(index, part, &new, &state)?;
            chain.draws.extend(new);
            chain.state = Some(state);
        }
        Ok(Some(chain))
    }

    /// The array that the numbers of a part are written as.
    fn array(count: usize) -> Array {
        Array::axis(
            "part",
            "number",
            count as u64,
            "",
            "draws, then the state of the chain",
        )
    }

    fn keep(
        &self,
        chain: u64,
        part: u64,
        draws: &[Draw],
        state: &Sampling,
    ) -> Result<(), CalibrationError> {
        let mut numbers = Vec::new();
        for draw in draws {
            let statistics = draw.statistics;
            numbers.extend(&draw.place);
            numbers.extend([
                draw.log_density,
                draw.step,
                statistics.acceptance,
                f64::from(statistics.steps),
                f64::from(statistics.depth),
                f64::from(u8::from(statistics.diverging)),
                statistics.energy,
            ]);
        }
        numbers.extend(state.numbers());
        let bytes = Self::array(numbers.len()).encode(&Values::Numbers(numbers));
        let path = self.part(chain, part);
        whole_file::write(&path, &bytes).map_err(CalibrationError::write(&path))
    }

    /// The draws of a part and the chain behind them, if it is there and what was written.
    fn kept(&self, chain: u64, part: u64, length: u64) -> Option<(Vec<Draw>, Sampling)> {
        let sampler = &self.plan.file.sampler;
        let size = self.plan.posterior.parameters().len();
        let bytes = fs::read(self.part(chain, part)).ok()?;
        let count = bytes.len().checked_sub(4)? / 8;
        let Ok(Values::Numbers(numbers)) = Self::array(count).decode(&bytes, count as u64) else {
            return None;
        };
        let (of_draws, state) = numbers.split_at_checked(length as usize * (size + OF_DRAW))?;
        let draws = of_draws.chunks(size + OF_DRAW).map(|numbers| {
            let (place, rest) = numbers.split_at(size);
            Draw {
                place: place.to_vec(),
                log_density: rest[0],
                step: rest[1],
                statistics: Statistics {
                    acceptance: rest[2],
                    steps: rest[3] as u32,
                    depth: rest[4] as u32,
                    diverging: rest[5] != 0.0,
                    energy: rest[6],
                },
            }
        });
        let state = Sampling::of_numbers(state, &self.plan.posterior, sampler, chain)?;
        Some((draws.collect(), state))
    }
}

/// The plan of a finished calibration, the one that its folder names or another, and its chains.
///
/// # Errors
/// [`CalibrationError::NotThere`], [`CalibrationError::OtherPlan`] and [`CalibrationError::Unfinished`] of the folder, and those of the
/// plan.
pub fn finished(folder: &Path, plan: Option<&Path>) -> Result<(Plan, Chains), CalibrationError> {
    let plan = match plan {
        Some(path) => Plan::read(path)?,
        None => Plan::read(&plan_of(folder)?)?,
    };
    let chains = Folder::finished(&plan, folder)?.chains_of_all()?;
    Ok((plan, chains))
}

/// The plan that the record of a folder names.
///
/// # Errors
/// [`CalibrationError::NotThere`].
fn plan_of(folder: &Path) -> Result<PathBuf, CalibrationError> {
    let record = fs::read(folder.join(RECORD)).ok();
    let record: Option<Value> = record.and_then(|bytes| serde_json::from_slice(&bytes).ok());
    let plan = record.as_ref().and_then(|record| record["plan"].as_str());
    plan.map(PathBuf::from)
        .ok_or_else(|| CalibrationError::NotThere {
            folder: folder.to_owned(),
        })
}

/// Whether a record is of the chains of a plan.
fn is_of(record: &[u8], plan: &Plan) -> bool {
    let record: Value = serde_json::from_slice(record).unwrap_or_default();
    let own = fingerprint(plan).ok();
    own.is_some_and(|own| record["fingerprint"] == own)
        && record["version"] == env!("CARGO_PKG_VERSION")
}

/// SHA-256 over all that the numbers follow from: the plan without its decisions, the text of all other files.
fn fingerprint(plan: &Plan) -> Result<String, CalibrationError> {
    let mut hash = Sha256::new();
    hash.update(plan.of_draws());
    for path in &plan.inputs[1..] {
        let bytes = fs::read(path).map_err(|reason| CalibrationError::Read {
            path: path.clone(),
            reason,
        })?;
        hash.update((bytes.len() as u64).to_le_bytes());
        hash.update(bytes);
    }
    let digest = hash.finalize();
    Ok(digest.iter().map(|byte| format!("{byte:02x}")).collect())
}
