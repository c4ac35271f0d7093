//! How fast the vehicles of a kind run.

use super::WheelValues;
use crate::Error;
use crate::cancel::check;
use crate::numerics::distribution::{Distribution, TAIL};

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
    /// Largest change of each quantity on halving the step: a bound of its error where the step
    /// resolves it.
    pub(super) error: [f64; N],
    /// Speeds at which the quantities were evaluated.
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

    /// Means of what `at` gives at a speed \[m/s\]: N quantities at each of some places.
    ///
    /// Of shares the weighted sum, exact. Of a normal distribution the trapezoidal rule over ±4 standard
    /// deviations, which converges faster than any power of the step for what is smooth. It begins with a
    /// quarter of a deviation and halves the step until that changes no mean by more than 1e-3 of the
    /// largest mean of its quantity, five times at most; what sharper lines leave is in the error.
    pub(super) fn means<const N: usize>(&self, mut at: impl FnMut(f64) -> Vec<[f64; N]>) -> Means<N> {
        let mut at = |speed| {
            check();
            at(speed)
        };
        let Some((mean, deviation)) = self.normal_law() else {
            let speeds = self.listed().unwrap_or_default();
            let mut sum = WeightedSum::new();
            for &(speed, share) in speeds {
                sum.add(&at(speed), share);
            }
            return Means { values: sum.mean(), error: [0.0; N], speeds: speeds.len() };
        };
        let mut sum = WeightedSum::new();
        let mut add = |sum: &mut WeightedSum<N>, z: f64| {
            let end = if z.abs() == TAIL { 0.5 } else { 1.0 };
            sum.add(&at(mean + z * deviation), end * (-0.5 * z * z).exp());
        };
        let z = |step: usize, steps: usize| 2.0 * TAIL * step as f64 / steps as f64 - TAIL;
        let mut steps = FIRST_STEPS;
        for step in 0..=steps {
            add(&mut sum, z(step, steps));
        }
        let mut values = sum.mean();
        let mut halvings = 0;
        loop {
            for step in 0..steps {
                add(&mut sum, z(2 * step + 1, 2 * steps));
            }
            (steps, halvings) = (2 * steps, halvings + 1);
            let finer = sum.mean();
            let mut error = [0.0; N];
            let mut converged = true;
            for (quantity, error) in error.iter_mut().enumerate() {
                let pairs = values.iter().zip(&finer);
                let changes = pairs.map(|(a, b)| (a[quantity] - b[quantity]).abs());
                *error = changes.fold(0.0, f64::max);
                let largest = finer.iter().map(|value| value[quantity].abs());
                converged &= *error <= TOLERANCE * largest.fold(0.0, f64::max);
            }
            values = finer;
            if converged || halvings == MOST_HALVINGS {
                return Means { values, error, speeds: steps + 1 };
            }
        }
    }
}

/// Σ w f and Σ w.
struct WeightedSum<const N: usize> {
    values: Vec<[f64; N]>,
    weight: f64,
}

impl<const N: usize> WeightedSum<N> {
    fn new() -> Self {
        Self { values: Vec::new(), weight: 0.0 }
    }

    fn add(&mut self, values: &[[f64; N]], weight: f64) {
        self.values.resize(values.len(), [0.0; N]);
        for (sum, value) in self.values.as_flattened_mut().iter_mut().zip(values.as_flattened()) {
            *sum += weight * value;
        }
        self.weight += weight;
    }

    fn mean(&self) -> Vec<[f64; N]> {
        let values = self.values.iter();
        values.map(|value| value.map(|sum| sum / self.weight)).collect()
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
            let found = speeds.means(|v| vec![[1.0 + (k * v).cos()]]);
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

    /// A line of growth a thirtieth of a deviation wide, against a sum of a million speeds.
    #[test]
    fn a_sharp_line_is_resolved_or_the_error_says_so() -> Result<(), Error> {
        let (mean, deviation) = (30.0, 3.0);
        let line = |v: f64| 1.0 / (1.0 + ((v - 31.0) / 0.1).powi(2));
        let found = SpeedDistribution::normal(mean, deviation)?.means(|v| vec![[line(v)]]);
        let steps = 1_000_000;
        let (mut sum, mut weight) = (0.0, 0.0);
        for step in 0..steps {
            let z = TAIL * (2.0 * (f64::from(step) + 0.5) / f64::from(steps) - 1.0);
            let density = (-0.5 * z * z).exp();
            sum += density * line(mean + z * deviation);
            weight += density;
        }
        let error = (found.values[0][0] - sum / weight).abs();
        assert!(found.speeds > FIRST_STEPS + 1);
        assert!(error <= 1e-3 * sum / weight, "{error}");
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
            let found = SpeedDistribution::normal(mean, spread * mean)?.means(|v| vec![[line(v)]]);
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
        assert_eq!(speeds.means(|v| vec![[v * v]]).values, [[325.0]]);
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
