//! Distributions of a number.

use super::gauss::gauss_legendre;
use super::normal_distribution;

/// Standard deviations from its middle at which an infinite tail is taken to end.
pub const TAIL: f64 = 4.0;

/// Half of the nodes of a rule, each with its weight; that of the middle first. All weights sum to one.
type Half = &'static [(f64, f64)];

/// Gauss–Hermite nodes of the standard normal distribution: exact for polynomials to the degree 5, 9 and 13.
/// Abramowitz & Stegun (1964), table 25.10, nodes times √2.
const NORMAL: [Half; Distribution::RULES] = [
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
        /// Standard deviation before it is cut.
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
    /// Rules of [`nodes`](Self::nodes), the coarsest first.
    pub const RULES: usize = 3;

    /// Infinite normal distribution.
    pub fn normal(mean: f64, standard_deviation: f64) -> Self {
        Self::Normal { mean, standard_deviation, min: f64::NEG_INFINITY, max: f64::INFINITY }
    }

    /// Infinite lognormal distribution of a median and the standard deviation of the logarithm.
    pub fn lognormal(median: f64, log_deviation: f64) -> Self {
        Self::Lognormal { log_mean: median.ln(), log_deviation, min: 0.0, max: f64::INFINITY }
    }

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

    /// Lowest and highest value.
    pub fn ends(&self) -> [f64; 2] {
        match *self {
            Self::Uniform { min, max }
            | Self::Normal { min, max, .. }
            | Self::Lognormal { min, max, .. }
            | Self::Triangular { min, max, .. } => [min, max],
        }
    }

    /// Lowest and highest value that are looked at: a tail ends four standard deviations from the middle, 3e-5 of the whole.
    pub fn reach(&self) -> [f64; 2] {
        let [min, max] = self.ends();
        match self.law() {
            Some(law) => [law.value(-TAIL).max(min), law.value(TAIL).min(max)],
            None => [min, max],
        }
    }

    /// Mean before it is cut.
    pub fn mean(&self) -> f64 {
        match *self {
            Self::Uniform { min, max } => 0.5 * (min + max),
            Self::Normal { mean, .. } => mean,
            Self::Lognormal { log_mean, log_deviation, .. } => (log_mean + 0.5 * log_deviation * log_deviation).exp(),
            Self::Triangular { min, mode, max } => (min + mode + max) / 3.0,
        }
    }

    /// The value below which a share `u` of all values lies, 0 < u < 1.
    ///
    /// Method: inverse of the cumulative distribution in closed form, with the inverse error function of
    /// `statrs`; for a distribution that is cut off, of the share between its ends.
    pub fn quantile(&self, u: f64) -> f64 {
        let [min, max] = self.ends();
        let width = max - min;
        let value = match (*self, self.law()) {
            (_, Some(law)) => law.value(cut_normal(u, [law.score(min), law.score(max)])),
            (Self::Triangular { mode, .. }, _) if u * width < mode - min => min + (u * width * (mode - min)).sqrt(),
            (Self::Triangular { mode, .. }, _) => max - ((1.0 - u) * width * (max - mode)).sqrt(),
            _ => min + u * width,
        };
        value.clamp(min, max)
    }

    /// Values with weights that sum to one, of which the weighted sum of a smooth function is its mean: 3, 5 or 7 nodes of Gauss by
    /// the number of the rule from 0, all within four standard deviations. Rules of Hermite for what has no ends, of Legendre over
    /// the quantiles for the others.
    pub fn nodes(&self, rule: usize) -> Vec<(f64, f64)> {
        let is_cut = |law: &Law| self.ends().map(|end| law.score(end)) != [f64::NEG_INFINITY, f64::INFINITY];
        if let Some(law) = self.law().filter(|law| !is_cut(law)) {
            let half = NORMAL[rule];
            let below = half.iter().skip(1).rev().map(|(at, weight)| (-at, *weight));
            return below.chain(half.iter().copied()).map(|(at, weight)| (law.value(at), weight)).collect();
        }
        let nodes = match rule {
            0 => gauss_legendre::<3>().to_vec(),
            1 => gauss_legendre::<5>().to_vec(),
            _ => gauss_legendre::<7>().to_vec(),
        };
        nodes.into_iter().map(|(share, weight)| (self.quantile(share), weight)).collect()
    }

    /// The share of all values from one to another.
    pub fn share_within(&self, low: f64, high: f64) -> f64 {
        let [min, max] = self.ends();
        let ends = [low, high].map(|end| end.clamp(min, max));
        let [from, to] = match (*self, self.law()) {
            (_, Some(law)) => {
                let share = |ends: [f64; 2]| between(ends.map(|end| law.score(end)));
                return share(ends) / share([min, max]);
            }
            (Self::Triangular { mode, .. }, _) => ends.map(|end| match end < mode {
                true => (end - min).powi(2) / (max - min) / (mode - min),
                false => 1.0 - (max - end).powi(2) / (max - min) / (max - mode),
            }),
            _ => ends.map(|end| (end - min) / (max - min)),
        };
        to - from
    }

    /// The normal distribution behind it.
    fn law(&self) -> Option<Law> {
        match *self {
            Self::Normal { mean, standard_deviation, .. } => {
                Some(Law { middle: mean, deviation: standard_deviation, is_of_logarithm: false })
            }
            Self::Lognormal { log_mean, log_deviation, .. } => {
                Some(Law { middle: log_mean, deviation: log_deviation, is_of_logarithm: true })
            }
            Self::Uniform { .. } | Self::Triangular { .. } => None,
        }
    }
}

/// Normal distribution of a number, or of its logarithm.
#[derive(Clone, Copy)]
struct Law {
    middle: f64,
    deviation: f64,
    is_of_logarithm: bool,
}

impl Law {
    /// Standard deviations of a value from the middle.
    fn score(&self, value: f64) -> f64 {
        let value = if self.is_of_logarithm { value.ln() } else { value };
        (value - self.middle) / self.deviation
    }

    fn value(&self, score: f64) -> f64 {
        let value = self.middle + self.deviation * score;
        if self.is_of_logarithm { value.exp() } else { value }
    }
}

/// Share of the standard normal distribution between two ends.
fn between([low, high]: [f64; 2]) -> f64 {
    if low > 0.0 {
        // In the upper tail probabilities are all but one: look from the other side.
        return between([-high, -low]);
    }
    normal_distribution::below(high) - normal_distribution::below(low)
}

/// Quantile of the standard normal distribution between two ends.
fn cut_normal(u: f64, [low, high]: [f64; 2]) -> f64 {
    if low > 0.0 {
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
    /// tails. The share below a quantile is its own.
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
            assert!((distribution.mean() - mean).abs() < 1e-14 * mean, "{distribution:?}");
            for u in [0.1, 0.4, 0.9] {
                let share = distribution.share_within(f64::NEG_INFINITY, distribution.quantile(u));
                assert!((share - u).abs() < 1e-12, "{distribution:?} {u} {share}");
            }
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

    /// Moments: of the standard normal distribution 1, 3, 15, 105, 945, 10395, of the even one 1/(n + 1).
    #[test]
    fn nodes_have_the_moments_of_their_distribution() {
        let normal = Distribution::normal(0.0, 1.0);
        let even = Distribution::Uniform { min: -1.0, max: 1.0 };
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
        let normal = Distribution::normal(0.0, 2.0);
        assert!((normal.share_within(-2.0, 2.0) - 0.682_689_492_137_086).abs() < 1e-14);
        let even = Distribution::Uniform { min: 0.0, max: 4.0 };
        assert_eq!(even.share_within(-1.0, 1.0), 0.25);
        assert_eq!(even.share_within(5.0, 6.0), 0.0);
    }
}
