//! The level in months to come.

use riffel::forecast::Forecast;
use riffel::roughness::Spectrum;
use riffel_case::traffic::bands_of;
use riffel_case::{Case, Variant};

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
    /// Months until the level reaches the limit, straight between two steps; none where it does not.
    pub months_to_limit: Option<f64>,
    /// The time looked ahead goes beyond the linear range of growth, where the course ends.
    pub cut: bool,
    /// What the reader should know about the growth.
    pub remarks: Vec<String>,
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
        if !(future.months.is_finite() && future.months > 0.0) {
            return Err(AnswerError::Argument {
                argument: "--months",
                value: future.months.to_string(),
                rule: "finite and greater than zero".to_owned(),
            });
        }
        let bands = bands_of(case);
        let on = future
            .traffic
            .on(case, &bands, &Variant::none(""), progress)?;
        let per_month = on
            .passages_per_month()
            .ok_or(AnswerError::NoPassagesPerDay)?;
        let forecast = Forecast::new(&request.roughness, on.growth.clone())
            .map_err(AnswerError::OutsideWindow)?;
        let (mut months, mut levels) = (Vec::new(), Vec::new());
        for step in 0..=STEPS {
            let month = future.months * f64::from(step) / f64::from(STEPS);
            let passages = month * per_month;
            if step > 0 && passages > forecast.valid_to() {
                break;
            }
            let roughness = then(&request.roughness, &forecast.spectrum(passages)?)?;
            let heard = levels_of(case, request, &roughness, request.speed)?;
            months.push(month);
            levels.push(heard.a_weighted(Part::Total));
        }
        Ok(Self {
            months_to_limit: future
                .limit
                .and_then(|limit| reached(&months, &levels, limit)),
            cut: months.len() <= STEPS as usize,
            limit: future.limit,
            months,
            levels,
            remarks: on.remarks,
        })
    }
}

/// The spectrum of which some bands have changed.
fn then(now: &Spectrum, changed: &Spectrum) -> Result<Spectrum, riffel::Error> {
    now.map(|level| changed.level(level.band).unwrap_or(level.level))
}

/// When a level first reaches a limit, straight between two of its values.
fn reached(months: &[f64], levels: &[f64], limit: f64) -> Option<f64> {
    let place = levels.iter().position(|&level| level >= limit)?;
    let Some(before) = place.checked_sub(1) else {
        return Some(months[place]);
    };
    let share = (limit - levels[before]) / (levels[place] - levels[before]);
    Some(months[before] + share * (months[place] - months[before]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_reached_between_two_months() {
        let (months, levels) = ([0.0, 1.0, 2.0], [80.0, 82.0, 81.0]);
        assert_eq!(reached(&months, &levels, 81.0), Some(0.5));
        assert_eq!(reached(&months, &levels, 79.0), Some(0.0));
        assert_eq!(reached(&months, &levels, 83.0), None);
    }
}
