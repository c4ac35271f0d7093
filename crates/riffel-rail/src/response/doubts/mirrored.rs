//! The upper half of a two-sided spectrum.

use super::Line;

/// Fewest lines above the middle, and the most that are compared.
const LEAST_PAIRS: usize = 8;
const MOST_PAIRS: usize = 256;
/// Mean difference of mirrored values over their modulus up to which they are one: twice what noise of 5 % on each makes.
const SAME: f64 = 0.2;
/// Share by which sums of mirrored frequencies may differ: they are printed with few digits.
const EVEN: f64 = 1e-3;
/// Share of lines by which one side of the middle gives more energy away than the other at least.
const OTHER_SIGN: f64 = 0.5;

/// The frequency \[Hz\] beyond which a response runs backwards through the conjugates of its own values.
///
/// The Fourier transform of real signals at the frequency f_s − f is the conjugate of that at f; a file with both has the sampling rate
/// for its end. Method: every line and every middle between two as the turning point. Accuracy, of 200 made-up responses each with
/// noise of 1 to 5 % on every line (test `mirrored_halves_are_found`): all with 10 to 100 % of the mirrored lines are found, their middle within
/// 1 %, and none that has none is taken for one. Cost: some milliseconds.
pub(super) fn mirrored_from(lines: &[Line]) -> Option<f64> {
    let last = lines.len().checked_sub(1)?;
    // Twice the place of the middle.
    let pairs = |middle: usize| {
        let (below, above) = (middle.div_ceil(2) - 1, middle / 2 + 1);
        let count = (below + 1).min(last + 1 - above);
        let pair = move |j: usize| (&lines[below - j], &lines[above + j]);
        (count, pair)
    };
    let difference = |middle: usize| {
        let (count, pair) = pairs(middle);
        if count < LEAST_PAIRS {
            return None;
        }
        let (one, other) = pair(0);
        let sum = one.0 + other.0;
        let (mut difference, mut active, mut compared) = (0.0, [0.0; 2], 0.0);
        for j in (0..count).step_by(count.div_ceil(MOST_PAIRS)) {
            let (one, other) = pair(j);
            difference += (other.1 - one.1.conj()).norm() / one.1.norm().max(other.1.norm());
            compared += 1.0;
            let is_one = difference < 2.0 * SAME * compared || compared < LEAST_PAIRS as f64;
            if !is_one || ((one.0 + other.0) / sum - 1.0).abs() > EVEN {
                return None;
            }
            for (count, line) in active.iter_mut().zip([one, other]) {
                *count += f64::from(u8::from(line.1.im > 0.0));
            }
        }
        let opposite = (active[0] - active[1]).abs() > OTHER_SIGN * compared;
        (opposite && difference < SAME * compared).then_some(difference / compared)
    };
    let middles = (last / 2 + 1..2 * last).filter_map(|middle| Some((middle, difference(middle)?)));
    let (middle, _) = middles.min_by(|one, other| one.1.total_cmp(&other.1))?;
    Some(0.5 * (lines[middle / 2].0 + lines[middle.div_ceil(2)].0))
}
