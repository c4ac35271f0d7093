//! One transition of a Hamiltonian sampler that finds its own length.
//!
//! Own code, since the crate for it, nuts-rs 0.19, cannot go on from a file and brings 35 crates, 112 of some 870 CPU-seconds of
//! the first build.

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel_numerics::matrix::dot;
use riffel_numerics::random_numbers::{normal, uniform};

/// Error of the energy from which a trajectory is said to diverge.
const DIVERGES: f64 = 1000.0;
/// Most doublings of a trajectory.
const DEEPEST: u32 = 10;

/// ln of a density and its gradient; `None` if it is zero.
pub(crate) type Potential<'a> = dyn Fn(&[f64]) -> Option<(f64, Vec<f64>)> + 'a;

/// A place with its density.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Place {
    pub(crate) at: Vec<f64>,
    pub(crate) log_density: f64,
    pub(crate) gradient: Vec<f64>,
}

/// What a transition tells of itself.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Statistics {
    /// Mean probability of acceptance over the steps.
    pub(crate) acceptance: f64,
    pub(crate) steps: u32,
    pub(crate) depth: u32,
    pub(crate) diverging: bool,
    /// −ln density and the kinetic energy at the start.
    pub(crate) energy: f64,
}

#[derive(Clone)]
struct Phase {
    place: Place,
    momentum: Vec<f64>,
}

/// A part of a trajectory.
struct Tree {
    /// Earliest and latest phase.
    ends: [Phase; 2],
    /// Sum of all momenta.
    sum: Vec<f64>,
    /// ln of the sum of the weights.
    log_weight: f64,
    proposal: Place,
    /// Whether it has turned back or left where the density is.
    ended: bool,
}

struct Walk<'a> {
    potential: &'a Potential<'a>,
    step: f64,
    energy: f64,
    random: &'a mut Xoshiro256PlusPlus,
    statistics: Statistics,
    accepted: f64,
}

/// The place after `from`, by steps of a size in coordinates in which the density has about unit covariance.
///
/// Method: no-U-turn sampler with multinomial choice from the trajectory, biased towards its newer half, and the criterion of
/// the sum of momenta, also across the halves.
///
/// Source: Hoffman & Gelman (2014), J. Mach. Learn. Res. 15; Betancourt (2017), arXiv:1701.02434, appendix A.
pub(crate) fn transition(
    potential: &Potential<'_>,
    from: &Place,
    step: f64,
    random: &mut Xoshiro256PlusPlus,
) -> (Place, Statistics) {
    let momentum: Vec<f64> = from.at.iter().map(|_| normal(random)).collect();
    let start = Phase { place: from.clone(), momentum };
    let energy = start.energy();
    let mut walk = Walk {
        potential,
        step,
        energy,
        random,
        statistics: Statistics { energy, ..Statistics::default() },
        accepted: 0.0,
    };
    let mut tree = Tree::of(start, 0.0);
    for depth in 0..DEEPEST {
        let forward = uniform(walk.random) < 0.5;
        let end = tree.ends[usize::from(forward)].clone();
        let new = walk.grow(end, forward, depth);
        walk.statistics.depth = depth + 1;
        if new.ended {
            break;
        }
        if uniform(walk.random).ln() < new.log_weight - tree.log_weight {
            tree.proposal = new.proposal.clone();
        }
        tree = tree.joined(new, forward);
        if tree.ended {
            break;
        }
    }
    let mut statistics = walk.statistics;
    statistics.acceptance = walk.accepted / f64::from(statistics.steps.max(1));
    (tree.proposal, statistics)
}

impl Place {
    /// A place under a density; `None` if it is zero.
    pub(crate) fn of(density: &Potential<'_>, at: &[f64]) -> Option<Self> {
        let (log_density, gradient) = density(at)?;
        let at = at.to_vec();
        Some(Self { at, log_density, gradient })
    }
}

impl Phase {
    fn energy(&self) -> f64 {
        0.5 * dot(&self.momentum, &self.momentum) - self.place.log_density
    }
}

impl Tree {
    fn of(phase: Phase, log_weight: f64) -> Self {
        Self {
            sum: phase.momentum.clone(),
            proposal: phase.place.clone(),
            ends: [phase.clone(), phase],
            log_weight,
            ended: false,
        }
    }

    /// With another part after or before it; the proposal stays its own.
    fn joined(self, new: Self, forward: bool) -> Self {
        let proposal = self.proposal.clone();
        let [early, late] = if forward { [self, new] } else { [new, self] };
        let add = |one: &[f64], other: &[f64]| -> Vec<f64> {
            one.iter().zip(other).map(|(one, other)| one + other).collect()
        };
        let sum = add(&early.sum, &late.sum);
        let turns = |sum: &[f64], first: &Phase, last: &Phase| {
            dot(sum, &first.momentum) <= 0.0 || dot(sum, &last.momentum) <= 0.0
        };
        let [begin, end_of_early] = early.ends;
        let [begin_of_late, end] = late.ends;
        let across = add(&early.sum, &begin_of_late.momentum);
        let back = add(&late.sum, &end_of_early.momentum);
        let ended =
            turns(&sum, &begin, &end) || turns(&across, &begin, &begin_of_late) || turns(&back, &end_of_early, &end);
        Self { ends: [begin, end], sum, log_weight: log_sum(early.log_weight, late.log_weight), proposal, ended }
    }
}

impl Walk<'_> {
    /// 2^depth steps on from an end.
    fn grow(&mut self, from: Phase, forward: bool, depth: u32) -> Tree {
        if depth == 0 {
            return self.step(from, forward);
        }
        let first = self.grow(from, forward, depth - 1);
        if first.ended {
            return first;
        }
        let end = first.ends[usize::from(forward)].clone();
        let second = self.grow(end, forward, depth - 1);
        if second.ended {
            return second;
        }
        let all = log_sum(first.log_weight, second.log_weight);
        let mut first = first;
        if uniform(self.random).ln() < second.log_weight - all {
            first.proposal = second.proposal.clone();
        }
        first.joined(second, forward)
    }

    /// One leapfrog step. Where there is no density, the trajectory ends: no divergence, but a border.
    fn step(&mut self, mut phase: Phase, forward: bool) -> Tree {
        let step = if forward { self.step } else { -self.step };
        self.statistics.steps += 1;
        let kick = |phase: &mut Phase| {
            let pairs = phase.momentum.iter_mut().zip(&phase.place.gradient);
            pairs.for_each(|(momentum, slope)| *momentum += 0.5 * step * slope);
        };
        kick(&mut phase);
        let pairs = phase.place.at.iter_mut().zip(&phase.momentum);
        pairs.for_each(|(at, momentum)| *at += step * momentum);
        let Some((log_density, gradient)) = (self.potential)(&phase.place.at) else {
            let mut tree = Tree::of(phase, f64::NEG_INFINITY);
            tree.ended = true;
            return tree;
        };
        (phase.place.log_density, phase.place.gradient) = (log_density, gradient);
        kick(&mut phase);
        let error = phase.energy() - self.energy;
        self.accepted += (-error).min(0.0).exp();
        let mut tree = Tree::of(phase, -error);
        if error.is_nan() || error >= DIVERGES {
            self.statistics.diverging = true;
            tree.ended = true;
        }
        tree
    }
}

fn log_sum(one: f64, other: f64) -> f64 {
    let (low, high) = (one.min(other), one.max(other));
    high + (low - high).exp().ln_1p()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_xoshiro::rand_core::SeedableRng;

    /// A normal variable and one that is −ln of a uniform one, cut off at zero: means, variances and a share of the tail, in
    /// 20 000 draws, to four standard errors.
    #[test]
    fn draws_are_of_the_density() {
        let potential = |at: &[f64]| {
            let (x, y) = (at[0], at[1]);
            (y > 0.0).then(|| (-0.5 * (x - 1.0).powi(2) - y, vec![1.0 - x, -1.0]))
        };
        let mut random = Xoshiro256PlusPlus::seed_from_u64(5);
        let (log_density, gradient) = potential(&[0.0, 1.0]).unwrap();
        let mut place = Place { at: vec![0.0, 1.0], log_density, gradient };
        let count = 20_000;
        let mut sums = [0.0; 5];
        for _ in 0..count {
            (place, _) = transition(&potential, &place, 0.6, &mut random);
            let (x, y) = (place.at[0], place.at[1]);
            let terms = [x, x * x, y, y * y, f64::from(u8::from(y > 3.0))];
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        }
        let means = sums.map(|sum| sum / f64::from(count));
        for (mean, (expected, tolerance)) in
            means.iter().zip([(1.0, 0.04), (2.0, 0.1), (1.0, 0.06), (2.0, 0.3), ((-3f64).exp(), 0.015)])
        {
            assert!((mean - expected).abs() < tolerance, "{means:?}");
        }
    }
}
