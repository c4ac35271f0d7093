//! A permutation by its number.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

/// Rounds of the network: four make a permutation that passes for random (Luby & Rackoff 1988); two more, since
/// halves of a few bits mix slowly.
const ROUNDS: u64 = 6;

/// The place of `index` in a permutation of the numbers below `count` that belongs to a key.
///
/// Method: a Feistel network on the smallest even number of bits that holds `count`, repeated until the number is
/// below `count` ("cycle walking", Black & Rogaway 2002): at most four times in the mean. No table is made.
pub(super) fn permuted(index: u64, count: u64, key: u64) -> u64 {
    let bits = 64 - count.saturating_sub(1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    let mask = (1u64 << half) - 1;
    let mut number = index;
    loop {
        let (mut left, mut right) = (number >> half, number & mask);
        for round in 0..ROUNDS {
            let state = key.wrapping_add(round << 32 | right);
            let mixed = SplitMix64::seed_from_u64(SplitMix64::seed_from_u64(state).next_u64());
            let mixed = { mixed }.next_u64();
            (left, right) = (right, left ^ (mixed & mask));
        }
        number = left << half | right;
        if number < count {
            return number;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_number_comes_once(count in 1u64..3000, key: u64) {
            let mut places: Vec<u64> = (0..count).map(|index| permuted(index, count, key)).collect();
            places.sort_unstable();
            prop_assert!(places.into_iter().eq(0..count));
        }
    }

    /// Each number goes to each place as often: 4000 permutations of five, within five standard errors.
    #[test]
    fn places_are_even() {
        let mut counts = [[0u32; 5]; 5];
        let keys = 4000u32;
        for key in 0..keys {
            for index in 0..5 {
                let place = permuted(index, 5, u64::from(key) << 20);
                counts[index as usize][place as usize] += 1;
            }
        }
        let expected = f64::from(keys) / 5.0;
        for count in counts.into_iter().flatten() {
            assert!((f64::from(count) - expected).abs() < 5.0 * (0.8 * expected).sqrt());
        }
    }
}
