//! What was measured of a rail before now, as the command line names it.

use std::path::Path;

use jiff::civil::Date;
use riffel_rail::{Elapsed, RailDates, Survey};

use super::roughness::{places_of_both, survey};
use crate::arguments::{Earlier, Layout};
use crate::error::CliError;

/// Earlier records of a rail, the oldest first.
pub(crate) struct History {
    /// All that were named.
    pub(crate) surveys: Vec<Survey>,
    /// The oldest and now place by place, where both are profiles: more records tell how sure a change is.
    pub(crate) places: Option<[Survey; 2]>,
    dates: Vec<Date>,
}

impl History {
    /// The records that are named beside that of now, each as it is chosen.
    pub(crate) fn read(
        earlier: &Earlier,
        now: Option<&Path>,
        layout: &Layout,
        choose: &[String],
    ) -> miette::Result<Self> {
        check_dates(earlier)?;
        let files = earlier.files.iter();
        let surveys = files.map(|path| Ok(survey(path, layout)?.choose(choose)?));
        Ok(Self {
            surveys: surveys.collect::<miette::Result<_>>()?,
            places: match (earlier.files.first(), now) {
                (Some(before), Some(now)) => places_of_both(before, now, layout)?,
                _ => None,
            },
            dates: earlier.dates.clone(),
        })
    }

    /// The latest of a survey as it is chosen, with the records that are named beside it, each with its date.
    pub(crate) fn of_dates(
        survey: Survey,
        earlier: &Earlier,
        now: Option<&Path>,
        layout: &Layout,
        choose: &[String],
    ) -> miette::Result<Survey> {
        if !earlier.files.is_empty() && earlier.dates.is_empty() {
            Err(CliError::Argument {
                argument: "--dates",
                value: "left out".to_owned(),
                rule: "given beside --earlier: the date of each record, that of now last".to_owned(),
            })?;
        }
        let (survey, _) = survey.choose(choose)?.latest();
        Ok(Self::read(earlier, now, layout, choose)?.before(survey, None))
    }

    /// `Ok` if there is a record of now, or none before it.
    pub(crate) fn check_now(earlier: &Earlier, now: Option<&Path>) -> Result<(), CliError> {
        match (earlier.files.first(), now) {
            (Some(file), None) => Err(CliError::Argument {
                argument: "--earlier",
                value: file.display().to_string(),
                rule: "left out, for there is no record of now; give --spectrum".to_owned(),
            }),
            _ => Ok(()),
        }
    }

    /// Date of now, and the days since the oldest; none without dates.
    pub(crate) fn days(&self) -> Option<(Date, f64)> {
        let (oldest, latest) = (self.dates.first()?, self.dates.last()?);
        Some((*latest, days_between(*oldest, *latest)?))
    }

    /// The survey of now with these before it, at their dates or else, of one, so many axle passages ago; unless it is of several dates.
    pub(crate) fn before(&self, mut now: Survey, passages: Option<f64>) -> Survey {
        if now.history.is_some() || self.surveys.is_empty() {
            return now;
        }
        let latest = self.dates.last();
        let days = (self.dates.iter()).map(|date| days_between(*date, *latest?));
        let (ago, elapsed) = match (passages, days.collect::<Option<Vec<f64>>>()) {
            (Some(passages), _) if self.surveys.len() == 1 => (vec![passages], Elapsed::Passages),
            (_, Some(days)) if !days.is_empty() => (days, Elapsed::Days),
            _ => return now,
        };
        let dated = |now: &Survey, surveys: &[Survey]| {
            let earlier = ago.iter().copied().zip(surveys.iter().cloned());
            RailDates::new(now, earlier.collect(), elapsed)
        };
        now.history = Some(match (&self.places, &self.surveys[..]) {
            (Some([before, now]), [_]) => dated(now, std::slice::from_ref(before)),
            _ => dated(&now, &self.surveys),
        });
        now
    }
}

fn days_between(earlier: Date, later: Date) -> Option<f64> {
    Some(f64::from(later.since(earlier).ok()?.get_days()))
}

/// `Ok` if there is a date for each record, each later than the one before, or none at all.
pub(crate) fn check_dates(earlier: &Earlier) -> Result<(), CliError> {
    let (dates, records) = (&earlier.dates, earlier.files.len() + 1);
    if dates.is_empty() || (dates.len() == records && dates.is_sorted_by(|one, next| one < next)) {
        return Ok(());
    }
    let written: Vec<String> = dates.iter().map(Date::to_string).collect();
    Err(CliError::Argument {
        argument: "--dates",
        value: written.join(","),
        rule: match dates.len() == records {
            true => "days that rise from each record to the next, that of now last".to_owned(),
            false => {
                format!("{records} dates, one for each --earlier and one for the record of now")
            }
        },
    })
}
