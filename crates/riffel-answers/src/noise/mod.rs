//! Rolling noise of a train on a rough rail, and what would make it quieter.

mod figure;
mod level_trend;
mod measure;
mod over_posterior;
mod question;
mod remarks;
mod since;
mod sources;
mod tables;
mod train;

use riffel_case::Case;
use riffel_keys::{Language, Message, say};
use riffel_noise::{Energies, Part};
use riffel_plot::LineFigure;
use serde::Serialize;

pub use level_trend::LevelTrend;
pub use measure::Measure;
pub use question::{DecayRates, NoiseQuestion};
pub use since::Since;
pub(crate) use since::at_least;
pub(crate) use tables::name_of;

use crate::parameters::parameters_in;
use crate::{Answer, OverPosterior, Table};

/// Levels beside the track, and what would lower them. Levels of pressure in dB re 20 µPa, of power in dB re 1 pW.
#[derive(Debug, Serialize)]
pub struct NoiseAnswer {
    /// Version of the program.
    pub riffel_version: &'static str,
    /// Speed of the train.
    pub speed_m_per_s: f64,
    /// Wheels of the train on one rail.
    pub wheels: u32,
    /// Length of the train.
    pub train_length_m: f64,
    /// Distance of the receiver from the middle of the track.
    pub distance_m: f64,
    /// Height of the receiver above the rail.
    pub height_m: f64,
    /// Name of the roughness of the wheels; null for smooth ones.
    pub wheel_roughness: Option<String>,
    /// Name of the modes of the wheels; null for rigid ones.
    pub wheel_modes: Option<String>,
    /// Nominal centres of the bands.
    pub frequency_hz: Vec<f64>,
    /// Highest band, where sums over bands end below 2 kHz and are lower bounds; null where they reach it.
    pub lower_bound_up_to_hz: Option<f64>,
    /// Over the passage of the train.
    pub level: Levels,
    /// Levels under the roughness of before; null if none was given.
    pub before: Option<Levels>,
    /// What has changed since before, over the bands that both have; null where there is nothing to compare.
    pub since: Option<Since>,
    /// Of one wheel with the rail and the sleepers under it.
    pub sound_power_level: Levels,
    /// Null without transfer functions.
    pub by_transfer_functions: Option<TransferLevels>,
    /// Of the whole passage, dB(A) re (20 µPa)² s.
    pub sound_exposure_level_dba: f64,
    /// What would help, each by itself.
    pub measures: Vec<Measure>,
    /// Null without traffic.
    pub course: Option<LevelTrend>,
    /// Nominal centres of the bands that are not known.
    pub left_out_hz: Vec<f64>,
    /// Levels over the draws of a calibration, if one was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_posterior: Option<OverPosterior>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
    /// These, and what the reader should know of the record and the case.
    #[serde(skip)]
    all_remarks: Vec<Message>,
    #[serde(skip)]
    title: Option<String>,
    #[serde(skip)]
    parameters: String,
}

impl NoiseAnswer {
    /// The level and what each measure saves over the draws of a calibration; nothing without one.
    pub(crate) fn over_posterior_in_words(&self) -> Vec<Message> {
        over_posterior::in_words(self)
    }

    /// The picture in a language; the case is that of which the answer is.
    pub(crate) fn figure_of(&self, case: &Case, language: Language) -> LineFigure {
        figure::figure(self, &parameters_in(case, language), language)
    }

    pub(crate) fn measures_table(&self) -> Table {
        tables::measures(self)
    }
}

/// Levels of the parts in bands and over all of them; null if a part radiates nothing.
#[derive(Debug, Serialize)]
pub struct Levels {
    /// Rail, by band.
    pub rail_db: Vec<Option<f64>>,
    /// Sleepers, by band.
    pub sleepers_db: Vec<Option<f64>>,
    /// Wheel, by band.
    pub wheel_db: Vec<Option<f64>>,
    /// All of it, by band.
    pub total_db: Vec<Option<f64>>,
    /// Rail, all bands.
    pub rail_dba: Option<f64>,
    /// Sleepers, all bands.
    pub sleepers_dba: Option<f64>,
    /// Wheel, all bands.
    pub wheel_dba: Option<f64>,
    /// All of it, all bands.
    pub total_dba: Option<f64>,
}

impl From<&Energies> for Levels {
    fn from(energies: &Energies) -> Self {
        Self {
            rail_db: energies.levels(Part::Rail),
            sleepers_db: energies.levels(Part::Sleepers),
            wheel_db: energies.levels(Part::Wheel),
            total_db: energies.levels(Part::Total),
            rail_dba: energies.a_weighted(Part::Rail),
            sleepers_dba: energies.a_weighted(Part::Sleepers),
            wheel_dba: energies.a_weighted(Part::Wheel),
            total_dba: energies.a_weighted(Part::Total),
        }
    }
}

impl Levels {
    /// Levels of a part in bands, and the A-weighted one over all.
    pub(crate) fn of(&self, part: Part) -> (&Vec<Option<f64>>, Option<f64>) {
        match part {
            Part::Rail => (&self.rail_db, self.rail_dba),
            Part::Sleepers => (&self.sleepers_db, self.sleepers_dba),
            Part::Wheel => (&self.wheel_db, self.wheel_dba),
            Part::Total => (&self.total_db, self.total_dba),
        }
    }
}

/// Levels by the transfer functions of the directive.
#[derive(Debug, Serialize)]
pub struct TransferLevels {
    /// Transfer function of the track.
    pub track: String,
    /// Transfer function of the vehicle.
    pub vehicle: String,
    /// Nominal centres of the bands.
    pub frequency_hz: Vec<f64>,
    /// Of the track, by band.
    pub track_db: Vec<Option<f64>>,
    /// Of the vehicle, by band.
    pub vehicle_db: Vec<Option<f64>>,
    /// All of it, by band.
    pub total_db: Vec<Option<f64>>,
    /// All of it, all bands.
    pub total_dba: Option<f64>,
}

/// Nominal centres of bands \[Hz\].
fn nominal(levels: &Energies) -> Vec<f64> {
    let bands = levels.bands.iter();
    bands.map(|band| band.band.nominal()).collect()
}

impl Answer for NoiseAnswer {
    fn name(&self) -> &'static str {
        "noise"
    }

    fn introduction(&self) -> Vec<Message> {
        tables::introduction(self)
    }

    fn tables(&self) -> Vec<Table> {
        let posterior = self.over_posterior.iter().map(OverPosterior::table);
        tables::tables(self).into_iter().chain(posterior).collect()
    }

    fn sentences(&self) -> Vec<Message> {
        let bound = self.lower_bound_up_to_hz;
        let course = self.course.iter().map(|course| course.in_words(bound));
        let bounded = bound.zip(self.level.total_dba);
        let bounded = bounded.map(|(_, level)| say!(noise_is_lower_bound, level = at_least(level, bound)));
        let since = self.since.iter().map(Since::in_words);
        bounded.into_iter().chain(since).chain(course).chain(self.over_posterior_in_words()).collect()
    }

    fn figure(&self) -> LineFigure {
        figure::figure(self, &self.parameters, Language::English)
    }

    fn remarks(&self) -> &[Message] {
        &self.all_remarks[..]
    }
}
