//! What the chains say of each parameter, and whether they agree.

use std::fmt::Write as _;

use riffel_keys::{Message, fixed, say};
use riffel_study::sensitivity::quantile;

use crate::chains::Chains;
use crate::diagnostics::{ess_bulk, ess_tail, rhat, sorted};
use crate::file::SamplerKind;
use crate::plan::Plan;

/// Least contraction of something that the data tell.
pub const TOLD: f64 = 0.1;
/// Largest R̂ of chains that agree.
const MOST_RHAT: f64 = 1.01;
/// Fewest effective draws.
const LEAST_ESS: f64 = 400.0;
/// Largest share of trajectories that may run away: fewer leave out no part of the posterior that its quantiles of 5 and 95 % would show.
const MOST_DIVERGENT: f64 = 1e-3;
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
    /// Quantiles of the prior.
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
    /// Draws of all chains.
    pub draws: usize,
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
        chains.map(|draws| draws.iter().map(|draw| draw.place[index]).collect()).collect()
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
            let values: Vec<Vec<f64>> =
                places.iter().map(|chain| chain.iter().map(|z| parameter.prior.value(*z)).collect()).collect();
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
            draws: self.draws.iter().map(Vec::len).sum(),
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
    /// Why the chains allow no conclusion, a sentence for each reason; empty if they do.
    pub fn doubts(&self) -> Vec<Message> {
        let mut doubts = Vec::new();
        for marginal in &self.marginals {
            let name = &marginal.name;
            if marginal.rhat.is_nan() || marginal.rhat > MOST_RHAT {
                let other = match self.sampler {
                    SamplerKind::Smc => say!(look_for_a_second_way),
                    _ => say!(populations_find_both_ways),
                };
                doubts.push(say!(
                    chains_disagree,
                    value = name,
                    rhat = fixed(marginal.rhat, 3),
                    most = MOST_RHAT,
                    other
                ));
            }
            let least = marginal.ess_bulk.min(marginal.ess_tail);
            if least.is_nan() || least < LEAST_ESS {
                doubts.push(say!(too_few_effective_draws, value = name, draws = fixed(least, 0), least = LEAST_ESS));
            }
        }
        if self.divergences as f64 > MOST_DIVERGENT * self.draws as f64 {
            doubts.push(say!(trajectories_ran_away, trajectories = self.divergences));
        }
        if let Some(bfmi) = self.bfmi.filter(|it| it.is_nan() || *it <= LEAST_BFMI) {
            doubts.push(say!(tails_are_not_reached, moves = fixed(bfmi, 2), least = LEAST_BFMI));
        }
        doubts
    }

    /// `summary.csv`.
    pub fn csv(&self) -> String {
        let mut text =
            "parameter,unit,mean,standard_deviation,q05,q25,q50,q75,q95,rhat,ess_bulk,ess_tail,contraction\n"
                .to_owned();
        for marginal in &self.marginals {
            let mut cells = vec![marginal.name.clone(), marginal.unit.clone()];
            let numbers = [marginal.mean, marginal.standard_deviation];
            cells.extend(numbers.iter().chain(&marginal.quantiles).map(|number| format!("{number:.8e}")));
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

#[cfg(test)]
mod tests {
    use riffel_keys::Language;

    use super::*;

    fn marginal(name: &str, rhat: f64, ess: f64) -> Marginal {
        Marginal {
            name: name.to_owned(),
            unit: "N/m".to_owned(),
            mean: 1.0,
            standard_deviation: 1.0,
            quantiles: [0.0; 5],
            prior_quantiles: [0.0; 5],
            rhat,
            ess_bulk: 2.0 * ess,
            ess_tail: ess,
            contraction: 0.5,
        }
    }

    /// What lies beyond a bound is said once, in both languages, and what lies on it is not.
    #[test]
    fn doubts_are_said_in_every_language() {
        let mut summary = Summary {
            marginals: vec![
                marginal("wheel.mass", 1.0125, 2000.0),
                marginal("rail.loss_factor", 1.01, 399.4),
                marginal("wear.coefficient", 1.01, 400.0),
            ],
            divergences: 3,
            draws: 2999,
            bfmi: Some(0.27),
            sampler: SamplerKind::Nuts,
        };
        let said = |summary: &Summary, language| {
            let doubts = summary.doubts().into_iter();
            doubts.map(|it| it.text(language)).collect::<Vec<String>>()
        };
        let english = said(&summary, Language::English);
        assert_eq!(
            english,
            [
                "the chains disagree on wheel.mass: R̂ is 1.012, but must be 1.01 at most; take more draws, or where the data can be fitted in two ways sampler.kind = \"smc\" finds both",
                "rail.loss_factor has 399 effective draws, but must have 400; take more draws",
                "3 trajectories ran away: the draws leave out a narrow part of the posterior; take a longer warm-up, or priors that keep away from it",
                "the energy of the chains moves by 0.27 of its spread, but must by 0.3: the tails are not reached",
            ]
        );
        let german = said(&summary, Language::German);
        for (sentence, words) in german.iter().zip([
            "uneins: R̂ ist 1,012, darf aber höchstens 1,01 sein; mehr Ziehungen nehmen, oder wo sich die Daten auf zwei Wegen",
            "rail.loss_factor hat 399 wirksame Ziehungen, braucht aber 400",
            "3 Bahnen sind entwichen",
            "um 0,27 ihrer Streuung, muss sich aber um 0,3 bewegen",
        ]) {
            assert!(sentence.contains(words), "{sentence}");
        }
        // One of a thousand may run away.
        summary.draws = 3000;
        assert_eq!(said(&summary, Language::English).len(), 3);
        summary.sampler = SamplerKind::Smc;
        let of_population = said(&summary, Language::German);
        assert!(of_population[0].ends_with("oder einen zweiten Weg suchen, auf dem das Modell zu den Daten passt"));
    }
}
