//! The rail in draws of the posterior.

use rayon::prelude::*;

use crate::chain::{Draw, random};
use crate::data::Levels;
use crate::error::CalibrationError;
use crate::nuts::normal;
use crate::plan::Plan;
use crate::posterior::Named;
use crate::run::Chains;

/// Most draws that are taken: errors of 3 % of a spread.
const MOST: usize = 1000;
/// The random numbers of rails are those of no chain.
const STREAM: u64 = u64::MAX;

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

impl Plan {
    /// The data that tell of a rail that grows.
    pub(crate) fn levels(&self) -> Result<(&Named, &Levels), CalibrationError> {
        let mut blocks = self.posterior.blocks.iter();
        let levels = blocks.find_map(|named| Some((named, named.block.as_levels()?)));
        levels.ok_or_else(|| {
            let reason = "the plan has no [[data]] of kind \"dated-levels\": without growth there is nothing to forecast";
            CalibrationError::Refused(reason.to_owned())
        })
    }

    /// Whether there are any.
    pub fn has_levels(&self) -> bool {
        self.levels().is_ok()
    }

    /// Axle passages of a month.
    pub(crate) fn passages_per_month(&self) -> Result<f64, CalibrationError> {
        let per_day = self.passages_per_day.ok_or_else(|| {
            let reason = "the traffic file says under [line] neither passages_per_day nor mgt_per_year: months cannot be told";
            CalibrationError::Refused(reason.to_owned())
        });
        Ok(per_day? * riffel_case::traffic::DAYS_PER_MONTH)
    }

    /// The rail in draws that lie evenly in the chains, 1000 at most.
    ///
    /// L_b and d_b are drawn from their distribution under the values of each draw: generalised least squares over all dates.
    pub(crate) fn rail_draws(&self, chains: &Chains) -> Result<Vec<RailDraw>, CalibrationError> {
        let (named, levels) = self.levels()?;
        let all: Vec<&Draw> = chains.draws.iter().flatten().collect();
        let count = all.len().min(MOST);
        let drawn = (0..count).into_par_iter().map(|index| {
            let place = all[index * all.len() / count].place.clone();
            let values = self.posterior.values(&place);
            let trial = self.posterior.model.trial(&values);
            let rail = levels.rail(&trial, &named.sizes(&values))?;
            let mut random = random(self.file.sampler.seed, STREAM, index as u64);
            let (drawn, missed) = rail.draw(|| normal(&mut random));
            let rates = levels.rates(&trial)?;
            Ok(RailDraw {
                levels: drawn,
                missed,
                rates,
                place,
                values,
            })
        });
        drawn
            .collect::<Result<Vec<RailDraw>, String>>()
            .map_err(CalibrationError::Refused)
    }
}
