//! What was measured now and before.

use jiff::civil::Date;
use riffel_keys::Message;
use riffel_rail::{Elapsed, RailDates, Survey};

use crate::arguments::Spectra;
use crate::error::CliError;
use crate::terminal::Terminal;

/// The survey of now, with its history, and the oldest one, with the days between if they are dated.
pub(super) struct Dated {
    pub(super) now: Survey,
    pub(super) earlier: Option<Survey>,
    /// The oldest and now place by place, where both are profiles: more records tell how sure a change is.
    pub(super) places: Option<[Survey; 2]>,
    pub(super) date: Option<Date>,
    pub(super) days: Option<f64>,
}

impl Dated {
    /// Chosen of all spectra of `--spectrum`, and of those of `--earlier`, which are read here.
    pub(super) fn new(spectra: &Spectra, given: Survey) -> miette::Result<Self> {
        let mut now = given.clone().choose(&spectra.choose)?.on_one_device();
        let path = spectra.spectrum.as_deref();
        let records = spectra.earlier.records();
        let mut history = records.read(path, &spectra.layout.records(), &spectra.earlier_choose, &Terminal)?;
        if history.surveys.is_empty() && !spectra.earlier_choose.is_empty() {
            let earlier = given.choose(&spectra.earlier_choose)?;
            history.surveys.push(earlier);
        }
        let earlier = history.surveys.first();
        now.warnings.extend(earlier.and_then(|earlier| now.device_since(earlier)));
        let of_files = history.days();
        let (mut date, mut days) = (of_files.map(|it| it.0), of_files.map(|it| it.1));
        if let Some(column) = &spectra.date_column {
            let before = earlier.map(|earlier| earlier.by_date(column)).transpose()?;
            let own = now.by_date(column)?;
            let all: Vec<(Date, Survey)> = before.into_iter().flatten().chain(own).collect();
            (now, date, days) = by_column(column, all, now.warnings)?;
        } else if history.surveys.is_empty() {
            (now, date) = now.latest();
        } else {
            now = history.before(now, spectra.passages_between);
        }
        let oldest = now.history.as_ref().map(|history| &history.dates[0]);
        if history.surveys.is_empty() {
            days = days.or(oldest.map(|oldest| -oldest.0));
        }
        let earlier = earlier.filter(|_| spectra.date_column.is_none());
        Ok(Self {
            earlier: earlier.or(oldest.map(|oldest| &oldest.1)).cloned(),
            now,
            places: history.places,
            date,
            days,
        })
    }
}

/// The latest of some records by a column of dates, with those of all dates, its date and the days since the earliest.
fn by_column(
    column: &str,
    mut all: Vec<(Date, Survey)>,
    warnings: Vec<Message>,
) -> Result<(Survey, Option<Date>, Option<f64>), CliError> {
    let wrong = |rule: String| CliError::Argument { argument: "--date-column", value: column.to_owned(), rule };
    let Some((date, mut now)) = all.pop() else {
        return Err(wrong("one with a date".to_owned()));
    };
    now.warnings = warnings;
    let mut earlier = Vec::new();
    for (before, survey) in all {
        let span = date.since(before).map_err(|error| wrong(format!("dates that can be compared: {error}")))?;
        let days = f64::from(span.get_days());
        if days <= 0.0 {
            return Err(CliError::Argument {
                argument: "--earlier",
                value: before.to_string(),
                rule: format!("earlier than {date}, the date of the spectrum"),
            });
        }
        earlier.push((days, survey));
    }
    let days = earlier.first().map(|(days, _)| *days);
    if days.is_some() {
        now.history = Some(RailDates::new(&now, earlier, Elapsed::Days));
    }
    Ok((now, Some(date), days))
}
