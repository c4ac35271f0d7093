//! A few lines of the transform of parts of a record, each a sum over its samples.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::RangeInclusive;
use std::sync::{Arc, Mutex, PoisonError};

use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;

use super::hann_window::{BATCH, window};

/// Most lines for which sums take less time than a transform: those of a band in 48 waves are 12.
const MOST_LINES: usize = 32;
/// Rows of waves that are kept, of some 300 kB each.
const MOST_KEPT: usize = 128;
/// Lines that are summed at once, and parts: their sums and what they are made of fit into sixteen registers with room.
const AT_ONCE: usize = 4;
const PARTS: usize = 2;
/// Numbers of which a row has a multiple, as registers have at most as many lanes.
const LANES: usize = 8;

/// The rows that were needed, made once for all parts of one length.
#[derive(Default)]
pub(super) struct KeptLines(Mutex<BTreeMap<(usize, usize, usize), Arc<FewLines>>>);

impl KeptLines {
    /// The lines of parts of so many samples; `None` if they are so many that a transform takes less time, or have no
    /// counterpart at negative wavenumbers.
    pub(super) fn of(&self, samples: usize, lines: RangeInclusive<usize>) -> Option<Arc<FewLines>> {
        let (first, last) = (*lines.start(), *lines.end());
        if first == 0 || 2 * last >= samples || last >= first + MOST_LINES {
            return None;
        }
        let kept = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (samples, first, last);
        if let Some(known) = kept().get(&key) {
            return Some(Arc::clone(known));
        }
        let made = Arc::new(FewLines::new(samples, lines));
        let mut kept = kept();
        if kept.len() < MOST_KEPT {
            kept.insert(key, Arc::clone(&made));
        }
        Some(made)
    }
}

/// Waves over half a part: of sums and differences of two heights as far from either end, cosines see the sums and sines
/// the differences. The first height, which the window hides, has no counterpart and is left out.
pub(super) struct FewLines {
    samples: usize,
    /// Hann window up to the middle, zero behind it; half of it in the middle, which is its own counterpart.
    window: Vec<f64>,
    /// Of each line the cosine and the sine.
    waves: Vec<[Vec<f64>; 2]>,
    /// What each line has of twice a mean of one, and of a slope of one a sample.
    trends: Vec<[f64; 2]>,
    /// Of |DFT|² to the mean square of both signs of a wavenumber.
    scale: f64,
}

impl FewLines {
    fn new(samples: usize, lines: RangeInclusive<usize>) -> Self {
        let half = samples / 2;
        let row = half.next_multiple_of(LANES);
        let mut weights = window(samples);
        let energy: f64 = weights.iter().map(|weight| weight * weight).sum();
        weights.truncate(half + 1);
        if 2 * half == samples {
            weights[half] *= 0.5;
        }
        weights.remove(0);
        weights.resize(row, 0.0);
        let circle: Vec<(f64, f64)> =
            (0..samples).map(|index| (TAU * index as f64 / samples as f64).sin_cos()).collect();
        let wave = |line: usize, part: fn(&(f64, f64)) -> f64| {
            let mut values: Vec<f64> = (1..=half).map(|index| part(&circle[line * index % samples])).collect();
            values.resize(row, 0.0);
            values
        };
        let waves: Vec<[Vec<f64>; 2]> = lines.map(|line| [wave(line, |at| at.1), wave(line, |at| at.0)]).collect();
        let trend = |[cosine, sine]: &[Vec<f64>; 2]| {
            let of_mean = weights.iter().zip(cosine);
            let of_slope = weights.iter().zip(sine).enumerate();
            let place = |index: usize| 2.0 * (index + 1) as f64 - samples as f64;
            [
                of_mean.map(|(weight, wave)| weight * wave).sum(),
                of_slope.map(|(index, (weight, wave))| place(index) * weight * wave).sum(),
            ]
        };
        Self {
            samples,
            trends: waves.iter().map(trend).collect(),
            window: weights,
            waves,
            scale: 2.0 / (samples as f64 * energy),
        }
    }

    /// Mean square of each line, as [`line_powers`](super::hann_window::line_powers).
    pub(super) fn powers(&self, parts: &[(&[f64], f64)]) -> Vec<f64> {
        let arch = Arch::new();
        let batches: Vec<Vec<f64>> =
            parts.par_chunks(BATCH).map(|parts| arch.dispatch(Batch { lines: self, parts })).collect();
        let mut sums = vec![0.0; self.waves.len()];
        for batch in &batches {
            for (sum, part) in sums.iter_mut().zip(batch) {
                *sum += self.scale * part;
            }
        }
        sums
    }

    /// Sums and differences of heights as far from either end, through the window; twice the mean of the heights, and their slope.
    #[inline(always)]
    fn fold(&self, heights: &[f64], sums: &mut [f64], differences: &mut [f64]) -> [f64; 2] {
        let (count, half) = (self.samples as f64, self.samples / 2);
        let pairs = heights[1..=half].iter().zip(heights.iter().rev());
        let folded = sums.iter_mut().zip(differences.iter_mut());
        for ((sum, difference), (one, other)) in folded.zip(pairs) {
            (*sum, *difference) = (one + other, one - other);
        }
        let mut total = [0.0; LANES];
        let mut moment = [0.0; LANES];
        let mut place = std::array::from_fn::<f64, LANES, _>(|lane| 2.0 * (lane + 1) as f64 - count);
        let folded = sums.as_chunks_mut().0.iter_mut();
        let folded = folded.zip(differences.as_chunks_mut().0);
        for ((sums, differences), weights) in folded.zip(self.window.as_chunks().0) {
            let (sums, differences): (&mut [f64; LANES], &mut [f64; LANES]) = (sums, differences);
            let weights: &[f64; LANES] = weights;
            for lane in 0..LANES {
                total[lane] += sums[lane];
                moment[lane] += place[lane] * differences[lane];
                place[lane] += 2.0 * LANES as f64;
                sums[lane] *= weights[lane];
                differences[lane] *= weights[lane];
            }
        }
        let (total, moment) = (total.iter().sum::<f64>(), moment.iter().sum::<f64>());
        let middle = if 2 * half == self.samples { heights[half] } else { 0.0 };
        let mean = (heights[0] + total - middle) / count;
        // About the middle of the samples, half a step before that of the window.
        let moment = 0.5 * (moment - count * heights[0]) + 0.5 * count * mean;
        let slope = moment / (count * (count * count - 1.0) / 12.0);
        [2.0 * mean + slope, slope]
    }
}

/// Parts whose powers are added one after the other.
struct Batch<'a> {
    lines: &'a FewLines,
    parts: &'a [(&'a [f64], f64)],
}

impl WithSimd for Batch<'_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Vec<f64> {
        let Self { lines, parts } = self;
        let mut powers = vec![0.0; lines.waves.len()];
        let mut folded: [Folded; PARTS] = std::array::from_fn(|_| {
            let row = vec![0.0; lines.window.len()];
            [row.clone(), row]
        });
        let (pairs, rest) = parts.as_chunks();
        for parts in pairs {
            lines.add(simd, parts, &mut folded, &mut powers);
        }
        let [folded, ..] = &mut folded;
        for part in rest.as_chunks::<1>().0 {
            lines.add(simd, part, std::array::from_mut(folded), &mut powers);
        }
        powers
    }
}

/// Sums and differences of heights.
type Folded = [Vec<f64>; 2];

impl FewLines {
    /// Add the powers of P parts to those of all lines.
    #[inline(always)]
    fn add<S: Simd, const P: usize>(
        &self,
        simd: S,
        parts: &[(&[f64], f64); P],
        folded: &mut [Folded; P],
        powers: &mut [f64],
    ) {
        let mut trends = [[0.0; 2]; P];
        let all = parts.iter().zip(folded.iter_mut()).zip(&mut trends);
        for (((heights, _), [sums, differences]), trend) in all {
            *trend = self.fold(heights, sums, differences);
        }
        let shares = parts.each_ref().map(|(_, share)| *share);
        let seen = (folded.each_ref(), trends, shares);
        let (waves, rest) = self.waves.as_chunks::<AT_ONCE>();
        let (trends, rest_of_trends) = self.trends.as_chunks::<AT_ONCE>();
        let (some, last) = powers.as_chunks_mut::<AT_ONCE>();
        for ((powers, waves), trends) in some.iter_mut().zip(waves).zip(trends) {
            add_powers(simd, powers, seen, waves, trends);
        }
        let last = last.as_chunks_mut::<1>().0.iter_mut();
        let rest = rest.as_chunks::<1>().0.iter().zip(rest_of_trends.as_chunks::<1>().0);
        for (power, (wave, trend)) in last.zip(rest) {
            add_powers(simd, power, seen, wave, trend);
        }
    }
}

/// Parts with their trends and shares.
type Seen<'a, const P: usize> = ([&'a Folded; P], [[f64; 2]; P], [f64; P]);

/// Add the powers of N lines in P parts.
#[inline(always)]
fn add_powers<S: Simd, const N: usize, const P: usize>(
    simd: S,
    powers: &mut [f64; N],
    (folded, trends, shares): Seen<'_, P>,
    waves: &[[Vec<f64>; 2]; N],
    trends_of_lines: &[[f64; 2]; N],
) {
    let mut both = [[[0.0; N]; P]; 2];
    for (half, found) in both.iter_mut().enumerate() {
        let rows = std::array::from_fn(|part| &folded[part][half][..]);
        let waves = std::array::from_fn(|line| &waves[line][half][..]);
        *found = products(simd, rows, waves);
        for (found, trend) in found.iter_mut().zip(&trends) {
            for (found, of_line) in found.iter_mut().zip(trends_of_lines) {
                *found -= trend[half] * of_line[half];
            }
        }
    }
    let [re, im] = &both;
    for ((re, im), share) in re.iter().zip(im).zip(shares) {
        for ((power, re), im) in powers.iter_mut().zip(re).zip(im) {
            *power += share * (re.powi(2) + im.powi(2));
        }
    }
}

/// The products of each of P rows with each of N waves, which are read once for all of them. Closures would be compiled without the wide
/// instructions.
#[inline(always)]
fn products<S: Simd, const N: usize, const P: usize>(simd: S, rows: [&[f64]; P], waves: [&[f64]; N]) -> [[f64; N]; P] {
    let count = S::as_simd_f64s(waves[0]).0.len();
    let rows: [&[S::f64s]; P] = std::array::from_fn(|part| &S::as_simd_f64s(rows[part]).0[..count]);
    let waves: [&[S::f64s]; N] = std::array::from_fn(|line| &S::as_simd_f64s(waves[line]).0[..count]);
    let mut sums = [[simd.splat_f64s(0.0); N]; P];
    for index in 0..count {
        for (row, sums) in rows.iter().zip(&mut sums) {
            let height = row[index];
            for (wave, sum) in waves.iter().zip(sums) {
                *sum = simd.mul_add_e_f64s(wave[index], height, *sum);
            }
        }
    }
    let mut found = [[0.0; N]; P];
    for (sums, found) in sums.iter().zip(&mut found) {
        for (sum, found) in sums.iter().zip(found) {
            *found = simd.reduce_sum_f64s(*sum);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::hann_window::line_powers;
    use super::*;

    /// Both are sums of rounded products: relative to the strongest line they differ by some of the last digits.
    #[test]
    fn sums_and_transforms_are_one() {
        for samples in [97, 1200, 1201, 1999] {
            let height = |index: usize| {
                let x = index as f64;
                3.0 + 0.01 * x + (0.7 * x).sin() + ((x * x * 0.37) % 1.0)
            };
            let record: Vec<f64> = (0..samples + 40).map(height).collect();
            let parts: Vec<(&[f64], f64)> =
                (0..=40).map(|start| (&record[start..start + samples], 0.5 + start as f64)).collect();
            let expected = line_powers(&parts, samples);
            let strongest = expected.iter().copied().fold(0.0, f64::max);
            for lines in [1..=1, 2..=8, 5..=16, 20..=44] {
                let kept = KeptLines::default();
                let found = kept.of(samples, lines.clone()).map(|few| few.powers(&parts));
                for (line, found) in lines.zip(found.unwrap()) {
                    let error = (found - expected[line]).abs();
                    assert!(error < 1e-13 * strongest, "{samples} {line}: {error:e} {strongest:e}");
                }
            }
        }
    }

    #[test]
    fn transforms_are_left_what_takes_them_less_time() {
        let kept = KeptLines::default();
        for (lines, are_few) in [(0..=3, false), (1..=32, true), (1..=33, false), (480..=499, true), (480..=500, false)]
        {
            assert_eq!(kept.of(1000, lines.clone()).is_some(), are_few, "{lines:?}");
        }
    }
}
