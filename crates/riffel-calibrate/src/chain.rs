//! One chain: where it begins, how it finds its steps, and its draws.

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel_numerics::matrix::Matrix;
use riffel_numerics::random_numbers::uniform;

use crate::draw::{Draw, random};
use crate::emulator::Emulator;
use crate::moments::Moments;
use crate::nuts::{Place, Potential, Statistics, transition};
use crate::optimum::{climb, covariance};
use crate::posterior::{MOST_TRIALS, Point, Posterior};

/// Places of the prior from which a chain looks for a top.
const STARTS: u64 = 4;
/// Probability of acceptance that steps are made for.
const ACCEPTANCE: f64 = 0.9;
/// Draws to which the covariance of the start counts as much.
const PRIOR_DRAWS: f64 = 10.0;
/// Of so many draws one follows the density of the model all along: it reaches where the emulator is not to be trusted.
const ALONG_THE_MODEL: u64 = 10;
/// Transitions under the density of an emulator until the model is asked.
const TRANSITIONS: usize = 2;
/// Share of its proposals that the model must keep, or a new emulator is made at the end of a window.
const GOOD_KEPT: f64 = 0.95;
/// After so many proposals in a row that the model does not keep, the warm-up goes on by the model alone: the emulator is wrong where
/// the chain is.
const MOST_REFUSED: f64 = 3.0;
/// Share of the draws that an emulator proposes of which the model must keep more.
const LEAST_KEPT: f64 = 0.2;

/// A chain between two draws. All its numbers fit a file, and the random ones follow from seed, chain and draw: one that was
/// kept goes on with the same draws.
#[derive(Debug, Clone)]
pub(crate) struct Chain {
    seed: u64,
    index: u64,
    warmup: u64,
    /// Draws that are made, those of the warm-up among them.
    pub(crate) done: u64,
    /// Where it is, in coordinates of unit covariance, and ln of the density of the model there.
    at: Vec<f64>,
    log_density: f64,
    /// z = middle + spread · coordinate.
    middle: Vec<f64>,
    spread: Matrix,
    step: Step,
    window: Window,
    /// Whether an emulator proposes, and middle and spread of the draws that it is made for: it follows from them.
    emulates: bool,
    made_for: (Vec<f64>, Matrix),
    emulator: Option<Emulator>,
}

/// The length of steps by dual averaging: Hoffman & Gelman (2014), algorithm 5.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Step {
    log: f64,
    log_mean: f64,
    bias: f64,
    count: f64,
    centre: f64,
}

/// The draws of a window.
#[derive(Debug, Clone)]
struct Window {
    moments: Moments,
    /// Those that an emulator proposed, and how many of them the model kept.
    proposed: f64,
    kept: f64,
    /// In a row.
    refused: f64,
}

/// What an emulator proposes, and the place with ln of the density there if the model keeps it.
struct Proposal {
    statistics: Statistics,
    kept: Option<(Vec<f64>, f64)>,
}

/// The place of a draw of the prior that the case takes; why not.
fn prior_draw(posterior: &Posterior, density: &Potential<'_>, random: &mut Xoshiro256PlusPlus) -> Option<Place> {
    (0..MOST_TRIALS).find_map(|_| {
        let values = posterior.drawn_from_priors(random);
        Place::of(density, &posterior.place(&values))
    })
}

impl Chain {
    /// A chain at the highest of the tops that it finds from its own draws of the prior, or a little beside; `None` if the
    /// case takes no draw of the prior.
    pub(crate) fn begin(posterior: &Posterior, seed: u64, index: u64, warmup: u64) -> Option<Self> {
        let scale: Vec<f64> = posterior.parameters().iter().map(|it| it.prior.variance().sqrt()).collect();
        let potential = |at: &[f64]| posterior.at(at).map(|it| (it.log_density, it.gradient));
        let tops = (0..STARTS).filter_map(|start| {
            let mut random = random(seed, index, u64::MAX - start);
            let from = prior_draw(posterior, &potential, &mut random)?;
            Some(climb(&potential, from, &scale))
        });
        let top = tops.max_by(|one, other| one.log_density.total_cmp(&other.log_density))?;
        let covariance = covariance(&potential, &top, &scale);
        let size = scale.len();
        let spread =
            covariance.cholesky().unwrap_or_else(|| Matrix::of(size, |i, j| if i == j { scale[i] } else { 0.0 }));
        let mut chain = Self {
            seed,
            index,
            warmup,
            done: 0,
            at: vec![0.0; size],
            log_density: top.log_density,
            made_for: (top.at.clone(), spread.clone()),
            middle: top.at,
            spread,
            step: Step::new(0.5),
            window: Window::new(size),
            emulates: true,
            emulator: None,
        };
        // Beside the top, where the density reaches: a chain shows where it came from.
        let mut random = random(seed, index, u64::MAX - STARTS);
        for _ in 0..MOST_TRIALS {
            let at: Vec<f64> = (0..size).map(|_| 2.0 * uniform(&mut random) - 1.0).collect();
            if let Some(log_density) = posterior.log_density(&chain.in_z(&at)) {
                (chain.at, chain.log_density) = (at, log_density);
                break;
            }
        }
        Some(chain)
    }

    /// A density of z in the coordinates of unit covariance.
    fn turned<'a>(
        &'a self,
        density: impl Fn(&[f64]) -> Option<Point> + 'a,
    ) -> impl Fn(&[f64]) -> Option<(f64, Vec<f64>)> + 'a {
        let turned = self.spread.transposed();
        move |at| {
            let point = density(&self.in_z(at))?;
            Some((point.log_density, turned.times(&point.gradient)))
        }
    }

    fn in_z(&self, at: &[f64]) -> Vec<f64> {
        let moved = self.spread.times(at).into_iter().zip(&self.middle);
        moved.map(|(moved, middle)| middle + moved).collect()
    }

    /// The next draw.
    pub(crate) fn draw(&mut self, posterior: &Posterior) -> Draw {
        let warm = self.done >= self.warmup;
        let step = match warm {
            true => self.step.log_mean.exp(),
            false => self.step.log.exp(),
        };
        if self.emulates && self.emulator.is_none() {
            let random = &mut random(self.seed, self.index, u64::MAX - STARTS - 1);
            let (middle, spread) = &self.made_for;
            self.emulator = Emulator::train(posterior, (middle, spread), random);
            self.emulates = self.emulator.is_some();
        }
        let statistics = self.advance(posterior, step);
        let place = self.in_z(&self.at);
        if !warm {
            self.step.adapt(statistics.acceptance);
            self.adapt(&place);
        }
        self.done += 1;
        Draw { place, log_density: self.log_density, statistics, step }
    }

    /// Go to the place of the next draw.
    fn advance(&mut self, posterior: &Posterior, step: f64) -> Statistics {
        let random = &mut random(self.seed, self.index, self.done);
        let misled = self.done < self.warmup && self.window.refused >= MOST_REFUSED;
        let emulator = self.emulator.as_ref().filter(|_| !misled);
        if let Some(emulator) = emulator
            && !self.done.is_multiple_of(ALONG_THE_MODEL)
            && let Some(Proposal { statistics, kept }) = self.propose(posterior, emulator, step, random)
        {
            self.window.proposed += 1.0;
            self.window.refused += 1.0;
            if let Some((at, log_density)) = kept {
                self.window.kept += 1.0;
                self.window.refused = 0.0;
                (self.at, self.log_density) = (at, log_density);
            }
            return statistics;
        }
        let along = |place: &[f64]| match emulator {
            Some(emulator) => emulator.along(posterior, place),
            None => posterior.at(place),
        };
        let along = self.turned(along);
        let Some(start) = Place::of(&along, &self.at) else {
            // No slope leads on from here.
            return Statistics::default();
        };
        let (place, statistics) = transition(&along, &start, step, random);
        drop(along);
        self.window.refused = 0.0;
        (self.at, self.log_density) = (place.at, place.log_density);
        statistics
    }

    /// Transitions under the density of an emulator; `None` if the emulator does not reach.
    ///
    /// Source: Liu (2001), *Monte Carlo Strategies in Scientific Computing*, section 9.4.3: transitions that are reversible under
    /// another density, kept with the probability that the ratio of the two densities asks.
    fn propose(
        &self,
        posterior: &Posterior,
        emulator: &Emulator,
        step: f64,
        random: &mut Xoshiro256PlusPlus,
    ) -> Option<Proposal> {
        let emulated = self.turned(|place| emulator.at(posterior, place));
        let start = Place::of(&emulated, &self.at)?;
        let (mut end, mut statistics) = transition(&emulated, &start, step, random);
        // Where an emulator runs away, the model need not; and the energy is that of the model where the draw begins.
        statistics.diverging = false;
        statistics.energy += start.log_density - self.log_density;
        for _ in 1..TRANSITIONS {
            (end, _) = transition(&emulated, &end, step, random);
        }
        let kept = posterior.log_density(&self.in_z(&end.at));
        let kept = kept.filter(|log_density| {
            let gain = log_density - self.log_density;
            uniform(random).ln() < gain - (end.log_density - start.log_density)
        });
        Some(Proposal { statistics, kept: kept.map(|log_density| (end.at, log_density)) })
    }

    /// Take a draw of the warm-up into the window, and at the end of that its covariance.
    fn adapt(&mut self, place: &[f64]) {
        let number = self.done + 1;
        // The first twelfth finds the way, the last twentieth the step; windows between double.
        let first = self.warmup / 12;
        let last = self.warmup - self.warmup / 20;
        if number <= first || number > last {
            return;
        }
        self.window.moments.add(place);
        if !ends_window(number, first, last) {
            return;
        }
        let size = place.len();
        let Moments { count, mean, scatter } = &self.window.moments;
        let share = count / (count + PRIOR_DRAWS);
        let before = self.spread.product(&self.spread.transposed());
        let after = Matrix::of(size, |i, j| {
            share * scatter.at(i, j) / (count - 1.0).max(1.0) + (1.0 - share) * before.at(i, j)
        });
        if let Some(spread) = after.cholesky() {
            self.middle = mean.clone();
            let beside: Vec<f64> = place.iter().zip(&self.middle).map(|(z, m)| z - m).collect();
            self.at = spread.forward(beside);
            self.spread = spread;
            self.step = Step::new(self.step.log.exp());
        }
        if number == last {
            self.emulates &= self.window.kept > LEAST_KEPT * self.window.proposed;
        }
        if self.window.kept < GOOD_KEPT * self.window.proposed {
            self.made_for = (self.middle.clone(), self.spread.clone());
            self.emulator = None;
        }
        self.window = Window::new(size);
    }

    /// The numbers of its state.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        let Step { log, log_mean, bias, count, centre } = self.step;
        let mut numbers = vec![self.done as f64, log, log_mean, bias, count, centre];
        numbers.extend([self.log_density, f64::from(u8::from(self.emulates))]);
        for part in [
            &self.at,
            &self.middle,
            &self.spread.values,
            &self.made_for.0,
            &self.made_for.1.values,
            &self.window.moments.mean,
            &self.window.moments.scatter.values,
        ] {
            numbers.extend(part);
        }
        let Window { moments, proposed, kept, refused } = &self.window;
        numbers.extend([moments.count, *proposed, *kept, *refused]);
        numbers
    }

    /// The chain of [`numbers`](Self::numbers) in a space of some dimensions; `None` if they are not as many.
    pub(crate) fn of_numbers(numbers: &[f64], size: usize, (seed, index, warmup): (u64, u64, u64)) -> Option<Self> {
        let mut rest = numbers;
        let mut take = |count: usize| -> Option<Vec<f64>> {
            let (part, behind) = rest.split_at_checked(count)?;
            rest = behind;
            Some(part.to_vec())
        };
        let head = take(8)?;
        let square = |values: Vec<f64>| Matrix { size, values };
        let chain = Self {
            seed,
            index,
            warmup,
            done: head[0] as u64,
            step: Step { log: head[1], log_mean: head[2], bias: head[3], count: head[4], centre: head[5] },
            log_density: head[6],
            emulates: head[7] != 0.0,
            emulator: None,
            at: take(size)?,
            middle: take(size)?,
            spread: square(take(size * size)?),
            made_for: (take(size)?, square(take(size * size)?)),
            window: Window {
                moments: Moments { mean: take(size)?, scatter: square(take(size * size)?), count: take(1)?[0] },
                proposed: take(1)?[0],
                kept: take(1)?[0],
                refused: take(1)?[0],
            },
        };
        rest.is_empty().then_some(chain)
    }
}

/// Whether a window ends with a draw: each is twice as long as the one before, and the last goes on to the end.
fn ends_window(number: u64, first: u64, last: u64) -> bool {
    let mut length = ((last - first) / 15).max(1);
    let mut end = first + length;
    while end < number {
        length *= 2;
        end += length;
    }
    if end + 2 * length > last { number == last } else { number == end }
}

impl Step {
    fn new(length: f64) -> Self {
        Self { log: length.ln(), log_mean: length.ln(), bias: 0.0, count: 0.0, centre: (2.0 * length).ln() }
    }

    fn adapt(&mut self, acceptance: f64) {
        const SHRINKS: f64 = 0.05;
        const BEGINS: f64 = 10.0;
        const FORGETS: f64 = 0.75;
        self.count += 1.0;
        let share = 1.0 / (self.count + BEGINS);
        self.bias = (1.0 - share) * self.bias + share * (ACCEPTANCE - acceptance);
        self.log = self.centre - self.bias * self.count.sqrt() / SHRINKS;
        let share = self.count.powf(-FORGETS);
        self.log_mean = share * self.log + (1.0 - share) * self.log_mean;
    }
}

impl Window {
    fn new(size: usize) -> Self {
        Self { moments: Moments::new(size), proposed: 0.0, kept: 0.0, refused: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 867 draws from the 84th on: 57, 114, 228 and the rest.
    #[test]
    fn windows_double() {
        let ends: Vec<u64> = (84..=950).filter(|it| ends_window(*it, 83, 950)).collect();
        assert_eq!(ends, [140, 254, 482, 950]);
    }

    /// A chain that is written and read goes on bit for bit, through the end of a window.
    #[test]
    fn a_chain_that_was_kept_goes_on_with_the_same_draws() {
        let plan = crate::fixtures::folder("b-three-dates").join("plan.toml");
        let posterior = crate::Plan::read(&plan).unwrap().posterior;
        let mut chain = Chain::begin(&posterior, 3, 1, 40).unwrap();
        (0..4).for_each(|_| drop(chain.draw(&posterior)));
        let numbers = chain.numbers();
        let size = posterior.parameters().len();
        let mut kept = Chain::of_numbers(&numbers, size, (3, 1, 40)).unwrap();
        assert!(Chain::of_numbers(&numbers[1..], size, (3, 1, 40)).is_none());
        for _ in 0..4 {
            let (one, other) = (chain.draw(&posterior), kept.draw(&posterior));
            assert_eq!(one.place, other.place);
            assert_eq!(one.log_density, other.log_density);
        }
        assert_eq!(chain.numbers(), kept.numbers());
    }
}
