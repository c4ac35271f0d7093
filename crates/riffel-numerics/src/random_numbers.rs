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
