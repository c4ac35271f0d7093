//! The rail that a forecast begins with.

use jiff::civil::Date;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel::roughness::LevelLimit;
use riffel_answers::forecast::RailStart;
use riffel_keys::Message;
use riffel_rail::{Elapsed, GroundRail, RailDates, Survey, read_date};

use crate::array::owned;
use crate::arrays_of_rails::spectrum;
use crate::errors::{of_case, wrong};

/// Wavelengths \[m\] and levels \[dB re 1 µm\].
pub(crate) type GivenLevels<'py> = (PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>);

/// Levels of now, earlier ones, the oldest first, and the dates of all.
pub(crate) type GivenDates<'py> = (GivenLevels<'py>, Vec<GivenLevels<'py>>, Vec<String>);

/// Limit table that grinding meets, and decibels below the limit.
pub(crate) type GivenGround = (Option<String>, Option<String>);

/// A rail as it was measured, and as it will be ground.
#[derive(Clone)]
pub(crate) struct Begins {
    survey: Option<Survey>,
    ground: Option<GroundRail>,
}

impl Begins {
    pub(crate) fn new(
        measured: Option<GivenDates<'_>>,
        ground: GivenGround,
        limit: &LevelLimit,
        edition: &str,
    ) -> PyResult<Self> {
        let ground = match ground {
            (Some(name), None) => Some(GroundRail::of_table(&name).map_err(of_case)?),
            (None, Some(decibels)) => {
                let below = GroundRail::below(edition, limit, &decibels);
                let refused = |rule| wrong(format!("from_limit is {decibels:?}, but must be {rule}"));
                Some(below.map_err(refused)?)
            }
            (None, None) => None,
            (Some(_), Some(_)) => {
                return Err(wrong("ground and from_limit exclude each other: give one"));
            }
        };
        let survey = measured.as_ref().map(survey).transpose()?;
        Ok(Self { survey, ground })
    }

    /// The rails under so many axle passages a day.
    pub(crate) fn starts(&self, passages_per_day: Option<f64>) -> Vec<RailStart> {
        // The rail has no name.
        RailStart::of(&[], self.survey.as_ref(), self.ground.as_ref(), passages_per_day)
    }

    /// Why the dates of the rail do not tell how it grows, if they do not.
    pub(crate) fn remark(&self, passages_per_day: Option<f64>) -> Option<Message> {
        let survey = self.survey.as_ref()?;
        let starts = self.starts(passages_per_day);
        RailStart::without_growth(&starts, survey, self.ground.is_some(), passages_per_day)
    }
}

/// The levels of now with those before them.
pub(crate) fn survey((now, earlier, dates): &GivenDates<'_>) -> PyResult<Survey> {
    let of = |(wavelengths, levels): &GivenLevels<'_>| {
        Ok::<_, PyErr>(Survey::of_spectrum(spectrum(&owned(wavelengths), &owned(levels))?))
    };
    let mut now = of(now)?;
    if earlier.is_empty() {
        return Ok(now);
    }
    let read: Result<Vec<Date>, _> = dates.iter().map(|date| read_date(date)).collect();
    let read = read.map_err(|said| wrong(said.to_string()))?;
    let [before @ .., last] = &read[..] else {
        return Err(wrong("dates is empty, but must be the dates of all records"));
    };
    if !read.is_sorted_by(|one, next| one < next) {
        let written = dates.join(", ");
        return Err(wrong(format!("dates is {written}, but must be the oldest first, each later than the one before")));
    }
    let days = before.iter().map(|date| {
        let span = last.since(*date).map_err(|error| wrong(error.to_string()))?;
        Ok(f64::from(span.get_days()))
    });
    let days = days.collect::<PyResult<Vec<f64>>>()?;
    let surveys = earlier.iter().map(of).collect::<PyResult<Vec<Survey>>>()?;
    let earlier = days.into_iter().zip(surveys).collect();
    now.history = Some(RailDates::new(&now, earlier, Elapsed::Days));
    Ok(now)
}
