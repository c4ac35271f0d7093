//! What a run is made of, in memory and on disk.

use riffel::passage::{Evolution, PassageExtremes};
use riffel::roughness::Profile;
use serde::{Deserialize, Serialize};

use super::bands::Bands;
use super::inputs::Inputs;
use crate::simulate::Extremes;

/// All of a run that was stopped, to the last digit.
///
/// A step that was cut short to end at the passages asked for is not in it: so it does not depend on them, and a run that is
/// asked for more goes on as if it had been asked for them at once.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EvolutionState {
    pub(super) inputs: Inputs,
    pub(super) spacing_m: f64,
    /// Stages, the first before any wheel; the one reached is not among them unless it is the first.
    pub(super) stages: Thinned<Stage>,
    /// Profiles, in the same way.
    pub(super) profiles: Thinned<WornProfile>,
    /// The stage reached.
    pub(super) reached: Stage,
    /// The profile reached.
    pub(super) profile: WornProfile,
}

/// A profile after some passages.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WornProfile {
    /// Wheels so far.
    pub passages: u64,
    /// Heights of the ring, without what is worn off everywhere.
    pub heights_m: Vec<f64>,
    /// What has flowed and hardened at each height; empty where nothing does.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outflow_m: Vec<f64>,
}

/// What a rail and a passage over it are like.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Stage {
    /// Wheels so far.
    pub passages: u64,
    /// Depth worn off everywhere.
    pub mean_depth_m: f64,
    /// Mean square of each band.
    pub mean_squares_m2: Vec<f64>,
    /// Mean square of the waves that fit between two supports; none on an even track.
    pub bay_mean_square_m2: Option<f64>,
    /// How far the waves of each band have moved in the direction of travel since the beginning.
    pub shifts_m: Vec<f64>,
    /// The passage before; none before any.
    pub extremes: Option<Extremes>,
}

impl Stage {
    /// True if the passage before left the wheel in the air for most of the time, where the
    /// [model ends](Evolution::MOST_CONTACT_LOSS).
    pub(super) fn is_airborne(&self) -> bool {
        let most = Evolution::MOST_CONTACT_LOSS;
        let lost = |passage: Extremes| passage.contact_loss_fraction > most;
        self.extremes.is_some_and(lost)
    }
}

/// Entries at equal numbers of steps, every other one forgotten whenever they are too many.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Thinned<T> {
    /// Steps from one entry to the next.
    stride: u64,
    /// Steps so far.
    steps: u64,
    pub(super) entries: Vec<T>,
}

impl<T> Thinned<T> {
    fn new() -> Self {
        Self { stride: 1, steps: 0, entries: Vec::new() }
    }

    /// One step; its entry is made where it is kept.
    fn push(&mut self, most: usize, entry: impl FnOnce() -> T) {
        if self.steps.is_multiple_of(self.stride) {
            self.entries.push(entry());
            if self.entries.len() > most {
                self.stride *= 2;
                let mut index = 0;
                self.entries.retain(|_| {
                    index += 1;
                    index % 2 == 1
                });
            }
        }
        self.steps += 1;
    }
}

impl EvolutionState {
    const MOST_STAGES: usize = 256;
    const MOST_PROFILES: usize = 12;

    pub(super) fn new(inputs: Inputs, evolution: &Evolution, bands: &Bands) -> Self {
        let reached = Stage {
            passages: 0,
            mean_depth_m: 0.0,
            mean_squares_m2: bands.mean_squares(&evolution.waves()),
            bay_mean_square_m2: bands.mean_square_of_bay(&evolution.waves()),
            shifts_m: vec![0.0; bands.count()],
            extremes: None,
        };
        Self {
            inputs,
            spacing_m: evolution.spacing(),
            stages: Thinned::new(),
            profiles: Thinned::new(),
            reached,
            profile: WornProfile {
                passages: 0,
                heights_m: evolution.heights().to_vec(),
                outflow_m: evolution.outflow().to_vec(),
            },
        }
    }

    /// `Ok` if a run with some number of bands may have got there.
    pub(super) fn check(&self, bands: usize) -> Result<(), String> {
        let (stages, profiles) = (&self.stages, &self.profiles);
        let all_stages = || stages.entries.iter().chain([&self.reached]);
        let all_profiles = || profiles.entries.iter().chain([&self.profile]);
        let of_bands = |stage: &Stage| {
            let values = [&stage.mean_squares_m2, &stage.shifts_m];
            values.iter().all(|of_band| of_band.len() == bands)
        };
        let is_right = all_stages().all(of_bands)
            && all_profiles().all(|profile| profile.heights_m.len() == self.profile.heights_m.len())
            && [0, self.profile.heights_m.len()].contains(&self.profile.outflow_m.len())
            && all_stages().is_sorted_by_key(|stage| stage.passages)
            && all_profiles().is_sorted_by_key(|profile| profile.passages)
            && self.profile.passages == self.reached.passages
            && [stages.stride, profiles.stride].iter().all(|stride| stride.is_power_of_two())
            && [stages.steps, profiles.steps].iter().all(|&steps| steps < u64::MAX / 2);
        match is_right {
            true => Ok(()),
            false => Err("it is damaged: its stages do not belong together".to_owned()),
        }
    }

    /// The rail reached.
    pub(super) fn evolution(&self) -> Result<Evolution, riffel::Error> {
        let heights = self.profile.heights_m.clone();
        let profile = Profile::new(0.0, self.spacing_m, heights)?;
        let Stage { passages, mean_depth_m, .. } = self.reached;
        let evolution = Evolution::resumed(&profile, passages, mean_depth_m);
        Ok(evolution.with_outflow(self.profile.outflow_m.clone()))
    }

    /// The next stage, after the rail has worn from one to the other.
    pub(super) fn next(
        &self,
        before: &Evolution,
        after: &Evolution,
        extremes: PassageExtremes,
        bands: &Bands,
    ) -> (Stage, WornProfile) {
        let (old, new) = (before.waves(), after.waves());
        let shifts = self.reached.shifts_m.iter().zip(bands.shifts(&old, &new));
        let stage = Stage {
            passages: after.passages(),
            mean_depth_m: after.mean_depth(),
            mean_squares_m2: bands.mean_squares(&new),
            bay_mean_square_m2: bands.mean_square_of_bay(&new),
            shifts_m: shifts.map(|(before, by)| before + by).collect(),
            extremes: Some(Extremes::new(extremes.normal_force, extremes.contact_loss)),
        };
        let profile = WornProfile {
            passages: after.passages(),
            heights_m: after.heights().to_vec(),
            outflow_m: after.outflow().to_vec(),
        };
        (stage, profile)
    }

    /// Go on to a stage.
    pub(super) fn reach(&mut self, (stage, profile): (Stage, WornProfile)) {
        let reached = std::mem::replace(&mut self.reached, stage);
        self.stages.push(Self::MOST_STAGES, || reached);
        let before = std::mem::replace(&mut self.profile, profile);
        self.profiles.push(Self::MOST_PROFILES, || before);
    }
}
