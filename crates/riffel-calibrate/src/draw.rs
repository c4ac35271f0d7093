//! One draw of a sampler.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;

use crate::nuts::Statistics;

/// A draw: its place in z and what the sampler says of it.
#[derive(Debug, Clone)]
pub(crate) struct Draw {
    pub(crate) place: Vec<f64>,
    pub(crate) log_density: f64,
    pub(crate) statistics: Statistics,
    pub(crate) step: f64,
}

/// Random numbers of a draw of a chain.
pub(crate) fn random(seed: u64, chain: u64, draw: u64) -> Xoshiro256PlusPlus {
    // Seeds are spread by the generator itself; chains and draws are kept apart by odd factors.
    let mixed = seed
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(chain.wrapping_mul(0xd1b5_4a32_d192_ed03))
        .wrapping_add(draw.wrapping_mul(0x8cb9_2ba7_2f3d_8dd7));
    Xoshiro256PlusPlus::seed_from_u64(mixed)
}
