//! A population that is led from the priors to the posterior.

use rand_xoshiro::Xoshiro256PlusPlus;
use rayon::prelude::*;
use riffel_numerics::bisection::bisection;
use riffel_numerics::random_numbers::uniform;
use riffel_study::Stop;

use crate::draw::{Draw, random};
use crate::ensemble::difference;
use crate::nuts::Statistics;
use crate::posterior::{Placed, Posterior};

/// Share of the population that counts after a step towards the data.
const COUNTS: f64 = 0.5;
/// Moves of each behind a step, and behind the last.
const MOVES: [u32; 2] = [15, 60];

/// A population at the posterior, one draw after the other. Its numbers fit a file.
#[derive(Debug, Clone)]
pub(crate) struct Population {
    /// ln of the mean of the likelihood over the priors, as far as the case takes their draws.
    pub(crate) log_evidence: f64,
    /// Share of the last moves that was kept.
    acceptance: f64,
    /// Those that are no draws yet, the next one last.
    rest: Vec<Placed>,
}

impl Population {
    /// So many, led from draws of the priors to the posterior by powers of the likelihood; `None` if the case takes too few draws
    /// of the priors. Where a wish to stop comes between, it is on its way.
    ///
    /// Source: Del Moral, Doucet & Jasra (2006), J. R. Stat. Soc. B 68, with the powers that leave half of the population of effect
    /// (Jasra et al. 2011), systematic resampling, and moves by differences of its members.
    pub(crate) fn begin(posterior: &Posterior, (seed, index): (u64, u64), count: u64, stop: &Stop) -> Option<Self> {
        let of = |stage: u64, member: u64| random(seed, index, (stage << 32) + member);
        let begin = |member: u64| posterior.begin(&mut of(0, member));
        let mut members: Vec<Placed> = (0..count).into_par_iter().map(begin).collect::<Option<_>>()?;
        let (mut power, mut log_evidence, mut acceptance) = (0.0, 0.0, 0.0);
        for stage in 1.. {
            if power == 1.0 || stop.is_asked() {
                break;
            }
            let step = step(&members, 1.0 - power);
            power = if step == 1.0 - power { 1.0 } else { power + step };
            let weights = Weights::of(&members, step);
            log_evidence += weights.log_mean;
            let picked = weights.resampled(uniform(&mut of(stage, count)));
            let from: Vec<Placed> = picked.iter().map(|it| members[*it].clone()).collect();
            let moves = MOVES[usize::from(power == 1.0)];
            let moved = from.par_iter().enumerate().map(|(member, start)| {
                let random = &mut of(stage, member as u64);
                let (mut place, mut kept) = (start.clone(), 0.0);
                for _ in 0..moves {
                    if let Some(next) = moved(&place, power, &from, posterior, random) {
                        (place, kept) = (next, kept + 1.0);
                    }
                }
                (place, kept)
            });
            let moved: Vec<(Placed, f64)> = moved.collect();
            let kept: f64 = moved.iter().map(|it| it.1).sum();
            acceptance = kept / f64::from(moves) / count as f64;
            members = moved.into_iter().map(|it| it.0).collect();
        }
        members.reverse();
        Some(Self { log_evidence, acceptance, rest: members })
    }

    /// The next draw. Siblings follow each other, so that diagnostics see how far they still hang together.
    pub(crate) fn draw(&mut self) -> Option<Draw> {
        let acceptance = self.acceptance;
        let statistics = Statistics { acceptance, steps: MOVES[1], ..Statistics::default() };
        self.rest.pop().map(|placed| placed.draw(statistics))
    }

    /// The numbers of its state.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        let rest = self.rest.iter().flat_map(Placed::numbers);
        let own = [self.log_evidence, self.acceptance];
        own.into_iter().chain(rest).collect()
    }

    /// The population of [`numbers`](Self::numbers) in a space of some dimensions; `None` if they are not as many.
    pub(crate) fn of_numbers(numbers: &[f64], size: usize) -> Option<Self> {
        let ([log_evidence, acceptance], rest) = numbers.split_first_chunk()?;
        Some(Self { log_evidence: *log_evidence, acceptance: *acceptance, rest: Placed::all(rest, size)? })
    }
}

/// A member after a move that the density of a power of the likelihood keeps.
fn moved(
    here: &Placed,
    power: f64,
    members: &[Placed],
    posterior: &Posterior,
    random: &mut Xoshiro256PlusPlus,
) -> Option<Placed> {
    let mut any = || &members[(uniform(random) * members.len() as f64) as usize].at;
    let (one, another) = (any(), any());
    let there = posterior.placed(difference(&here.at, one, another, random))?;
    let density = |placed: &Placed| placed.log_prior + power * placed.log_likelihood;
    (uniform(random).ln() < density(&there) - density(here)).then_some(there)
}

/// The largest step of the power, up to what is left, that leaves half of the population of effect.
fn step(members: &[Placed], left: f64) -> f64 {
    let counts = |step: f64| Weights::of(members, step).effective >= COUNTS * members.len() as f64;
    if counts(left) {
        return left;
    }
    let [largest, _] = bisection([0.0, left], 1e-18 * left, |step| !counts(step));
    // A likelihood that one member alone has leaves no step to halve.
    largest.max(f64::EPSILON * left)
}

/// What members count after a step.
struct Weights {
    /// In sum one.
    of_members: Vec<f64>,
    /// 1/Σ w².
    effective: f64,
    /// ln of their mean before.
    log_mean: f64,
}

impl Weights {
    fn of(members: &[Placed], step: f64) -> Self {
        let logs = || members.iter().map(|it| step * it.log_likelihood);
        let highest = logs().fold(f64::NEG_INFINITY, f64::max);
        let raw: Vec<f64> = logs().map(|log| (log - highest).exp()).collect();
        let sum: f64 = raw.iter().sum();
        let of_members: Vec<f64> = raw.iter().map(|it| it / sum).collect();
        Self {
            effective: of_members.iter().map(|it| it * it).sum::<f64>().recip(),
            log_mean: highest + (sum / members.len() as f64).ln(),
            of_members,
        }
    }

    /// Members by as many evenly spaced shares as there are of them, the first at a share of that distance.
    fn resampled(&self, share: f64) -> Vec<usize> {
        let count = self.of_members.len();
        let (mut member, mut sum) = (0, self.of_members[0]);
        let pick = |place: usize| {
            let at = (place as f64 + share) / count as f64;
            while sum < at && member + 1 < count {
                member += 1;
                sum += self.of_members[member];
            }
            member
        };
        (0..count).map(pick).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conjugate::{Modes, U1, number};

    fn population(posterior: &Posterior, seed: u64) -> (f64, Vec<Draw>) {
        let mut population = Population::begin(posterior, (seed, 0), 1000, &Stop::default()).unwrap();
        let draws = (0..1000).map(|_| population.draw().unwrap()).collect();
        assert!(population.draw().is_none());
        (population.log_evidence, draws)
    }

    /// U1: the evidence of three dates, where each of some three steps that leave half of 1000 of effect errs by 1/√1000 = 0.03, to
    /// three errors of them all; the growth to four standard errors of 500 draws that count.
    #[test]
    fn a_population_has_the_evidence_of_linear_levels() {
        let u1 = U1::read();
        let after = u1.after(&u1.proper());
        let posterior = u1.posterior(&[0, 1, 2]);
        let (log_evidence, draws) = population(&posterior, 1);
        let expected = number("/U1/log_evidence");
        assert!((log_evidence - expected).abs() < 0.15, "{log_evidence}");
        let mean = draws.iter().map(|it| 1.0 + it.place[0]).sum::<f64>() / 1000.0;
        let deviation = after.covariance().at(0, 0).sqrt();
        assert!(((mean - after.mean[0]) / deviation).abs() < 0.18, "{mean}");
    }

    /// Two modes, each narrower than the way between them by twenty: their shares and the evidence in closed form.
    #[test]
    fn a_population_finds_two_modes_with_their_shares() {
        let posterior = Modes::posterior();
        let found: Vec<(f64, f64)> = (0..4)
            .map(|seed| {
                let (log_evidence, draws) = population(&posterior, seed);
                let right = draws.iter().filter(|it| it.place[0] > 0.0).count();
                (log_evidence, right as f64 / 1000.0)
            })
            .collect();
        let mean = |of: fn(&(f64, f64)) -> f64| found.iter().map(of).sum::<f64>() / 4.0;
        assert!((mean(|it| it.0) - Modes::LOG_EVIDENCE).abs() < 0.1, "{found:?}");
        assert!((mean(|it| it.1) - Modes::RIGHT).abs() < 0.05, "{found:?}");
    }

    /// A population that is written and read goes on with the same draws, and threads change nothing.
    #[test]
    fn a_population_that_was_kept_goes_on_with_the_same_draws() {
        let posterior = Modes::posterior();
        let begin = || Population::begin(&posterior, (3, 1), 200, &Stop::default()).unwrap();
        let mut population = begin();
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        assert_eq!(alone.unwrap().install(begin).numbers(), population.numbers());
        (0..20).for_each(|_| drop(population.draw()));
        let mut kept = Population::of_numbers(&population.numbers(), 2).unwrap();
        assert!(Population::of_numbers(&population.numbers()[1..], 2).is_none());
        let (one, other) = (population.draw().unwrap(), kept.draw().unwrap());
        assert_eq!(one.place, other.place);
        assert_eq!(population.numbers(), kept.numbers());
    }

    /// Shares of 0.1, 0.6 and 0.3 by three evenly spaced picks.
    #[test]
    fn members_are_picked_by_their_shares() {
        let weights = Weights { of_members: vec![0.1, 0.6, 0.3], effective: 0.0, log_mean: 0.0 };
        assert_eq!(weights.resampled(0.2), [0, 1, 2]);
        assert_eq!(weights.resampled(0.5), [1, 1, 2]);
    }
}
