//! Laws of straight pieces, over a wave and over the loads of traffic.

use riffel_numerics::normal_distribution::below;

use super::ClippedPower;

/// Σ c ⟨x − t⟩: a law that changes its slope by c at each t.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramps([(f64, f64); 3]);

impl Ramps {
    /// The law of the corners t and the changes c of slope there; t rises.
    pub const fn new(corners: [(f64, f64); 3]) -> Self {
        Self(corners)
    }

    /// The first corner.
    pub(super) fn begin(&self) -> f64 {
        self.0[0].0
    }

    /// At x.
    pub fn value(&self, x: f64) -> f64 {
        self.sum(|corner| (x - corner).max(0.0))
    }

    /// Its slope at x, at a corner that of the piece above.
    pub fn slope(&self, x: f64) -> f64 {
        self.sum(|corner| f64::from(x >= corner))
    }

    /// Mean over x + U cos θ.
    pub fn mean(&self, x: f64, amplitude: f64) -> f64 {
        self.sum(|corner| ClippedPower::new(1.0, 0.0).mean(x - corner, amplitude))
    }

    /// First harmonic over x + U cos θ.
    pub fn first(&self, x: f64, amplitude: f64) -> f64 {
        self.sum(|corner| ClippedPower::new(1.0, 0.0).first(x - corner, amplitude))
    }

    /// What a wave is multiplied by: the slope where no corner lies within it, else the first harmonic over U.
    pub fn rate(&self, x: f64, amplitude: f64) -> f64 {
        match self.0.iter().all(|(corner, _)| (x - corner).abs() >= amplitude) {
            true => self.slope(x),
            false => self.first(x, amplitude) / amplitude,
        }
    }

    /// E f and E x f′ over x = median · e^{σz}, z normal.
    pub fn over_log_normal(&self, median: f64, sigma: f64) -> [f64; 2] {
        if sigma == 0.0 {
            return [self.value(median), median * self.slope(median)];
        }
        let mean = median * (0.5 * sigma * sigma).exp();
        let (mut value, mut rise) = (0.0, 0.0);
        for (corner, change) in self.0 {
            let (moment, share) = match corner > 0.0 {
                true => {
                    let deviations = (median / corner).ln() / sigma;
                    (mean * below(deviations + sigma), below(deviations))
                }
                false => (mean, 1.0),
            };
            value += change * (moment - corner * share);
            rise += change * moment;
        }
        [value, rise]
    }

    fn sum(&self, of: impl Fn(f64) -> f64) -> f64 {
        self.0.iter().map(|&(corner, change)| change * of(corner)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spread of nothing is the law itself, and E x f′ is the derivative of E f over ln of the median.
    #[test]
    fn mean_over_traffic() {
        let law = Ramps::new([(0.0, 5.3), (10.4, -5.3), (77.2, 61.9)]);
        let [value, rise] = law.over_log_normal(30.0, 1e-6);
        assert!((value - 55.12).abs() < 1e-9 && rise.abs() < 1e-9);
        let step: f64 = 1e-5;
        let [up, down] = [step, -step].map(|step| law.over_log_normal(30.0 * step.exp(), 0.5)[0]);
        let [_, rise] = law.over_log_normal(30.0, 0.5);
        assert!(((up - down) / (2.0 * step) / rise - 1.0).abs() < 1e-8);
    }
}
