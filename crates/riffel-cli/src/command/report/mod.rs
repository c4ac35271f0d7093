//! `riffel report`

mod drawn;
mod fit;
mod inputs;

use std::path::Path;

use jiff::civil::Date;
use riffel_answers::compare::{CompareAnswer, CompareQuestion};
use riffel_answers::diagnose::Diagnosis;
use riffel_answers::forecast::{ForecastQuestion, MeasuredSpectra, TrackForecast, WearReport};
use riffel_answers::map::{MapAnswer, growth_over};
use riffel_answers::noise::{NoiseAnswer, NoiseQuestion, RoughWheels};
use riffel_answers::question::{PosteriorSource, Source, choose_nothing};
use riffel_answers::report::{
    GENERATOR, MeasuredRail, MeasuredRoughness, ProfileStrips, ReportRequest, Site, block_of_strip, report,
};
use riffel_answers::roughness::SpectraAnswer;
use riffel_answers::{LineGrowth, PosteriorDraws};
use riffel_case::traffic::Traffic;
use riffel_case::{Case, Hold};
use riffel_keys::quantity::Quantity;
use riffel_keys::{Message, number, say};
use riffel_rail::{Limit, LimitTable, RoughnessFile, Survey};

use crate::arguments::{CaseArguments, DiagnosisArguments, Report, Statistics};
use crate::command::roughness::profile::judged;
use crate::command::roughness::read;
use crate::error::CliError;
use crate::messages::language;
use crate::output::print;
use crate::posterior::{finished_of, over};
use crate::progress::Progress;
use crate::staging::{Existing, write_file};
use crate::terminal::Terminal;
use fit::Before;
use inputs::inputs;

/// Months for which the level of a train is told ahead where no other time is asked for.
const MONTHS_OF_NOISE: f64 = 12.0;

/// What was measured of the rail.
struct Measured {
    roughness: MeasuredRoughness,
    /// What the file was understood as.
    understood: Message,
    /// The latest date of a table of spectra.
    date: Option<Date>,
    /// The latest spectra, with what is to be said of them.
    survey: Survey,
    /// The earliest of a table of several dates.
    before: Option<Before>,
    diagnosis: Option<Diagnosis>,
}

/// What the record says of now.
struct Now<'a> {
    /// The file.
    path: &'a Path,
    /// Its spectra.
    survey: Survey,
    date: Option<Date>,
    /// Mean speed of the traffic \[m/s\].
    speed: f64,
}

/// A case, as its file and the command line say it.
struct GivenCase<'a> {
    path: &'a Path,
    overrides: Vec<String>,
    case: Case,
}

impl<'a> GivenCase<'a> {
    fn read(path: &'a Path, overrides: Vec<String>) -> miette::Result<Self> {
        let case = CaseArguments::of(path, &overrides).read()?;
        Ok(Self { path, overrides, case })
    }

    /// The same case with another wear coefficient \[kg/J\], to the four digits that `riffel forecast` prints.
    fn with_wear_coefficient(mut self, coefficient: f64) -> miette::Result<Self> {
        self.overrides.push(format!("wear.coefficient={coefficient:.3e}"));
        Self::read(self.path, self.overrides)
    }

    fn arguments(&self) -> CaseArguments {
        CaseArguments::of(self.path, &self.overrides)
    }
}

pub(crate) fn run(arguments: &Report) -> miette::Result<()> {
    let site = arguments.site.as_deref().map(Site::read).transpose()?;
    let site = site.unwrap_or_default();
    let mut given =
        arguments.case.as_deref().map(|path| GivenCase::read(path, arguments.overrides.clone())).transpose()?;
    let limits = LimitTable::named(&arguments.limit)?;
    let record = &arguments.record;
    let rail = measured_rail(arguments, given.as_ref().map(|given| &given.case), &limits)?;
    let mut now = rail.as_ref().and_then(|(path, rail)| now(path, rail, record));
    let before = match Before::of_arguments(arguments, now.as_mut())? {
        Some(before) => Some(before),
        None => rail.as_ref().and_then(|(_, rail)| rail.before.clone()),
    };
    fit::check_passages(arguments, before.as_ref())?;
    let mut wear = None;
    if let (Some(case), Some(now), Some(before), Some(traffic)) = (&given, &now, &before, &record.traffic) {
        wear = Some(fit::fit(arguments, &case.case, &limits, traffic, before, now)?);
    }
    // From here on the case has the coefficient of this rail.
    if !arguments.keep_coefficient
        && let Some(Ok(fit)) = &wear
        && let Some(coefficient) = fit.fitted_coefficient()
        && let Some(case) = given.take()
    {
        given = Some(case.with_wear_coefficient(coefficient)?);
    }
    let case = given.as_ref().map(|given| &given.case);
    let traffic = record.traffic.as_deref();
    let posterior = given.as_ref().zip(arguments.posterior.as_deref());
    let posterior = posterior.map(|(given, folder)| finished_of(&given.arguments(), folder)).transpose()?;
    let draws = posterior.as_ref().map(|(plan, chains)| PosteriorDraws::new(plan, chains)).transpose()?;
    let map = case.map(|case| growth_map(case, traffic, draws.as_ref()));
    let map = map.transpose()?;
    let posterior_forecast = match &posterior {
        Some((plan, chains)) if plan.has_levels() => Some(drawn::forecast(arguments, &limits, plan, chains)?),
        _ => None,
    };
    // The case goes by the coefficient that was fitted, unless it is to keep its own.
    let fitted = wear.as_ref().and_then(|wear| wear.as_ref().ok()?.spread());
    let fitted = fitted.filter(|_| !arguments.keep_coefficient);
    let no_roughness = || say!(no_roughness_given);
    let (mut forecast, mut compare) = (Err(no_roughness()), Err(no_roughness()));
    let mut noise = Err(no_roughness());
    if let Some(given) = &given {
        if let Some(now) = &now {
            forecast = outlook(arguments, given, &limits, now, wear)?;
            noise = heard(arguments, &given.case, &limits, now, draws.as_ref())?;
        }
        compare = what_if(arguments, given, &limits, now.as_ref())?;
        if let Ok(forecast) = &mut forecast {
            forecast.wear_spread = fitted.or(forecast.wear_spread);
        }
        if let Ok(compare) = &mut compare {
            compare.wear_spread = fitted.or(compare.wear_spread);
        }
    }
    let understood = rail.as_ref().map(|(_, rail)| rail.understood.clone());
    let inputs = inputs(arguments, given.as_ref(), understood)?;
    let rail_warnings = rail.as_ref().map(|(_, rail)| rail.survey.warnings.clone());
    let rail_warnings = rail_warnings.unwrap_or_default();
    let (rail, diagnosis) = match rail {
        Some((path, rail)) => (Some((path, rail.roughness)), rail.diagnosis),
        None => (None, None),
    };
    let page = report(ReportRequest {
        language: language(),
        title: arguments.title.as_deref(),
        site: &site,
        limits: &limits,
        rail: rail.map(|(path, roughness)| MeasuredRail {
            path,
            roughness,
            warnings: &rail_warnings,
            diagnosis: diagnosis.as_ref(),
        }),
        case: case.zip(map.as_ref()),
        forecast: forecast.as_ref().map_err(Message::clone),
        posterior_forecast: posterior_forecast.as_ref(),
        compare: compare.as_ref().map_err(Message::clone),
        noise: noise.as_ref().map_err(Message::clone),
        inputs: &inputs,
    })?;
    let existing = Existing::page(&arguments.output, arguments.force, GENERATOR);
    write_file(&arguments.output, &page, existing)?;
    let wrote = say!(report_is_written, file = arguments.output.display().to_string());
    print(&(wrote.text(language()) + "\n"))?;
    Ok(())
}

/// The rail with the path of its file, if one was given.
fn measured_rail<'a>(
    arguments: &'a Report,
    case: Option<&Case>,
    limits: &[LimitTable],
) -> miette::Result<Option<(&'a Path, Measured)>> {
    let Some(path) = &arguments.roughness else {
        check_without_roughness(arguments)?;
        return Ok(None);
    };
    let rail = measured(path, case, &arguments.record, limits)?;
    Ok(Some((path, rail)))
}

/// The growth map of a case, with a bar of how far it is.
fn growth_map(case: &Case, traffic: Option<&Path>, draws: Option<&PosteriorDraws>) -> miette::Result<MapAnswer> {
    case.check_window()?;
    let traffic = traffic.map(Traffic::read).transpose()?;
    let progress = Progress::new(riffel_keys::say!(progress_growth_map), case.speed.points());
    let mut map = MapAnswer::new(case, |rows| progress.advance(rows));
    map.over_posterior = over(draws, growth_over)?;
    if draws.is_none() {
        map.under_traffic = Some(LineGrowth::new(case, traffic.as_ref())?);
    }
    Ok(map)
}

/// `Ok` if there is a case to report on, and nothing is said of a rail.
fn check_without_roughness(arguments: &Report) -> Result<(), CliError> {
    let wrong = |argument, value: &str, rule: &str| {
        Err(CliError::Argument { argument, value: value.to_owned(), rule: rule.to_owned() })
    };
    if let Some(argument) = arguments.record.given() {
        return wrong(argument, "given", "left out where there is no --roughness");
    }
    if arguments.case.is_none() {
        let rule = "given where there is no case to report on";
        return wrong("--roughness", "left out", rule);
    }
    Ok(())
}

/// What was measured, held to limits and diagnosed.
fn measured(
    path: &Path,
    case: Option<&Case>,
    record: &DiagnosisArguments,
    limits: &[LimitTable],
) -> miette::Result<Measured> {
    let file = read(path, &record.layout)?;
    // The diagnosis looks at the heights, which the statistics use up.
    let diagnosis = match case {
        Some(case) => Some(record.rail().diagnosis(case, path, &file, &Terminal)?),
        None => None,
    };
    Ok(match file {
        RoughnessFile::Profile(profile) => {
            choose_nothing(path, &record.choose, record.by.as_deref())?;
            let strips = ProfileStrips::new(&profile, language()).map_err(CliError::from)?;
            let growing = match record.layout.keep_defects {
                true => profile.clone(),
                false => profile.clone().without_defects(),
            };
            let survey = Survey::of(path, RoughnessFile::Profile(growing))?;
            let before = Before::of_table(&survey);
            let (survey, date) = survey.latest();
            let statistics = Statistics { block: Quantity::new(block_of_strip(&profile)), ..Statistics::default() };
            let answer = judged(path, profile, limits, &statistics)?;
            Measured {
                understood: answer.understood(),
                date,
                survey,
                before,
                roughness: MeasuredRoughness::Profile { strips, answer: Box::new(answer) },
                diagnosis,
            }
        }
        RoughnessFile::Spectra(spectra, warnings) => {
            let survey = Survey::new(path, spectra, warnings)?.choose(&record.choose)?;
            let by = record.by.as_deref().or_else(|| survey.date_column());
            let before = Before::of_table(&survey);
            let (latest, date) = survey.clone().latest();
            let answer = SpectraAnswer::new(&survey, limits, by)?;
            Measured {
                understood: match (answer.count(), &record.choose[..]) {
                    (count, []) => say!(one_third_octave_spectra, count = count),
                    (count, choose) => say!(chosen_spectra, count = number(count), choices = choose.join(", ")),
                },
                date,
                survey: latest,
                before,
                roughness: MeasuredRoughness::Spectra(answer),
                diagnosis,
            }
        }
    })
}

/// What the record says of now; none without a diagnosis, for the speeds are its.
fn now<'a>(path: &'a Path, rail: &Measured, record: &DiagnosisArguments) -> Option<Now<'a>> {
    let diagnosis = rail.diagnosis.as_ref()?;
    Some(Now {
        path,
        survey: rail.survey.clone(),
        date: rail.date.or_else(|| record.earlier.dates.last().copied()),
        speed: diagnosis.speeds.mean(),
    })
}

/// What becomes of the rail, or why that is left out; `wear` is the fit that the case goes by, or why there is none.
fn outlook(
    arguments: &Report,
    given: &GivenCase<'_>,
    limits: &[LimitTable],
    now: &Now<'_>,
    wear: Option<Result<WearReport, Message>>,
) -> miette::Result<Result<TrackForecast, Message>> {
    let Some(limit) = level_limit(arguments, limits) else {
        return Ok(Err(say!(needs_a_limit_of_levels)));
    };
    let Some(traffic) = &arguments.record.traffic else {
        return Ok(Err(say!(no_traffic_given)));
    };
    let asked = ForecastQuestion {
        case: given.arguments().source(),
        spectra: MeasuredSpectra { spectrum: Some(now.survey.clone().into()), ..MeasuredSpectra::default() },
        ground: arguments.ground.source(),
        traffic: Some(Source::File(traffic.clone())),
        posterior: None,
        limit,
        passages: None,
        mgt: None,
        months: arguments.months,
        date: now.date,
    };
    let mut answer = asked.answer_on(&given.case, &Terminal)?;
    match wear {
        Some(Ok(fit)) => answer.wear = Some(fit),
        Some(Err(why)) => answer.warnings.push(why),
        None => (),
    }
    Ok(Ok(answer))
}

/// What a coach sounds like on the rail at the mean speed of the traffic, or why that is left out.
fn heard(
    arguments: &Report,
    case: &Case,
    limits: &[LimitTable],
    now: &Now<'_>,
    draws: Option<&PosteriorDraws>,
) -> miette::Result<Result<NoiseAnswer, Message>> {
    let Some(limit) = level_limit(arguments, limits) else {
        return Ok(Err(say!(needs_a_limit_of_levels)));
    };
    let question = NoiseQuestion {
        traffic: arguments.record.traffic.clone().map(Source::File),
        months: arguments.months.unwrap_or(MONTHS_OF_NOISE),
        limit_dba: arguments.limit_dba,
        wheel_roughness: arguments.wheel_roughness.clone().map(RoughWheels::Named),
        wheel_modes: arguments.wheel_modes.clone(),
        ..NoiseQuestion::of_a_coach(case.clone(), now.survey.clone(), now.speed, &limit)?
    };
    // A case whose track does not radiate, and bands that do not meet, leave the rest of the report as it is.
    let answer = question.answer_over(draws, &Terminal);
    Ok(answer.map_err(|error| error.message()))
}

/// What would help, with what is measured now if anything is, or why that is left out.
fn what_if(
    arguments: &Report,
    given: &GivenCase<'_>,
    limits: &[LimitTable],
    now: Option<&Now<'_>>,
) -> miette::Result<Result<CompareAnswer, Message>> {
    let Some(limit) = level_limit(arguments, limits) else {
        return Ok(Err(say!(needs_a_limit_of_levels)));
    };
    if arguments.variants.is_empty() {
        return Ok(Err(say!(no_variant_given)));
    }
    let traffic = arguments.record.traffic.clone();
    let mut question = CompareQuestion::of_variants(given.arguments().source(), &limit)?;
    question.variants = arguments.variants.iter().cloned().map(Source::File).collect();
    question.speed = now.filter(|_| traffic.is_none()).map(|now| Quantity::new(now.speed).into());
    question.traffic = traffic.map(Source::File);
    question.posterior = PosteriorSource { posterior: arguments.posterior.clone() };
    question.hold = arguments.hold.map(Hold::from);
    question.spectrum = now.map(|now| now.survey.clone().into());
    question.ground = arguments.ground.source();
    Ok(Ok(question.answer_on(&given.case, &Terminal)?))
}

/// The limit of levels that forecast and what-if go by: the one asked for, or the first of all.
fn level_limit(arguments: &Report, limits: &[LimitTable]) -> Option<String> {
    let is_of_levels = |table: &LimitTable| matches!(table.limit, Limit::Levels(_));
    let first = limits.iter().find(|table| is_of_levels(table))?;
    let given = arguments.limit.iter().find(|name| LimitTable::find(name).is_ok_and(|table| is_of_levels(&table)));
    Some(given.unwrap_or(&first.name).clone())
}
