//! Independent points: plain Monte Carlo.

use rand_xoshiro::rand_core::{Rng, SeedableRng};
use rand_xoshiro::{SplitMix64, Xoshiro256PlusPlus};

use super::unit;

/// Independent points, each from a generator of its own.
#[derive(Debug, Clone, Copy)]
pub struct Random {
    samples: u64,
    dimensions: usize,
    seed: u64,
}

impl Random {
    /// So many points in so many dimensions.
    pub fn new(samples: u64, dimensions: usize, seed: u64) -> Self {
        Self { samples, dimensions, seed }
    }

    /// Number of points.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// The point of a number.
    pub fn point(&self, index: u64) -> Vec<f64> {
        let mut random = generator(self.seed, index);
        (0..self.dimensions).map(|_| unit(random.next_u64())).collect()
    }
}

/// A generator that belongs to a seed and a number: xoshiro256++ (Blackman & Vigna 2021), its state filled by
/// SplitMix64 from both.
pub(super) fn generator(seed: u64, number: u64) -> Xoshiro256PlusPlus {
    let seed = SplitMix64::seed_from_u64(seed).next_u64();
    Xoshiro256PlusPlus::seed_from_u64(seed ^ SplitMix64::seed_from_u64(number).next_u64())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means and covariances of 20 000 points within five standard errors.
    #[test]
    fn points_are_even_and_independent() {
        let (samples, dimensions) = (20_000, 4);
        let design = Random::new(samples, dimensions, 7);
        let points: Vec<Vec<f64>> = (0..samples).map(|index| design.point(index)).collect();
        let count = samples as f64;
        for i in 0..dimensions {
            let mean = points.iter().map(|point| point[i]).sum::<f64>() / count;
            assert!((mean - 0.5).abs() < 5.0 / (12.0 * count).sqrt());
            for j in 0..i {
                let products = points.iter().map(|point| (point[i] - 0.5) * (point[j] - 0.5));
                let covariance = products.sum::<f64>() / count;
                assert!(covariance.abs() < 5.0 / (12.0 * count.sqrt()));
            }
        }
        assert_ne!(design.point(3), Random::new(samples, dimensions, 8).point(3));
        assert_eq!(design.point(3), points[3]);
    }
}
