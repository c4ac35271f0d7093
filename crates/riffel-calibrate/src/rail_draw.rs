//! The rail in draws of the posterior.

use std::f64::consts::LN_10;

use rand_xoshiro::Xoshiro256PlusPlus;
use rayon::prelude::*;
use riffel::forecast::{GrowingSum, LINES_PER_BAND};
use riffel_numerics::random_numbers::normal;

use crate::chains::Chains;
use crate::data::Levels;
use crate::draw::random;
use crate::error::CalibrationError;
use crate::plan::Plan;
use crate::posterior::{Named, Posterior};

/// Most draws that are taken: errors of 3 % of a spread.
const MOST: usize = 1000;
/// The random numbers of rails are those of no chain.
const STREAM: u64 = u64::MAX;

const NO_LEVELS: &str =
    "the plan has no [[data]] of kind \"dated-levels\": without growth there is nothing to forecast";

/// What one draw of the posterior says of a rail.
pub(crate) struct RailDraw {
    /// In z.
    pub(crate) place: Vec<f64>,
    /// Of the parameters, in SI.
    pub(crate) values: Vec<f64>,
    /// Levels of the bands at the first date \[dB\].
    pub(crate) levels: Vec<f64>,
    /// What the model misses of their growth \[dB per passage\].
    pub(crate) missed: Vec<f64>,
    /// Growth rates of the amplitude of all lines, per passage.
    pub(crate) rates: Vec<f64>,
}

/// The bands of a rail by the growth rates of all their lines, which begin alike. What is missed of growth \[dB per passage\] goes to
/// every line of a band.
pub fn growing_bands<'a>(rates: &'a [f64], missed: &'a [f64]) -> impl Iterator<Item = GrowingSum> {
    let bands = rates.chunks(LINES_PER_BAND).zip(missed);
    bands.map(|(rates, missed)| {
        let square = (rates.len() as f64).recip();
        let missed = LN_10 / 20.0 * missed;
        GrowingSum::new(rates.iter().map(|rate| (square, rate + missed)))
    })
}

impl Posterior {
    /// The data that tell of a rail that grows, if there are any.
    pub(crate) fn levels(&self) -> Option<(&Named, &Levels)> {
        let mut blocks = self.blocks.iter();
        blocks.find_map(|named| Some((named, named.block.as_levels()?)))
    }

    /// The rail under the values of a place in z: L_b and d_b are drawn from their distribution, generalised least squares over
    /// all dates.
    pub(crate) fn rail_draw(&self, place: Vec<f64>, random: &mut Xoshiro256PlusPlus) -> Result<RailDraw, String> {
        let (named, levels) = self.levels().ok_or(NO_LEVELS)?;
        let values = self.values(&place);
        let trial = self.model.trial(&values);
        let rail = levels.rail(&trial, &named.sizes(&values))?;
        let (drawn, missed) = rail.draw(|| normal(random));
        let rates = levels.rates(&trial)?;
        Ok(RailDraw { levels: drawn, missed, rates, place, values })
    }
}

impl Plan {
    /// The data that tell of a rail that grows.
    pub(crate) fn levels(&self) -> Result<(&Named, &Levels), CalibrationError> {
        let levels = self.posterior.levels();
        levels.ok_or_else(|| CalibrationError::Refused(NO_LEVELS.to_owned()))
    }

    /// Whether there are any.
    pub fn has_levels(&self) -> bool {
        self.levels().is_ok()
    }

    /// Axle passages of a month.
    pub(crate) fn passages_per_month(&self) -> Result<f64, CalibrationError> {
        let per_day = self.passages_per_day.ok_or_else(|| {
            let reason =
                "the traffic file says under [line] neither passages_per_day nor mgt_per_year: months cannot be told";
            CalibrationError::Refused(reason.to_owned())
        });
        Ok(per_day? * riffel_case::traffic::DAYS_PER_MONTH)
    }

    /// The rail in draws that lie evenly in the chains, 1000 at most.
    pub(crate) fn rail_draws(&self, chains: &Chains) -> Result<Vec<RailDraw>, CalibrationError> {
        self.levels()?;
        let draws = chains.evenly(MOST).into_par_iter().enumerate();
        let drawn = draws.map(|(index, draw)| {
            let mut random = random(self.file.sampler.seed, STREAM, index as u64);
            self.posterior.rail_draw(draw.place.clone(), &mut random)
        });
        drawn.collect::<Result<Vec<RailDraw>, String>>().map_err(CalibrationError::Refused)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One rate has a line: 20 lg e · g N. Two have cosh: 10 lg ((e^{2gN} + e^{−2gN})/2), and never a fall at zero.
    #[test]
    fn a_rise_is_reached_where_its_closed_form_says() {
        let band = |rates: &[f64; 16], missed: f64| growing_bands(rates, &[missed]).next().unwrap();
        let rise = |decibels: f64| 10f64.powf(0.1 * decibels);
        let one = band(&[1e-7; 16], 0.5e-6);
        let per_passage = 20.0 / LN_10 * 1e-7 + 0.5e-6;
        let expected = 6.0 / per_passage;
        let found = one.passages_to(rise(6.0)).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-12);
        assert!((one.level_change(1e6) - 1e6 * per_passage).abs() < 1e-12);
        // From a later begin as many less, and none where it is there.
        let later = one.clone().after(1e6).passages_to(rise(6.0)).unwrap();
        assert!((later - (expected - 1e6)).abs() < 1e-3);
        assert_eq!(one.after(1.01 * expected).passages_to(rise(6.0)), Some(0.0));
        let mut rates = [3e-7; 16];
        rates[..8].fill(-3e-7);
        let two = band(&rates, 0.0);
        let found = two.passages_to(rise(6.0)).unwrap();
        let expected = 10f64.powf(0.6).acosh() / 6e-7;
        assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
        // No number is too large.
        assert!(two.level_change(1e12).is_finite());
        // What falls never rises.
        assert_eq!(band(&[-1e-7; 16], 0.0).passages_to(rise(6.0)), None);
    }
}
