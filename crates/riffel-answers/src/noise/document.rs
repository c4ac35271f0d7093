//! Rolling noise as data and as a table.

use riffel_keys::Message;
use std::io::{self, Write};

use serde::Serialize;

use super::levels::finite;
use super::{BandPressure, NoiseAnswer, Part, PassByLevels};

/// What `riffel noise --json` prints; levels in dB re 20 µPa, those of sound power in dB re 1 pW.
#[derive(Serialize)]
pub struct NoiseDocument<'a> {
    riffel_version: &'static str,
    speed_m_per_s: f64,
    wheels: u32,
    train_length_m: f64,
    distance_m: f64,
    height_m: f64,
    wheel_roughness: Option<&'a str>,
    wheel_modes: Option<&'a str>,
    /// Nominal centres of the bands.
    frequency_hz: Vec<f64>,
    level: Levels,
    /// Of one wheel with the rail and the sleepers under it.
    sound_power_level: Levels,
    /// Null without transfer functions.
    by_transfer_functions: Option<TransferLevels<'a>>,
    sound_exposure_level_dba: f64,
    measures: Vec<MeasureDocument<'a>>,
    /// Null without traffic.
    course: Option<CourseDocument<'a>>,
    /// Nominal centres of the bands that are not known.
    left_out_hz: Vec<f64>,
    remarks: &'a [Message],
}

#[derive(Serialize)]
struct Levels {
    rail_db: Vec<Option<f64>>,
    sleepers_db: Vec<Option<f64>>,
    wheel_db: Vec<Option<f64>>,
    total_db: Vec<Option<f64>>,
    rail_dba: Option<f64>,
    sleepers_dba: Option<f64>,
    wheel_dba: Option<f64>,
    total_dba: Option<f64>,
}

impl Levels {
    fn new(by_band: impl Fn(Part) -> Vec<Option<f64>>, a_weighted: impl Fn(Part) -> f64) -> Self {
        let a_weighted = |part| finite(a_weighted(part));
        Self {
            rail_db: by_band(Part::Rail),
            sleepers_db: by_band(Part::Sleepers),
            wheel_db: by_band(Part::Wheel),
            total_db: by_band(Part::Total),
            rail_dba: a_weighted(Part::Rail),
            sleepers_dba: a_weighted(Part::Sleepers),
            wheel_dba: a_weighted(Part::Wheel),
            total_dba: a_weighted(Part::Total),
        }
    }
}

#[derive(Serialize)]
struct TransferLevels<'a> {
    track: &'a str,
    vehicle: &'a str,
    frequency_hz: Vec<f64>,
    track_db: Vec<Option<f64>>,
    vehicle_db: Vec<Option<f64>>,
    total_db: Vec<Option<f64>>,
    total_dba: Option<f64>,
}

#[derive(Serialize)]
struct MeasureDocument<'a> {
    title: &'a str,
    /// Of the level now, less what is saved.
    total_dba: f64,
    saved_db: f64,
}

#[derive(Serialize)]
struct CourseDocument<'a> {
    month: &'a [f64],
    total_dba: &'a [f64],
    limit_dba: Option<f64>,
    /// Null where the limit is not reached in these months.
    months_to_limit: Option<f64>,
    beyond_linear_range: bool,
}

fn by_band(levels: &PassByLevels, part: Part) -> Vec<Option<f64>> {
    let bands = levels.bands().iter();
    bands.map(|band| band.level(part)).collect()
}

fn frequencies(levels: &PassByLevels) -> Vec<f64> {
    let bands = levels.bands().iter();
    bands.map(|band| band.band.nominal()).collect()
}

pub(super) fn document(answer: &NoiseAnswer) -> NoiseDocument<'_> {
    let (request, levels) = (&answer.request, &answer.levels);
    let transfer = answer.by_transfer.as_ref().zip(request.transfer.as_ref());
    NoiseDocument {
        riffel_version: env!("CARGO_PKG_VERSION"),
        speed_m_per_s: request.speed,
        wheels: request.train.wheels,
        train_length_m: request.train.length,
        distance_m: request.train.distance,
        height_m: request.train.height,
        wheel_roughness: request.wheels.as_ref().map(|(name, _)| name.as_str()),
        wheel_modes: request
            .wheel_modes
            .as_ref()
            .map(|table| table.name.as_str()),
        frequency_hz: frequencies(levels),
        level: Levels::new(|part| by_band(levels, part), |part| levels.a_weighted(part)),
        sound_power_level: Levels::new(
            |part| answer.powers.levels(part),
            |part| answer.powers.a_weighted(part),
        ),
        by_transfer_functions: transfer.map(|(levels, [track, vehicle])| TransferLevels {
            track: &track.name,
            vehicle: &vehicle.name,
            frequency_hz: frequencies(levels),
            track_db: by_band(levels, Part::Rail),
            vehicle_db: by_band(levels, Part::Wheel),
            total_db: by_band(levels, Part::Total),
            total_dba: finite(levels.a_weighted(Part::Total)),
        }),
        sound_exposure_level_dba: answer.exposure_level(),
        measures: answer
            .measures
            .iter()
            .map(|measure| MeasureDocument {
                title: &measure.title,
                total_dba: levels.a_weighted(Part::Total) - measure.saved,
                saved_db: measure.saved,
            })
            .collect(),
        course: answer.course.as_ref().map(|course| CourseDocument {
            month: &course.months,
            total_dba: &course.levels,
            limit_dba: course.limit,
            months_to_limit: course.months_to_limit,
            beyond_linear_range: course.cut,
        }),
        left_out_hz: answer.left_out.iter().map(|band| band.nominal()).collect(),
        remarks: &answer.remarks,
    }
}

pub(super) fn bands_csv(answer: &NoiseAnswer, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header: Vec<String> = vec!["frequency_hz".to_owned()];
    header.extend(Part::ALL.map(|part| format!("{}_db", part.name())));
    header.extend(Part::ALL.map(|part| format!("{}_power_db", part.name())));
    let transfer = answer.by_transfer.as_ref();
    if transfer.is_some() {
        header.extend(["track", "vehicle", "total"].map(|part| format!("transfer_{part}_db")));
    }
    writer.write_record(&header)?;
    let written =
        |level: Option<f64>| level.map_or_else(String::new, |level| format!("{level:.3}"));
    let cell =
        |band: Option<&BandPressure>, part: Part| written(band.and_then(|band| band.level(part)));
    let powers = Part::ALL.map(|part| answer.powers.levels(part));
    for (place, band) in answer.levels.bands().iter().enumerate() {
        let mut row = vec![format!("{}", band.band.nominal())];
        row.extend(Part::ALL.map(|part| cell(Some(band), part)));
        let power = |levels: &Vec<Option<f64>>| levels.get(place).copied().flatten();
        row.extend(powers.iter().map(|levels| written(power(levels))));
        if let Some(levels) = transfer {
            let same = levels.bands().iter().find(|other| other.band == band.band);
            row.extend([Part::Rail, Part::Wheel, Part::Total].map(|part| cell(same, part)));
        }
        writer.write_record(&row)?;
    }
    writer.flush()
}
