//! Values of choices, drawn evenly.

/// The draw of one value of one sample, from 0 to 1 exclusive, of a low-discrepancy sequence in as many dimensions as there are
/// choices: the same sample has the same values however many are drawn.
///
/// Source: M. Roberts, *The unreasonable effectiveness of quasirandom sequences* (2018): α_j = φ^(−j−1), where φ is the positive
/// root of x^(d+1) = x + 1; the start is shifted by the seed.
pub(super) fn draw(seed: u64, sample: usize, choice: usize, choices: usize) -> f64 {
    let mut root = 2.0_f64;
    for _ in 0..60 {
        root = (1.0 + root).powf(1.0 / (choices as f64 + 1.0));
    }
    let step = root.powi(-(choice as i32) - 1);
    let value = (shift(seed, choice) + (sample as f64 + 1.0) * step).fract();
    // Neither end has a quantile of a normal distribution.
    value.clamp(1e-9, 1.0 - 1e-9)
}

/// A number from 0 to 1 of a seed and a choice: splitmix64 (Steele, Lea & Flood 2014).
fn shift(seed: u64, choice: usize) -> f64 {
    let mut z = seed.wrapping_add(choice as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (z ^ (z >> 31)) as f64 / 2f64.powi(64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 1000 draws in seven dimensions every tenth of each holds a tenth, to some.
    #[test]
    fn draws_fill_their_range() {
        for choice in 0..7 {
            let mut counts = [0; 10];
            for sample in 0..1000 {
                counts[(10.0 * draw(1, sample, choice, 7)) as usize] += 1;
            }
            assert!(counts.iter().all(|count| (90..=110).contains(count)), "{choice} {counts:?}");
        }
        assert_ne!(draw(1, 0, 0, 7), draw(2, 0, 0, 7));
    }
}
