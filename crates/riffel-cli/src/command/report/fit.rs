//! The wear coefficient that a report goes by, where an earlier record tells it.

use std::path::Path;

use jiff::civil::Date;
use riffel_answers::forecast::WearReport;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Variant};
use riffel_keys::{Message, say};
use riffel_rail::{LimitTable, Survey};

use super::{Now, level_limit};
use crate::arguments::Report;
use crate::error::CliError;
use crate::progress::Progress;
use crate::terminal::Terminal;

/// The rail as it was before.
#[derive(Clone)]
pub(super) struct Before {
    survey: Survey,
    places: Option<[Survey; 2]>,
    date: Option<Date>,
}

impl Before {
    /// The oldest of the earlier records of the command line; with all of them the rail of now has a history.
    pub(super) fn of_arguments(arguments: &Report, now: Option<&mut Now<'_>>) -> miette::Result<Option<Self>> {
        let record = &arguments.record;
        let path = arguments.roughness.as_deref();
        let history = record.earlier.records().read(path, &record.layout.records(), &record.choose, &Terminal)?;
        let Some(oldest) = history.surveys.first() else {
            return Ok(None);
        };
        let (survey, written) = oldest.clone().latest();
        if let Some(now) = now {
            now.survey = history.before(now.survey.clone(), arguments.passages_between);
        }
        Ok(Some(Self { survey, places: history.places, date: record.earlier.dates.first().copied().or(written) }))
    }

    /// The earliest records of a table of several dates, as `riffel forecast --date-column` takes them.
    pub(super) fn of_table(survey: &Survey) -> Option<Self> {
        let dates = survey.by_date(survey.column_of_several_dates()?).ok()?;
        let (date, survey) = dates.into_iter().next()?;
        Some(Self { survey, places: None, date: Some(date) })
    }
}

/// The fit of the change from before to now under the traffic, or why there is none.
pub(super) fn fit(
    arguments: &Report,
    case: &Case,
    limits: &[LimitTable],
    traffic: &Path,
    before: &Before,
    now: &Now<'_>,
) -> miette::Result<Result<WearReport, Message>> {
    let traffic = Traffic::read(traffic)?;
    let progress = Progress::new(riffel_keys::say!(progress_fit), traffic.file.vehicle.len());
    let on = traffic.on(case, &bands_of(case), &Variant::none(""), &|by| {
        progress.advance(by);
    })?;
    let days = before.date.zip(now.date).and_then(|(before, now)| {
        let days = now.since(before).ok()?.get_days();
        (days > 0).then(|| f64::from(days))
    });
    let by_date = days.and_then(|days| on.passages_in(days));
    let Some(passages) = arguments.passages_between.or(by_date) else {
        return Ok(Err(say!(not_fitted_without_passages)));
    };
    let limit = match level_limit(arguments, limits) {
        Some(name) => Some(riffel_answers::level_limit(&name)?.1),
        None => None,
    };
    let places = before.places.as_ref();
    let report = WearReport::since(&before.survey, places, &now.survey, (case, &on), limit.as_ref(), passages);
    Ok(report.map_err(|error| say!(coefficient_not_fitted, reason = error.message())))
}

/// `Ok` if passages between two records are given only where there are two.
pub(super) fn check_passages(arguments: &Report, before: Option<&Before>) -> Result<(), CliError> {
    match (arguments.passages_between, before) {
        (Some(passages), None) => Err(CliError::Argument {
            argument: "--passages-between",
            value: passages.to_string(),
            rule: "left out, for there is no earlier record; give --earlier".to_owned(),
        }),
        _ => Ok(()),
    }
}
