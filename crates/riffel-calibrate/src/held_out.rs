//! How well data that were left out are predicted by all others.

use rayon::prelude::*;
use serde::Serialize;

use crate::chains::Chains;
use crate::data::{Conditional, Group, Held};
use crate::diagnostics::ess_bulk;
use crate::draw::Draw;
use crate::error::CalibrationError;
use crate::plan::Plan;
use crate::smoothing::Weights;

/// The prediction of one group of data by all others.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Score {
    /// The data that it is of.
    pub data: String,
    /// What of them was left out.
    pub held_out: Held,
    /// ln of the density that the model and all other data give to what was measured.
    pub log_density: f64,
    /// Its standard error by the number of draws.
    pub error: f64,
    /// k̂ of the weights that leave the group out; `None` if chains were drawn without it.
    pub shape: Option<f64>,
    /// Whether density and error are to be trusted: by the shape and by how many draws count.
    pub is_told: bool,
    /// Data that were left out and have a band: those that are bounds have none.
    pub count: usize,
    /// How many of them lie within the band of 50 % of their prediction.
    pub inside_50: usize,
    /// And within that of 90 %.
    pub inside_90: usize,
}

/// What the scores of all groups follow from, by draw: the density of each group given all others, and where its data lie.
pub(crate) fn given_rest(
    plan: &Plan,
    chains: &Chains,
    groups: &[(usize, Group)],
) -> Result<Vec<Vec<Conditional>>, CalibrationError> {
    let posterior = &plan.posterior;
    let all: Vec<&Draw> = chains.draws.iter().flatten().collect();
    let of_draw = |draw: &&Draw| {
        let values = posterior.values(&draw.place);
        let trial = posterior.model.trial(&values);
        let of_group = |(block, group): &(usize, Group)| {
            let named = &posterior.blocks[*block];
            let predicted = named.block.predict(&trial)?;
            let given = named.block.given_rest(group, &predicted, &named.sizes(&values));
            given.ok_or_else(|| "the errors of the data are beyond numbers".to_owned())
        };
        groups.iter().map(of_group).collect()
    };
    all.par_iter().map(of_draw).collect::<Result<Vec<Vec<Conditional>>, String>>().map_err(CalibrationError::Refused)
}

impl Score {
    /// From draws that saw the group, by weights that take it out again, or from draws that did not.
    pub(crate) fn of(
        (data, held_out): (String, Held),
        given: &[&Conditional],
        chains: usize,
        is_drawn_without: bool,
    ) -> Self {
        let logs: Vec<f64> = given.iter().map(|it| it.log_density).collect();
        let count = logs.len() as f64;
        let (weights, shape) = match is_drawn_without {
            true => (vec![count.recip(); logs.len()], None),
            false => {
                let ratios: Vec<f64> = logs.iter().map(|log| -log).collect();
                let weights = Weights::smoothed(&ratios);
                (weights.of_draws, Some(weights.shape))
            }
        };
        let highest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let terms = || {
            let densities = logs.iter().map(|log| (log - highest).exp());
            weights.iter().zip(densities)
        };
        let mean: f64 = terms().map(|(weight, density)| weight * density).sum();
        let square: f64 = terms().map(|(weight, density)| (weight * (density - mean)).powi(2)).sum();
        let of_chains: Vec<Vec<f64>> = logs.chunks(logs.len() / chains).map(<[f64]>::to_vec).collect();
        let effective = (ess_bulk(&of_chains) / count).clamp(1e-3, 1.0);
        let places = 0..given[0].shares.len();
        let shares: Vec<f64> = places
            .map(|place| {
                let terms = weights.iter().zip(given);
                terms.map(|(weight, it)| weight * it.shares[place]).sum()
            })
            .collect();
        let inside = |band: f64| {
            let is_inside = |share: &&f64| (**share - 0.5).abs() <= 0.5 * band;
            shares.iter().filter(is_inside).count()
        };
        Self {
            data,
            held_out,
            log_density: highest + mean.ln(),
            error: (square / effective).sqrt() / mean,
            shape,
            is_told: shape.is_none_or(|shape| Weights::are_told(shape, effective * count)),
            count: shares.len(),
            inside_50: inside(0.5),
            inside_90: inside(0.9),
        }
    }
}
