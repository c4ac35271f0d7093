//! The level in months to come.

use riffel::roughness::Spectrum;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Variant};
use riffel_keys::{Message, fixed, number, say};
use riffel_noise::Part;
use riffel_numerics::bisection::fallible_bisection;
use serde::Serialize;

use super::at_least;
use super::sources::Radiation;
use super::train::Train;
use crate::forecast::RailStart;
use crate::{AnswerError, Result};

/// Steps of the time looked ahead.
const STEPS: u32 = 24;

/// The A-weighted level of a train on a rail that grows rougher, or smoother, under traffic.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LevelTrend {
    /// Months from now.
    pub month: Vec<f64>,
    /// Level of all parts \[dB(A)\].
    pub total_dba: Vec<f64>,
    /// Highest level that is allowed \[dB(A)\].
    pub limit_dba: Option<f64>,
    /// Months until the level reaches the limit; `None` if it does not.
    pub months_to_limit: Option<f64>,
    /// The time looked ahead goes beyond the linear range of growth, where the course ends.
    pub beyond_linear_range: bool,
}

impl LevelTrend {
    /// The level of a train while the rail changes under traffic, `None` if no months follow from how it grows, and remarks on its
    /// growth; wavelengths outside the map of the case keep their level.
    pub(super) fn new(
        case: &Case,
        train: &Train,
        radiation: &Radiation<'_>,
        traffic: &Traffic,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<(Option<Self>, Vec<Message>)> {
        let on = traffic.on(case, &bands_of(case), &Variant::none(""), progress)?;
        let per_month = on.passages_per_month().ok_or(AnswerError::NoPassagesPerDay)?;
        let start = RailStart {
            levels: train.roughness.clone().into(),
            is_measured: true,
            is_of_case: true,
            growth: (train.history.as_ref()).and_then(|history| history.growth(None, on.passages_per_day)),
        };
        let has_dates = train.history.is_some();
        let per_day = on.passages_per_day;
        let without = RailStart::without_dates(std::slice::from_ref(&start), has_dates, false, per_day);
        let forecast = start.forecast(&on).map_err(AnswerError::OutsideWindow)?;
        let without_time = start.without_time(&forecast, &on);
        let mut remarks: Vec<Message> = on.remarks.into_iter().chain(without).collect();
        if let Some(reason) = without_time {
            remarks.insert(0, say!(noise_without_course, reason));
            return Ok((None, remarks));
        }
        // The course ends at one month whatever time is asked for, and so does a limit that is reached before.
        let linear = forecast.valid_to() / per_month;
        let end = train.months.min(linear);
        let month: Vec<f64> = if end > 0.0 {
            let share = |step| f64::from(step) / f64::from(STEPS);
            (0..=STEPS).map(|step| end * share(step)).collect()
        } else {
            vec![0.0]
        };
        let level = |month: f64| -> Result<f64> {
            let passages = (month * per_month).min(forecast.valid_to());
            let roughness = then(&train.roughness, &forecast.spectrum(passages)?)?;
            let levels = train.levels(radiation, &roughness)?;
            Ok(levels.a_weighted(Part::Total).unwrap_or(f64::NEG_INFINITY))
        };
        let levels = month.iter().map(|&month| level(month));
        let total_dba = levels.collect::<Result<Vec<_>, _>>()?;
        let course = Self {
            months_to_limit: match train.limit_dba {
                Some(limit) => reached(&month, &total_dba, limit, level)?,
                None => None,
            },
            beyond_linear_range: linear < train.months,
            limit_dba: train.limit_dba,
            month,
            total_dba,
        };
        Ok((Some(course), remarks))
    }

    /// The course in a sentence without its full stop, its levels lower bounds where the bands end at a frequency \[Hz\].
    pub fn in_words(&self, up_to: Option<f64>) -> Message {
        // A course begins with the level of now.
        let last = self.total_dba.len() - 1;
        let [from, to] = [0, last].map(|place| at_least(self.total_dba[place], up_to));
        let months = fixed(self.month[last], 1);
        let course = match self.beyond_linear_range {
            false => say!(noise_becomes, from, to, months),
            true => say!(noise_becomes_to_linear_end, from, to, months),
        };
        let Some(limit) = self.limit_dba else {
            return course;
        };
        let falls_below = self.total_dba[last] < limit;
        let limit = number(limit);
        match self.months_to_limit {
            Some(0.0) if falls_below => say!(noise_falls_below, sentence = course, limit),
            Some(0.0) => say!(noise_limit_now, sentence = course, limit),
            Some(months) => {
                let months = fixed(months, 1);
                say!(noise_limit_in_months, sentence = course, limit, months)
            }
            None if up_to.is_some() => {
                say!(noise_limit_not_known, sentence = course, limit)
            }
            None => say!(noise_limit_not_reached, sentence = course, limit),
        }
    }
}

/// The spectrum of which some bands have changed.
fn then(now: &Spectrum, changed: &Spectrum) -> Result<Spectrum, riffel::Error> {
    now.map(|level| changed.level(level.band).unwrap_or(level.level))
}

/// When a level first reaches a limit: between the first two of its values that have the limit between them, by halving to
/// 1e-4 of the time between them.
fn reached<E>(
    months: &[f64],
    levels: &[f64],
    limit: f64,
    level: impl Fn(f64) -> Result<f64, E>,
) -> Result<Option<f64>, E> {
    let Some(place) = levels.iter().position(|&level| level >= limit) else {
        return Ok(None);
    };
    let Some(before) = place.checked_sub(1) else {
        return Ok(Some(months[place]));
    };
    let between = [months[before], months[place]];
    let enough = 1e-4 * (between[1] - between[0]);
    let [_, first] = fallible_bisection(between, enough, |month| Ok(level(month)? >= limit))?;
    Ok(Some(first))
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;

    #[test]
    fn a_limit_is_reached_between_two_months() {
        let (months, levels) = ([0.0, 1.0, 2.0], [80.0, 84.0, 81.0]);
        let between = |month: f64| Ok::<_, Infallible>(80.0 + 4.0 * month.powi(2));
        let at = |limit: f64| reached(&months, &levels, limit, between).unwrap();
        assert!((at(81.0).unwrap() - 0.5).abs() < 1e-4);
        assert_eq!(at(79.0), Some(0.0));
        assert_eq!(at(85.0), None);
    }
}
