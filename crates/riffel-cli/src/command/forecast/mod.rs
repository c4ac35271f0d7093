//! `riffel forecast`

mod dated;
mod over_posterior;
mod wear;

use std::path::Path;

use dated::Dated;
use riffel_answers::forecast::{ForecastAnswer, ForecastHorizon, ForecastRequest, TrackForecast};
use riffel_answers::{AnswerError, level_limit};
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_rail::Survey;
use wear::wear_report;

use crate::arguments::{Forecast as Arguments, Horizon};
use crate::command::roughness::survey;
use crate::error::CliError;
use crate::progress::Progress;
use crate::results::Results;
use crate::terminal::Terminal;

pub(crate) use wear::Measured;

pub(crate) fn run(arguments: &Arguments) -> miette::Result<()> {
    if let Some(folder) = &arguments.posterior {
        return over_posterior::run(arguments, folder);
    }
    let spectra = &arguments.spectra;
    let survey = match &spectra.spectrum {
        Some(path) => Some(survey(path, &spectra.layout)?),
        None => None,
    };
    let case = arguments.case.read()?;
    let name = spectra.spectrum.as_ref().map(|path| path.display().to_string());
    let answer = ForecastAnswer::new(&case, forecast(&case, arguments, survey)?, name);
    Ok(Results::of("forecast", &arguments.case, &arguments.results).answer(&answer)?)
}

/// The forecast of the rail that will be ground, or else of what was measured; `survey` holds all spectra of
/// `--spectrum`.
pub(super) fn forecast(case: &Case, arguments: &Arguments, survey: Option<Survey>) -> miette::Result<TrackForecast> {
    // It is there where no posterior is.
    let traffic = Traffic::read(arguments.traffic.as_deref().unwrap_or_else(|| Path::new("")))?;
    let limit = level_limit(&arguments.limit)?;
    let ground = arguments.ground.source().read(&limit, &Terminal)?;
    arguments.spectra.earlier.records().check_now(arguments.spectra.spectrum.is_some())?;
    let dated = survey.map(|survey| Dated::new(&arguments.spectra, survey)).transpose()?;
    let progress = Progress::new(riffel_keys::say!(progress_traffic), traffic.file.vehicle.len());
    let measured_on = dated.as_ref().and_then(|dated| dated.date);
    let request = ForecastRequest {
        traffic,
        survey: dated.as_ref().map(|dated| dated.now.clone()),
        ground,
        horizon: horizon(&arguments.horizon),
        limit,
        date: arguments.date.or(measured_on),
    };
    let answer = TrackForecast::new(case, request, &|by| progress.advance(by))
        .map_err(|error| arguments.ground.source().outside(dated.as_ref().map(|dated| &dated.now), case, error))
        .map_err(|error| of_arguments(arguments, error))?;
    drop(progress);
    let wear = match &dated {
        Some(dated) => wear_report(&arguments.spectra, dated, case, &answer)?,
        None => None,
    };
    Ok(match wear {
        Some(wear) => answer.with_wear(wear),
        None => answer,
    })
}

/// How far to look ahead: as asked for, or a year.
fn horizon(horizon: &Horizon) -> ForecastHorizon {
    match (horizon.passages, horizon.mgt) {
        (Some(passages), _) => ForecastHorizon::Passages(passages),
        (None, Some(mgt)) => ForecastHorizon::MillionGrossTonnes(mgt),
        (None, None) => ForecastHorizon::Months(horizon.months.unwrap_or(12.0)),
    }
}

/// What there is no forecast for, under the names of the arguments.
fn of_arguments(arguments: &Arguments, error: AnswerError) -> miette::Report {
    match error {
        AnswerError::NoSpectrum => CliError::Argument {
            argument: "--spectrum",
            value: "left out".to_owned(),
            rule: "given, or else --ground or --from-limit".to_owned(),
        }
        .into(),
        AnswerError::NoPassagesPerDay => CliError::Argument {
            argument: "--months",
            value: arguments.horizon.months.map_or("left out".to_owned(), |months| months.to_string()),
            rule: "replaced by --passages or --mgt, for the traffic file says under [line] neither \
                   passages_per_day nor mgt_per_year"
                .to_owned(),
        }
        .into(),
        error => error.into(),
    }
}
