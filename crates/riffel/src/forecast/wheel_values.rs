//! Values of passing wheels.

use riffel_numerics::distribution::Distribution;

use crate::Error;

/// Values of passing wheels.
#[derive(Debug, Clone, PartialEq)]
pub enum WheelValues {
    /// Values with weights that sum to one.
    Shares(Vec<(f64, f64)>),
    /// Any number of a distribution.
    Spread(Distribution),
}

impl WheelValues {
    /// Values with their shares, which are scaled to sum to one.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless every value is finite, every share above zero, and there is one at least.
    pub fn shares(values: &[(f64, f64)]) -> Result<Self, Error> {
        for &(value, share) in values {
            finite(value)?;
            Error::unless_positive("share of a value", share, "")?;
        }
        let sum: f64 = values.iter().map(|value| value.1).sum();
        Error::unless_positive("sum of the shares of values", sum, "")?;
        let values = values.iter().map(|&(value, share)| (value, share / sum));
        Ok(Self::Shares(values.collect()))
    }

    /// One value of all.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is finite.
    pub fn single(value: f64) -> Result<Self, Error> {
        Self::shares(&[(value, 1.0)])
    }

    /// A normal distribution; without deviation its mean.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are finite and the deviation is not negative.
    pub fn normal(mean: f64, deviation: f64) -> Result<Self, Error> {
        finite(mean)?;
        Error::unless_not_negative("standard deviation", deviation, "")?;
        match deviation {
            0.0 => Self::single(mean),
            _ => Ok(Self::Spread(Distribution::normal(mean, deviation))),
        }
    }

    /// Values of which 68 % lie between the median over a factor and the median times it; without a factor the median.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the median is above zero and the factor not below one.
    pub fn log_normal(median: f64, factor: f64) -> Result<Self, Error> {
        Error::unless_positive("median of a distribution", median, "")?;
        let deviation = factor.ln();
        Error::unless_not_negative("logarithm of a factor", deviation, "")?;
        match deviation {
            0.0 => Self::single(median),
            _ => Ok(Self::Spread(Distribution::lognormal(median, deviation))),
        }
    }

    /// Even density from one value to another; the value itself if both are equal.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are finite and the first is not above the second.
    pub fn even(low: f64, high: f64) -> Result<Self, Error> {
        finite(low)?;
        finite(high)?;
        if low > high {
            return Err(Error::OutOfRange {
                quantity: "upper end of a distribution",
                value: high,
                unit: "",
                rule: "must not be below the lower end",
            });
        }
        match low == high {
            true => Self::single(low),
            false => Ok(Self::Spread(Distribution::Uniform { min: low, max: high })),
        }
    }

    /// Mean.
    pub fn mean(&self) -> f64 {
        match self {
            Self::Shares(values) => values.iter().map(|(value, share)| value * share).sum(),
            Self::Spread(distribution) => distribution.mean(),
        }
    }

    /// Whether all wheels have one value.
    pub fn is_single(&self) -> bool {
        matches!(self, Self::Shares(values) if values.len() == 1)
    }

    /// Lowest and highest value; those of [`Distribution::reach`] for a distribution.
    pub fn reach(&self) -> [f64; 2] {
        match self {
            Self::Shares(values) => {
                let values = values.iter().map(|value| value.0);
                [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
            }
            Self::Spread(distribution) => distribution.reach(),
        }
    }

    /// Values with weights that sum to one, of which the weighted sum of a smooth function is its mean: of shares these
    /// themselves, else [`Distribution::nodes`] by the number of the rule.
    pub fn nodes(&self, rule: usize) -> Vec<(f64, f64)> {
        match self {
            Self::Shares(values) => values.clone(),
            Self::Spread(distribution) => distribution.nodes(rule),
        }
    }

    /// The share of all values from one to another, ends of steps included.
    pub fn share_within(&self, low: f64, high: f64) -> f64 {
        match self {
            Self::Shares(values) => {
                let inside = values.iter().filter(|(value, _)| (low..=high).contains(value));
                inside.map(|(_, share)| share).sum()
            }
            Self::Spread(distribution) => distribution.share_within(low, high),
        }
    }
}

fn finite(value: f64) -> Result<(), Error> {
    match value.is_finite() {
        true => Ok(()),
        false => {
            Err(Error::OutOfRange { quantity: "value of a distribution", value, unit: "", rule: "must be finite" })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a lognormal distribution half lie below the median and 68.27 % within the factor; the mean of xⁿ is mⁿ exp(n² s²/2), which
    /// five nodes have to the 2e-4 by which the remainder of Gauss and Hermite, (n s)¹⁰/10! · 5!, leaves them for n s = 1.
    #[test]
    fn days_of_friction_are_lognormal() {
        let days = WheelValues::log_normal(0.4, 1.4).unwrap();
        assert!((days.share_within(0.0, 0.4) - 0.5).abs() < 1e-12);
        assert!((days.share_within(0.4 / 1.4, 0.4 * 1.4) - 0.682_689_492).abs() < 1e-9);
        assert!((days.share_within(0.26, 0.616) - 0.8).abs() < 1e-2);
        let deviation = 1.4f64.ln();
        for power in [1, 2, 3] {
            let nodes = days.nodes(1).into_iter();
            let mean: f64 = nodes.map(|(at, weight)| weight * at.powi(power)).sum();
            let n = f64::from(power);
            let exact = 0.4f64.powi(power) * (0.5 * (n * deviation).powi(2)).exp();
            assert!((mean / exact - 1.0).abs() < 2e-4, "{power}: {mean} {exact}");
        }
        assert!((days.mean() / (0.4 * (0.5 * deviation * deviation).exp()) - 1.0).abs() < 1e-12);
        assert!(WheelValues::log_normal(0.4, 0.9).is_err());
        assert!(WheelValues::log_normal(0.4, 1.0).unwrap().is_single());
    }

    #[test]
    fn shares_are_weights() {
        let shares = WheelValues::shares(&[(0.0, 3.0), (5.0, 1.0)]).unwrap();
        assert_eq!(shares.share_within(-1.0, 1.0), 0.75);
        assert_eq!((shares.mean(), shares.reach()), (1.25, [0.0, 5.0]));
    }

    #[test]
    fn what_is_no_distribution_is_refused() {
        assert!(WheelValues::shares(&[]).is_err());
        assert!(WheelValues::shares(&[(1.0, -0.5)]).is_err());
        assert!(WheelValues::normal(1.0, -1.0).is_err());
        assert!(WheelValues::even(2.0, 1.0).is_err());
        assert!(WheelValues::single(f64::NAN).is_err());
        assert!(WheelValues::normal(1.0, 0.0).unwrap().is_single());
        assert!(WheelValues::even(2.0, 2.0).unwrap().is_single());
    }
}
