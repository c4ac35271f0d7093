//! Distributions of a parameter, by their quantiles.

use riffel::numerics::normal_distribution;

/// How a number is spread. Values are in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Every value between two is as likely.
    Uniform {
        /// Lower end.
        min: f64,
        /// Upper end.
        max: f64,
    },
    /// Gauss's, cut off at its ends; without ends, infinite.
    Normal {
        /// Mean of the distribution before it is cut.
        mean: f64,
        /// Standard deviation of the same.
        standard_deviation: f64,
        /// Lower end.
        min: f64,
        /// Upper end.
        max: f64,
    },
    /// Of a quantity whose logarithm is normal, cut off at its ends.
    Lognormal {
        /// Mean of the logarithm: the logarithm of the median.
        log_mean: f64,
        /// Standard deviation of the logarithm.
        log_deviation: f64,
        /// Lower end, 0 for none.
        min: f64,
        /// Upper end.
        max: f64,
    },
    /// Rises to its mode and falls.
    Triangular {
        /// Lower end.
        min: f64,
        /// Most likely value.
        mode: f64,
        /// Upper end.
        max: f64,
    },
}

impl Distribution {
    /// Lognormal distribution of a mean and a standard deviation of the quantity itself, both above zero:
    /// σ² = ln(1 + (sd/mean)²), μ = ln mean − σ²/2.
    pub fn lognormal_of_moments(mean: f64, standard_deviation: f64, ends: (f64, f64)) -> Self {
        let variance = (standard_deviation / mean).powi(2).ln_1p();
        Self::Lognormal {
            log_mean: mean.ln() - 0.5 * variance,
            log_deviation: variance.sqrt(),
            min: ends.0,
            max: ends.1,
        }
    }

    /// The value below which a share `u` of all values lies, 0 < u < 1.
    ///
    /// Method: inverse of the cumulative distribution in closed form, with the inverse error function of
    /// `statrs`; for a distribution that is cut off, of the share between its ends.
    pub fn quantile(&self, u: f64) -> f64 {
        match *self {
            Self::Uniform { min, max } => (min + u * (max - min)).clamp(min, max),
            Self::Normal { mean, standard_deviation, min, max } => {
                let ends = [min, max].map(|end| (end - mean) / standard_deviation);
                (mean + standard_deviation * cut_normal(u, ends)).clamp(min, max)
            }
            Self::Lognormal { log_mean, log_deviation, min, max } => {
                let ends = [min, max].map(|end| (end.ln() - log_mean) / log_deviation);
                (log_mean + log_deviation * cut_normal(u, ends)).exp().clamp(min, max)
            }
            Self::Triangular { min, mode, max } => {
                let width = max - min;
                let value = if u * width < mode - min {
                    min + (u * width * (mode - min)).sqrt()
                } else {
                    max - ((1.0 - u) * width * (max - mode)).sqrt()
                };
                value.clamp(min, max)
            }
        }
    }
}

/// Quantile of the standard normal distribution between two ends.
fn cut_normal(u: f64, [low, high]: [f64; 2]) -> f64 {
    if low > 0.0 {
        // In the upper tail probabilities are all but one: look from the other side.
        return -cut_normal(1.0 - u, [-high, -low]);
    }
    let (from, to) = (normal_distribution::below(low), normal_distribution::below(high));
    normal_distribution::quantile(from + u * (to - from)).clamp(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and standard deviation by the midpoint rule over the quantiles.
    fn moments(distribution: Distribution) -> (f64, f64) {
        let count = 200_000;
        let values = (0..count).map(|k| distribution.quantile((f64::from(k) + 0.5) / f64::from(count)));
        let (sum, squares) = values.fold((0.0, 0.0), |(sum, squares), x| (sum + x, squares + x * x));
        let mean = sum / f64::from(count);
        (mean, (squares / f64::from(count) - mean * mean).sqrt())
    }

    /// Moments in closed form; the midpoint rule over 2e5 quantiles loses some 1e-4 of the spread in infinite
    /// tails.
    #[test]
    fn moments_are_those_of_the_books() {
        let infinite = (f64::NEG_INFINITY, f64::INFINITY);
        let (density, below): (f64, f64) = (0.241_970_724_519_143_37, 0.682_689_492_137_085_9);
        let normal = |(min, max)| Distribution::Normal { mean: 3.0, standard_deviation: 2.0, min, max };
        let cases = [
            (Distribution::Uniform { min: 1.0, max: 4.0 }, 2.5, 3.0 / 12f64.sqrt()),
            (normal(infinite), 3.0, 2.0),
            // Cut at one standard deviation: σ²(1 − 2φ(1)/(Φ(1) − Φ(−1))).
            (normal((1.0, 5.0)), 3.0, 2.0 * (1.0 - 2.0 * density / below).sqrt()),
            (Distribution::lognormal_of_moments(5.0, 1.5, (0.0, f64::INFINITY)), 5.0, 1.5),
            (
                Distribution::Triangular { min: 0.0, mode: 1.0, max: 4.0 },
                5.0 / 3.0,
                ((0.0 + 1.0 + 16.0 - 0.0 - 0.0 - 4.0) / 18f64).sqrt(),
            ),
        ];
        for (distribution, mean, deviation) in cases {
            let found = moments(distribution);
            assert!((found.0 - mean).abs() < 1e-4 * deviation, "{distribution:?} {found:?}");
            assert!((found.1 - deviation).abs() < 5e-4 * deviation, "{distribution:?} {found:?}");
        }
    }

    /// Far out in a tail the quantiles stay between the ends and in order.
    #[test]
    fn a_far_tail_keeps_its_digits() {
        for sign in [1.0, -1.0] {
            let ends = if sign > 0.0 { (8.0, 9.0) } else { (-9.0, -8.0) };
            let tail = Distribution::Normal { mean: 0.0, standard_deviation: 1.0, min: ends.0, max: ends.1 };
            // P(Z > z | Z > 8): the median is at φ(z)/z = φ(8)/16 nearly, z = 8.083 to 1e-3.
            let median = sign * tail.quantile(0.5);
            assert!((median - 8.0847).abs() < 2e-3, "{median}");
            let quantiles: Vec<f64> = (1..100).map(|k| tail.quantile(f64::from(k) / 100.0)).collect();
            assert!(quantiles.is_sorted() && quantiles[0] < quantiles[98]);
        }
    }
}
