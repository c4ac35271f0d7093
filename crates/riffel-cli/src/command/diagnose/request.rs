//! What a diagnosis is asked for on the command line.

use std::path::Path;

use riffel::diagnosis::{Instrument, TrafficSpeeds};
use riffel_answers::AnswerError;
use riffel_answers::diagnose::{Diagnosis, DiagnosisSettings};
use riffel_answers::question::AsWritten;
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_keys::quantity::{Frequency, Kind, Quantity, Speed};
use riffel_keys::{Message, say};
use riffel_rail::history::SpectraChoice;
use riffel_rail::{RailRecord, RoughnessFile};

use crate::arguments::{DiagnosisArguments, positive};
use crate::command::roughness::{choose_nothing, read};
use crate::error::CliError;
use crate::terminal::Terminal;

/// The diagnosis of the file that was read, with the earlier ones, which are read here.
pub(crate) fn diagnosis(
    case: &Case,
    path: &Path,
    file: &RoughnessFile,
    arguments: &DiagnosisArguments,
) -> miette::Result<Diagnosis> {
    let (speeds, remark) = speeds(case, arguments)?;
    let settings = DiagnosisSettings {
        speeds,
        spectra: SpectraChoice {
            choose: &arguments.choose,
            by: arguments.by.as_deref(),
            keep_defects: arguments.layout.keep_defects,
        },
        torsion: modes("--torsion", &arguments.torsion)?,
        bending: modes("--bending", &arguments.bending)?,
        instrument: if arguments.from_vehicle { Instrument::Vehicle } else { Instrument::Trolley },
    };
    arguments.earlier.records().check()?;
    let files: Vec<RoughnessFile> =
        arguments.earlier.files.iter().map(|path| read(path, &arguments.layout)).collect::<miette::Result<_>>()?;
    if matches!(file, RoughnessFile::Profile(_)) {
        choose_nothing(path, &arguments.choose, arguments.by.as_deref())?;
    }
    let earlier: Vec<RailRecord<'_>> = arguments
        .earlier
        .files
        .iter()
        .zip(&files)
        .enumerate()
        .map(|(place, (name, file))| RailRecord {
            name,
            date: arguments.earlier.dates.get(place).copied(),
            roughness: file.into(),
        })
        .collect();
    let present = RailRecord { name: path, date: arguments.earlier.dates.last().copied(), roughness: file.into() };
    let mut diagnosis = Diagnosis::new(case, &present, &earlier, &settings)?;
    diagnosis.warnings.splice(0..0, remark);
    Ok(diagnosis)
}

fn modes(argument: &'static str, frequencies: &[Quantity<Frequency>]) -> Result<Vec<f64>, CliError> {
    let modes = frequencies.iter();
    modes.map(|&frequency| positive(argument, frequency)).collect()
}

/// The speeds asked for, or those of the usual traffic with a remark that says so.
fn speeds(case: &Case, arguments: &DiagnosisArguments) -> miette::Result<(TrafficSpeeds, Option<Message>)> {
    let wrong = |value: &str, rule: &str| CliError::Argument {
        argument: "--speed",
        value: value.to_owned(),
        rule: rule.to_owned(),
    };
    if let (Some(path), true) = (&arguments.traffic, arguments.speed.is_empty()) {
        let speeds = Traffic::read(path)?.passing_speeds();
        let speeds = speeds.map_err(|error| CliError::Argument {
            argument: "--traffic",
            value: path.display().to_string(),
            rule: format!("a file with speeds: {error}"),
        })?;
        return Ok((speeds, None));
    }
    if arguments.speed.is_empty() {
        let (speeds, sentence) =
            Diagnosis::usual_speeds(case).map_err(|error| wrong("those of the usual traffic", &error.to_string()))?;
        let remark = sentence.about(say!(neither_speed_nor_traffic));
        return Ok((speeds, Some(remark)));
    }
    let mut ranges = Vec::new();
    for written in &arguments.speed {
        let (slowest, fastest) = match Kind::of::<Speed>().range_in_words(written) {
            Some([slowest, fastest]) => (within(&slowest)?, within(&fastest)?),
            None => {
                let speed = within(written)?;
                (speed, speed)
            }
        };
        if slowest > fastest {
            Err(wrong(written, "from the slower to the faster"))?;
        }
        ranges.push((slowest, fastest));
    }
    let speeds =
        TrafficSpeeds::of_ranges(ranges).map_err(|error| wrong(&arguments.speed.join(", "), &error.to_string()))?;
    Ok((speeds, None))
}

/// A speed of a range \[m/s\].
fn within(text: &str) -> Result<f64, AnswerError> {
    let wrong = |error| AnswerError::Range { argument: "--speed", message: format!(": {error}") };
    text.parse::<AsWritten<Speed>>().map_err(wrong)?.within("--speed", &Terminal)
}
