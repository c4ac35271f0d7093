//! How a value is spread over the wheels of a traffic.

use crate::Error;
use crate::numerics::gauss::gauss_legendre;
use crate::numerics::normal_distribution;

/// Standard deviations between zero and the mean of a normal distribution, at least.
const TAIL: f64 = 4.0;

/// Distribution of a value over passing wheels.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// Values with weights that sum to one.
    Shares(Vec<(f64, f64)>),
    /// Normal.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Of which the logarithm is normal.
    LogNormal {
        /// Half of all values lie below.
        median: f64,
        /// Standard deviation of the logarithm.
        deviation: f64,
    },
    /// Even density between two ends.
    Even {
        /// Lowest.
        low: f64,
        /// Highest.
        high: f64,
    },
}

/// Half of the nodes of a rule, each with its weight; that of the middle first. All weights sum to one.
type Half = &'static [(f64, f64)];

/// Gauss–Hermite nodes of the standard normal distribution: exact for polynomials to the degree 5, 9 and 13.
/// Abramowitz & Stegun (1964), table 25.10, nodes times √2.
const NORMAL: [Half; 3] = [
    &[(0.0, 2.0 / 3.0), (1.732_050_807_568_877, 1.0 / 6.0)],
    &[
        (0.0, 8.0 / 15.0),
        (1.355_626_179_974_266, 0.222_075_922_005_612_6),
        (2.856_970_013_872_806, 0.011_257_411_327_720_69),
    ],
    &[
        (0.0, 16.0 / 35.0),
        (1.154_405_394_739_968, 0.240_123_178_605_012_7),
        (2.366_759_410_734_541, 0.030_757_123_967_586_51),
        (3.750_439_717_725_742, 5.482_688_559_722_18e-4),
    ],
];

impl Distribution {
    /// Rules of [`nodes`](Self::nodes), the coarsest first.
    pub const RULES: usize = 3;

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
            _ => Ok(Self::Normal { mean, deviation }),
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
            _ => Ok(Self::LogNormal { median, deviation }),
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
            false => Ok(Self::Even { low, high }),
        }
    }

    /// Mean.
    pub fn mean(&self) -> f64 {
        match self {
            Self::Shares(values) => values.iter().map(|(value, share)| value * share).sum(),
            Self::Normal { mean, .. } => *mean,
            Self::LogNormal { median, deviation } => median * (0.5 * deviation * deviation).exp(),
            Self::Even { low, high } => 0.5 * (low + high),
        }
    }

    /// Whether all wheels have one value.
    pub fn is_single(&self) -> bool {
        matches!(self, Self::Shares(values) if values.len() == 1)
    }

    /// Lowest value; of a normal distribution that four standard deviations below the mean,
    /// of a lognormal one by its logarithm.
    pub fn lowest(&self) -> f64 {
        match self {
            Self::Shares(values) => values.iter().map(|v| v.0).fold(f64::INFINITY, f64::min),
            Self::Normal { mean, deviation } => mean - TAIL * deviation,
            Self::LogNormal { median, deviation } => median * (-TAIL * deviation).exp(),
            Self::Even { low, .. } => *low,
        }
    }

    /// Highest value, likewise.
    pub fn highest(&self) -> f64 {
        match self {
            Self::Shares(values) => values.iter().map(|v| v.0).fold(f64::NEG_INFINITY, f64::max),
            Self::Normal { mean, deviation } => mean + TAIL * deviation,
            Self::LogNormal { median, deviation } => median * (TAIL * deviation).exp(),
            Self::Even { high, .. } => *high,
        }
    }

    /// Values with weights that sum to one, of which the weighted sum of a smooth function is its mean: of shares these
    /// themselves, else 3, 5 or 7 nodes of Gauss by the number of the rule from 0, all within four standard deviations.
    pub fn nodes(&self, rule: usize) -> Vec<(f64, f64)> {
        let (middle, scale) = match self {
            Self::Shares(values) => return values.clone(),
            Self::Normal { mean, deviation } => (*mean, *deviation),
            Self::LogNormal { median, deviation } => (median.ln(), *deviation),
            Self::Even { low, high } => {
                let nodes = match rule {
                    0 => gauss_legendre::<3>().to_vec(),
                    1 => gauss_legendre::<5>().to_vec(),
                    _ => gauss_legendre::<7>().to_vec(),
                };
                return nodes.into_iter().map(|(place, weight)| (low + place * (high - low), weight)).collect();
            }
        };
        let half = NORMAL[rule];
        let below = half.iter().skip(1).rev().map(|(at, weight)| (-at, *weight));
        let nodes = below.chain(half.iter().copied());
        let value = |at: f64| match self {
            Self::LogNormal { .. } => (middle + scale * at).exp(),
            _ => middle + scale * at,
        };
        nodes.map(|(at, weight)| (value(at), weight)).collect()
    }

    /// The share of all values from one to another, ends of steps included.
    pub fn share_within(&self, low: f64, high: f64) -> f64 {
        match self {
            Self::Shares(values) => {
                let inside = values.iter().filter(|(value, _)| (low..=high).contains(value));
                inside.map(|(_, share)| share).sum()
            }
            Self::Normal { mean, deviation } => {
                normal_distribution::below((high - mean) / deviation)
                    - normal_distribution::below((low - mean) / deviation)
            }
            Self::LogNormal { median, deviation } => {
                let below = |value: f64| normal_distribution::below((value.max(0.0) / median).ln() / deviation);
                below(high) - below(low)
            }
            Self::Even { low: from, high: to } => ((high.min(*to) - low.max(*from)) / (to - from)).max(0.0),
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
        let days = Distribution::log_normal(0.4, 1.4).unwrap();
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
        assert!(Distribution::log_normal(0.4, 0.9).is_err());
        assert!(Distribution::log_normal(0.4, 1.0).unwrap().is_single());
    }

    /// Moments: of the standard normal distribution 1, 3, 15, 105, 945, 10395, of the even one 1/(n + 1).
    #[test]
    fn nodes_have_the_moments_of_their_distribution() {
        let normal = Distribution::normal(0.0, 1.0).unwrap();
        let even = Distribution::even(-1.0, 1.0).unwrap();
        for rule in 0..Distribution::RULES {
            for half in 0..=2 * rule as i32 + 2 {
                let moment = |it: &Distribution| -> f64 {
                    it.nodes(rule).iter().map(|(at, weight)| weight * at.powi(2 * half)).sum()
                };
                let double_factorial: f64 = (1..=half).map(|k| f64::from(2 * k - 1)).product();
                // Nodes have 16 digits.
                assert!((moment(&normal) / double_factorial - 1.0).abs() < 1e-12, "{rule} {half}");
                assert!((moment(&even) * f64::from(2 * half + 1) - 1.0).abs() < 1e-12);
            }
            let odd: f64 = normal.nodes(rule).iter().map(|(at, weight)| weight * at).sum();
            assert!(odd.abs() < 1e-15);
        }
    }

    #[test]
    fn shares_within_a_band() {
        let normal = Distribution::normal(0.0, 2.0).unwrap();
        assert!((normal.share_within(-2.0, 2.0) - 0.682_689_492_137_086).abs() < 1e-14);
        let even = Distribution::even(0.0, 4.0).unwrap();
        assert_eq!(even.share_within(-1.0, 1.0), 0.25);
        assert_eq!(even.share_within(5.0, 6.0), 0.0);
        let shares = Distribution::shares(&[(0.0, 3.0), (5.0, 1.0)]).unwrap();
        assert_eq!(shares.share_within(-1.0, 1.0), 0.75);
        assert_eq!((shares.mean(), shares.lowest(), shares.highest()), (1.25, 0.0, 5.0));
    }

    #[test]
    fn what_is_no_distribution_is_refused() {
        assert!(Distribution::shares(&[]).is_err());
        assert!(Distribution::shares(&[(1.0, -0.5)]).is_err());
        assert!(Distribution::normal(1.0, -1.0).is_err());
        assert!(Distribution::even(2.0, 1.0).is_err());
        assert!(Distribution::single(f64::NAN).is_err());
        assert!(Distribution::normal(1.0, 0.0).unwrap().is_single());
        assert!(Distribution::even(2.0, 2.0).unwrap().is_single());
    }
}
