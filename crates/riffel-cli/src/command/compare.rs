//! `riffel compare`

use riffel::forecast::SpeedDistribution;
use riffel_answers::AnswerError;
use riffel_answers::compare::{CompareAnswer, CompareRequest, compare_over};
use riffel_case::traffic::{Traffic, UsualTraffic};
use riffel_case::{Case, Hold, Variant};
use riffel_keys::{CaseError, Message, say, shown_speed};
use riffel_rail::Survey;

use super::forecast::{ground_rail, outside};
use super::roughness::survey;
use crate::arguments::{Compare, Models};
use crate::error::CliError;
use crate::posterior::over;
use crate::progress::Progress;
use crate::results::Results;
use crate::terminal::Terminal;

pub(crate) fn run(arguments: &Compare) -> miette::Result<()> {
    if let Some(Models(models)) = &arguments.models {
        return super::models::run(arguments, models);
    }
    if arguments.remedies {
        return super::remedies::run(arguments);
    }
    let survey = match &arguments.spectrum {
        Some(path) => Some(survey(path, &arguments.layout)?),
        None => None,
    };
    let case = arguments.case.read()?;
    let answer = compare(&case, arguments, survey)?;
    let results = Results::of("compare", &arguments.case, &arguments.results);
    Ok(results.answer(&answer)?)
}

/// The comparison; `survey` holds all spectra of `--spectrum`.
pub(super) fn compare(case: &Case, arguments: &Compare, survey: Option<Survey>) -> miette::Result<CompareAnswer> {
    let hold = arguments.hold.map(Hold::from);
    let variants: Result<Vec<Variant>, CaseError> = arguments
        .variants
        .iter()
        .map(|path| {
            let mut variant = Variant::read(path)?;
            variant.hold = hold;
            Ok(variant)
        })
        .collect();
    let variants = variants?;
    let draws = arguments.posterior.draws(&arguments.case)?;
    let of_plan = draws.as_ref().and_then(|draws| draws.traffic.clone());
    let (traffic, speeds) = match of_plan {
        Some(traffic) => titled(traffic),
        None => traffic(case, arguments)?,
    };
    let (table, limit) = riffel_answers::level_limit(&arguments.limit)?;
    let ground = ground_rail(&arguments.ground, &table, &limit)?;
    arguments.earlier.check_now(arguments.spectrum.as_deref())?;
    let (path, layout) = (arguments.spectrum.as_deref(), arguments.layout.records());
    let earlier = arguments.earlier.records();
    let dated = |survey| earlier.of_dates(survey, path, &layout, &arguments.choose, &Terminal);
    let survey = survey.map(dated).transpose()?;
    let steps = (1 + variants.len()) * traffic.file.vehicle.len();
    let limit = (table, limit);
    let mut request = CompareRequest { variants, traffic, speeds, hold, survey, ground, limit, over_posterior: None };
    request.over_posterior = over(draws.as_ref(), |draws, progress| compare_over(draws, &request, progress))?;
    let progress = Progress::new(riffel_keys::say!(progress_variants), steps);
    let answer = CompareAnswer::new(case, request, &|by| progress.advance(by));
    answer.map_err(|error| match error {
        AnswerError::OutsideWindow(error) => {
            let path = arguments.spectrum.as_deref();
            outside(&arguments.ground, path, case, error).into()
        }
        error => miette::Report::from(error),
    })
}

/// The traffic with its speeds in words: that of the file, the wheel of the case at the speed that is asked for, or the usual one of
/// its line.
fn traffic(case: &Case, arguments: &Compare) -> miette::Result<(Traffic, Message)> {
    if let Some(path) = &arguments.traffic {
        return Ok(titled(Traffic::read(path)?));
    }
    let Some(mean) = &arguments.speed else {
        let usual = UsualTraffic::of(case);
        let under = say!(compared_under, traffic = usual.in_words());
        return Ok((usual.traffic()?, under));
    };
    let mean = mean.within("--speed", &Terminal)?;
    let deviation = arguments.speed_deviation;
    let speeds = SpeedDistribution::normal(mean, deviation.map_or(0.0, |speed| speed.si()));
    let speeds = speeds.map_err(|error| CliError::Physics { input: "--speed-deviation".to_owned(), error })?;
    let words = in_words(&speeds);
    Ok((Traffic::of_case(speeds), words))
}

/// A traffic with its title.
fn titled(traffic: Traffic) -> (Traffic, Message) {
    let title = traffic.file.title.clone();
    (traffic, title.map_or_else(|| say!(traffic_word), Message::verbatim))
}

fn in_words(speeds: &SpeedDistribution) -> Message {
    let speed = shown_speed(speeds.mean(), 1);
    match speeds.deviation() {
        0.0 => say!(at_speed, speed = speed),
        deviation => say!(at_spread_speed, speed = speed, deviation = shown_speed(deviation, 1)),
    }
}
