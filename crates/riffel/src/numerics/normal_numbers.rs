//! Normal random numbers that a seed repeats on every machine.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::Rng;

/// Two independent normal numbers of variance one, after Box & Muller.
pub(crate) fn normal_pair(random: &mut Xoshiro256PlusPlus) -> Complex64 {
    let mut uniform = || ((random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64;
    Complex64::from_polar((-2.0 * uniform().ln()).sqrt(), TAU * uniform())
}
