//! One chain of draws, by whatever sampler a plan names.

use riffel_study::Stop;

use crate::chain::Chain;
use crate::draw::Draw;
use crate::ensemble::Ensemble;
use crate::file::{SamplerFile, SamplerKind};
use crate::posterior::Posterior;
use crate::smc::Population;

/// Draws that follow each other. All its numbers fit a file, and the random ones follow from seed, chain and draw: one that was kept
/// goes on with the same draws.
pub(crate) enum Sampling {
    Nuts(Box<Chain>),
    Ensemble(Ensemble),
    Smc(Population),
}

impl Sampling {
    /// The chain of a number; `None` if the case takes no draw of the priors. A population is led to the posterior at once, and is
    /// only on its way where a wish to stop comes between.
    pub(crate) fn begin(posterior: &Posterior, sampler: &SamplerFile, index: u64, stop: &Stop) -> Option<Self> {
        let seed = sampler.seed;
        Some(match sampler.kind {
            SamplerKind::Nuts => Self::Nuts(Box::new(Chain::begin(posterior, seed, index, sampler.warmup)?)),
            SamplerKind::Ensemble => Self::Ensemble(Ensemble::begin(posterior, seed, index, sampler.warmup)?),
            SamplerKind::Smc => {
                let from = (seed, index);
                Self::Smc(Population::begin(posterior, from, sampler.draws, stop)?)
            }
        })
    }

    /// The next draw; none behind the last of a population.
    pub(crate) fn draw(&mut self, posterior: &Posterior) -> Option<Draw> {
        match self {
            Self::Nuts(chain) => Some(chain.draw(posterior)),
            Self::Ensemble(ensemble) => Some(ensemble.draw(posterior)),
            Self::Smc(population) => population.draw(),
        }
    }

    /// The numbers of its state.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Nuts(chain) => chain.numbers(),
            Self::Ensemble(ensemble) => ensemble.numbers(),
            Self::Smc(population) => population.numbers(),
        }
    }

    /// The chain of [`numbers`](Self::numbers); `None` if they are not as many.
    pub(crate) fn of_numbers(
        numbers: &[f64],
        posterior: &Posterior,
        sampler: &SamplerFile,
        index: u64,
    ) -> Option<Self> {
        let size = posterior.parameters().len();
        let from = (sampler.seed, index, sampler.warmup);
        Some(match sampler.kind {
            SamplerKind::Nuts => Self::Nuts(Box::new(Chain::of_numbers(numbers, size, from)?)),
            SamplerKind::Ensemble => Self::Ensemble(Ensemble::of_numbers(numbers, posterior, from)?),
            SamplerKind::Smc => Self::Smc(Population::of_numbers(numbers, size)?),
        })
    }

    /// ln of the evidence, if it is told.
    pub(crate) fn log_evidence(&self) -> Option<f64> {
        match self {
            Self::Smc(population) => Some(population.log_evidence),
            _ => None,
        }
    }
}

impl SamplerFile {
    /// Draws before those that are kept: a population needs none.
    pub fn left_out(&self) -> u64 {
        match self.kind {
            SamplerKind::Smc => 0,
            _ => self.warmup,
        }
    }

    /// The draws that are kept, in the order in which they hang together.
    pub(crate) fn kept(&self, mut draws: Vec<Draw>, posterior: &Posterior) -> Vec<Draw> {
        let kept = draws.split_off(self.left_out() as usize);
        match self.kind {
            SamplerKind::Ensemble => Ensemble::by_walker(&kept, posterior),
            _ => kept,
        }
    }
}
