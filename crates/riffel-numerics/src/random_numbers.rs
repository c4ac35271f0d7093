//! Random numbers that a seed repeats on every machine.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::Rng;

/// Number of 0 ≤ u < 1 from the upper 53 of 64 random bits.
pub fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

/// Uniform number of 0 < u < 1, in the middle of one of 2⁵³ equal steps.
pub fn uniform(random: &mut Xoshiro256PlusPlus) -> f64 {
    ((random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64
}

/// Normal number of mean zero and variance one, the first of a [`normal_pair`].
pub fn normal(random: &mut Xoshiro256PlusPlus) -> f64 {
    normal_pair(random).re
}

/// Two independent normal numbers of mean zero and variance one. Source: Box & Muller (1958), Ann. Math. Statist. 29; two
/// [`uniform`] numbers for both.
pub fn normal_pair(random: &mut Xoshiro256PlusPlus) -> Complex64 {
    Complex64::from_polar((-2.0 * uniform(random).ln()).sqrt(), TAU * uniform(random))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_xoshiro::rand_core::SeedableRng;

    #[test]
    fn units_fill_their_range() {
        assert_eq!([0, 1 << 63, u64::MAX].map(unit), [0.0, 0.5, 1.0 - 0.5 * f64::EPSILON]);
    }

    /// Moments of 10⁵ draws: four standard errors, √(variance of the power/n).
    #[test]
    fn moments_are_those_of_the_distributions() {
        const DRAWS: u32 = 100_000;
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
        let mut mean = |draw: &dyn Fn(&mut Xoshiro256PlusPlus) -> f64| {
            (0..DRAWS).map(|_| draw(&mut random)).sum::<f64>() / f64::from(DRAWS)
        };
        let error = 4.0 / f64::from(DRAWS).sqrt();
        assert!((mean(&|random| uniform(random)) - 0.5).abs() < error * (1.0f64 / 12.0).sqrt());
        assert!(mean(&|random| normal(random)).abs() < error);
        assert!((mean(&|random| normal(random).powi(2)) - 1.0).abs() < error * 2f64.sqrt());
        assert!((mean(&|random| normal(random).powi(4)) - 3.0).abs() < error * 96f64.sqrt());
        let product = |random: &mut Xoshiro256PlusPlus| {
            let pair = normal_pair(random);
            pair.re * pair.im
        };
        assert!(mean(&product).abs() < error);
    }
}
