//! A rail that wears under many wheels.

mod bands;
mod document;
mod figure;
mod inputs;
mod linear;
mod state;
mod table;

use std::f64::consts::TAU;

use riffel::passage::{Evolution, PassageModel, Sinusoid, WearOfPassages};
use riffel::roughness::Profile;
use riffel_case::Case;
use riffel_keys::{CaseError, Remark};

use super::along_rail::{check_sampling, refused};
use super::remarks;
use crate::AnswerError;
use bands::Bands;
pub use document::{BandDocument, EvolutionDocument};
use inputs::Inputs;
use linear::Linear;
use state::EvolutionState;
pub use state::{Extremes, Stage, WornProfile};

/// A rail and how it is rolled over.
#[derive(Debug, Clone, PartialEq)]
pub struct EvolutionRequest {
    /// \[m/s\].
    pub speed: f64,
    /// The rail before any wheel.
    pub surface: Surface,
    /// Longest step of the marches \[m\].
    pub largest_step: f64,
}

/// The rail before any wheel.
#[derive(Debug, Clone, PartialEq)]
pub enum Surface {
    /// A record whose ends do not meet.
    Record(Profile),
    /// A whole number of periods, which goes on where it ends.
    Ring(Profile),
}

impl Surface {
    /// Its profile.
    pub fn into_profile(self) -> Profile {
        match self {
            Self::Record(profile) | Self::Ring(profile) => profile,
        }
    }

    /// One wave, from crest to crest.
    ///
    /// # Errors
    /// [`riffel::Error::OutOfRange`] for a wavelength that is not positive.
    pub fn of_sinusoid(sinusoid: Sinusoid) -> Result<Self, AnswerError> {
        /// Heights of the wave: its tenth harmonic has twelve.
        const HEIGHTS: usize = 128;
        let share = |index: usize| index as f64 / HEIGHTS as f64;
        let heights = (0..HEIGHTS).map(|index| sinusoid.amplitude * (TAU * share(index)).cos());
        let spacing = sinusoid.wavelength / HEIGHTS as f64;
        Ok(Self::Ring(Profile::new(0.0, spacing, heights.collect())?))
    }
}

/// A rail on its way to a number of passages.
///
/// What was asked is given once, the work is done by [`go_on`](Self::go_on) step by step, and between two steps the run may be
/// saved and left. A run resumed from its [`state`](Self::state) is the same run, bit for bit.
pub struct EvolutionRun {
    case: Case,
    request: EvolutionRequest,
    model: PassageModel,
    wear: WearOfPassages,
    memory: f64,
    bands: Bands,
    evolution: Evolution,
    state: EvolutionState,
}

impl EvolutionRun {
    /// Waves longer than this \[m\], or than the bands of the map where these are longer, are taken off a record.
    pub const LONGEST_KEPT: f64 = 1.0;

    /// A run before any wheel.
    ///
    /// # Errors
    /// [`CaseError`] as of [`Case::passage`], for discrete supports, for a profile coarser than the patch is long, and for a record shorter than the
    /// motion remembers or than four of the longest waves kept.
    pub fn new(case: &Case, request: EvolutionRequest) -> Result<Self, AnswerError> {
        if case.track.support_spacing().is_some() {
            let message = format!(
                "`track.model` is \"{}\", whose supports pass under the wheel, but many passages take a track that is the same \
                 everywhere along the rail; choose its continuous counterpart",
                case.file.track.model.name()
            );
            Err(case.refuse("track.model", &message))?;
        }
        let model = case.passage(request.speed)?;
        let wear = case
            .wear_of_passages(request.largest_step)
            .ok_or_else(|| case.refuse("contact.creepage", "no loop of longitudinal creepage"))?;
        let memory = model.memory().map_err(refused)?;
        let evolution = match &request.surface {
            Surface::Record(record) => {
                check_sampling(case, record)?;
                if record.length() < memory {
                    Err(refused(riffel::Error::ProfileTooShort {
                        length: record.length(),
                        memory,
                    }))?;
                }
                let longest = f64::max(Self::LONGEST_KEPT, 1.3 * case.wavelength.max());
                Evolution::of_record(record, longest).map_err(refused)?
            }
            Surface::Ring(ring) => Evolution::new(ring),
        };
        let length = evolution.heights().len() as f64 * evolution.spacing();
        let bands = Bands::new(case, wear.shortest, length);
        if bands.count() == 0 {
            return Err(AnswerError::Argument {
                argument: "--passages",
                value: "given".to_owned(),
                rule: "left out: the profile has no wave in map.wavelength of the case that is longer than the patch"
                    .to_owned(),
            });
        }
        let inputs = Inputs::new(case, &request);
        Ok(Self {
            state: EvolutionState::new(inputs, &evolution, &bands),
            case: case.clone(),
            request,
            model,
            wear,
            memory,
            bands,
            evolution,
        })
    }

    /// Go on from where a run was left; `text` is its [`state`](Self::state).
    ///
    /// # Errors
    /// A sentence that names what differs, where that was not the same run.
    pub fn resume(&mut self, text: &str) -> Result<(), String> {
        let state: EvolutionState = serde_json::from_str(text)
            .map_err(|error| format!("it is not the state of a run: {error}"))?;
        if let Some([key, own, others]) = self.state.inputs.difference(&state.inputs) {
            return Err(format!(
                "it was begun by another run: {key} is {own} here and was {others} there"
            ));
        }
        let first = state.profiles.entries.first().unwrap_or(&state.profile);
        if first.heights_m != self.evolution.heights() || state.spacing_m != self.state.spacing_m {
            return Err(
                "it was begun by another run: the profile is another here than there".to_owned(),
            );
        }
        self.evolution = state.evolution().map_err(|error| error.to_string())?;
        self.state = state;
        Ok(())
    }

    /// The run so far as text.
    pub fn state(&self) -> String {
        // Only a map with keys that are not strings could be refused.
        serde_json::to_string(&self.state).unwrap_or_default()
    }

    /// Wheels so far.
    pub fn passages(&self) -> u64 {
        self.state.reached.passages
    }

    /// One step on: as many passages as change the rail by a share. Returns the answer where that reaches the passages asked
    /// for, or the wheel has been in the air for most of a passage, and none before.
    ///
    /// # Errors
    /// Those of a march.
    pub fn go_on(&mut self, passages: u64) -> Result<Option<EvolutionAnswer>, AnswerError> {
        let mut state = self.state.clone();
        if self.passages() < passages && !state.reached.is_airborne() {
            let most = passages - self.passages();
            let mut evolution = self.evolution.clone();
            let extremes = evolution
                .advance(&self.model, &self.wear, self.memory, most)
                .map_err(|error| CaseError::Physics {
                    input: "--passages".to_owned(),
                    error,
                })?;
            state.reach(state.next(&self.evolution, &evolution, extremes, &self.bands));
            if evolution.passages() < passages {
                self.evolution = evolution;
                self.state = state;
                return Ok(None);
            }
        }
        Ok(Some(self.answer(state)))
    }

    fn answer(&self, state: EvolutionState) -> EvolutionAnswer {
        let EvolutionState {
            stages,
            profiles,
            reached,
            profile,
            spacing_m,
            ..
        } = state;
        let stages: Vec<Stage> = stages.entries.into_iter().chain([reached]).collect();
        let profiles: Vec<WornProfile> = profiles.entries.into_iter().chain([profile]).collect();
        let last = &stages[stages.len() - 1];
        let track = remarks::of_track(&self.model.track);
        let airborne = last.is_airborne();
        let airborne = airborne.then(|| remarks::of_air(last.passages));
        EvolutionAnswer {
            linear: Linear::new(
                &self.case,
                self.request.speed,
                &self.bands,
                &profiles[0].heights_m,
                spacing_m,
            ),
            speed: self.request.speed,
            step: spacing_m / (spacing_m / self.request.largest_step).ceil().max(1.0),
            spacing: spacing_m,
            share_cut: self.model.track.share_cut(),
            remarks: track.into_iter().chain(airborne).collect(),
            stages,
            profiles,
        }
    }
}

/// A rail after many wheels.
pub struct EvolutionAnswer {
    /// \[m/s\].
    pub speed: f64,
    /// Step of the marches \[m\].
    pub step: f64,
    /// Distance of heights \[m\].
    pub spacing: f64,
    /// From before any wheel to the last.
    pub stages: Vec<Stage>,
    /// From before any wheel to the last.
    pub profiles: Vec<WornProfile>,
    /// What the reader should know.
    pub remarks: Vec<Remark>,
    share_cut: f64,
    linear: Linear,
}
