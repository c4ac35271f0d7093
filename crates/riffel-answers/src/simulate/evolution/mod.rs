//! A rail that wears under many wheels.

mod band;
mod bands;
mod figure;
mod inputs;
mod linear;
mod stages;
mod state;
mod table;
mod words;

use riffel::contact::ContactFilter;
use riffel::passage::{Evolution, EvolutionStep, PassingWheel, Sinusoid};
use riffel::roughness::Profile;
use riffel_case::Case;
use riffel_case::traffic::{Traffic, VehicleInTime};
use riffel_keys::Message;
use riffel_plot::LineFigure;
use serde::Serialize;

use super::along_rail::{check_sampling, check_step};
use super::{Run, refused, remarks};
use crate::{Answer, AnswerError, Result, ResultFile, Table};
use band::Band;
use bands::Bands;
use inputs::Inputs;
use linear::Linear;
use stages::Stages;
use state::{EvolutionState, Stage, WornProfile};

/// A rail and how it is rolled over.
#[derive(Clone)]
pub struct EvolutionRequest {
    /// The wheels that pass, such as that of the case at one speed.
    pub traffic: Traffic,
    /// The rail before any wheel.
    pub surface: Surface,
    /// Longest step of the marches \[m\].
    pub largest_step: f64,
    /// The wheels feel the mean over their patch in the place of the height.
    pub contact_filter: bool,
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

    /// The [ring](Sinusoid::ring) of a sinusoid.
    ///
    /// # Errors
    /// [`riffel::Error::OutOfRange`] for a wavelength that is not positive.
    pub fn of_sinusoid(sinusoid: Sinusoid, bay: Option<f64>) -> Result<Self> {
        Ok(Self::Ring(sinusoid.ring(bay)?))
    }
}

/// A rail on its way to a number of passages.
///
/// What was asked is given once, the work is done by [`go_on`](Self::go_on) step by step, and between two steps the run may be
/// saved and left. A run resumed from its [`state`](Self::state) is the same run, bit for bit.
pub struct EvolutionRun {
    case: Case,
    vehicles: Vec<VehicleInTime>,
    step: EvolutionStep,
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
    /// [`CaseError`](riffel_keys::CaseError) as of [`ask::in_time`](riffel_case::ask::in_time), for a profile coarser than the patch is long, for a record shorter than the motion remembers
    /// or than four of the longest waves kept, and for a ring on discrete supports that is not of whole bays.
    pub fn new(case: &Case, request: EvolutionRequest) -> Result<Self> {
        /// Mean square of a band that is nothing but rounding \[m²\].
        const STILL: f64 = 1e-30;
        check_step(request.largest_step)?;
        let mut vehicles = request.traffic.in_time(case)?;
        if request.contact_filter {
            for vehicle in &mut vehicles {
                let filter = Some(ContactFilter::of(&vehicle.case.hertz));
                let wheels = vehicle.wheels.iter_mut();
                wheels.for_each(|wheel| wheel.model.contact_filter = filter);
            }
        }
        let wheels = || vehicles.iter().flat_map(|vehicle| &vehicle.wheels);
        let evolution = match &request.surface {
            Surface::Record(record) => {
                check_sampling(case, record)?;
                let longest = f64::max(Self::LONGEST_KEPT, 1.3 * case.wavelength.max());
                check_length(record, longest)?;
                Evolution::of_record(record, longest, case.track.support_spacing()).map_err(refused("--profile"))?
            }
            Surface::Ring(ring) => Evolution::new(ring),
        };
        // What the patch of any of them covers does not wear.
        let shortest = wheels().map(|wheel| wheel.wear.shortest).fold(0.0, f64::max);
        let length = evolution.heights().len() as f64 * evolution.spacing();
        if let Some(bay) = case.track.support_spacing() {
            check_bays(length, bay)?;
        }
        let bands = Bands::new(case, shortest, evolution.heights().len(), length);
        // Harmonics of a wave come of themselves, and what supports print: but there must be something to begin with.
        let is_still = bands.mean_squares(&evolution.waves()).iter().all(|square| *square < STILL);
        if bands.count() == 0 || is_still && case.track.support_spacing().is_none() {
            return Err(AnswerError::argument(
                "--passages",
                "given",
                format!(
                    "left out: the profile has no wave in map.wavelength of the case, {:.1} to {:.1} mm, that is longer than \
                     the patch, {:.1} mm",
                    1e3 * case.wavelength.min(),
                    1e3 * case.wavelength.max(),
                    1e3 * shortest
                ),
            ));
        }
        let inputs = Inputs::new(case, &request);
        Ok(Self {
            case: case.clone(),
            state: EvolutionState::new(inputs, &evolution, &bands),
            step: EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: request.largest_step },
            vehicles,
            bands,
            evolution,
        })
    }

    /// Go on from where a run was left; `text` is its [`state`](Self::state).
    ///
    /// # Errors
    /// A sentence that names what differs, where that was not the same run.
    pub fn resume(&mut self, text: &str) -> Result<(), String> {
        let state: EvolutionState =
            serde_json::from_str(text).map_err(|error| format!("it is not the state of a run: {error}"))?;
        if let Some([key, own, others]) = self.state.inputs.difference(&state.inputs) {
            return Err(format!("it was begun by another run: {key} is {own} here and was {others} there"));
        }
        let first = state.profiles.entries.first().unwrap_or(&state.profile);
        if first.heights_m != self.evolution.heights() || state.spacing_m != self.state.spacing_m {
            return Err("it was begun by another run: the profile is another here than there".to_owned());
        }
        state.check(self.state.reached.shifts_m.len())?;
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
    /// Errors of a march.
    pub fn go_on(&mut self, passages: u64) -> Result<Option<EvolutionAnswer>> {
        let mut state = self.state.clone();
        if self.passages() < passages && !state.reached.is_airborne() {
            let most = passages - self.passages();
            let mut evolution = self.evolution.clone();
            let wheels: Vec<&PassingWheel> = self.wheels().collect();
            let extremes = evolution.advance(&wheels, &self.step, most).map_err(refused("--passages"))?;
            state.reach(state.next(&self.evolution, &evolution, extremes, &self.bands));
            if evolution.passages() < passages {
                self.evolution = evolution;
                self.state = state;
                return Ok(None);
            }
        }
        self.answer(state).map(Some)
    }

    fn wheels(&self) -> impl Iterator<Item = &PassingWheel> {
        self.vehicles.iter().flat_map(|vehicle| &vehicle.wheels)
    }

    fn answer(&self, state: EvolutionState) -> Result<EvolutionAnswer> {
        let EvolutionState { stages, profiles, reached, profile, spacing_m, .. } = state;
        let stages: Vec<Stage> = stages.entries.into_iter().chain([reached]).collect();
        let profiles: Vec<WornProfile> = profiles.entries.into_iter().chain([profile]).collect();
        let last = &stages[stages.len() - 1];
        let tracks = self.wheels().map(|wheel| &wheel.model);
        let worst = tracks.max_by(|one, other| one.structures.share_cut().total_cmp(&other.structures.share_cut()));
        let airborne = last.is_airborne();
        let airborne = airborne.then(|| remarks::of_air(last.passages));
        let passing = self.wheels().map(|wheel| wheel.share * wheel.model.speed);
        let linear = Linear::new(&self.vehicles, &self.bands, &profiles[0].heights_m, spacing_m)?;
        let own_remarks = worst.and_then(remarks::of_track).into_iter().chain(airborne);
        // Extremes of a stage are those of the first passage after the one before.
        let lifted = stages.windows(2).find(|pair| {
            let after = pair[1].extremes.as_ref();
            after.is_some_and(|passage| passage.contact_loss_fraction > 0.0)
        });
        let bands = linear.bands().iter().enumerate();
        Ok(EvolutionAnswer {
            speed_m_per_s: passing.sum(),
            vehicles: self.vehicles.iter().map(PassingVehicle::of).collect(),
            step_m: spacing_m / (spacing_m / self.step.largest_step).ceil().max(1.0),
            length_m: profiles[0].heights_m.len() as f64 * spacing_m,
            passages: last.passages,
            mean_depth_m: last.mean_depth_m,
            first_contact_loss_passages: lifted.map(|pair| pair[0].passages),
            track_share_cut: worst.map_or(0.0, |track| track.structures.share_cut()),
            bands: bands.map(|(index, linear)| Band::new(index, &stages, linear)).collect(),
            stages: Stages::new(&stages),
            spacing: spacing_m,
            profiles,
            linear,
            run: Run::new(&self.case, own_remarks, &self.case.remarks),
        })
    }
}

/// `Ok` if a record is long enough to be joined, four of the longest waves kept \[m\].
fn check_length(record: &Profile, longest: f64) -> Result<()> {
    let least = 4.0 * longest;
    if record.length() >= least {
        return Ok(());
    }
    Err(AnswerError::argument(
        "--profile",
        format!("{:.3} m long", record.length()),
        format!("at least {least:.1} m long, four of the longest waves that are kept, so that its ends can be joined"),
    ))
}

/// `Ok` if a ring \[m\] is of whole bays \[m\].
fn check_bays(length: f64, bay: f64) -> Result<()> {
    let bays = length / bay;
    if (bays - bays.round()).abs() <= 1e-6 && bays > 0.5 {
        return Ok(());
    }
    Err(AnswerError::argument(
        "--length",
        format!("{length} m"),
        format!(
            "a whole number of support spacings of {bay} m for a rail that goes on where it ends, such as {:.3} m",
            bays.ceil() * bay
        ),
    ))
}

/// A kind of wheel that passed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct PassingVehicle {
    /// Name of the vehicle.
    pub name: String,
    /// Its share of the passages.
    pub share: f64,
    /// Part of these under traction.
    pub traction_share: f64,
    /// Normal load of a wheel.
    pub normal_load_n: f64,
    /// Tractive ratio of those under traction.
    pub tractive_ratio: f64,
    /// Mean of its speed.
    pub speed_m_per_s: f64,
    /// Standard deviation of its speed.
    pub speed_deviation_m_per_s: f64,
    /// Speeds at which it was followed.
    pub speeds: usize,
}

impl PassingVehicle {
    fn of(vehicle: &VehicleInTime) -> Self {
        let [speed_m_per_s, speed_deviation_m_per_s] = vehicle.speed;
        Self {
            name: vehicle.name.clone(),
            share: vehicle.share,
            traction_share: vehicle.wheels.first().map_or(1.0, |wheel| wheel.traction_share),
            normal_load_n: vehicle.case.steady.normal_force,
            tractive_ratio: vehicle.case.steady.tractive_ratio(),
            speed_m_per_s,
            speed_deviation_m_per_s,
            speeds: vehicle.wheels.len(),
        }
    }
}

/// A rail after many wheels: serialised, what `riffel simulate --passages --json` prints.
#[derive(Serialize)]
pub struct EvolutionAnswer {
    /// Mean of the passages.
    speed_m_per_s: f64,
    /// That passed.
    vehicles: Vec<PassingVehicle>,
    /// Of the marches.
    step_m: f64,
    /// Of the ring.
    length_m: f64,
    passages: u64,
    /// Worn off everywhere.
    mean_depth_m: f64,
    /// Wheels before the first passage that is known to have lost contact, of those at the stages; `None` if none has.
    first_contact_loss_passages: Option<u64>,
    /// Mean square of the relative error of the track in time.
    track_share_cut: f64,
    /// From before any wheel to the last.
    stages: Stages,
    /// The shortest wavelength first.
    bands: Vec<Band>,
    /// Distance of heights \[m\].
    #[serde(skip)]
    pub spacing: f64,
    /// From before any wheel to the last.
    #[serde(skip)]
    pub profiles: Vec<WornProfile>,
    /// The march; it keeps no courses, there are too many.
    #[serde(skip)]
    pub run: Run,
    #[serde(skip)]
    linear: Linear,
}

impl Answer for EvolutionAnswer {
    fn name(&self) -> &'static str {
        "spectrum"
    }
    fn document_name(&self) -> &'static str {
        "evolution.json"
    }

    fn introduction(&self) -> Vec<Message> {
        words::introduction(self)
    }

    fn tables(&self) -> Vec<Table> {
        vec![words::bands(&self.bands), self.bands_table(), self.profiles_table()]
    }

    fn sentences(&self) -> Vec<Message> {
        words::sentences(self)
    }

    fn figure(&self) -> LineFigure {
        self.spectrum_figure()
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let figures = [
            ResultFile::Lines(self.name(), self.figure()),
            ResultFile::Lines("profile", self.profile_figure()),
            ResultFile::Stages("passages", self.stage_figures()),
        ];
        let grid = ResultFile::Grid("evolution", self.grid());
        figures.into_iter().chain(ResultFile::tables(self.tables())).chain([grid]).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.run.remarks
    }
}
