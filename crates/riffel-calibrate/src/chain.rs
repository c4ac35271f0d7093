//! One chain: where it begins, how it finds its steps, and its draws.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;

use crate::matrix::Matrix;
use crate::nuts::{Place, Statistics, transition, uniform};
use crate::optimum::{climb, covariance};
use crate::posterior::Posterior;

/// Places of the prior from which a chain looks for a top.
const STARTS: u64 = 4;
/// Most draws of the prior until the case takes one.
const MOST_TRIALS: u64 = 200;
/// Probability of acceptance that steps are made for.
const ACCEPTANCE: f64 = 0.9;
/// Draws to which the covariance of the start counts as much.
const PRIOR_DRAWS: f64 = 10.0;

/// A chain between two draws. All its numbers fit a file, and the random ones follow from seed, chain and draw: one that was
/// kept goes on with the same draws.
#[derive(Debug, Clone)]
pub(crate) struct Chain {
    seed: u64,
    index: u64,
    warmup: u64,
    /// Draws that are made, those of the warm-up among them.
    pub(crate) done: u64,
    /// In coordinates of unit covariance.
    place: Place,
    /// z = middle + spread · coordinate.
    middle: Vec<f64>,
    spread: Matrix,
    step: Step,
    window: Window,
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

/// Mean and scatter of the draws of a window, by Welford.
#[derive(Debug, Clone)]
struct Window {
    count: f64,
    mean: Vec<f64>,
    scatter: Matrix,
}

/// A draw: its place in z and what the sampler says of it.
#[derive(Debug, Clone)]
pub(crate) struct Draw {
    pub(crate) place: Vec<f64>,
    pub(crate) log_density: f64,
    pub(crate) statistics: Statistics,
    pub(crate) step: f64,
}

pub(crate) fn random(seed: u64, chain: u64, draw: u64) -> Xoshiro256PlusPlus {
    // Seeds are spread by the generator itself; chains and draws are kept apart by odd factors.
    let mixed = seed
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(chain.wrapping_mul(0xd1b5_4a32_d192_ed03))
        .wrapping_add(draw.wrapping_mul(0x8cb9_2ba7_2f3d_8dd7));
    Xoshiro256PlusPlus::seed_from_u64(mixed)
}

/// The place of a draw of the prior that the case takes; why not.
fn prior_draw(posterior: &Posterior, random: &mut Xoshiro256PlusPlus) -> Option<Place> {
    (0..MOST_TRIALS).find_map(|_| {
        let parameters = posterior.parameters().iter();
        let at: Vec<f64> = parameters
            .map(|parameter| {
                parameter
                    .prior
                    .place(parameter.prior.quantile(uniform(random)))
            })
            .collect();
        let point = posterior.at(&at)?;
        Some(Place {
            at,
            log_density: point.log_density,
            gradient: point.gradient,
        })
    })
}

impl Chain {
    /// A chain at the highest of the tops that it finds from its own draws of the prior, or a little beside; none where the
    /// case takes no draw of the prior.
    pub(crate) fn begin(posterior: &Posterior, seed: u64, index: u64, warmup: u64) -> Option<Self> {
        let scale: Vec<f64> = posterior
            .parameters()
            .iter()
            .map(|it| it.prior.variance().sqrt())
            .collect();
        let potential = |at: &[f64]| posterior.at(at).map(|it| (it.log_density, it.gradient));
        let tops = (0..STARTS).filter_map(|start| {
            let mut random = random(seed, index, u64::MAX - start);
            let from = prior_draw(posterior, &mut random)?;
            Some(climb(&potential, from, &scale))
        });
        let top = tops.max_by(|one, other| one.log_density.total_cmp(&other.log_density))?;
        let covariance = covariance(&potential, &top, &scale);
        let size = scale.len();
        let spread = covariance
            .cholesky()
            .unwrap_or_else(|| Matrix::of(size, |i, j| if i == j { scale[i] } else { 0.0 }));
        let mut chain = Self {
            seed,
            index,
            warmup,
            done: 0,
            place: Place {
                at: vec![0.0; size],
                log_density: top.log_density,
                gradient: spread.transposed().times(&top.gradient),
            },
            middle: top.at,
            spread,
            step: Step::new(0.5),
            window: Window::new(size),
        };
        // Beside the top, where the density reaches: a chain shows where it came from.
        let mut random = random(seed, index, u64::MAX - STARTS);
        for _ in 0..MOST_TRIALS {
            let at: Vec<f64> = (0..size)
                .map(|_| 2.0 * uniform(&mut random) - 1.0)
                .collect();
            let there = chain.potential(posterior)(&at);
            if let Some((log_density, gradient)) = there {
                chain.place = Place {
                    at,
                    log_density,
                    gradient,
                };
                break;
            }
        }
        Some(chain)
    }

    /// The density in coordinates of unit covariance.
    fn potential<'a>(
        &'a self,
        posterior: &'a Posterior,
    ) -> impl Fn(&[f64]) -> Option<(f64, Vec<f64>)> + 'a {
        let turned = self.spread.transposed();
        move |at| {
            let point = posterior.at(&self.in_z(at))?;
            Some((point.log_density, turned.times(&point.gradient)))
        }
    }

    fn in_z(&self, at: &[f64]) -> Vec<f64> {
        let moved = self.spread.times(at).into_iter().zip(&self.middle);
        moved.map(|(moved, middle)| middle + moved).collect()
    }

    /// The next draw.
    pub(crate) fn draw(&mut self, posterior: &Posterior) -> Draw {
        let mut random = random(self.seed, self.index, self.done);
        let warm = self.done >= self.warmup;
        let step = match warm {
            true => self.step.log_mean.exp(),
            false => self.step.log.exp(),
        };
        let (place, statistics) =
            transition(&self.potential(posterior), &self.place, step, &mut random);
        self.place = place;
        let place = self.in_z(&self.place.at);
        if !warm {
            self.step.adapt(statistics.acceptance);
            self.adapt(&place);
        }
        self.done += 1;
        Draw {
            place,
            log_density: self.place.log_density,
            statistics,
            step,
        }
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
        self.window.add(place);
        if !ends_window(number, first, last) {
            return;
        }
        let size = place.len();
        let share = self.window.count / (self.window.count + PRIOR_DRAWS);
        let before = self.spread.product(&self.spread.transposed());
        let after = Matrix::of(size, |i, j| {
            share * self.window.scatter.at(i, j) / (self.window.count - 1.0).max(1.0)
                + (1.0 - share) * before.at(i, j)
        });
        if let Some(spread) = after.cholesky() {
            // The same place and force in the new coordinates.
            let force = self.spread.transposed().backward(&self.place.gradient);
            self.middle = self.window.mean.clone();
            let beside: Vec<f64> = place.iter().zip(&self.middle).map(|(z, m)| z - m).collect();
            self.place.at = spread.forward(beside);
            self.place.gradient = spread.transposed().times(&force);
            self.spread = spread;
            self.step = Step::new(self.step.log.exp());
        }
        self.window = Window::new(size);
    }

    /// The numbers of its state.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        let Step {
            log,
            log_mean,
            bias,
            count,
            centre,
        } = self.step;
        let mut numbers = vec![self.done as f64, log, log_mean, bias, count, centre];
        numbers.push(self.place.log_density);
        for part in [
            &self.place.at,
            &self.place.gradient,
            &self.middle,
            &self.spread.values,
            &self.window.mean,
            &self.window.scatter.values,
        ] {
            numbers.extend(part);
        }
        numbers.push(self.window.count);
        numbers
    }

    /// The chain of [`numbers`](Self::numbers) in a space of some dimensions; none where they are not as many.
    pub(crate) fn of_numbers(
        numbers: &[f64],
        size: usize,
        (seed, index, warmup): (u64, u64, u64),
    ) -> Option<Self> {
        let mut rest = numbers;
        let mut take = |count: usize| -> Option<Vec<f64>> {
            let (part, behind) = rest.split_at_checked(count)?;
            rest = behind;
            Some(part.to_vec())
        };
        let head = take(7)?;
        let square = |values: Vec<f64>| Matrix { size, values };
        let chain = Self {
            seed,
            index,
            warmup,
            done: head[0] as u64,
            step: Step {
                log: head[1],
                log_mean: head[2],
                bias: head[3],
                count: head[4],
                centre: head[5],
            },
            place: Place {
                log_density: head[6],
                at: take(size)?,
                gradient: take(size)?,
            },
            middle: take(size)?,
            spread: square(take(size * size)?),
            window: Window {
                mean: take(size)?,
                scatter: square(take(size * size)?),
                count: take(1)?[0],
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
    if end + 2 * length > last {
        number == last
    } else {
        number == end
    }
}

impl Step {
    fn new(length: f64) -> Self {
        Self {
            log: length.ln(),
            log_mean: length.ln(),
            bias: 0.0,
            count: 0.0,
            centre: (2.0 * length).ln(),
        }
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
        Self {
            count: 0.0,
            mean: vec![0.0; size],
            scatter: Matrix::of(size, |_, _| 0.0),
        }
    }

    fn add(&mut self, place: &[f64]) {
        self.count += 1.0;
        let before: Vec<f64> = place
            .iter()
            .zip(&self.mean)
            .map(|(z, mean)| z - mean)
            .collect();
        for (mean, before) in self.mean.iter_mut().zip(&before) {
            *mean += before / self.count;
        }
        let after = place.iter().zip(&self.mean).map(|(z, mean)| z - mean);
        let after: Vec<f64> = after.collect();
        let rows = self.scatter.values.chunks_exact_mut(place.len());
        for (row, before) in rows.zip(before) {
            for (entry, after) in row.iter_mut().zip(&after) {
                *entry += before * after;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrix::dot;

    /// 867 draws from the 84th on: 57, 114, 228 and the rest.
    #[test]
    fn windows_double() {
        let ends: Vec<u64> = (84..=950).filter(|it| ends_window(*it, 83, 950)).collect();
        assert_eq!(ends, [140, 254, 482, 950]);
    }

    /// A chain that is written and read goes on bit for bit, through the end of a window.
    #[test]
    fn a_chain_that_was_kept_goes_on_with_the_same_draws() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let plan = root.join("../../validation/calibration/b-three-dates/plan.toml");
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

    /// Mean and covariance of a window are those of the sums.
    #[test]
    fn a_window_has_the_moments_of_its_draws() {
        let draws = [[1.0, 2.0], [3.0, -1.0], [0.5, 0.0], [-2.0, 4.0]];
        let mut window = Window::new(2);
        draws.iter().for_each(|draw| window.add(draw));
        let column = |index: usize| draws.map(|draw| draw[index] - window.mean[index]);
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            assert!((window.scatter.at(i, j) - dot(&column(i), &column(j))).abs() < 1e-12);
        }
    }
}
