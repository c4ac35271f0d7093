//! Rolling noise of a train on a rough rail, and what would make it quieter.

mod course;
mod figure;
mod measure;
mod over_posterior;
mod remarks;
mod since;
mod sources;
mod tables;

use std::path::Path;

use riffel::error::readable;
use riffel::noise::{Energies, FrequencyBand, Part, PassBy, Surroundings, WheelModes};
use riffel::roughness::{LevelLimit, Spectrum};
use riffel_case::traffic::Traffic;
use riffel_case::{Case, TrackRadiator};
use riffel_keys::{Language, Message, PhysicalRange, say};
use riffel_plot::LineFigure;
use riffel_rail::{
    LimitTable, RailDates, TransferPart, TransferTable, WheelModesTable, WheelRoughness, levels_unlike_a_rail,
};
use serde::Serialize;

pub use course::Course;
pub use measure::Measure;
pub use since::Since;
pub(crate) use since::at_least;
use since::lower_bound_up_to;
pub(crate) use tables::name_of;

use crate::forecast::ForecastHorizon;
use crate::parameters::parameters_in;
use crate::{Answer, AnswerError, OverPosterior, PosteriorDraws, Table, parameters};

/// Least length of train to a wheel on one rail \[m\]: wheels follow each other at more than their diameter.
const LEAST_PER_WHEEL: f64 = 0.5;

/// The roughness of the wheels.
#[derive(Debug, Clone, PartialEq)]
pub enum RoughWheels {
    /// A table that comes with Riffel, or a file of spectra.
    Named(String),
    /// Levels.
    Given(Spectrum),
}

/// What is asked of rolling noise; numbers are SI.
#[derive(Clone)]
pub struct NoiseQuestion {
    /// Speed of the train.
    pub speed: f64,
    /// Roughness of the rail.
    pub roughness: Spectrum,
    /// Its records at several dates, by which it goes on growing.
    pub history: Option<RailDates>,
    /// What it was before, as before grinding.
    pub before: Option<Spectrum>,
    /// Names of the rails of which the roughness is the mean, where they are several.
    pub rails: Vec<String>,
    /// Roughness of the wheels; none for smooth ones.
    pub wheel_roughness: Option<RoughWheels>,
    /// Modes of the web and tyre of the wheels, by name or file; none for rigid wheels.
    pub wheel_modes: Option<String>,
    /// Rail and sleepers as radiators.
    pub radiator: TrackRadiator,
    /// Transfer functions of track and vehicle, by name or file, for the level by the directive beside that by the model.
    pub transfer: Option<[String; 2]>,
    /// What the rail may be ground to, by name or file.
    pub limit: String,
    /// Wheels of the train on one rail.
    pub wheels: u32,
    /// Length of the train; 6.6 m for each wheel if left out.
    pub train_length: Option<f64>,
    /// Distance of the receiver from the middle of the track.
    pub distance: f64,
    /// Height of the receiver over the rail head.
    pub height: f64,
    /// What is around track and receiver.
    pub surroundings: Surroundings,
    /// Traffic under which the rail changes.
    pub traffic: Option<Traffic>,
    /// How far to look ahead under it \[months\].
    pub months: f64,
    /// Highest level that is allowed \[dB(A)\].
    pub limit_dba: Option<f64>,
}

impl NoiseQuestion {
    /// A coach on four wheelsets with smooth wheels, 7.5 m from the track and 1.2 m above the rail, as ISO 3095 measures, on a rail
    /// with a foot of 150 mm and sleepers of which 0.33 m² belong to each rail.
    pub fn of_a_coach(speed: f64, roughness: Spectrum, limit: String) -> Self {
        Self {
            speed,
            roughness,
            history: None,
            rails: Vec::new(),
            before: None,
            wheel_roughness: None,
            wheel_modes: None,
            radiator: TrackRadiator::default(),
            transfer: None,
            limit,
            wheels: 4,
            train_length: None,
            distance: 7.5,
            height: 1.2,
            surroundings: Surroundings::HardGround,
            traffic: None,
            months: 12.0,
            limit_dba: None,
        }
    }

    fn length(&self) -> f64 {
        let length = PassBy::LENGTH_PER_WHEEL * f64::from(self.wheels);
        self.train_length.unwrap_or(length)
    }

    /// `Ok` where every number is within its physical range, whoever asks.
    fn check(&self) -> Result<(), AnswerError> {
        let wrong = |argument, value: String, rule: String| Err(AnswerError::Argument { argument, value, rule });
        if self.distance.is_nan() || self.distance <= PassBy::NEAREST {
            let rule = "beyond the rail, 0.75 m".to_owned();
            return wrong("--distance", format!("{} m", self.distance), rule);
        }
        for (argument, value, unit) in [
            ("--speed", self.speed, "m/s"),
            ("--distance", self.distance, "m"),
            ("--height", self.height, "m"),
            ("--train-length", self.length(), "m"),
            ("--rail-foot", self.radiator.rail_foot, "m"),
            ("--sleeper-area", self.radiator.sleeper_area, "m²"),
        ] {
            if let Some(range) = PhysicalRange::of(argument) {
                let [low, high] = range.hard;
                if !(value >= low && value <= high) {
                    let rule = format!("between {low} and {high} {unit}");
                    return wrong(argument, format!("{value} {unit}"), rule);
                }
            }
        }
        let shortest = LEAST_PER_WHEEL * f64::from(self.wheels);
        if self.length() < shortest {
            let rule = format!("at least {shortest} m, half a metre to each of {} wheels", self.wheels);
            return wrong("--train-length", format!("{} m", self.length()), rule);
        }
        match self.traffic {
            Some(_) => ForecastHorizon::Months(self.months).check(),
            None => Ok(()),
        }
    }

    /// The answer on a case; `progress` is called after each vehicle of the traffic.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] where a number is outside its range, no band is known, or the track has no decay;
    /// [`AnswerError::Case`] with the key or the file at fault.
    pub fn answer(&self, case: &Case, progress: &(dyn Fn(usize) + Sync)) -> Result<NoiseAnswer, AnswerError> {
        if let (None, Some(why)) = (&self.radiator.decay_rate, case.without_decay()) {
            return Err(AnswerError::Argument {
                argument: "--decay-rate",
                value: "left out".to_owned(),
                rule: format!("given: {why}"),
            });
        }
        self.check()?;
        let train = Train::new(self)?;
        let radiation = train.radiation(case, train.wheel_modes(), self.speed)?;
        let powers = train.powers(&radiation, &self.roughness)?;
        let levels = train.heard(&powers);
        if levels.bands.is_empty() {
            // Where the roughness fills bands that are heard, it is the decay rates that are missing.
            if let Some(rates) = &self.radiator.decay_rate
                && self.fills_a_band()
            {
                let known = || rates.iter().map(|(band, _)| band.nominal());
                let [from, to] = [known().next(), known().next_back()].map(Option::unwrap_or_default);
                return Err(AnswerError::Argument {
                    argument: "--decay-rate",
                    value: format!("known from {} to {} Hz", readable(from), readable(to)),
                    rule: "known where the roughness fills a one-third octave between 100 Hz and 5 kHz, over frequencies in Hz"
                        .to_owned(),
                });
            }
            return Err(AnswerError::Argument {
                argument: "--speed",
                value: format!("{:.1} km/h", 3.6 * self.speed),
                rule: "one at which the wavelengths of the roughness fill a one-third octave \
                       between 100 Hz and 5 kHz"
                    .to_owned(),
            });
        }
        let left_out: Vec<FrequencyBand> =
            FrequencyBand::all().filter(|band| levels.bands.iter().all(|level| level.band != *band)).collect();
        let (course, of_traffic) = match &self.traffic {
            Some(traffic) => Course::new(case, &train, &radiation, traffic, progress)?,
            None => (None, Vec::new()),
        };
        let mut remarks = remarks::remarks(case, &train, &powers, &left_out);
        let levels_of_rail = self.roughness.levels().iter();
        remarks.extend(levels_unlike_a_rail(levels_of_rail.map(|level| level.level)));
        remarks.extend(of_traffic);
        let by_transfer_functions = match &train.transfer {
            Some([track, vehicle]) => {
                let levels = train.levels_by_transfer(case, [track, vehicle])?;
                Some(TransferLevels {
                    track: track.name.clone(),
                    vehicle: vehicle.name.clone(),
                    frequency_hz: nominal(&levels),
                    track_db: levels.levels(Part::Rail),
                    vehicle_db: levels.levels(Part::Wheel),
                    total_db: levels.levels(Part::Total),
                    total_dba: levels.a_weighted(Part::Total),
                })
            }
            None => None,
        };
        let before = match &self.before {
            Some(before) => Some(train.levels(&radiation, before)?),
            None => None,
        };
        let since = before.as_ref();
        let since = since.and_then(|before| Since::between(before, &levels));
        let before = before.as_ref().map(Levels::from);
        let level = Levels::from(&levels);
        let total = level.total_dba.unwrap_or(f64::NEG_INFINITY);
        let duration = self.length() / self.speed;
        let name = |(name, _): &(String, Spectrum)| name.clone();
        let frequency_hz = nominal(&levels);
        Ok(NoiseAnswer {
            riffel_version: env!("CARGO_PKG_VERSION"),
            speed_m_per_s: self.speed,
            wheels: self.wheels,
            train_length_m: self.length(),
            distance_m: self.distance,
            height_m: self.height,
            wheel_roughness: train.wheels.as_ref().map(name),
            wheel_modes: self.wheel_modes.clone(),
            lower_bound_up_to_hz: lower_bound_up_to(&frequency_hz),
            frequency_hz,
            sound_power_level: Levels::from(&sources::powers_of_parts(&powers)),
            by_transfer_functions,
            sound_exposure_level_dba: total + 10.0 * duration.log10(),
            measures: measure::measures(case, &train, &radiation, &levels)?,
            level,
            before,
            since,
            course,
            left_out_hz: left_out.iter().map(|band| band.nominal()).collect(),
            over_posterior: None,
            remarks,
            title: case.file.title.clone(),
            parameters: parameters(case),
        })
    }

    /// Whether the roughness fills a one-third octave that is heard.
    fn fills_a_band(&self) -> bool {
        let mut bands = self.roughness.levels().iter();
        bands.any(|level| (100.0..=5000.0).contains(&(self.speed / level.band.wavelength())))
    }

    /// The answers on the cases of draws, under the traffic of the calibration if the question has one or looks ahead.
    ///
    /// # Errors
    /// Those of [`answer`](Self::answer).
    pub fn over(
        &self,
        draws: &PosteriorDraws,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<OverPosterior, AnswerError> {
        draws.over(progress, |drawn| {
            let question = Self { traffic: drawn.traffic.clone().or_else(|| self.traffic.clone()), ..self.clone() };
            question.answer(&drawn.case, &|_| ())
        })
    }
}

/// What the names of a question stand for.
struct Train<'a> {
    question: &'a NoiseQuestion,
    /// Roughness of the wheels with its name.
    wheels: Option<(String, Spectrum)>,
    modes: Option<WheelModesTable>,
    transfer: Option<[TransferTable; 2]>,
    limit: (LimitTable, LevelLimit),
    pass: PassBy,
}

impl<'a> Train<'a> {
    fn new(question: &'a NoiseQuestion) -> Result<Self, AnswerError> {
        let wheels = match &question.wheel_roughness {
            None => None,
            Some(RoughWheels::Given(levels)) => Some(("given".to_owned(), levels.clone())),
            Some(RoughWheels::Named(name)) => {
                let found = WheelRoughness::named_or_in(name, Path::new(name))?;
                Some(found.ok_or_else(|| AnswerError::Argument {
                    argument: "--wheel-roughness",
                    value: format!("\"{name}\""),
                    rule: format!("a spectrum or one of {}", WheelRoughness::names()),
                })?)
            }
        };
        let modes = question.wheel_modes.as_deref().map(WheelModesTable::find);
        let transfer = match &question.transfer {
            Some([track, vehicle]) => Some([
                TransferTable::find(track, TransferPart::Track)?,
                TransferTable::find(vehicle, TransferPart::Vehicle)?,
            ]),
            None => None,
        };
        Ok(Self {
            question,
            wheels,
            modes: modes.transpose()?,
            transfer,
            limit: crate::level_limit(&question.limit)?,
            pass: PassBy::new(
                question.distance,
                question.height,
                f64::from(question.wheels),
                question.length(),
                question.surroundings,
            )?,
        })
    }

    fn wheel_modes(&self) -> Option<&WheelModes> {
        self.modes.as_ref().map(|table| &table.modes)
    }
}

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
    /// The same with the roughness of before; null where none was given.
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
    pub course: Option<Course>,
    /// Nominal centres of the bands that are not known.
    pub left_out_hz: Vec<f64>,
    /// The same over the draws of a calibration, where one was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_posterior: Option<OverPosterior>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
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

    /// What each measure does.
    /// The picture in a language; the case is that of which the answer is.
    pub(crate) fn figure_of(&self, case: &Case, language: Language) -> LineFigure {
        figure::figure(self, &parameters_in(case, language), language)
    }

    pub(crate) fn measures_table(&self) -> Table {
        tables::measures(self)
    }
}

/// Levels of the parts in bands and over all of them; none where a part radiates nothing.
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
    const NAME: &'static str = "noise";

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
        &self.remarks
    }
}
