//! When a rail reaches its limit, over the posterior.

use riffel::roughness::{LevelLimit, ThirdOctave};
use riffel_study::sensitivity::quantile;
use serde::Serialize;

use crate::chains::Chains;
use crate::decision::Months;
use crate::error::CalibrationError;
use crate::plan::Plan;
use crate::rail_draw::growing_bands;
use crate::summary::SHARES;

/// The future of a rail from its last date on.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Forecast {
    /// Draws of the posterior.
    pub draws: usize,
    /// Axle passages from the first date to the last.
    pub passages_now: f64,
    /// How far it looks ahead.
    pub horizon_months: f64,
    /// Until the first band reaches its limit.
    pub months_to_limit: Months,
    /// The longest wavelength first.
    pub bands: Vec<BandForecast>,
}

/// One band of it; 5, 25, 50, 75 and 95 % of the draws.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BandForecast {
    /// Its centre.
    pub wavelength_m: f64,
    /// At the last date.
    pub level_now_db: [f64; 5],
    /// At the horizon.
    pub level_then_db: [f64; 5],
    /// Its limit, if it has one.
    pub limit_db: Option<f64>,
    /// Until it reaches that.
    pub months_to_limit: Option<Months>,
}

/// Level of a band now and at the horizon, and passages until its limit.
type BandTrend = (f64, f64, Option<f64>);

impl Forecast {
    /// The forecast of the rail of a plan over the draws of its chains: level at the last date, growth from there on, and what the
    /// model misses of it.
    ///
    /// # Errors
    /// [`CalibrationError::Refused`] without dated levels, without passages of a day, or without a limit of any band.
    pub fn of(plan: &Plan, chains: &Chains, limit: &LevelLimit, months: f64) -> Result<Self, CalibrationError> {
        let (_, levels) = plan.levels()?;
        let per_month = plan.passages_per_month()?;
        let draws = plan.rail_draws(chains)?;
        let (now, ahead) = (levels.last(), months * per_month);
        let limits = levels.bands().iter().map(|band| limit.spectrum().level(*band));
        let limits: Vec<Option<f64>> = limits.collect();
        if limits.iter().all(Option::is_none) {
            let reason = "the limit has none of the bands that were measured";
            return Err(CalibrationError::Refused(reason.to_owned()));
        }
        let courses: Vec<Vec<BandTrend>> = draws
            .iter()
            .map(|draw| {
                let bands = growing_bands(&draw.rates, &draw.missed);
                let bands = bands.zip(&draw.levels).zip(&limits);
                bands
                    .map(|((band, level), limit)| {
                        let at = |passages: f64| level + band.level_change(passages);
                        let levels = [at(now), at(now + ahead)];
                        let from_now = band.after(now);
                        let reached = limit
                            .and_then(|limit| from_now.passages_to(10f64.powf(0.1 * (limit - level))))
                            .filter(|passages| *passages <= ahead);
                        (levels[0], levels[1], reached)
                    })
                    .collect()
            })
            .collect();
        let in_months = |passages: Option<f64>| passages.map(|it| it / per_month);
        let quantiles = |of: &dyn Fn(&[BandTrend]) -> f64| {
            let mut values: Vec<f64> = courses.iter().map(|bands| of(bands)).collect();
            values.sort_by(f64::total_cmp);
            SHARES.map(|share| quantile(&values, share))
        };
        let band = |(place, band): (usize, &ThirdOctave)| BandForecast {
            wavelength_m: band.wavelength(),
            level_now_db: quantiles(&|bands| bands[place].0),
            level_then_db: quantiles(&|bands| bands[place].1),
            limit_db: limits[place],
            months_to_limit: limits[place].map(|_| Months::of(courses.iter().map(|bands| in_months(bands[place].2)))),
        };
        let first = courses.iter().map(|bands| {
            let reached = bands.iter().filter_map(|band| band.2);
            in_months(reached.min_by(f64::total_cmp))
        });
        Ok(Self {
            draws: draws.len(),
            passages_now: now,
            horizon_months: months,
            months_to_limit: Months::of(first),
            bands: levels.bands().iter().enumerate().rev().map(band).collect(),
        })
    }
}
