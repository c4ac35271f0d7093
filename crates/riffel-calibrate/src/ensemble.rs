//! Walkers that find their steps from each other, without slopes.
//!
//! Nothing here is shared with the chains of trajectories: no slopes, no emulator, no top to begin from. So each checks the other.

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel_numerics::random_numbers::{normal, uniform};
use riffel_study::sensitivity::quantile;

use crate::draw::{Draw, random};
use crate::nuts::Statistics;
use crate::posterior::{Placed, Posterior};

/// Walkers for each coordinate, and fewest of all.
const WALKERS: (usize, usize) = (3, 12);
/// Moves of a walker from one of its draws to the next.
const MOVES: u32 = 20;
/// Draws of the priors of which a walker begins at the likeliest.
const BEGINNINGS: u32 = 10;
/// Of so many moves by differences one takes the whole of a difference, which leads from one mode to another.
const WHOLE: f64 = 0.1;
/// Largest factor of a stretch.
const STRETCH: f64 = 2.0;
/// So often in the warm-up walkers that are stuck far from all others go to the likeliest.
const RESCUES: u64 = 8;
/// Quartile ranges below the lower quartile of ln density behind which a walker is stuck.
const STUCK: f64 = 2.0;
/// Deviation of what is added to a difference, in units of z: no place is out of reach.
const BESIDE: f64 = 1e-6;

/// An ensemble between two draws. All its numbers fit a file.
#[derive(Debug, Clone)]
pub(crate) struct Ensemble {
    seed: u64,
    index: u64,
    warmup: u64,
    done: u64,
    walkers: Vec<Placed>,
}

impl Ensemble {
    /// Walkers at draws of the priors; `None` if the case takes too few of these.
    pub(crate) fn begin(posterior: &Posterior, seed: u64, index: u64, warmup: u64) -> Option<Self> {
        let mut random = random(seed, index, u64::MAX);
        let begin = |_| {
            let starts = (0..BEGINNINGS).map_while(|_| posterior.begin(&mut random));
            starts.max_by(|one, other| one.log_density().total_cmp(&other.log_density()))
        };
        let walkers: Option<Vec<Placed>> = (0..walkers(posterior)).map(begin).collect();
        Some(Self { seed, index, warmup, done: 0, walkers: walkers? })
    }

    /// The next draw: of the walkers in turn.
    pub(crate) fn draw(&mut self, posterior: &Posterior) -> Draw {
        let random = &mut random(self.seed, self.index, self.done);
        let own = self.done as usize % self.walkers.len();
        let mut accepted = 0.0;
        for _ in 0..MOVES {
            if let Some(moved) = self.moved(own, posterior, random) {
                self.walkers[own] = moved;
                accepted += 1.0;
            }
        }
        self.done += 1;
        let pause = (self.warmup / RESCUES).max(1);
        if self.done < self.warmup && self.done.is_multiple_of(pause) {
            self.rescue();
        }
        self.walkers[own].draw(Statistics {
            acceptance: accepted / f64::from(MOVES),
            steps: MOVES,
            ..Statistics::default()
        })
    }

    /// Put walkers that are stuck where hardly any share of the posterior is onto the likeliest one, from where they spread.
    ///
    /// Source: Vrugt et al. (2009), Int. J. Nonlinear Sci. Numer. Simul. 10, for chains whose density is an outlier.
    fn rescue(&mut self) {
        let mut densities: Vec<f64> = self.walkers.iter().map(Placed::log_density).collect();
        densities.sort_by(f64::total_cmp);
        let [low, high] = [0.25, 0.75].map(|share| quantile(&densities, share));
        let least = low - STUCK * (high - low);
        let best = self.walkers.iter();
        let best = best.max_by(|one, other| one.log_density().total_cmp(&other.log_density()));
        let Some(best) = best.cloned() else { return };
        let stuck = self.walkers.iter_mut();
        stuck.filter(|walker| walker.log_density() < least).for_each(|walker| *walker = best.clone());
    }

    /// One walker after a move that the density keeps.
    ///
    /// Source: ter Braak (2006), Statistics and Computing 16, for differences; Goodman & Weare (2010), Commun. Appl. Math. Comput.
    /// Sci. 5, for stretches.
    fn moved(&self, own: usize, posterior: &Posterior, random: &mut Xoshiro256PlusPlus) -> Option<Placed> {
        let here = &self.walkers[own];
        let mut other = || &self.walkers[other_than(own, self.walkers.len(), random)].at;
        let (one, another) = (other(), other());
        let (at, weight) = match uniform(random) < 0.5 {
            true => (difference(&here.at, one, another, random), 0.0),
            false => {
                let share = uniform(random);
                // Of density 1/√z from 1/a to a.
                let z = (1.0 + (STRETCH - 1.0) * share).powi(2) / STRETCH;
                let pairs = here.at.iter().zip(one);
                let at = pairs.map(|(here, one)| one + z * (here - one)).collect();
                (at, (here.at.len() as f64 - 1.0) * z.ln())
            }
        };
        let there = posterior.placed(at)?;
        let gain = there.log_density() - here.log_density() + weight;
        (uniform(random).ln() < gain).then_some(there)
    }

    /// The numbers of its state.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        let walkers = self.walkers.iter().flat_map(Placed::numbers);
        [self.done as f64].into_iter().chain(walkers).collect()
    }

    /// The ensemble of [`numbers`](Self::numbers) of a posterior; `None` if they are not as many.
    pub(crate) fn of_numbers(
        numbers: &[f64],
        posterior: &Posterior,
        (seed, index, warmup): (u64, u64, u64),
    ) -> Option<Self> {
        let (done, walkers) = numbers.split_first()?;
        let walkers = Placed::all(walkers, posterior.parameters().len())?;
        (walkers.len() == self::walkers(posterior)).then_some(Self { seed, index, warmup, done: *done as u64, walkers })
    }

    /// Draws walker by walker, each in its order, so that what follows each other hangs together: diagnostics look for that.
    pub(crate) fn by_walker(draws: &[Draw], posterior: &Posterior) -> Vec<Draw> {
        let count = walkers(posterior);
        let of = |walker: usize| draws.iter().skip(walker).step_by(count).cloned();
        (0..count).flat_map(of).collect()
    }
}

fn walkers(posterior: &Posterior) -> usize {
    (WALKERS.0 * posterior.parameters().len()).max(WALKERS.1)
}

/// Another of so many.
fn other_than(own: usize, count: usize, random: &mut Xoshiro256PlusPlus) -> usize {
    let other = (uniform(random) * (count - 1) as f64) as usize;
    other + usize::from(other >= own)
}

/// A place beside another by the difference of two.
pub(crate) fn difference(here: &[f64], one: &[f64], another: &[f64], random: &mut Xoshiro256PlusPlus) -> Vec<f64> {
    let factor = match uniform(random) < WHOLE {
        true => 1.0,
        // The best of normal densities.
        false => 2.38 / (2.0 * here.len() as f64).sqrt() * (0.5 + uniform(random)),
    };
    let apart = one.iter().zip(another).map(|(one, other)| one - other);
    let moved = here.iter().zip(apart);
    moved.map(|(here, apart)| here + factor * apart + BESIDE * normal(random)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conjugate::{Modes, U1};

    fn drawn(posterior: &Posterior, count: u64) -> Vec<Draw> {
        let mut ensemble = Ensemble::begin(posterior, 7, 0, 300).unwrap();
        let draws: Vec<Draw> = (0..count + 300).map(|_| ensemble.draw(posterior)).collect();
        draws[300..].to_vec()
    }

    /// U1 to four standard errors of 3000 draws, if one in two counts: 0.1 of the deviation, 7 % of it.
    #[test]
    fn walkers_have_the_growth_of_linear_levels() {
        let u1 = U1::read();
        let after = u1.after(&u1.proper());
        let draws = drawn(&u1.posterior(&[0, 1, 2]), 3000);
        let values = draws.iter().map(|draw| 1.0 + draw.place[0]);
        let mean = values.clone().sum::<f64>() / 3000.0;
        let deviation = (values.map(|it| (it - mean).powi(2)).sum::<f64>() / 2999.0).sqrt();
        let expected = after.covariance().at(0, 0).sqrt();
        assert!(((mean - after.mean[0]) / expected).abs() < 0.1, "{mean}");
        assert!((deviation / expected - 1.0).abs() < 0.07, "{deviation}");
    }

    /// κ with the three first levels, whose priors are 10 to 29 times as wide as what the data leave, and which hang together (r to
    /// −0.66). To five standard errors, if one in four of 12000 draws counts: means to 0.09 of the deviation, covariances to 0.14 of
    /// its product. A stretch with a power too many or too few is off by 0.16.
    #[test]
    fn walkers_have_values_that_hang_together() {
        let u1 = U1::read();
        let after = u1.after(&u1.proper());
        let posterior = u1.posterior_of_all();
        let draws = drawn(&posterior, 12_000);
        let of = |place: usize| -> Vec<f64> {
            let prior = &posterior.parameters()[place].prior;
            draws.iter().map(|it| prior.value(it.place[place])).collect()
        };
        let values: Vec<Vec<f64>> = (0..4).map(of).collect();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let expected = after.covariance();
        for i in 0..4 {
            let deviation = expected.at(i, i).sqrt();
            let off = (mean(&values[i]) - after.mean[i]) / deviation;
            assert!(off.abs() < 0.09, "{i}: {off}");
            for j in 0..=i {
                let pairs = values[i].iter().zip(&values[j]);
                let products: Vec<f64> = pairs.map(|(a, b)| (a - after.mean[i]) * (b - after.mean[j])).collect();
                let scale = deviation * expected.at(j, j).sqrt();
                let off = (mean(&products) - expected.at(i, j)) / scale;
                assert!(off.abs() < 0.14, "{i}, {j}: {off}");
            }
        }
    }

    /// An ensemble that is written and read goes on bit for bit.
    #[test]
    fn an_ensemble_that_was_kept_goes_on_with_the_same_draws() {
        let posterior = Modes::posterior();
        let mut ensemble = Ensemble::begin(&posterior, 3, 1, 30).unwrap();
        (0..20).for_each(|_| drop(ensemble.draw(&posterior)));
        let numbers = ensemble.numbers();
        let mut kept = Ensemble::of_numbers(&numbers, &posterior, (3, 1, 30)).unwrap();
        assert!(Ensemble::of_numbers(&numbers[1..], &posterior, (3, 1, 30)).is_none());
        for _ in 0..20 {
            let (one, other) = (ensemble.draw(&posterior), kept.draw(&posterior));
            assert_eq!(one.place, other.place);
        }
        assert_eq!(ensemble.numbers(), kept.numbers());
    }

    /// A walker 40 nats below all others goes to the likeliest, one that is 3 below stays.
    #[test]
    fn a_walker_that_is_stuck_is_put_among_the_others() {
        let posterior = Modes::posterior();
        let mut ensemble = Ensemble::begin(&posterior, 3, 1, 300).unwrap();
        for (place, walker) in ensemble.walkers.iter_mut().enumerate() {
            walker.at = vec![place as f64; 2];
            walker.log_prior = 0.0;
            walker.log_likelihood = -0.5 * place as f64;
        }
        ensemble.walkers[5].log_likelihood = -40.0;
        ensemble.walkers[6].log_likelihood = -7.0;
        ensemble.rescue();
        assert_eq!(ensemble.walkers[5].at, [0.0; 2]);
        assert_eq!(ensemble.walkers[6].at, [6.0; 2]);
    }

    /// Draws of walkers in turn come walker by walker.
    #[test]
    fn draws_are_put_walker_by_walker() {
        let posterior = Modes::posterior();
        let mut draws = drawn(&posterior, 25);
        (0..25).for_each(|place| draws[place].log_density = place as f64);
        let order = Ensemble::by_walker(&draws, &posterior);
        let order: Vec<f64> = order.iter().map(|draw| draw.log_density).collect();
        assert_eq!(order[..5], [0.0, 12.0, 24.0, 1.0, 13.0]);
        assert_eq!(order.len(), 25);
    }
}
