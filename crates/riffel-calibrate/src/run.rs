//! All chains, kept in parts.

use std::fs;
use std::path::Path;

use rayon::prelude::*;
use riffel_arrays::{Array, Values};
use riffel_study::Stop;
use serde_json::Value;

use crate::chains::Chains;
use crate::draw::Draw;
use crate::error::CalibrationError;
use crate::file::SamplerKind;
use crate::folder::Folder;
use crate::names::{PARTS, TREE};
use crate::nuts::Statistics;
use crate::plan::Plan;
use crate::record::Record;
use crate::sampling::Sampling;

/// Draws of a part of a chain, which is kept as a whole.
const PART: u64 = 250;
/// Numbers that a draw has beside its place.
const OF_DRAW: usize = 7;
/// Fewest draws of a chain that goes on where it allows no conclusion: shorter ones are meant to be short.
const GOES_ON: u64 = 1000;
/// Most draws of such a chain, over those of the plan. Riffel's choice.
const MOST_TIMES: u64 = 16;

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
    /// Draws, those of the warm-up among them.
    draws: Vec<Draw>,
    /// None before its first draw.
    state: Option<Sampling>,
    /// Parts of it that are kept.
    parts: u64,
}

impl Folder<'_> {
    /// Draws of each chain, those of the warm-up among them.
    pub fn draws_of_a_chain(&self) -> u64 {
        self.plan.file.sampler.left_out() + self.plan.file.sampler.draws
    }

    /// Draw until every chain is whole, on the current rayon pool; `None` if a wish to stop came between. Chains of a thousand draws
    /// and more that allow no conclusion go on, up to sixteen times their draws.
    ///
    /// Draws do not depend on the number of threads, nor on whether a chain was stopped on its way.
    ///
    /// # Errors
    /// [`CalibrationError::Write`]; parts that are finished are kept. [`CalibrationError::NoStart`].
    pub fn run(&self, progress: &(dyn Fn(Progress) + Sync), stop: &Stop) -> Result<Option<Chains>, CalibrationError> {
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
            let kept = longer.iter().map(|it| sampler.kept(it.draws.clone(), posterior));
            let states = longer.iter().filter_map(|it| it.state.as_ref());
            let chains =
                Chains { draws: kept.collect(), log_evidences: states.filter_map(Sampling::log_evidence).collect() };
            let ends =
                sampler.kind == SamplerKind::Smc || sampler.draws < GOES_ON || draws >= MOST_TIMES * sampler.draws;
            if ends || chains.summary(self.plan).doubts().is_empty() {
                return Ok(Some(chains));
            }
            (going, more) = (longer, draws);
            draws += more;
            progress(Progress::GoesOn { draws });
        }
    }

    /// A chain after so many draws more; `None` if a wish to stop came between.
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
                    let reason = reason.unwrap_or_else(|| "they are too unlikely for numbers".to_owned());
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
        Array::axis("part", "number", count as u64, "", "draws, then the state of the chain, then the mark of the plan")
    }

    fn keep(&self, chain: u64, part: u64, draws: &[Draw], state: &Sampling) -> Result<(), CalibrationError> {
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
        numbers.push(self.record.mark());
        let bytes = Self::array(numbers.len()).encode(&Values::Numbers(numbers));
        self.put(&part_name(chain, part), &bytes)
    }

    /// The draws of a part and the chain behind them, if it is there, what was written, and of this plan.
    fn kept(&self, chain: u64, part: u64, length: u64) -> Option<(Vec<Draw>, Sampling)> {
        let sampler = &self.plan.file.sampler;
        let size = self.plan.posterior.parameters().len();
        let bytes = fs::read(self.path.join(part_name(chain, part))).ok()?;
        let count = bytes.len().checked_sub(4)? / 8;
        let Ok(Values::Numbers(numbers)) = Self::array(count).decode(&bytes, count as u64) else {
            return None;
        };
        let (mark, numbers) = numbers.split_last()?;
        if !self.goes_on || *mark != self.record.mark() {
            return None;
        }
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

impl<'a> Folder<'a> {
    /// The chains of a plan, if all are there, and the draws in `posterior.zarr` are of the same plan.
    ///
    /// # Errors
    /// [`CalibrationError::OtherPlan`], [`CalibrationError::OtherDraws`], [`CalibrationError::NotThere`],
    /// [`CalibrationError::Unfinished`].
    fn finished(plan: &'a Plan, path: &Path) -> Result<Chains, CalibrationError> {
        let folder = path.to_owned();
        let Some(there) = Record::read(path) else {
            return Err(CalibrationError::NotThere { folder });
        };
        let record = Record::of(plan)?;
        if !there.is_like(&record) {
            return Err(CalibrationError::OtherPlan { folder });
        }
        let tree = path.join(TREE);
        match fs::read(tree.join("zarr.json")) {
            Ok(bytes) => {
                let group: Value = serde_json::from_slice(&bytes).unwrap_or_default();
                if group["attributes"]["fingerprint"] != *record.fingerprint {
                    return Err(CalibrationError::OtherDraws { path: tree });
                }
            }
            Err(_) => return Err(CalibrationError::Unfinished { folder }),
        }
        let own = Self::to_read(plan, path, record);
        let stop = Stop::default();
        stop.ask();
        let chains = own.run(&|_| (), &stop)?;
        chains.ok_or(CalibrationError::Unfinished { folder })
    }
}

/// The plan of a finished calibration, the one that its folder names or another, and its chains.
///
/// # Errors
/// [`CalibrationError::NotThere`], [`CalibrationError::OtherPlan`], [`CalibrationError::OtherDraws`] and
/// [`CalibrationError::Unfinished`] of the folder, and those of the plan.
pub fn finished(folder: &Path, plan: Option<&Path>) -> Result<(Plan, Chains), CalibrationError> {
    let there = Record::read(folder).ok_or_else(|| CalibrationError::NotThere { folder: folder.to_owned() })?;
    let plan = Plan::read(plan.unwrap_or(&there.plan))?;
    let chains = Folder::finished(&plan, folder)?;
    Ok((plan, chains))
}

/// The file of a part of a chain, below the folder of results.
fn part_name(chain: u64, part: u64) -> String {
    format!("{PARTS}/{chain}-{part}")
}
