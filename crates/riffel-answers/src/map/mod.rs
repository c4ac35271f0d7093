//! Growth over wavelength and speed.

mod bay;
mod over_posterior;
mod panel;
mod table;

use riffel::growth::RidgePoint;
use riffel::{GrowthMap, Ridge};
use riffel_case::Case;
use riffel_case::file::CaseFile;
use riffel_keys::Message;
use riffel_plot::{MapFigure, Observation};
use serde::Serialize;

use crate::ridge::{BranchDocument, RidgePointDocument, best_fit_frequency, ridge_of};
use crate::stability::StabilityAtSpeed;
use crate::{LineGrowth, OverPosterior, WearLimitDocument};

pub use bay::{BayDocument, BayGrowth};
pub use over_posterior::{growth_in_words, growth_over};
pub use panel::{Shown, map_figure, panel};
pub use table::{map_csv, map_netcdf};

/// The growth map of a case with its ridge.
pub struct MapAnswer {
    /// Ŵ₁ over the window of the case.
    pub map: GrowthMap,
    /// Its ridge.
    pub ridge: Ridge,
    /// The branches of the ridge, the strongest first.
    pub branches: Vec<BranchDocument>,
    /// Growth over the sleeper bay, where it was asked for.
    pub bay: Option<BayGrowth>,
    /// What grows fastest under the traffic of the line, where it was asked for.
    pub under_traffic: Option<LineGrowth>,
    /// Growth under the traffic over the draws of a calibration, where one was given.
    pub over_posterior: Option<OverPosterior>,
    /// How many observations were laid over the map, where there were any.
    pub observations: Option<ObservationCount>,
}

/// Measured wavelengths laid over a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct ObservationCount {
    /// All of them.
    pub count: usize,
    /// Those that lie outside the window of the map.
    pub outside_window: usize,
}

impl ObservationCount {
    /// Of the map of a case.
    pub fn new(case: &Case, observations: &[Observation]) -> Self {
        let wavelengths = case.wavelength.min()..=case.wavelength.max();
        let speeds = case.speed.min()..=case.speed.max();
        let outside = |observation: &&Observation| {
            !wavelengths.contains(&observation.wavelength_m) || !speeds.contains(&observation.speed_m_per_s)
        };
        Self { count: observations.len(), outside_window: observations.iter().filter(outside).count() }
    }

    /// As in "3 observations, 1 outside the map".
    pub fn sentence(self) -> String {
        let noun = match self.count {
            1 => "observation",
            _ => "observations",
        };
        match self.outside_window {
            0 => format!("{} {noun}", self.count),
            outside => format!("{} {noun}, {outside} outside the map", self.count),
        }
    }
}

/// What `riffel map --json` prints.
#[derive(Serialize)]
pub struct MapDocument<'a> {
    riffel_version: &'static str,
    /// The case after presets, defaults and overrides; reads back as a case.
    inputs: &'a CaseFile,
    derived: DerivedDocument,
    #[serde(skip_serializing_if = "Option::is_none")]
    under_traffic: Option<&'a LineGrowth>,
    #[serde(skip_serializing_if = "Option::is_none")]
    over_posterior: Option<&'a OverPosterior>,
    ridge: RidgeSummary<'a>,
    /// For the highest growth of the ridge, of one wheel of this kind on one line of the rail.
    #[serde(flatten)]
    wear_limit: WearLimitDocument,
    /// At the speeds judged; none for one wheel and one axis.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    stability: Vec<StabilityAtSpeed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bay: Option<BayDocument>,
    #[serde(skip_serializing_if = "Option::is_none")]
    observations: Option<ObservationCount>,
    remarks: &'a [Message],
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
struct RidgeSummary<'a> {
    /// That of the strongest branch.
    best_fit_frequency_hz: Option<f64>,
    /// The strongest first.
    branches: &'a [BranchDocument],
    highest: Option<RidgePointDocument>,
    speeds_that_grow: usize,
    speeds_at_edge: usize,
    speeds: usize,
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
        let map = GrowthMap::compute(&case.feedback, case.wavelength, case.speed, progress);
        let ridge = ridge_of(case, &case.feedback);
        Self {
            branches: BranchDocument::all(case, &ridge),
            map,
            ridge,
            bay: None,
            under_traffic: None,
            over_posterior: None,
            observations: None,
        }
    }

    /// The map as a figure, with what was observed.
    pub fn figure(&self, case: &Case, observations: Vec<Observation>) -> MapFigure {
        map_figure(case, &self.map, &self.ridge, observations)
    }

    /// The map as data: what `riffel map --json` prints.
    pub fn document<'a>(&'a self, case: &'a Case) -> MapDocument<'a> {
        let ridge = &self.ridge;
        let grows = |point: &&RidgePoint| point.growth_rate > 0.0;
        MapDocument {
            riffel_version: env!("CARGO_PKG_VERSION"),
            inputs: &case.file,
            derived: DerivedDocument::of(case),
            under_traffic: self.under_traffic.as_ref(),
            over_posterior: self.over_posterior.as_ref(),
            ridge: RidgeSummary {
                best_fit_frequency_hz: best_fit_frequency(ridge),
                branches: &self.branches,
                highest: ridge.highest().filter(grows).map(RidgePointDocument::from),
                speeds_that_grow: ridge.points.iter().filter(grows).count(),
                speeds_at_edge: ridge.points.iter().filter(|point| point.at_edge).count(),
                speeds: ridge.points.len(),
            },
            wear_limit: WearLimitDocument::new(case, ridge.highest().map(|point| point.growth_rate)),
            stability: (case.stability_over_the_map().into_iter()).map(StabilityAtSpeed::from).collect(),
            bay: self.bay.as_ref().map(BayGrowth::summary),
            observations: self.observations,
            remarks: &case.remarks,
        }
    }
}
