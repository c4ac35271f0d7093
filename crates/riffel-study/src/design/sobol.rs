//! Scrambled Sobol sequence.

use ::sobol::params::JoeKuoD6;
use rand_xoshiro::rand_core::Rng;

use super::random::generator;
use super::unit;

/// Bits of the number of a point.
const INDEX_BITS: usize = 32;

/// A Sobol sequence (direction numbers of Joe & Kuo 2008) under Matoušek's random linear scramble and a digital
/// shift (Matoušek 1998), as `scipy.stats.qmc.Sobol` has it.
///
/// Of 2^m points from the beginning each of the 2^m elementary intervals of any one parameter holds one, and of
/// the first few parameters together any elementary box as many as its volume says. That balance is lost where
/// the number of points is no power of two.
#[derive(Debug, Clone)]
pub struct Sobol {
    samples: u64,
    dimensions: Vec<Dimension>,
}

/// The scrambled directions of a parameter.
#[derive(Debug, Clone)]
struct Dimension {
    directions: [u64; INDEX_BITS],
    shift: u64,
}

impl Sobol {
    /// Most dimensions that the direction numbers reach.
    pub const MOST_DIMENSIONS: usize = 1000;
    /// Most points.
    pub const MOST_SAMPLES: u64 = 1 << INDEX_BITS;

    /// So many points, at most [`MOST_SAMPLES`](Self::MOST_SAMPLES), in so many dimensions, at most
    /// [`MOST_DIMENSIONS`](Self::MOST_DIMENSIONS).
    pub fn new(samples: u64, dimensions: usize, seed: u64) -> Self {
        let params = match dimensions {
            ..=100 => JoeKuoD6::minimal(),
            _ => JoeKuoD6::standard(),
        };
        let plain = ::sobol::Sobol::<f64>::init_direction_vals::<u32>(dimensions, INDEX_BITS, &params);
        let dimensions = plain.iter().enumerate().map(|(dimension, directions)| {
            let mut random = generator(seed, dimension as u64);
            // Column p of a lower triangular matrix over the digits, ones on its diagonal.
            let columns: [u64; INDEX_BITS] = std::array::from_fn(|p| (random.next_u64() | 1 << 63) >> p);
            Dimension {
                directions: std::array::from_fn(|bit| scrambled(directions[bit], &columns)),
                shift: random.next_u64(),
            }
        });
        Self { samples, dimensions: dimensions.collect() }
    }

    /// Number of points.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    /// The point of a number.
    pub fn point(&self, index: u64) -> Vec<f64> {
        self.dimensions
            .iter()
            .map(|dimension| {
                let digits = (0..INDEX_BITS)
                    .filter(|bit| index >> bit & 1 == 1)
                    .fold(dimension.shift, |digits, bit| digits ^ dimension.directions[bit]);
                unit(digits)
            })
            .collect()
    }
}

fn scrambled(digits: u64, columns: &[u64; INDEX_BITS]) -> u64 {
    (0..INDEX_BITS).filter(|p| digits >> (63 - p) & 1 == 1).fold(0, |sum, p| sum ^ columns[p])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// One point in each of 2^m intervals of each parameter.
        #[test]
        fn every_interval_holds_one_point(power in 0u32..9, dimensions in 1usize..20, seed: u64) {
            let samples = 1u64 << power;
            let design = Sobol::new(samples, dimensions, seed);
            for dimension in 0..dimensions {
                let mut intervals: Vec<u64> = (0..samples)
                    .map(|index| (design.point(index)[dimension] * samples as f64) as u64)
                    .collect();
                intervals.sort_unstable();
                prop_assert!(intervals.into_iter().eq(0..samples));
            }
        }

        /// The first two dimensions are a (0, m, 2)-net: one point in each elementary box of any shape.
        #[test]
        fn two_parameters_fill_every_box(power in 1u32..9, seed: u64) {
            let samples = 1u64 << power;
            let design = Sobol::new(samples, 2, seed);
            for first in 0..=power {
                let (columns, rows) = ((1u64 << first) as f64, (1u64 << (power - first)) as f64);
                let mut boxes: Vec<u64> = (0..samples)
                    .map(|index| {
                        let point = design.point(index);
                        (point[0] * columns) as u64 * rows as u64 + (point[1] * rows) as u64
                    })
                    .collect();
                boxes.sort_unstable();
                prop_assert!(boxes.into_iter().eq(0..samples));
            }
        }
    }

    /// A longer design begins with the shorter one.
    #[test]
    fn a_longer_design_begins_alike() {
        let (short, long) = (Sobol::new(64, 5, 3), Sobol::new(1024, 5, 3));
        assert!((0..64).all(|index| short.point(index) == long.point(index)));
    }

    /// The mean of a smooth function of six parameters: the error of 2^14 points is a hundredth of that of as
    /// many random ones, whose standard error is 1/√N times the standard deviation, here 0.72.
    #[test]
    fn means_converge_faster_than_at_random() {
        let samples = 1 << 14;
        let design = Sobol::new(samples, 6, 11);
        let product = |point: Vec<f64>| -> f64 { point.iter().map(|x| 0.5 + x).product() };
        let mean = (0..samples).map(|index| product(design.point(index))).sum::<f64>();
        let error = mean / samples as f64 - 1.0;
        assert!(error.abs() < 0.01 * 0.72 / (samples as f64).sqrt() * 3.0, "{error:e}");
    }

    #[test]
    fn the_highest_dimension_is_there() {
        let design = Sobol::new(2, Sobol::MOST_DIMENSIONS, 0);
        assert_eq!(design.point(1).len(), 1000);
    }
}
