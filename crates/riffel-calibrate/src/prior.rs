//! Priors, on the whole line.

use std::f64::consts::PI;

use riffel_numerics::distribution::Distribution;

/// What was known of a value before anything was measured. The sampler moves on the whole line:
///
/// | prior of x | z |
/// |---|---|
/// | lognormal, half-normal | ln x |
/// | normal | (x − mean)/standard deviation |
/// | uniform, triangular from a to b | ln((x − a)/(b − x)) |
///
/// and [`log_density`](Self::log_density) is that of z, with the Jacobian dx/dz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Prior {
    /// A distribution of a plan, in SI.
    Of(Distribution),
    /// |N(0, S²)|, of a size.
    HalfNormal(
        /// S.
        f64,
    ),
}

impl Prior {
    /// The prior, cut off at the ends of a range that can be computed. `None` if nothing is left.
    pub fn within(distribution: Distribution, [low, high]: [f64; 2]) -> Option<Self> {
        let mut cut = distribution;
        let (Distribution::Uniform { min, max }
        | Distribution::Normal { min, max, .. }
        | Distribution::Lognormal { min, max, .. }
        | Distribution::Triangular { min, max, .. }) = &mut cut;
        if let Distribution::Triangular { .. } = distribution {
            return (low <= *min && *max <= high).then_some(Self::Of(distribution));
        }
        (*min, *max) = (min.max(low), max.min(high));
        (*min < *max).then_some(Self::Of(cut))
    }

    /// Lowest and highest value.
    pub fn ends(&self) -> [f64; 2] {
        match *self {
            Self::HalfNormal(_) => [0.0, f64::INFINITY],
            Self::Of(distribution) => distribution.ends(),
        }
    }

    /// x of z.
    pub fn value(&self, z: f64) -> f64 {
        match *self {
            Self::HalfNormal(_) | Self::Of(Distribution::Lognormal { .. }) => z.exp(),
            Self::Of(Distribution::Normal { mean, standard_deviation, .. }) => mean + standard_deviation * z,
            Self::Of(Distribution::Uniform { min, max } | Distribution::Triangular { min, max, .. }) => {
                min + (max - min) / (1.0 + (-z).exp())
            }
        }
    }

    /// A coordinate in which a model is smooth, and its derivative by z: x itself where it lies between two ends, since z goes far
    /// where x hardly moves; z elsewhere.
    pub(crate) fn smooth(&self, z: f64) -> (f64, f64) {
        match *self {
            Self::Of(Distribution::Uniform { min, max } | Distribution::Triangular { min, max, .. }) => {
                let x = self.value(z);
                (x, (x - min) * (max - x) / (max - min))
            }
            _ => (z, 1.0),
        }
    }

    /// z of x.
    pub fn place(&self, x: f64) -> f64 {
        match *self {
            Self::HalfNormal(_) | Self::Of(Distribution::Lognormal { .. }) => x.ln(),
            Self::Of(Distribution::Normal { mean, standard_deviation, .. }) => (x - mean) / standard_deviation,
            Self::Of(Distribution::Uniform { min, max } | Distribution::Triangular { min, max, .. }) => {
                ((x - min) / (max - x)).ln()
            }
        }
    }

    /// ln of the density of z and its derivative; −∞ beyond the ends. What a cut leaves out is not made up for: that is the
    /// same everywhere.
    pub fn log_density(&self, z: f64) -> (f64, f64) {
        let half_of_two_pi = 0.5 * (2.0 * PI).ln();
        let x = self.value(z);
        let [low, high] = self.ends();
        if !(low..=high).contains(&x) {
            return (f64::NEG_INFINITY, 0.0);
        }
        // ln(dx/dz) of the logistic function without the width, and its derivative.
        let logistic = || {
            let value = -z.abs() - 2.0 * (-z.abs()).exp().ln_1p();
            (value, -(0.5 * z).tanh())
        };
        match *self {
            Self::HalfNormal(scale) => {
                let t = x / scale;
                let norm = 2f64.ln() - scale.ln() - half_of_two_pi;
                (norm - 0.5 * t * t + z, 1.0 - t * t)
            }
            Self::Of(Distribution::Lognormal { log_mean, log_deviation, .. }) => {
                let t = (z - log_mean) / log_deviation;
                let norm = -log_deviation.ln() - half_of_two_pi;
                (norm - 0.5 * t * t, -t / log_deviation)
            }
            Self::Of(Distribution::Normal { .. }) => (-half_of_two_pi - 0.5 * z * z, -z),
            Self::Of(Distribution::Uniform { .. }) => logistic(),
            Self::Of(Distribution::Triangular { min, mode, max }) => {
                let (value, slope) = logistic();
                let side = match x < mode {
                    true => (x - min) / (mode - min),
                    false => (max - x) / (max - mode),
                };
                // dx/dz over the distance to the end: the other share of the width.
                let share = (x - min) / (max - min);
                let by_side = match x < mode {
                    true => 1.0 - share,
                    false => -share,
                };
                (value + (2.0 * side).ln(), slope + by_side)
            }
        }
    }

    /// The x below which a share u lies, 0 < u < 1.
    pub fn quantile(&self, u: f64) -> f64 {
        match self {
            Self::HalfNormal(scale) => {
                Distribution::Normal { mean: 0.0, standard_deviation: *scale, min: 0.0, max: f64::INFINITY }.quantile(u)
            }
            Self::Of(distribution) => distribution.quantile(u),
        }
    }

    /// Variance of z, by its quantiles to some 0.1 %.
    pub fn variance(&self) -> f64 {
        const PARTS: u32 = 20_000;
        let parts = (0..PARTS).map(|k| (f64::from(k) + 0.5) / f64::from(PARTS));
        let places = parts.map(|u| self.place(self.quantile(u)));
        let (sum, squares) = places.fold((0.0, 0.0), |(sum, squares), z| (sum + z, squares + z * z));
        let mean = sum / f64::from(PARTS);
        squares / f64::from(PARTS) - mean * mean
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn priors() -> [Prior; 5] {
        [
            Prior::HalfNormal(0.15),
            Prior::Of(Distribution::Lognormal { log_mean: 3.0, log_deviation: 0.4, min: 0.0, max: f64::INFINITY }),
            Prior::Of(Distribution::normal(30.0, 2.0)),
            Prior::Of(Distribution::Uniform { min: 0.05, max: 0.95 }),
            Prior::Of(Distribution::Triangular { min: 1.0, mode: 2.0, max: 5.0 }),
        ]
    }

    /// The density of z integrates to one by the trapezoidal rule over ±40, and its derivative is that of differences.
    #[test]
    fn densities_have_their_jacobian() {
        for prior in priors() {
            let step = 1e-3;
            let nodes = (-40_000..=40_000).map(|k| f64::from(k) * step);
            let sum: f64 = nodes.map(|z| prior.log_density(z).0.exp()).sum();
            assert!((sum * step - 1.0).abs() < 1e-6, "{prior:?}: {}", sum * step);
            for u in [0.1, 0.3, 0.8] {
                let z = prior.place(prior.quantile(u));
                let (h, slope) = (1e-5, prior.log_density(z).1);
                let difference = prior.log_density(z + h).0 - prior.log_density(z - h).0;
                assert!((difference / (2.0 * h) - slope).abs() < 1e-6, "{prior:?}");
            }
        }
    }

    /// Variances in closed form: π²/8 of ln|N|, π²/3 of the logistic distribution.
    #[test]
    fn variances_are_those_of_the_books() {
        let [half, log, normal, uniform, _] = priors();
        for (prior, variance) in [(half, PI * PI / 8.0), (log, 0.16), (normal, 1.0), (uniform, PI * PI / 3.0)] {
            assert!((prior.variance() / variance - 1.0).abs() < 2e-3, "{prior:?}");
        }
    }
}
