//! The level in months to come.

use riffel::forecast::Forecast;
use riffel::roughness::Spectrum;
use riffel_case::traffic::bands_of;
use riffel_case::{Case, Variant};
use riffel_keys::Message;

use super::{Future, NoiseRequest, Part, levels_of};
use crate::AnswerError;

/// Steps of the time looked ahead.
const STEPS: u32 = 24;

/// The A-weighted level of a train on a rail that grows rougher, or smoother, under traffic.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Months from now.
    pub months: Vec<f64>,
    /// Level of all parts \[dB(A)\].
    pub levels: Vec<f64>,
    /// Highest level that is allowed \[dB(A)\].
    pub limit: Option<f64>,
    /// Months until the level reaches the limit; none where it does not.
    pub months_to_limit: Option<f64>,
    /// The time looked ahead goes beyond the linear range of growth, where the course ends.
    pub cut: bool,
    /// What the reader should know about the growth.
    pub remarks: Vec<Message>,
}

impl Course {
    /// The level of the train of the request, while the rail changes under the traffic; wavelengths outside the map of the
    /// case keep their level.
    pub(super) fn new(
        case: &Case,
        request: &NoiseRequest,
        future: &Future,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, AnswerError> {
        let bands = bands_of(case);
        let on = future
            .traffic
            .on(case, &bands, &Variant::none(""), progress)?;
        let per_month = on
            .passages_per_month()
            .ok_or(AnswerError::NoPassagesPerDay)?;
        let forecast = Forecast::new(&request.roughness, on.growth.clone())
            .map_err(AnswerError::OutsideWindow)?;
        // The course ends at one month whatever time is asked for, and so does a limit that is reached before.
        let linear = forecast.valid_to() / per_month;
        let end = future.months.min(linear);
        let months: Vec<f64> = if end > 0.0 {
            let share = |step| f64::from(step) / f64::from(STEPS);
            (0..=STEPS).map(|step| end * share(step)).collect()
        } else {
            vec![0.0]
        };
        let level = |month: f64| -> Result<f64, AnswerError> {
            let passages = (month * per_month).min(forecast.valid_to());
            let roughness = then(&request.roughness, &forecast.spectrum(passages)?)?;
            let heard = levels_of(case, request, &roughness, request.speed)?;
            Ok(heard.a_weighted(Part::Total))
        };
        let levels: Vec<f64> = months
            .iter()
            .map(|&month| level(month))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            months_to_limit: match future.limit {
                Some(limit) => reached(&months, &levels, limit, level)?,
                None => None,
            },
            cut: linear < future.months,
            limit: future.limit,
            months,
            levels,
            remarks: on.remarks,
        })
    }
}

impl Course {
    /// The course as one sentence without its full stop.
    pub fn in_words(&self) -> String {
        // A course begins with the level of now.
        let (from, to) = (self.levels[0], self.levels[self.levels.len() - 1]);
        let months = self.months[self.months.len() - 1];
        let mut sentence =
            format!("under the traffic {from:.1} dB(A) become {to:.1} dB(A) in {months:.1} months");
        if self.cut {
            sentence += ", where roughness leaves the linear range";
        }
        match (self.limit, self.months_to_limit) {
            (None, _) => sentence,
            (Some(limit), Some(0.0)) if to < limit => {
                format!("{sentence}; it is above {limit} dB(A) now and falls below")
            }
            (Some(limit), Some(0.0)) => format!("{sentence}; {limit} dB(A) are reached now"),
            (Some(limit), Some(months)) => {
                format!("{sentence}; {limit} dB(A) are reached in {months:.1} months")
            }
            (Some(limit), None) => format!("{sentence}; {limit} dB(A) are not reached"),
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
    let (mut below, mut above) = (months[before], months[place]);
    let enough = 1e-4 * (above - below);
    while above - below > enough {
        let middle = 0.5 * (below + above);
        if level(middle)? < limit {
            below = middle;
        } else {
            above = middle;
        }
    }
    Ok(Some(above))
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
