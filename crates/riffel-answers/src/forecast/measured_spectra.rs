//! What was measured now and before.

use std::sync::Arc;

use jiff::civil::Date;
use riffel_keys::Message;
use riffel_rail::{Elapsed, RailDates, Survey};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::AnswerError;
use crate::question::{Client, EarlierRecords, RecordLayout, Source};

/// What was measured of a rail, now and before.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct MeasuredSpectra {
    /// Measured rail: a table of one-third-octave levels or a longitudinal profile; the energy mean of its
    /// records is taken. Of several dates the latest is now, and growth goes on as measured.
    #[schemars(extend("value_name" = "FILE"))]
    pub spectrum: Option<Source<Survey>>,
    /// How the records are read.
    #[serde(flatten)]
    pub layout: RecordLayout,
    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[serde(rename = "where")]
    #[schemars(extend("value_name" = "COLUMN=VALUE"))]
    pub choose: Vec<String>,
    /// Column of dates, as 2026-01-31 or 31.01.2026: the latest is now, the earliest before.
    #[schemars(extend("value_name" = "COLUMN"))]
    pub date_column: Option<String>,
    /// Records before the spectrum.
    #[serde(flatten)]
    pub earlier: EarlierRecords,
    /// Keep the earlier spectra whose column has this value [default file: that of --spectrum].
    #[schemars(extend("value_name" = "COLUMN=VALUE"))]
    pub earlier_where: Vec<String>,
    /// Axle passages between the oldest record and that of now [default: from the dates and the traffic file].
    #[schemars(extend("value_name" = "N"))]
    pub passages_between: Option<f64>,
}

/// The survey of now, with its history, and the oldest one, with the days between if they are dated.
pub(super) struct Dated {
    pub(super) now: Survey,
    pub(super) earlier: Option<Survey>,
    /// The oldest and now place by place, where both are profiles: more records tell how sure a change is.
    pub(super) places: Option<[Survey; 2]>,
    pub(super) date: Option<Date>,
    pub(super) days: Option<f64>,
}

impl MeasuredSpectra {
    /// All spectra of now, if they are given.
    pub(super) fn read(&self, client: &dyn Client) -> Result<Option<Arc<Survey>>, AnswerError> {
        let spectrum = self.spectrum.as_ref();
        spectrum.map(|spectrum| spectrum.value(|path| self.layout.survey(path, client))).transpose()
    }

    /// Whether a fit of the wear coefficient is asked for: a table of several dates is fitted by itself, if it can be.
    pub(super) fn asks_for_fit(&self) -> bool {
        self.date_column.is_some() || !self.earlier.earlier.is_empty() || !self.earlier_where.is_empty()
    }

    /// The latest records before and now, place by place too where both are profiles; those of now with both as their history.
    pub(super) fn latest_of_both(
        &self,
        passages: f64,
        client: &dyn Client,
    ) -> Result<(Survey, Option<[Survey; 2]>, Survey), AnswerError> {
        let now = self.read(client)?.ok_or(AnswerError::NoSpectrum)?;
        let (mut now, _) = Arc::unwrap_or_clone(now).latest();
        now.history = None;
        let path = self.spectrum.as_ref().and_then(Source::path);
        let mut history = self.earlier.read(path, &self.layout, &[], client)?;
        let earlier = history.surveys.into_iter().next();
        let earlier = earlier.ok_or_else(|| AnswerError::argument("--earlier", "left out", "given"))?;
        let (earlier, _) = earlier.latest();
        history.surveys = vec![earlier.clone()];
        let now = history.before(now, Some(passages));
        Ok((earlier, history.places, now))
    }

    /// What is chosen of all spectra of now, and of those before, which are read here.
    pub(super) fn dated(&self, given: &Survey, client: &dyn Client) -> Result<Dated, AnswerError> {
        let mut now = given.clone().choose(&self.choose)?.on_one_device();
        let path = self.spectrum.as_ref().and_then(Source::path);
        let mut history = self.earlier.read(path, &self.layout, &self.earlier_where, client)?;
        if history.surveys.is_empty() && !self.earlier_where.is_empty() {
            history.surveys.push(given.clone().choose(&self.earlier_where)?);
        }
        let earlier = history.surveys.first();
        now.warnings.extend(earlier.and_then(|earlier| now.device_since(earlier)));
        let (mut date, mut days) = history.days().unzip();
        if let Some(column) = &self.date_column {
            let before = earlier.map(|earlier| earlier.by_date(column)).transpose()?;
            let own = now.by_date(column)?;
            let all: Vec<(Date, Survey)> = before.into_iter().flatten().chain(own).collect();
            (now, date, days) = by_column(column, all, now.warnings)?;
        } else if history.surveys.is_empty() {
            (now, date) = now.latest();
        } else {
            now = history.before(now, self.passages_between);
        }
        let oldest = now.history.as_ref().map(|history| &history.dates[0]);
        if history.surveys.is_empty() {
            days = days.or(oldest.map(|oldest| -oldest.0));
        }
        let earlier = earlier.filter(|_| self.date_column.is_none());
        Ok(Dated {
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
) -> Result<(Survey, Option<Date>, Option<f64>), AnswerError> {
    let wrong = |rule: String| AnswerError::argument("--date-column", column, rule);
    let Some((date, mut now)) = all.pop() else {
        return Err(wrong("one with a date".to_owned()));
    };
    now.warnings = warnings;
    let mut earlier = Vec::new();
    for (before, survey) in all {
        let span = date.since(before).map_err(|error| wrong(format!("dates that can be compared: {error}")))?;
        let days = f64::from(span.get_days());
        if days <= 0.0 {
            let rule = format!("earlier than {date}, the date of the spectrum");
            return Err(AnswerError::argument("--earlier", before, rule));
        }
        earlier.push((days, survey));
    }
    let days = earlier.first().map(|(days, _)| *days);
    if days.is_some() {
        now.history = Some(RailDates::new(&now, earlier, Elapsed::Days));
    }
    Ok((now, Some(date), days))
}
