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
