//! How fast the vehicles of a kind run.

use rayon::prelude::*;
use riffel_numerics::distribution::{Distribution, TAIL};

use super::WheelValues;
use crate::Error;
use crate::cancel::check;

/// Equal steps over a normal distribution to begin with, a quarter of a standard deviation each.
const FIRST_STEPS: usize = 32;
/// How often they may be halved.
const MOST_HALVINGS: u32 = 5;
/// Change on halving the step, relative to the largest mean, at which a mean is taken to be found.
const TOLERANCE: f64 = 1e-3;

/// Distribution of the speed of passing wheels.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedDistribution {
    /// Shares, or a normal distribution.
    values: WheelValues,
}

/// Means over a distribution of speeds.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Means<const N: usize> {
    /// Means of the N quantities at each place.
    pub(super) values: Vec<[f64; N]>,
    /// Largest change of each quantity on halving the step for the last time: a bound of its error where the step
    /// resolves it.
    pub(super) error: [f64; N],
    /// Most speeds at which a quantity was evaluated.
    pub(super) speeds: usize,
}

impl SpeedDistribution {
    /// Least mean of a normal distribution in its standard deviations.
    pub const LEAST_MEAN_IN_DEVIATIONS: f64 = TAIL;

    /// A speed \[m/s\] of its own.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is finite and above zero.
    pub fn single(speed: f64) -> Result<Self, Error> {
        Self::shares(&[(speed, 1.0)])
    }

    /// Speeds \[m/s\] with their shares, which are scaled to sum to one.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless every speed and share is above zero and there is one at least.
    pub fn shares(speeds: &[(f64, f64)]) -> Result<Self, Error> {
        for &(speed, share) in speeds {
            Error::unless_positive("speed", speed, "m/s")?;
            Error::unless_positive("share of a speed", share, "")?;
        }
        let sum: f64 = speeds.iter().map(|speed| speed.1).sum();
        Error::unless_positive("sum of the shares of speeds", sum, "")?;
        Ok(Self { values: WheelValues::shares(speeds)? })
    }

    /// A normal distribution of a mean and a standard deviation \[m/s\], cut off at four standard deviations;
    /// without deviation the mean itself.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the mean is above zero and the deviation is not negative and less than
    /// a quarter of the mean, so that no wheel stands.
    pub fn normal(mean: f64, deviation: f64) -> Result<Self, Error> {
        Error::unless_positive("mean speed", mean, "m/s")?;
        Error::unless_not_negative("standard deviation of the speed", deviation, "m/s")?;
        if TAIL * deviation >= mean {
            return Err(Error::OutOfRange {
                quantity: "standard deviation of the speed",
                value: deviation,
                unit: "m/s",
                rule: "must be less than a quarter of the mean, for a normal distribution to end above \
                       standstill",
            });
        }
        Ok(Self { values: WheelValues::normal(mean, deviation)? })
    }

    /// Mean \[m/s\].
    pub fn mean(&self) -> f64 {
        self.values.mean()
    }

    /// Standard deviation \[m/s\].
    pub fn deviation(&self) -> f64 {
        if let Some((_, deviation)) = self.normal_law() {
            return deviation;
        }
        let mean = self.mean();
        let squares = self.listed().into_iter().flatten().map(|(v, share)| share * (v - mean).powi(2));
        squares.sum::<f64>().sqrt()
    }

    /// Lowest and highest speed \[m/s\].
    pub fn range(&self) -> (f64, f64) {
        self.values.reach().into()
    }

    /// The speeds \[m/s\] with their shares where they are listed; none for a normal distribution.
    pub fn listed(&self) -> Option<&[(f64, f64)]> {
        match &self.values {
            WheelValues::Shares(speeds) => Some(speeds),
            WheelValues::Spread(_) => None,
        }
    }

    /// Mean and standard deviation \[m/s\] of a normal distribution; `None` where speeds are listed.
    fn normal_law(&self) -> Option<(f64, f64)> {
        match self.values {
            WheelValues::Spread(Distribution::Normal { mean, standard_deviation, .. }) => {
                Some((mean, standard_deviation))
            }
            _ => None,
        }
    }

    /// The distribution with every speed multiplied by a factor above zero.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the factor is finite and above zero.
    pub fn scaled(&self, factor: f64) -> Result<Self, Error> {
        Error::unless_positive("factor of the speed", factor, "")?;
        if let Some((mean, deviation)) = self.normal_law() {
            return Self::normal(factor * mean, factor * deviation);
        }
        let speeds: Vec<_> = self.listed().into_iter().flatten().map(|&(v, share)| (factor * v, share)).collect();
        Self::shares(&speeds)
    }

    /// Speeds \[m/s\] with weights that sum to one, so few that a wheel may be followed through time at each of them: of
    /// shares these themselves, of a normal distribution those of the trapezoidal rule in halves of a standard deviation.
    ///
    /// The mean of cos kV is right to 10⁻⁴, what the tails hold, for kσ ≤ 8; a resonance as narrow as half a standard
    /// deviation may fall between two of them.
    pub fn nodes(&self) -> Vec<(f64, f64)> {
        const HALVES: i32 = 2 * TAIL as i32;
        let Some((mean, deviation)) = self.normal_law() else {
            return self.listed().unwrap_or_default().to_vec();
        };
        let at = |half: i32| {
            let z = 0.5 * f64::from(half);
            let end = if half.abs() == HALVES { 0.5 } else { 1.0 };
            (mean + z * deviation, end * (-0.5 * z * z).exp())
        };
        let nodes: Vec<(f64, f64)> = (-HALVES..=HALVES).map(at).collect();
        let sum: f64 = nodes.iter().map(|(_, weight)| weight).sum();
        nodes.into_iter().map(|(speed, weight)| (speed, weight / sum)).collect()
    }

    /// Means of what `at` gives of a block of neighbouring places at a speed \[m/s\]: N quantities at each of its places.
    ///
    /// Of shares the weighted sum, exact. Of a normal distribution the trapezoidal rule over ±4 standard
    /// deviations, which converges faster than any power of the step for what is smooth. It begins with a
    /// quarter of a deviation and halves the step of each block until that changes no mean in it by more than 1e-3
    /// of the largest mean of its quantity in all blocks, five times at most; what sharper lines leave is in the error.
    /// A sharp line that moves with the speed falls between the speeds at one place of a block, and on one at another:
    /// a dozen places tell whether it is resolved.
    ///
    /// Blocks in parallel on the current rayon pool.
    pub(super) fn means<B: Send, const N: usize>(
        &self,
        blocks: impl IntoIterator<Item = B>,
        at: impl Fn(&mut B, f64) -> Vec<[f64; N]> + Sync,
    ) -> Means<N> {
        let at = |of: &mut B, speed: f64| {
            check();
            at(of, speed)
        };
        let mut blocks: Vec<Block<B, N>> = blocks.into_iter().map(Block::new).collect();
        let Some((mean, deviation)) = self.normal_law() else {
            let speeds = self.listed().unwrap_or_default();
            blocks.par_iter_mut().for_each(|block| block.add(speeds.iter().copied(), at));
            return Means::of(&blocks, speeds.len());
        };
        let node = |step: usize, steps: usize| {
            let z = 2.0 * TAIL * step as f64 / steps as f64 - TAIL;
            let end = if z.abs() == TAIL { 0.5 } else { 1.0 };
            (mean + z * deviation, end * (-0.5 * z * z).exp())
        };
        let mut steps = FIRST_STEPS;
        blocks.par_iter_mut().for_each(|block| block.add((0..=steps).map(|step| node(step, steps)), at));
        for _ in 0..MOST_HALVINGS {
            let between = (0..steps).map(|step| node(2 * step + 1, 2 * steps));
            let unresolved = blocks.par_iter_mut().filter(|block| !block.resolved);
            unresolved.for_each(|block| block.add(between.clone(), at));
            steps *= 2;
            let values = || blocks.iter().flat_map(|block| &block.means);
            let largest: [f64; N] =
                std::array::from_fn(|quantity| values().map(|value| value[quantity].abs()).fold(0.0, f64::max));
            for block in &mut blocks {
                let mut errors = block.change.iter().zip(largest);
                block.resolved = errors.all(|(change, largest)| *change <= TOLERANCE * largest);
            }
            if blocks.iter().all(|block| block.resolved) {
                break;
            }
        }
        Means::of(&blocks, steps + 1)
    }
}

/// Neighbouring places and their means so far.
struct Block<B, const N: usize> {
    of: B,
    /// Σ w f and Σ w.
    sums: Vec<[f64; N]>,
    weight: f64,
    /// Their ratio.
    means: Vec<[f64; N]>,
    /// Largest change of each quantity by what was added last.
    change: [f64; N],
    /// Whether that is within the tolerance.
    resolved: bool,
}

impl<B, const N: usize> Block<B, N> {
    fn new(of: B) -> Self {
        Self { of, sums: Vec::new(), weight: 0.0, means: Vec::new(), change: [0.0; N], resolved: false }
    }

    /// Add what is found at some speeds, each with its weight.
    fn add(&mut self, speeds: impl Iterator<Item = (f64, f64)>, at: impl Fn(&mut B, f64) -> Vec<[f64; N]>) {
        for (speed, weight) in speeds {
            let values = at(&mut self.of, speed);
            self.sums.resize(values.len(), [0.0; N]);
            for (sum, value) in self.sums.as_flattened_mut().iter_mut().zip(values.as_flattened()) {
                *sum += weight * value;
            }
            self.weight += weight;
        }
        let means: Vec<[f64; N]> = self.sums.iter().map(|sums| sums.map(|sum| sum / self.weight)).collect();
        self.change = [0.0; N];
        for (before, after) in self.means.iter().zip(&means) {
            for (quantity, change) in self.change.iter_mut().enumerate() {
                *change = change.max((before[quantity] - after[quantity]).abs());
            }
        }
        self.means = means;
    }
}

impl<const N: usize> Means<N> {
    fn of<B>(blocks: &[Block<B, N>], speeds: usize) -> Self {
        let changes = |quantity: usize| blocks.iter().map(move |block| block.change[quantity]);
        Self {
            values: blocks.iter().flat_map(|block| &block.means).copied().collect(),
            error: std::array::from_fn(|quantity| changes(quantity).fold(0.0, f64::max)),
            speeds,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// E cos(kV + φ) = cos(kμ + φ) exp(−k²σ²/2); the tails cut off hold 6.3e-5.
    #[test]
    fn the_mean_of_a_cosine_is_its_characteristic_function() -> Result<(), Error> {
        let (mean, deviation) = (30.0, 2.0);
        let speeds = SpeedDistribution::normal(mean, deviation)?;
        for k in [0.0, 0.1, 0.5, 1.0, 2.0] {
            let found = speeds.means([()], |(), v| vec![[1.0 + (k * v).cos()]]);
            let expected = 1.0 + (k * mean).cos() * (-0.5 * (k * deviation).powi(2)).exp();
            let [value] = found.values[0];
            let nodes = speeds.nodes();
            let of_nodes: f64 = nodes.iter().map(|(v, share)| share * (k * v).cos()).sum();
            assert!((1.0 + of_nodes - expected).abs() < 1.3e-4, "{k}: {of_nodes}");
            assert!((value - expected).abs() < 1.3e-4, "k {k}: {value} {expected}");
            assert!(found.error[0] <= 1e-3 * expected);
        }
        Ok(())
    }

    /// Mean by a sum of that many speeds.
    fn fine_sum(mean: f64, deviation: f64, steps: u32, at: impl Fn(f64) -> f64) -> f64 {
        let (mut sum, mut weight) = (0.0, 0.0);
        for step in 0..steps {
            let z = TAIL * (2.0 * (f64::from(step) + 0.5) / f64::from(steps) - 1.0);
            let density = (-0.5 * z * z).exp();
            sum += density * at(mean + z * deviation);
            weight += density;
        }
        sum / weight
    }

    /// A line of growth a thirtieth of a deviation wide, against a sum of a million speeds.
    #[test]
    fn a_sharp_line_is_resolved_or_the_error_says_so() -> Result<(), Error> {
        let (mean, deviation) = (30.0, 3.0);
        let line = |v: f64| 1.0 / (1.0 + ((v - 31.0) / 0.1).powi(2));
        let found = SpeedDistribution::normal(mean, deviation)?.means([()], |(), v| vec![[line(v)]]);
        let expected = fine_sum(mean, deviation, 1_000_000, line);
        let error = (found.values[0][0] - expected).abs();
        assert!(found.speeds > FIRST_STEPS + 1);
        assert!(error <= 1e-3 * expected, "{error}");
        Ok(())
    }

    /// Resonances of 0.1 to 3 % of their frequency at the lines of bands from 20 to 315 mm, under three spreads of speed, against sums of
    /// 20 000 speeds: what is left is within the tolerance and the error that is told, and bands that hold no sharp resonance are
    /// asked at fewer speeds.
    #[test]
    fn each_band_is_asked_at_as_many_speeds_as_it_needs() -> Result<(), Error> {
        let resonances = [(43.0, 0.3, 2.0), (71.0, 0.07, -3.0), (320.0, 9.0, 1.0), (655.0, 4.0, -0.4)];
        let line = |wavelength: f64, v: f64| {
            let terms = resonances.iter();
            let terms = terms.map(|(at, width, height)| height / (1.0 + ((v / wavelength - at) / width).powi(2)));
            terms.sum::<f64>()
        };
        let lines: Vec<f64> = (0..192).map(|index| 0.02 * (f64::from(index) * 0.0144).exp()).collect();
        for (mean, deviation) in [(12.5, 0.8), (19.0, 2.3), (33.0, 1.1)] {
            let asked = std::sync::atomic::AtomicUsize::new(0);
            let found = SpeedDistribution::normal(mean, deviation)?.means(lines.chunks(16), |lines, v| {
                asked.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
                lines.iter().map(|wavelength| [line(*wavelength, v)]).collect()
            });
            let expected: Vec<f64> =
                lines.iter().map(|&wavelength| fine_sum(mean, deviation, 20_000, |v| line(wavelength, v))).collect();
            let largest = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            for (([value], expected), wavelength) in found.values.iter().zip(&expected).zip(&lines) {
                let error = (value - expected).abs();
                assert!(
                    error <= f64::max(TOLERANCE * largest, found.error[0]),
                    "{mean} {wavelength}: {error} {largest}"
                );
            }
            let (asked, of_all) = (asked.into_inner(), found.speeds * lines.len() / 16);
            assert!(3 * asked < 2 * of_all, "{mean}: {asked} of {of_all}");
        }
        Ok(())
    }

    /// A Lorentzian line of the relative half width ζ falls under a normal spread s of the speed to √π u erfcx(u), u = ζ/(√2 s), of
    /// its height: Voigt's function at its middle. To four digits as tabulated, and the tails cut off.
    #[test]
    fn a_line_falls_under_a_spread_of_speed_as_in_closed_form() -> Result<(), Error> {
        let table = [
            (0.01, 0.01, 0.6557),
            (0.01, 0.05, 0.2152),
            (0.01, 0.10, 0.1159),
            (0.02, 0.20, 0.1159),
            (0.10, 0.05, 0.8427),
            (0.20, 0.20, 0.6557),
        ];
        for (width, spread, expected) in table {
            let mean = 20.0;
            let line = |v: f64| 1.0 / (1.0 + ((v / mean - 1.0) / width).powi(2));
            let found = SpeedDistribution::normal(mean, spread * mean)?.means([()], |(), v| vec![[line(v)]]);
            let [value] = found.values[0];
            let error = (value - expected).abs();
            assert!(error < 2e-3 * expected, "{width} {spread}: {value} {expected}");
            let u = width / (2f64.sqrt() * spread);
            let closed = std::f64::consts::PI.sqrt() * u * (u * u).exp() * libm::erfc(u);
            assert!((closed - expected).abs() < 1e-4, "{closed} {expected}");
        }
        Ok(())
    }

    #[test]
    fn shares_are_weights() -> Result<(), Error> {
        let speeds = SpeedDistribution::shares(&[(10.0, 1.0), (20.0, 3.0)])?;
        assert_eq!(speeds.mean(), 17.5);
        assert_eq!(speeds.range(), (10.0, 20.0));
        assert_eq!(speeds.means([()], |(), v| vec![[v * v]]).values, [[325.0]]);
        assert!((speeds.deviation() - 18.75f64.sqrt()).abs() < 1e-12);
        assert_eq!(speeds.scaled(2.0)?.mean(), 35.0);
        Ok(())
    }

    #[test]
    fn what_stands_is_refused() {
        assert!(SpeedDistribution::single(0.0).is_err());
        assert!(SpeedDistribution::shares(&[]).is_err());
        assert!(SpeedDistribution::shares(&[(10.0, -1.0)]).is_err());
        assert!(SpeedDistribution::normal(20.0, 5.0).is_err());
        assert!(SpeedDistribution::normal(20.0, f64::NAN).is_err());
        let (low, _) = SpeedDistribution::normal(20.0, 4.9).unwrap().range();
        assert!(low > 0.0);
    }
}
