//! Data that lie far from what all others say.

use rayon::prelude::*;
use serde::Serialize;

use crate::chain::Draw;
use crate::data::{Block, Observable, differences};
use crate::plan::Plan;
use crate::run::Chains;

/// Draws over which a residual is the mean: it then errs by a tenth of its own scatter at most.
const MOST: usize = 100;
/// Standard deviations from which on a datum is told: of normal errors one in 370 lies as far.
const FAR: f64 = 3.0;

/// A datum that lies far from what the others say.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outlying {
    /// The name of its data.
    pub data: String,
    /// What it is.
    pub measured: Observable,
    /// Frequency \[Hz\], wavelength \[m\], or passages.
    pub at: f64,
    /// Position \[m\] or passages, where there are any.
    pub of: Option<f64>,
    /// How many standard deviations above what is expected of it.
    pub deviations: f64,
}

/// r_i = (S⁻¹r)_i/√(S⁻¹)_ii: each datum beside what all others of the block say of it, in its standard deviations (Sundararajan &
/// Keerthi 2001). None where sizes are beyond numbers.
fn standardised(block: &dyn Block, predicted: &[f64], sizes: &[f64]) -> Option<Vec<f64>> {
    let inverse = block.covariance(sizes, 1.0).cholesky()?.inverse_of_square();
    let weighted = inverse.times(&differences(&block.observed(), predicted));
    let own = weighted.iter().enumerate();
    Some(
        own.map(|(place, it)| it / inverse.at(place, place).sqrt())
            .collect(),
    )
}

impl Chains {
    /// Data that lie three standard deviations and more from what all others say of them, what the model misses among these, in the
    /// mean over the posterior; the farthest first.
    ///
    /// They stay among the data. The first level of a band is compared with none: where it is off, those after it are.
    pub fn outlying(&self, plan: &Plan) -> Vec<Outlying> {
        let posterior = &plan.posterior;
        let of_draw = |draw: &&Draw| -> Vec<Option<Vec<f64>>> {
            let values = posterior.values(&draw.place);
            let trial = posterior.model.trial(&values);
            let blocks = posterior.blocks.iter();
            blocks
                .map(|named| {
                    let predicted = named.block.predict(&trial).ok()?;
                    standardised(&*named.block, &predicted, &named.sizes(&values))
                })
                .collect()
        };
        let of_draws: Vec<_> = self.evenly(MOST).par_iter().map(of_draw).collect();
        let mut outlying: Vec<Outlying> = Vec::new();
        for (block, named) in posterior.blocks.iter().enumerate() {
            let known = || of_draws.iter().filter_map(|draw| draw[block].as_ref());
            let count = known().count().max(1) as f64;
            for (datum, place) in named.block.places().into_iter().enumerate() {
                let deviations = known().map(|all| all[datum]).sum::<f64>() / count;
                if deviations.abs() >= FAR {
                    outlying.push(Outlying {
                        data: named.names.join(" + "),
                        measured: place.measured,
                        at: place.at,
                        of: place.of,
                        deviations,
                    });
                }
            }
        }
        let far = |it: &Outlying| it.deviations.abs();
        outlying.sort_by(|one, other| far(other).total_cmp(&far(one)));
        outlying
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::random;
    use crate::nuts::Statistics;

    /// The third set with an error added to one of its data, held against its truth: draws about that would say the same.
    fn with_error(error: f64) -> Vec<Outlying> {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let plan = root.join("../../validation/calibration/c-all-together/plan.toml");
        let mut plan = Plan::read(&plan).unwrap();
        let medians = plan.posterior.parameters().iter();
        let values: Vec<f64> = medians.map(|it| it.prior.quantile(0.5)).collect();
        // Data that these values would have made, with their own errors.
        let model = &plan.posterior.model;
        let trial = model.trial(&values);
        let mut random = random(17, 3, 0);
        let made: Vec<_> = (plan.posterior.blocks.iter())
            .map(|named| {
                let sizes = named.sizes(&values);
                let predicted = named.block.predict(&trial).unwrap();
                let mut data = named
                    .block
                    .replicate(&predicted, &sizes, &mut random)
                    .unwrap();
                if named.names[0] == "growth" {
                    data[9] += error;
                }
                named.block.with_data(&data).unwrap()
            })
            .collect();
        let place = plan.posterior.place(&values);
        for (named, block) in plan.posterior.blocks.iter_mut().zip(made) {
            named.block = block;
        }
        let draw = Draw {
            place,
            log_density: 0.0,
            statistics: Statistics::default(),
            step: 1.0,
        };
        let chains = Chains {
            draws: vec![vec![draw]],
            log_evidences: Vec::new(),
        };
        chains.outlying(&plan)
    }

    /// 8 dB too much of a band at one date, some ten of its errors, are told first and at its place; of 104 data as they come 0.3 lie
    /// beyond three standard deviations, and here none.
    #[test]
    fn a_level_that_is_wrong_is_told_and_no_other() {
        assert_eq!(with_error(0.0), []);
        let told = with_error(8.0);
        assert_eq!(
            (told[0].measured, told[0].of),
            (Observable::LevelRiseDb, Some(6e6))
        );
        assert!(
            (told[0].at - 0.158_489).abs() < 1e-6 && told[0].deviations > 5.0,
            "{told:?}"
        );
        assert_eq!(told[0].data, "growth + axle-box");
        let falls = with_error(-8.0);
        assert!(falls[0].deviations < -5.0, "{falls:?}");
    }
}
