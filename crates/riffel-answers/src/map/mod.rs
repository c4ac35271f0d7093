//! Growth over wavelength and speed.

mod bay;
pub(crate) mod observations;
mod over_posterior;
mod panel;
mod ridge_map;
mod table;

use riffel::growth::RidgePoint;
use riffel_case::{Case, ask};
use riffel_keys::{Message, fixed, number, say};
use riffel_plot::{MapFigure, Observation};
use serde::Serialize;

use crate::answer::{inputs, titled};
use crate::capital::as_sentence;
use crate::ridge::{BranchDocument, RidgePointDocument, best_fit_frequency, branches_table, ridge_table};
use crate::stability::StabilityAtSpeed;
use crate::{Answer, LineGrowth, OverPosterior, ResultFile, Table, WearLimitDocument, for_whom};

pub use bay::BayGrowth;
pub use over_posterior::{growth_in_words, growth_over};
pub use panel::{Shown, map_figure, panel};
pub use ridge_map::RidgeMap;
pub use table::map_csv;

/// The growth map of a case with its ridge: serialised, what `riffel map --json` prints.
#[derive(Serialize)]
pub struct MapAnswer {
    riffel_version: &'static str,
    /// After presets, defaults and overrides; reads back as a case.
    #[serde(rename = "inputs", serialize_with = "inputs")]
    case: Case,
    derived: DerivedDocument,
    /// What grows fastest under the traffic of the line, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub under_traffic: Option<LineGrowth>,
    /// Growth under the traffic over the draws of a calibration, where one was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_posterior: Option<OverPosterior>,
    ridge: RidgeSummary,
    /// For the highest growth of the ridge, of one wheel of this kind on one line of the rail.
    #[serde(flatten)]
    wear_limit: WearLimitDocument,
    /// At the speeds judged; none for one wheel and one axis.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    stability: Vec<StabilityAtSpeed>,
    /// Growth over the sleeper bay, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bay: Option<BayGrowth>,
    #[serde(skip_serializing_if = "Option::is_none")]
    observations: Option<ObservationCount>,
    remarks: Vec<Message>,
    /// The map itself.
    #[serde(skip)]
    pub on: RidgeMap,
    /// Laid over the map.
    #[serde(skip)]
    marks: Vec<Observation>,
}

/// Measured wavelengths laid over a map.
#[derive(Debug, Clone, Copy, Serialize)]
struct ObservationCount {
    count: usize,
    /// Those that lie outside the window of the map.
    outside_window: usize,
}

impl ObservationCount {
    /// Of the map of a case.
    fn new(case: &Case, observations: &[Observation]) -> Self {
        let wavelengths = case.wavelength.min()..=case.wavelength.max();
        let speeds = case.speed.min()..=case.speed.max();
        let outside = |observation: &&Observation| {
            !wavelengths.contains(&observation.wavelength_m) || !speeds.contains(&observation.speed_m_per_s)
        };
        Self { count: observations.len(), outside_window: observations.iter().filter(outside).count() }
    }

    /// Number of observations in words, "3 observations, 1 outside the map".
    fn sentence(self) -> Message {
        let all = say!(so_many_observations, count = self.count);
        match self.outside_window {
            0 => all,
            outside => say!(observations_outside, all, outside = number(outside)),
        }
    }
}

/// What follows from a case, whatever the window of its map.
#[derive(Serialize)]
pub struct DerivedDocument {
    semi_axis_longitudinal_m: f64,
    semi_axis_lateral_m: f64,
    /// Of the paper's creep law only.
    #[serde(skip_serializing_if = "Option::is_none")]
    creep_coefficient: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    saturation_creepage: Option<f64>,
    creepage: f64,
    tractive_ratio: f64,
    contact_stiffness_n_per_m: f64,
    mean_dissipation_j_per_m: f64,
}

#[derive(Serialize)]
struct RidgeSummary {
    /// That of the strongest branch.
    best_fit_frequency_hz: Option<f64>,
    /// The strongest first.
    branches: Vec<BranchDocument>,
    highest: Option<RidgePointDocument>,
    speeds_that_grow: usize,
    speeds_at_edge: usize,
    speeds: usize,
}

impl RidgeSummary {
    fn new(RidgeMap { ridge, branches, .. }: &RidgeMap) -> Self {
        let grows = |point: &&RidgePoint| point.growth_rate > 0.0;
        Self {
            best_fit_frequency_hz: best_fit_frequency(ridge),
            branches: branches.clone(),
            highest: ridge.highest().filter(grows).map(RidgePointDocument::from),
            speeds_that_grow: ridge.points.iter().filter(grows).count(),
            speeds_at_edge: ridge.points.iter().filter(|point| point.at_edge).count(),
            speeds: ridge.points.len(),
        }
    }
}

impl DerivedDocument {
    /// Of a case.
    pub fn of(case: &Case) -> Self {
        let steady = case.steady;
        let slope = case.law.as_ref().and_then(|law| law.own_slope());
        Self {
            semi_axis_longitudinal_m: case.hertz.semi_axis_longitudinal(),
            semi_axis_lateral_m: case.hertz.semi_axis_lateral(),
            creep_coefficient: slope.map(|slope| slope.creep_coefficient),
            saturation_creepage: slope.map(|slope| slope.saturation_creepage),
            creepage: steady.creepages.longitudinal,
            tractive_ratio: steady.tractive_ratio(),
            contact_stiffness_n_per_m: case.feedback.contacts()[0].stiffness,
            mean_dissipation_j_per_m: steady.energy_per_metre(),
        }
    }
}

impl MapAnswer {
    /// The map over the window of the case; `progress` is told of rows done, one for each speed.
    pub fn new(case: &Case, progress: impl Fn(usize) + Sync) -> Self {
        let on = RidgeMap::new(case, progress);
        Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            derived: DerivedDocument::of(case),
            under_traffic: None,
            over_posterior: None,
            ridge: RidgeSummary::new(&on),
            wear_limit: WearLimitDocument::new(case, on.ridge.highest().map(|point| point.growth_rate)),
            stability: (ask::stability_over_the_map(case).into_iter()).map(StabilityAtSpeed::from).collect(),
            bay: None,
            observations: None,
            remarks: case.remarks.clone(),
            case: case.clone(),
            on,
            marks: Vec::new(),
        }
    }

    /// Map with what was observed on it.
    #[must_use]
    pub fn with_observations(self, marks: Vec<Observation>) -> Self {
        Self { observations: Some(ObservationCount::new(&self.case, &marks)), marks, ..self }
    }

    /// The map as a figure, with what was observed.
    pub fn map_figure(&self) -> MapFigure {
        map_figure(&self.case, &self.on.map, &self.on.ridge, self.marks.clone())
    }
}

impl Answer for MapAnswer {
    fn name(&self) -> &'static str {
        "map"
    }

    fn introduction(&self) -> Vec<Message> {
        let title = titled(self.case.file.title.as_ref(), say!(growth_map));
        let under_traffic = self.under_traffic.iter().flat_map(|it| it.remarks.clone());
        let over = self.over_posterior.iter().flat_map(growth_in_words);
        let remarks = under_traffic.chain(over).map(|remark| as_sentence(&remark));
        let window = say!(
            highest_at_each_speed,
            shortest = fixed(1e3 * self.case.wavelength.min(), 0),
            longest = fixed(1e3 * self.case.wavelength.max(), 0)
        );
        [title].into_iter().chain(remarks).chain([window]).collect()
    }

    fn tables(&self) -> Vec<Table> {
        let RidgeMap { ridge, .. } = &self.on;
        let of_ridge =
            [table::shown(&self.case, ridge), ridge_table("ridge", ridge), branches_table("branches", ridge)];
        of_ridge.into_iter().chain(self.over_posterior.as_ref().map(OverPosterior::table)).collect()
    }

    fn sentences(&self) -> Vec<Message> {
        let growth = [for_whom(&self.case), BranchDocument::sentence(&self.ridge.branches)];
        let bay = self.bay.iter().flat_map(BayGrowth::sentences);
        let observations = self.observations.map(ObservationCount::sentence);
        growth.into_iter().chain(bay).chain(observations).collect()
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let figure = self.map_figure();
        let grid = table::grid(&self.on.map, figure.title.clone());
        let own = [
            ResultFile::Maps(self.name(), figure),
            ResultFile::Map(self.name(), &self.on.map),
            ResultFile::Grid(self.name(), grid),
        ];
        let bay = self.bay.iter().flat_map(|bay| bay.files(&self.case));
        own.into_iter().chain(ResultFile::tables(self.tables())).chain(bay).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
