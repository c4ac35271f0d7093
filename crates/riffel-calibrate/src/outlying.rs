//! Data that lie far from what all others say.

use rayon::prelude::*;
use riffel_numerics::matrix::Matrix;
use serde::Serialize;

use crate::chains::Chains;
use crate::data::{Observable, differences};
use crate::draw::Draw;
use crate::plan::Plan;
use crate::posterior::Named;

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

/// Residuals of a block under one draw, with the covariance of its errors.
struct Residuals {
    residuals: Vec<f64>,
    covariance: Matrix,
}

impl Residuals {
    /// r_i = (S⁻¹r)_i/√(S⁻¹)_ii of some of the data: each beside what the others of these say of it, in its standard deviations
    /// (Sundararajan & Keerthi 2001). `None` if sizes are beyond numbers.
    fn standardised(&self, some: &[usize]) -> Option<Vec<f64>> {
        let covariance = Matrix::of(some.len(), |i, j| self.covariance.at(some[i], some[j]));
        let inverse = covariance.cholesky()?.inverse_of_square();
        let residuals: Vec<f64> = some.iter().map(|datum| self.residuals[*datum]).collect();
        let weighted = inverse.times(&residuals).into_iter().enumerate();
        Some(weighted.map(|(place, it)| it / inverse.at(place, place).sqrt()).collect())
    }
}

/// The data that lie far from the others in the mean of some draws: the farthest, then the farthest of what is left without it,
/// and so on, for what is wrong pulls others away from what they would be.
fn far(of_draws: &[Residuals], count: usize) -> Vec<(usize, f64)> {
    let mut left: Vec<usize> = (0..count).collect();
    let mut found = Vec::new();
    while !left.is_empty() {
        let draws: Vec<Vec<f64>> = (of_draws.iter()).filter_map(|draw| draw.standardised(&left)).collect();
        let mean = |place: usize| {
            let sum: f64 = draws.iter().map(|draw| draw[place]).sum();
            sum / draws.len().max(1) as f64
        };
        let means = (0..left.len()).map(|place| (place, mean(place)));
        let farthest = means.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()));
        match farthest {
            Some((place, deviations)) if deviations.abs() >= FAR => {
                found.push((left.remove(place), deviations));
            }
            _ => break,
        }
    }
    found
}

impl Chains {
    /// Data that lie three standard deviations and more from what all others say of them, what the model misses among these, in the
    /// mean over the posterior; the farthest of each block first, each without those before it.
    ///
    /// They stay among the data. The first level of a band is compared with none: where it is off, those after it are. Of a whole
    /// date that is off, and of what draws the values of the parameters to itself, little shows here.
    pub fn outlying(&self, plan: &Plan) -> Vec<Outlying> {
        let posterior = &plan.posterior;
        let draws = self.evenly(MOST);
        let of_block = |named: &Named| {
            let of_draw = |draw: &&Draw| {
                let values = posterior.values(&draw.place);
                let predicted = named.block.predict(&posterior.model.trial(&values)).ok()?;
                Some(Residuals {
                    residuals: differences(&named.block.observed(), &predicted),
                    covariance: named.block.covariance(&named.sizes(&values), 1.0),
                })
            };
            let of_draws: Vec<Residuals> = draws.par_iter().filter_map(of_draw).collect();
            let places = named.block.places();
            let told = far(&of_draws, places.len()).into_iter();
            told.map(|(datum, deviations)| Outlying {
                data: named.names.join(" + "),
                measured: places[datum].measured,
                at: places[datum].at,
                of: places[datum].of,
                deviations,
            })
            .collect::<Vec<Outlying>>()
        };
        posterior.blocks.iter().flat_map(of_block).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::random;
    use crate::nuts::Statistics;

    /// The third set with an error added to one of its data, held against its truth: draws about that would say the same.
    fn with_error(error: f64) -> Vec<Outlying> {
        let plan = crate::fixtures::folder("c-all-together").join("plan.toml");
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
                let mut data = named.block.replicate(&predicted, &sizes, &mut random).unwrap();
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
        let draw = Draw { place, log_density: 0.0, statistics: Statistics::default(), step: 1.0 };
        let chains = Chains { draws: vec![vec![draw]], log_evidences: Vec::new() };
        chains.outlying(&plan)
    }

    /// 8 dB too much of a band at one date, some ten of its errors, are told first and at its place; of 104 data as they come 0.3 lie
    /// beyond three standard deviations, and here none.
    #[test]
    fn a_level_that_is_wrong_is_told_and_no_other() {
        assert_eq!(with_error(0.0), []);
        let told = with_error(8.0);
        assert_eq!((told[0].measured, told[0].of), (Observable::LevelRiseDb, Some(6e6)));
        assert!((told[0].at - 0.158_489).abs() < 1e-6 && told[0].deviations > 5.0, "{told:?}");
        assert_eq!(told[0].data, "growth + axle-box");
        // The same band at the other date and its neighbours are no worse than before.
        assert_eq!(told.len(), 1, "{told:?}");
        let falls = with_error(-8.0);
        assert!(falls[0].deviations < -5.0, "{falls:?}");
    }
}
