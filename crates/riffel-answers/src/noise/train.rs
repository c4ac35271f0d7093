//! What a question of noise asks for, read and checked.

use std::path::Path;
use std::sync::Arc;

use riffel::error::as_typed;
use riffel::roughness::{LevelLimit, Spectrum};
use riffel_case::traffic::Traffic;
use riffel_case::{Case, TrackRadiator, ask};
use riffel_keys::Message;
use riffel_noise::{FrequencyBand, Part, PassBy, WheelModes};
use riffel_rail::{
    LimitTable, RailDates, TransferPart, TransferTable, WheelModesTable, WheelRoughness, levels_unlike_a_rail,
    read_decay_rates,
};

use super::measure::measures;
use super::remarks::remarks;
use super::since::lower_bound_up_to;
use super::sources::powers_of_parts;
use super::{LevelTrend, Levels, NoiseAnswer, NoiseQuestion, Since, TransferLevels, nominal};
use crate::forecast::ForecastHorizon;
use crate::question::Client;
use crate::{AnswerError, Result, parameters};

/// Least length of train to a wheel on one rail \[m\]: wheels follow each other at more than their diameter.
const LEAST_PER_WHEEL: f64 = 0.5;

/// A train on a measured rail, in SI.
pub(super) struct Train {
    pub(super) speed: f64,
    wheels: u32,
    length: f64,
    pub(super) distance: f64,
    height: f64,
    /// Roughness of the rail.
    pub(super) roughness: Spectrum,
    /// Its records at several dates, by which it goes on growing.
    pub(super) history: Option<RailDates>,
    /// Names of the rails of which the roughness is the mean, where they are several.
    pub(super) rails: Vec<String>,
    /// What it was before, as before grinding.
    before: Option<Spectrum>,
    /// Roughness of the wheels with its name; none for smooth ones.
    pub(super) wheel_roughness: Option<(String, Spectrum)>,
    /// Modes of the web and tyre of the wheels with their name; none for rigid wheels.
    pub(super) modes: Option<(String, WheelModesTable)>,
    pub(super) radiator: TrackRadiator,
    transfer: Option<[TransferTable; 2]>,
    /// What the rail may be ground to.
    pub(super) limit: (LimitTable, LevelLimit),
    pub(super) pass: PassBy,
    /// How far to look ahead.
    pub(super) months: f64,
    pub(super) limit_dba: Option<f64>,
    /// What was put right in the record.
    warnings: Vec<Message>,
}

impl Train {
    /// What a question names, read; `client` is told what is unusual.
    pub(super) fn new(question: &NoiseQuestion, client: &dyn Client) -> Result<Self> {
        let (layout, choose) = (&question.layout, &question.choose);
        let now = Arc::unwrap_or_clone(question.roughness.value(|path| layout.survey(path, client))?);
        let survey = question.earlier.of_dates(now, question.roughness.path(), layout, choose, client)?;
        let before = question.before.as_ref().map(|before| {
            let before = before.value(|path| layout.survey(path, client))?;
            Ok::<_, AnswerError>(Arc::unwrap_or_clone(before).choose(choose)?.latest().0.mean())
        });
        let before = before.transpose()?;
        let speed = question.speed.within("--speed", client)?;
        let radiator = TrackRadiator {
            rail_foot: question.rail_foot.within("--rail-foot", client)?,
            sleeper_area: question.sleeper_area.within("--sleeper-area", client)?,
            decay_rate: match &question.decay_rate {
                Some(rates) => Some(Arc::unwrap_or_clone(rates.value(read_decay_rates)?)),
                None => None,
            },
        };
        let wheels = question.wheels;
        let length = match &question.train_length {
            Some(length) => length.within("--train-length", client)?,
            None => PassBy::LENGTH_PER_WHEEL * f64::from(wheels),
        };
        let [distance, height] =
            [question.distance.within("--distance", client)?, question.height.within("--height", client)?];
        check_length(length, wheels)?;
        if distance <= PassBy::NEAREST {
            let rule = "beyond the rail, 0.75 m".to_owned();
            return Err(AnswerError::argument("--distance", format!("{distance} m"), rule));
        }
        if question.traffic.is_some() || question.posterior.posterior.is_some() {
            ForecastHorizon::Months(question.months).check()?;
        }
        let modes = question.wheel_modes.as_ref();
        let modes = modes.map(|name| Ok::<_, AnswerError>((name.clone(), WheelModesTable::find(name)?)));
        let transfer = match (&question.track_transfer, &question.vehicle_transfer) {
            (Some(track), Some(vehicle)) => Some([
                TransferTable::find(track, TransferPart::Track)?,
                TransferTable::find(vehicle, TransferPart::Vehicle)?,
            ]),
            _ => None,
        };
        Ok(Self {
            speed,
            wheels,
            length,
            distance,
            height,
            roughness: survey.mean(),
            rails: survey.rails(),
            before,
            wheel_roughness: wheel_roughness(question)?,
            modes: modes.transpose()?,
            radiator,
            transfer,
            limit: crate::level_limit(&question.limit)?,
            pass: PassBy::new(distance, height, f64::from(wheels), length, question.surroundings)?,
            months: question.months,
            limit_dba: question.limit_dba,
            history: survey.history,
            warnings: survey.warnings,
        })
    }

    /// The answer on a case; `progress` is called after each vehicle of the traffic.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] where a number is outside its range, no band is known, or the track has no decay;
    /// [`AnswerError::Case`] with the key or the file at fault.
    pub(super) fn answer(
        &self,
        case: &Case,
        traffic: Option<&Traffic>,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<NoiseAnswer> {
        if let (None, Some(why)) = (&self.radiator.decay_rate, ask::without_decay(case)) {
            return Err(AnswerError::argument("--decay-rate", "left out", format!("given: {why}")));
        }
        let radiation = self.radiation(case, self.wheel_modes(), self.speed)?;
        let powers = self.powers(&radiation, &self.roughness)?;
        let levels = self.levels_at_receiver(&powers);
        if levels.bands.is_empty() {
            return Err(self.no_band_is_known());
        }
        let left_out: Vec<FrequencyBand> =
            FrequencyBand::all().filter(|band| levels.bands.iter().all(|level| level.band != *band)).collect();
        let (course, of_traffic) = match traffic {
            Some(traffic) => LevelTrend::new(case, self, &radiation, traffic, progress)?,
            None => (None, Vec::new()),
        };
        let mut remarks = remarks(case, self, &powers, &left_out);
        let levels_of_rail = self.roughness.levels().iter();
        remarks.extend(levels_unlike_a_rail(levels_of_rail.map(|level| level.level)));
        remarks.extend(of_traffic);
        let by_transfer_functions = match &self.transfer {
            Some([track, vehicle]) => {
                let levels = self.levels_by_transfer(case, [track, vehicle])?;
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
            Some(before) => Some(self.levels(&radiation, before)?),
            None => None,
        };
        let since = before.as_ref();
        let since = since.and_then(|before| Since::between(before, &levels));
        let before = before.as_ref().map(Levels::from);
        let level = Levels::from(&levels);
        let total = level.total_dba.unwrap_or(f64::NEG_INFINITY);
        let duration = self.length / self.speed;
        let name = |(name, _): &(String, Spectrum)| name.clone();
        let frequency_hz = nominal(&levels);
        Ok(NoiseAnswer {
            riffel_version: env!("CARGO_PKG_VERSION"),
            speed_m_per_s: self.speed,
            wheels: self.wheels,
            train_length_m: self.length,
            distance_m: self.distance,
            height_m: self.height,
            wheel_roughness: self.wheel_roughness.as_ref().map(name),
            wheel_modes: self.modes.as_ref().map(|(name, _)| name.clone()),
            lower_bound_up_to_hz: lower_bound_up_to(&frequency_hz),
            frequency_hz,
            sound_power_level: Levels::from(&powers_of_parts(&powers)),
            by_transfer_functions,
            sound_exposure_level_dba: total + 10.0 * duration.log10(),
            measures: measures(case, self, &radiation, &levels)?,
            level,
            before,
            since,
            course,
            left_out_hz: left_out.iter().map(|band| band.nominal()).collect(),
            over_posterior: None,
            all_remarks: [&remarks, &self.warnings, &case.remarks].into_iter().flatten().cloned().collect(),
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

    /// Why no band is known.
    fn no_band_is_known(&self) -> AnswerError {
        // Where the roughness fills bands that are heard, it is the decay rates that are missing.
        if let Some(rates) = &self.radiator.decay_rate
            && self.fills_a_band()
        {
            let known = || rates.iter().map(|(band, _)| band.nominal());
            let [from, to] = [known().next(), known().next_back()].map(Option::unwrap_or_default);
            return AnswerError::argument(
                "--decay-rate",
                format!("known from {} to {} Hz", as_typed(from), as_typed(to)),
                "known where the roughness fills a one-third octave between 100 Hz and 5 kHz, over frequencies in Hz",
            );
        }
        AnswerError::argument(
            "--speed",
            format!("{:.1} km/h", 3.6 * self.speed),
            "one at which the wavelengths of the roughness fill a one-third octave \
                   between 100 Hz and 5 kHz",
        )
    }

    pub(super) fn wheel_modes(&self) -> Option<&WheelModes> {
        self.modes.as_ref().map(|(_, table)| &table.modes)
    }
}

/// `Ok` if the wheels have room in a train.
fn check_length(length: f64, wheels: u32) -> Result<()> {
    let shortest = LEAST_PER_WHEEL * f64::from(wheels);
    if length >= shortest {
        return Ok(());
    }
    let rule = format!("at least {shortest} m, half a metre to each of {wheels} wheels");
    Err(AnswerError::argument("--train-length", format!("{length} m"), rule))
}

/// The roughness of the wheels with its name.
fn wheel_roughness(question: &NoiseQuestion) -> Result<Option<(String, Spectrum)>> {
    let Some(name) = &question.wheel_roughness else {
        return Ok(None);
    };
    let found = WheelRoughness::named_or_in(name, Path::new(name))?;
    found.map(Some).ok_or_else(|| {
        AnswerError::argument(
            "--wheel-roughness",
            format!("\"{name}\""),
            format!("a spectrum or one of {}", WheelRoughness::names()),
        )
    })
}
