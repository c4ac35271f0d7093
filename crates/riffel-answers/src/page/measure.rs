//! What a measured rail says: levels held to limits, dominant wavelengths, and what becomes of it. Its record is read once.

use riffel_case::ask;
use riffel_rail::{Limit, LimitTable, RoughnessFile};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::diagnose::{DiagnoseQuestion, Diagnosis};
use crate::forecast::{ForecastAnswer, ForecastQuestion, MeasuredSpectra};
use crate::page::Fault;
use crate::question::{Client, EarlierRecords, Question, Rule, Source, of_keys};
use crate::roughness::{MeasuredAnswer, RoughnessQuestion};
use crate::{Answer, AnswerError, Result};

/// A measured rail with its case and its traffic: roughness, diagnosis and forecast.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub(crate) struct MeasureQuestion {
    #[serde(flatten)]
    diagnosed: DiagnoseQuestion,
    /// Earlier record to fit the wear coefficient to, where not all have a date.
    #[schemars(extend("value_name" = "FILE"))]
    since: Option<Source<RoughnessFile>>,
    /// Axle passages between that record and the roughness.
    #[schemars(extend("value_name" = "N"))]
    passages_between: Option<f64>,
    /// Months that the forecast looks ahead.
    #[schemars(extend("value_name" = "M", "default" = 12))]
    months: f64,
}

#[derive(Serialize)]
struct MeasureAnswer {
    roughness: MeasuredAnswer,
    diagnosis: Outcome<Diagnosis>,
    forecast: Outcome<Forecast>,
    /// The track carries its vibration on without end, and has no level of noise.
    is_silent: bool,
    limits: Vec<LevelLimit>,
}

/// An answer, or why there is none: short of it the others are still worth seeing.
#[derive(Serialize)]
#[serde(untagged)]
enum Outcome<T> {
    Printed(Box<T>),
    Refused { fault: Fault },
}

impl<T> From<Result<T>> for Outcome<T> {
    fn from(answer: Result<T>) -> Self {
        match answer {
            Ok(answer) => Self::Printed(Box::new(answer)),
            Err(error) => Self::Refused { fault: error.into() },
        }
    }
}

#[derive(Serialize)]
struct Forecast {
    #[serde(flatten)]
    answer: ForecastAnswer,
    /// Why the wear coefficient cannot be fitted to the earlier records.
    #[serde(skip_serializing_if = "Option::is_none")]
    fit_fault: Option<Fault>,
}

/// A limit of levels that comes with Riffel.
#[derive(Serialize)]
struct LevelLimit {
    edition: String,
    source: String,
    wavelength_m_and_level_db: Vec<[f64; 2]>,
}

impl LevelLimit {
    fn all() -> Vec<Self> {
        let of_levels = |table: &LimitTable| match &table.limit {
            Limit::Levels(limit) => Some(Self {
                edition: table.edition.clone(),
                source: table.source.clone(),
                wavelength_m_and_level_db: (limit.spectrum().levels().iter())
                    .map(|level| [level.band.wavelength(), level.level])
                    .collect(),
            }),
            Limit::Rms(_) => None,
        };
        LimitTable::all().iter().filter_map(of_levels).collect()
    }
}

impl MeasureQuestion {
    /// The forecast, with the wear coefficient of the earlier records where it can be fitted.
    fn forecast(&self, client: &dyn Client) -> Result<Forecast> {
        let DiagnoseQuestion { case, roughness, rail } = &self.diagnosed;
        let mut asked: ForecastQuestion = of_keys(json!({ "case": "", "traffic": "" }))?;
        asked.case = case.clone();
        asked.traffic = rail.traffic.clone();
        asked.months = Some(self.months);
        asked.spectra = MeasuredSpectra {
            spectrum: roughness.path().map(|path| Source::File(path.to_owned())),
            layout: rail.layout.clone(),
            ..MeasuredSpectra::default()
        };
        let mut fitted = asked.clone();
        fitted.spectra.earlier = match &self.since {
            Some(since) => EarlierRecords { earlier: vec![since.clone()], dates: Vec::new() },
            None if rail.earlier.dates.is_empty() => EarlierRecords::default(),
            None => rail.earlier.clone(),
        };
        fitted.spectra.passages_between = self.passages_between;
        match fitted.told(client) {
            Ok(answer) => Ok(Forecast { answer, fit_fault: None }),
            Err(error) if fitted.spectra.earlier.earlier.is_empty() => Err(error),
            Err(error) => Ok(Forecast { answer: asked.told(client)?, fit_fault: Some(error.into()) }),
        }
    }
}

impl Question for MeasureQuestion {
    const NAME: &'static str = "measure";
    const EXAMPLE: &'static str = "";
    const RULES: &'static [Rule] = DiagnoseQuestion::RULES;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let mut asked = self.clone();
        let DiagnoseQuestion { case, roughness, rail } = &mut asked.diagnosed;
        rail.layout.kept = Some(Default::default());
        let roughness = RoughnessQuestion::of_file(roughness.clone(), rail.layout.clone())?.measured(client)?;
        let read = case.read(client)?;
        *case = read.clone().into();
        Ok(Box::new(MeasureAnswer {
            roughness: roughness.ok_or(AnswerError::NoSpectrum)?,
            diagnosis: asked.diagnosed.diagnosis(client).into(),
            forecast: asked.forecast(client).into(),
            is_silent: ask::without_decay(&read).is_some(),
            limits: LevelLimit::all(),
        }))
    }
}

impl Answer for MeasureAnswer {
    fn name(&self) -> &'static str {
        "measure"
    }
}
