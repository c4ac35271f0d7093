//! Latin hypercube.

use rand_xoshiro::rand_core::Rng;

use super::permutation::permuted;
use super::random::generator;
use super::unit;

/// A Latin hypercube (McKay, Beckman & Conover 1979): of as many equal strata of each parameter as there are
/// points each holds one, at a random place in it; the strata of the parameters are paired at random.
#[derive(Debug, Clone)]
pub struct LatinHypercube {
    samples: u64,
    seed: u64,
    /// Key of the permutation of each parameter.
    keys: Vec<u64>,
}

impl LatinHypercube {
    /// So many points in so many dimensions.
    pub fn new(samples: u64, dimensions: usize, seed: u64) -> Self {
        // The numbers of points are below this one.
        let mut random = generator(seed, u64::MAX);
        Self { samples, seed, keys: (0..dimensions).map(|_| random.next_u64()).collect() }
    }

    /// Number of points.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// The point of a number.
    pub fn point(&self, index: u64) -> Vec<f64> {
        let mut random = generator(self.seed, index);
        self.keys
            .iter()
            .map(|&key| {
                let stratum = permuted(index, self.samples, key);
                (stratum as f64 + unit(random.next_u64())) / self.samples as f64
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_stratum_holds_one_point(samples in 1u64..500, dimensions in 1usize..6, seed: u64) {
            let design = LatinHypercube::new(samples, dimensions, seed);
            let points: Vec<Vec<f64>> = (0..samples).map(|index| design.point(index)).collect();
            for dimension in 0..dimensions {
                let place = |point: &Vec<f64>| (point[dimension] * samples as f64) as u64;
                let mut strata: Vec<u64> = points.iter().map(place).collect();
                strata.sort_unstable();
                prop_assert!(strata.into_iter().eq(0..samples));
            }
        }
    }

    /// The strata of two parameters are paired at random: no correlation beyond five standard errors.
    #[test]
    fn parameters_are_not_correlated() {
        let samples = 10_000;
        let design = LatinHypercube::new(samples, 3, 1);
        let products = (0..samples).map(|index| {
            let point = design.point(index);
            (point[0] - 0.5) * (point[1] - 0.5) * 12.0
        });
        let correlation = products.sum::<f64>() / samples as f64;
        assert!(correlation.abs() < 5.0 / (samples as f64).sqrt());
    }
}
