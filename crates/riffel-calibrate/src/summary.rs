//! What the chains say of each parameter, and whether they agree.

use std::fmt::Write as _;

use riffel_study::sensitivity::quantile;

use crate::diagnostics::{ess_bulk, ess_tail, rhat, sorted};
use crate::file::SamplerKind;
use crate::plan::Plan;
use crate::run::Chains;

/// Least contraction of something that the data tell.
pub const TOLD: f64 = 0.1;
/// Largest R̂ of chains that agree.
const MOST_RHAT: f64 = 1.01;
/// Fewest effective draws.
const LEAST_ESS: f64 = 400.0;
/// Least Bayesian fraction of missing information of the energy.
const LEAST_BFMI: f64 = 0.3;

/// A parameter after all data, in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Marginal {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub standard_deviation: f64,
    /// Values below which 5, 25, 50, 75 and 95 % lie.
    pub quantiles: [f64; 5],
    /// The same of the prior.
    pub prior_quantiles: [f64; 5],
    /// R̂ of rank-normalised split chains.
    pub rhat: f64,
    /// Effective draws for the middle.
    pub ess_bulk: f64,
    /// Effective draws for the tails.
    pub ess_tail: f64,
    /// 1 − variance after over variance before, on the whole line of [`Prior`](crate::Prior).
    pub contraction: f64,
}

/// All parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// In the order of the plan, sizes of discrepancies last.
    pub marginals: Vec<Marginal>,
    /// Trajectories whose energy ran away.
    pub divergences: usize,
    /// Least over the chains of E-BFMI, where they follow trajectories.
    pub bfmi: Option<f64>,
    /// What drew them.
    pub sampler: SamplerKind,
}

/// The shares of the quantiles.
pub(crate) const SHARES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];

impl Chains {
    /// The places in z of one parameter, chain by chain.
    pub(crate) fn places(&self, index: usize) -> Vec<Vec<f64>> {
        let chains = self.draws.iter();
        chains
            .map(|draws| draws.iter().map(|draw| draw.place[index]).collect())
            .collect()
    }

    /// All draws of one parameter, in SI.
    pub fn values(&self, plan: &Plan, index: usize) -> Vec<f64> {
        let prior = &plan.posterior.parameters()[index].prior;
        let draws = self.draws.iter().flatten();
        draws.map(|draw| prior.value(draw.place[index])).collect()
    }

    /// What the chains say.
    pub fn summary(&self, plan: &Plan) -> Summary {
        let parameters = plan.posterior.parameters().iter().enumerate();
        let marginals = parameters.map(|(index, parameter)| {
            let places = self.places(index);
            let values: Vec<Vec<f64>> = places
                .iter()
                .map(|chain| chain.iter().map(|z| parameter.prior.value(*z)).collect())
                .collect();
            let (mean, variance) = moments(&values);
            let in_order = sorted(&values);
            Marginal {
                name: parameter.name.clone(),
                unit: parameter.unit.clone(),
                mean,
                standard_deviation: variance.sqrt(),
                quantiles: SHARES.map(|share| quantile(&in_order, share)),
                prior_quantiles: SHARES.map(|share| parameter.prior.quantile(share)),
                rhat: rhat(&places),
                ess_bulk: ess_bulk(&places),
                ess_tail: ess_tail(&places),
                contraction: 1.0 - moments(&places).1 / parameter.prior.variance(),
            }
        });
        let of_all = self.draws.iter().flatten();
        let sampler = plan.file.sampler.kind;
        let bfmi = self.draws.iter().map(|draws| {
            let energies: Vec<f64> = draws.iter().map(|draw| draw.statistics.energy).collect();
            let changes = energies.windows(2).map(|pair| (pair[1] - pair[0]).powi(2));
            let (_, variance) = moments(std::slice::from_ref(&energies));
            changes.sum::<f64>() / (variance * (energies.len() - 1) as f64)
        });
        Summary {
            marginals: marginals.collect(),
            divergences: of_all.filter(|draw| draw.statistics.diverging).count(),
            bfmi: (sampler == SamplerKind::Nuts).then(|| bfmi.fold(f64::INFINITY, f64::min)),
            sampler,
        }
    }
}

fn moments(chains: &[Vec<f64>]) -> (f64, f64) {
    let count = chains.iter().map(Vec::len).sum::<usize>() as f64;
    let mean = chains.iter().flatten().sum::<f64>() / count;
    let squares = chains.iter().flatten().map(|x| (x - mean).powi(2));
    (mean, squares.sum::<f64>() / (count - 1.0))
}

impl Summary {
    /// Why the chains allow no conclusion, a sentence for each reason; none where they do.
    pub fn doubts(&self) -> Vec<String> {
        let mut doubts = Vec::new();
        for marginal in &self.marginals {
            let name = &marginal.name;
            if marginal.rhat.is_nan() || marginal.rhat > MOST_RHAT {
                let other = match self.sampler {
                    SamplerKind::Smc => "look for a second way to fit the data",
                    _ => {
                        "where the data can be fitted in two ways sampler.kind = \"smc\" finds both"
                    }
                };
                doubts.push(format!(
                    "the chains disagree on {name}: R̂ is {:.3}, but must be {MOST_RHAT} at most; take more draws, or {other}",
                    marginal.rhat
                ));
            }
            let least = marginal.ess_bulk.min(marginal.ess_tail);
            if least.is_nan() || least < LEAST_ESS {
                doubts.push(format!(
                    "{name} has {least:.0} effective draws, but must have {LEAST_ESS:.0}; take more draws"
                ));
            }
        }
        if self.divergences > 0 {
            doubts.push(format!(
                "{} trajectories ran away: the draws leave out a narrow part of the posterior; take a longer warm-up, or priors that keep away from it",
                self.divergences
            ));
        }
        if let Some(bfmi) = self.bfmi.filter(|it| it.is_nan() || *it <= LEAST_BFMI) {
            doubts.push(format!(
                "the energy of the chains moves by {bfmi:.2} of its spread, but must by {LEAST_BFMI}: the tails are not reached"
            ));
        }
        doubts
    }

    /// `summary.csv`.
    pub fn csv(&self) -> String {
        let mut text = "parameter,unit,mean,standard_deviation,q05,q25,q50,q75,q95,rhat,ess_bulk,ess_tail,contraction\n".to_owned();
        for marginal in &self.marginals {
            let mut cells = vec![marginal.name.clone(), marginal.unit.clone()];
            let numbers = [marginal.mean, marginal.standard_deviation];
            cells.extend(
                numbers
                    .iter()
                    .chain(&marginal.quantiles)
                    .map(|number| format!("{number:.8e}")),
            );
            cells.push(format!("{:.5}", marginal.rhat));
            cells.push(format!("{:.0}", marginal.ess_bulk));
            cells.push(format!("{:.0}", marginal.ess_tail));
            cells.push(format!("{:.4}", marginal.contraction));
            // A text takes any line.
            let _ = writeln!(text, "{}", cells.join(","));
        }
        text
    }
}
