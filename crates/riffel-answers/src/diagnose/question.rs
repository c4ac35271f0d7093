//! What is asked of the dominant wavelengths of a rail.

use std::path::Path;
use std::sync::Arc;

use riffel::diagnosis::{Instrument, TrafficSpeeds};
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_keys::quantity::{Frequency, Kind, Quantity, Speed};
use riffel_keys::{Message, say};
use riffel_rail::history::SpectraChoice;
use riffel_rail::{RailRecord, RoughnessFile};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{Diagnosis, DiagnosisSettings};
use crate::question::{
    AsWritten, CaseSource, Client, EarlierRecords, Question, RecordLayout, Rule, Source, called, choose_nothing,
    positive,
};
use crate::{Answer, AnswerError, Result};

/// Dominant wavelengths of a measured rail, and what may have made them.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct DiagnoseQuestion {
    #[serde(flatten)]
    pub(crate) case: CaseSource,
    /// Longitudinal profile, or table of one-third-octave levels.
    #[schemars(extend("value_name" = "FILE"))]
    pub(crate) roughness: Source<RoughnessFile>,
    #[serde(flatten)]
    pub(crate) rail: DiagnosedRail,
}

impl DiagnoseQuestion {
    /// The diagnosis of the roughness.
    ///
    /// # Errors
    /// Errors of [`DiagnosedRail::diagnosis`], and [`AnswerError::Case`] with the case at fault.
    pub(crate) fn diagnosis(&self, client: &dyn Client) -> Result<Diagnosis> {
        let case = self.case.read(client)?;
        let file = self.roughness.value(|path| self.rail.layout.read(path, client))?;
        self.rail.diagnosis(&case, called(self.roughness.name()), &file, client)
    }
}

/// How a measured rail is held against a case.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct DiagnosedRail {
    /// How the records are read.
    #[serde(flatten)]
    pub layout: RecordLayout,
    /// Records before the roughness.
    #[serde(flatten)]
    pub earlier: EarlierRecords,
    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[serde(rename = "where")]
    #[schemars(extend("value_name" = "COLUMN=VALUE"))]
    pub choose: Vec<String>,
    /// Column of a table that tells its records apart in time [default: date, if there is one].
    #[schemars(extend("value_name" = "COLUMN"))]
    pub by: Option<String>,
    /// Speeds of the traffic, as "80 km/h" or a range "60 km/h..90 km/h"; may be repeated [default: those
    /// of the map of the case].
    pub speed: Vec<String>,
    /// Traffic file, for the speeds of its vehicles where no --speed is given, and for growth and forecast of a report.
    #[schemars(extend("value_name" = "TOML"))]
    pub traffic: Option<Source<Traffic>>,
    /// Frequency of a torsional mode of the wheelset; may be repeated.
    #[schemars(extend("value_name" = "FREQUENCY"))]
    pub torsion: Vec<Quantity<Frequency>>,
    /// Frequency of a bending mode of the wheelset; may be repeated.
    #[schemars(extend("value_name" = "FREQUENCY"))]
    pub bending: Vec<Quantity<Frequency>>,
    /// The record was taken from a vehicle, whose wheels are in it, and not with a trolley.
    pub from_vehicle: bool,
}

impl DiagnosedRail {
    /// The diagnosis of the file that was read, with the earlier ones, which are read here.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] and [`AnswerError::Range`] with the rule, [`AnswerError::Case`] with the file at fault.
    pub fn diagnosis(&self, case: &Case, path: &Path, file: &RoughnessFile, client: &dyn Client) -> Result<Diagnosis> {
        let modes = |argument, frequencies: &[Quantity<Frequency>]| {
            let modes = frequencies.iter().map(|frequency| positive(argument, *frequency));
            modes.collect::<Result<Vec<f64>>>()
        };
        let (speeds, remark) = self.speeds(case, client)?;
        let settings = DiagnosisSettings {
            speeds,
            spectra: SpectraChoice {
                choose: &self.choose,
                by: self.by.as_deref(),
                keep_defects: self.layout.keep_defects,
            },
            torsion: modes("--torsion", &self.torsion)?,
            bending: modes("--bending", &self.bending)?,
            instrument: if self.from_vehicle { Instrument::Vehicle } else { Instrument::Trolley },
        };
        self.earlier.check()?;
        let files = self.earlier.earlier.iter().map(|source| source.value(|path| self.layout.read(path, client)));
        let files = files.collect::<Result<Vec<Arc<RoughnessFile>>>>()?;
        if matches!(file, RoughnessFile::Profile(_)) {
            choose_nothing(path, &self.choose, self.by.as_deref())?;
        }
        let dates = &self.earlier.dates;
        let earlier = self.earlier.earlier.iter().zip(&files).enumerate();
        let earlier: Vec<RailRecord<'_>> = earlier
            .map(|(place, (source, file))| RailRecord {
                name: called(source.name()),
                date: dates.get(place).copied(),
                roughness: (&**file).into(),
            })
            .collect();
        let present = RailRecord { name: path, date: dates.last().copied(), roughness: file.into() };
        let mut diagnosis = Diagnosis::new(case, &present, &earlier, &settings)?;
        diagnosis.warnings.splice(0..0, remark);
        Ok(diagnosis)
    }

    /// The speeds asked for, or those of the usual traffic with a remark that says so.
    fn speeds(&self, case: &Case, client: &dyn Client) -> Result<(TrafficSpeeds, Option<Message>)> {
        let wrong_speeds =
            |value: &str, error: riffel::Error| AnswerError::argument("--speed", value, error.to_string());
        match (&self.traffic, &self.speed[..]) {
            (Some(traffic), []) => {
                let speeds = traffic.value(Traffic::read)?.passing_speeds().map_err(|error| {
                    AnswerError::argument("--traffic", traffic.name().display(), format!("a file with speeds: {error}"))
                });
                Ok((speeds?, None))
            }
            (None, []) => {
                let usual = Diagnosis::usual_speeds(case);
                let (speeds, sentence) = usual.map_err(|error| wrong_speeds("those of the usual traffic", error))?;
                Ok((speeds, Some(sentence.about(say!(neither_speed_nor_traffic)))))
            }
            (_, written) => {
                let ranges = written.iter().map(|written| range(written, client));
                let speeds = TrafficSpeeds::of_ranges(ranges.collect::<Result<Vec<_>, _>>()?);
                Ok((speeds.map_err(|error| wrong_speeds(&written.join(", "), error))?, None))
            }
        }
    }
}

/// A range of speeds as it is written, or one speed \[m/s\].
fn range(written: &str, client: &dyn Client) -> Result<(f64, f64)> {
    let within = |text: &str| {
        let wrong = |error| AnswerError::Range { argument: "--speed", message: format!(": {error}") };
        text.parse::<AsWritten<Speed>>().map_err(wrong)?.within("--speed", client)
    };
    let Some([slowest, fastest]) = Kind::of::<Speed>().range_in_words(written) else {
        let speed = within(written)?;
        return Ok((speed, speed));
    };
    match (within(&slowest)?, within(&fastest)?) {
        (slowest, fastest) if slowest > fastest => {
            Err(AnswerError::argument("--speed", written, "from the slower to the faster"))
        }
        range => Ok(range),
    }
}

impl Question for DiagnoseQuestion {
    const NAME: &'static str = "diagnose";
    const EXAMPLE: &'static str = "\
        Example: riffel diagnose case.toml --roughness profile.csv --speed \"60 km/h..80 km/h\" --earlier last-year.csv\n\n\
        Shares compare the candidates of one list, each taken to be equally likely beforehand; they are no \
        probability that a finding is right.";
    const RULES: &'static [Rule] = &[EarlierRecords::RULE];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        Ok(Box::new(self.diagnosis(client)?))
    }
}
