//! Growth of the waves of one rail, from profiles of the same place at two dates.

use num_complex::Complex64;
use riffel_numerics::fourier::Plans;

use super::Profile;
use super::hann_window::{remove_trend, window};
use crate::Error;

/// Length of a segment in longest waves.
const WAVES: f64 = 8.0;
/// Fewest segments, half overlapped, of which a coherence can be told.
const FEWEST: usize = 8;
/// Lines of a Hann window apart whose errors are as good as independent: neighbours correlate by 2/3, the next by 1/6.
const APART: usize = 3;
/// Largest error in the positions of two records \[m\].
const LARGEST_SHIFT: f64 = 1.0;
/// Largest variance of a logarithm that its first order still describes \[Np²\].
const LARGEST_VARIANCE: f64 = 0.05;
/// Correlation of half overlapped segments behind Hann's window (Welch 1967).
const OVERLAP: f64 = 1.0 / 36.0;

/// What became of a wave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveGrowth {
    /// Wavelength \[m\].
    pub wavelength: f64,
    /// ln of its complex amplitude over that of before, for a wave exp(2πi x/λ) along rising positions: Np and rad.
    pub logarithm: Complex64,
    /// Variance of the real part, and of the imaginary one.
    pub variance: f64,
}

/// What became of the waves of a rail between two dates.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveGrowths {
    /// Waves whose growth can be told, the longest first.
    pub waves: Vec<WaveGrowth>,
    /// How many waves between them have too little in common.
    pub lost: usize,
    /// By how much positions of the later record lie beyond those of the earlier \[m\], to half a sample.
    pub shift: f64,
    /// Share of a line that lies beside it by so many lines: what a segment sees of waves between lines.
    pub seen: [(f64, f64); 7],
    /// Length of a segment \[m\]; lines are 1/length apart.
    pub segment: f64,
}

impl WaveGrowths {
    /// Growth of the waves of some lengths \[m\] from an earlier profile to a later one.
    ///
    /// Segments of eight longest waves behind Hann's window, half overlapped, give cross-spectra; every third line
    /// is ln(S₁₂/S₁₁), each part with the variance (1 − γ²)/2nγ² of a transfer function (Bendat & Piersol, *Random Data*, 2010,
    /// section 9.2), n segments after their overlap. Positions are taken to be off by one shift of at most 1 m, which the largest
    /// correlation tells to half a sample; what is left of it turns phases by 2π/λ of it. Lines with a variance above 0.05 are lost:
    /// there the logarithm is beyond its first order.
    ///
    /// # Errors
    /// [`Error::Measurement`] where spacings differ, the common part has less than eight segments, or nothing is in common.
    pub fn between(before: &Profile, after: &Profile, lengths: [f64; 2]) -> Result<Self, Error> {
        let [shortest, longest] = lengths;
        let wrong = |rule| Err(Error::Measurement { index: 0, rule });
        let spacing = before.spacing();
        if (after.spacing() / spacing - 1.0).abs() > 1e-6 {
            return wrong("both profiles must have one spacing");
        }
        let samples = 2 * (0.5 * WAVES * longest / spacing).round() as usize;
        let offset = ((after.start() - before.start()) / spacing).round() as isize;
        let (one, other) = common(before.heights(), after.heights(), offset);
        let enough = |count: usize| 2 * count >= (FEWEST + 1) * samples;
        if !enough(one.len()) {
            return wrong("both profiles must have a stretch of 36 longest waves in common");
        }
        let lag = best_lag(one, other, spacing, lengths);
        let (one, other) = common(one, other, -lag);
        if !enough(one.len()) {
            return wrong("both profiles must have a stretch of 36 longest waves in common");
        }
        let sums = spectra(one, other, samples);
        let count = 2 * one.len() / samples - 1;
        let inner = 2.0 * OVERLAP * (count - 1) as f64 / count as f64;
        let averages = count as f64 / (1.0 + inner);
        let segment = samples as f64 * spacing;
        let first = (segment / longest).ceil() as usize;
        let last = ((segment / shortest).floor() as usize).min(samples / 2 - 1);
        let (mut waves, mut lost) = (Vec::new(), 0);
        for line in (first..=last).step_by(APART) {
            let [own, later] = [sums.one[line], sums.other[line]];
            let cross = sums.cross[line];
            let coherence = cross.norm_sqr() / (own * later);
            let variance = (1.0 - coherence) / (2.0 * averages * coherence);
            if variance.is_nan() || variance > LARGEST_VARIANCE {
                lost += 1;
                continue;
            }
            waves.push(WaveGrowth { wavelength: segment / line as f64, logarithm: (cross / own).ln(), variance });
        }
        if waves.is_empty() {
            return wrong("both profiles must show the same rail, but have no wave in common");
        }
        Ok(Self { waves, lost, shift: lag as f64 * spacing, seen: seen(), segment })
    }
}

/// |W|² of Hann's window at half lines beside a line, as shares.
fn seen() -> [(f64, f64); 7] {
    let power = |beside: f64| {
        let window: f64 = match beside.abs() {
            0.0 => 1.0,
            1.0 => 0.5,
            away => {
                let phase = std::f64::consts::PI * away;
                phase.sin() / phase / (1.0 - away * away)
            }
        };
        window * window
    };
    let beside: [f64; 7] = std::array::from_fn(|k| 0.5 * (k as f64 - 3.0));
    let sum: f64 = beside.iter().map(|beside| power(*beside)).sum();
    beside.map(|beside| (beside, power(beside) / sum))
}

/// The parts of two records that lie beside each other where the second begins `offset` samples after the first.
fn common<'a>(one: &'a [f64], other: &'a [f64], offset: isize) -> (&'a [f64], &'a [f64]) {
    let skipped = |by: isize| usize::try_from(by).unwrap_or(0);
    let one = one.get(skipped(offset)..).unwrap_or_default();
    let other = other.get(skipped(-offset)..).unwrap_or_default();
    let count = one.len().min(other.len());
    (&one[..count], &other[..count])
}

/// By how many samples the second record lags behind the first: the largest correlation of waves of some lengths.
fn best_lag(one: &[f64], other: &[f64], spacing: f64, [shortest, longest]: [f64; 2]) -> isize {
    let count = 2 * one.len();
    let mut plans = Plans::default();
    let forward = plans.real_forward(count);
    let backward = plans.real_inverse(count);
    let transformed = |heights: &[f64]| {
        let mut input = heights.to_vec();
        remove_trend(&mut input);
        input.resize(count, 0.0);
        let mut output = forward.make_output_vec();
        // Fails only for a buffer of another length.
        let done = forward.process(&mut input, &mut output);
        debug_assert!(done.is_ok());
        output
    };
    let of_line = count as f64 * spacing;
    let mut product: Vec<Complex64> = (transformed(one).into_iter().zip(transformed(other)))
        .enumerate()
        .map(|(line, (one, other))| {
            let wavelength = of_line / line as f64;
            match (shortest..=longest).contains(&wavelength) {
                true => one.conj() * other,
                false => Complex64::ZERO,
            }
        })
        .collect();
    let mut correlation = backward.make_output_vec();
    let done = backward.process(&mut product, &mut correlation);
    debug_assert!(done.is_ok());
    let most = ((LARGEST_SHIFT / spacing) as isize).min(one.len() as isize - 1);
    let at = |lag: isize| correlation[lag.rem_euclid(count as isize) as usize];
    (-most..=most).max_by(|one, other| at(*one).total_cmp(&at(*other))).unwrap_or(0)
}

/// Sums over segments.
struct Spectra {
    one: Vec<f64>,
    other: Vec<f64>,
    cross: Vec<Complex64>,
}

fn spectra(one: &[f64], other: &[f64], samples: usize) -> Spectra {
    let transform = Plans::default().real_forward(samples);
    let window = window(samples);
    let lines = samples / 2 + 1;
    let mut sums = Spectra { one: vec![0.0; lines], other: vec![0.0; lines], cross: vec![Complex64::ZERO; lines] };
    let transformed = |heights: &[f64]| {
        let mut input = heights.to_vec();
        remove_trend(&mut input);
        for (height, weight) in input.iter_mut().zip(&window) {
            *height *= weight;
        }
        let mut output = transform.make_output_vec();
        let done = transform.process(&mut input, &mut output);
        debug_assert!(done.is_ok());
        output
    };
    for from in (0..=one.len() - samples).step_by(samples / 2) {
        let one = transformed(&one[from..from + samples]);
        let other = transformed(&other[from..from + samples]);
        for line in 0..lines {
            sums.one[line] += one[line].norm_sqr();
            sums.other[line] += other[line].norm_sqr();
            sums.cross[line] += one[line].conj() * other[line];
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::{Rng, SeedableRng};
    use riffel_numerics::random_numbers::unit;
    use std::f64::consts::TAU;

    const SPACING: f64 = 2e-3;

    /// Growth and drift of a wavelength.
    fn grown(wavelength: f64) -> Complex64 {
        let beside = ((wavelength - 0.07) / 0.03).powi(2);
        Complex64::new(0.9 / (1.0 + beside) - 0.2, 0.5 * (wavelength / 0.07 - 1.0))
    }

    /// A random rail, and what it becomes with noise of its own, moved along.
    fn rails(seed: u64, metres: f64, noise: f64, moved: f64) -> [Profile; 2] {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut uniform = || unit(random.next_u64());
        let mut normal = || (-2.0 * uniform().max(1e-300).ln()).sqrt() * (TAU * uniform()).cos();
        let count = (metres / SPACING) as usize;
        let mut plans = Plans::default();
        let backward = plans.real_inverse(count);
        let [mut one, mut other] = [0; 2].map(|_| backward.make_input_vec());
        let last = one.len() - 1;
        for line in 1..last {
            let wavelength = metres / line as f64;
            if !(0.03..0.4).contains(&wavelength) {
                continue;
            }
            let level = (wavelength / 0.1).sqrt();
            let wave = level * Complex64::new(normal(), normal());
            let turn = Complex64::from_polar(1.0, -TAU * moved / wavelength);
            one[line] = wave;
            other[line] = wave * grown(wavelength).exp() * turn + noise * level * Complex64::new(normal(), normal());
        }
        [one, other].map(|mut lines| {
            let mut heights = backward.make_output_vec();
            backward.process(&mut lines, &mut heights).unwrap();
            Profile::new(0.0, SPACING, heights).unwrap()
        })
    }

    /// What a segment sees of the growth about a wavelength.
    fn expected(found: &WaveGrowths, wavelength: f64) -> Complex64 {
        let seen = found
            .seen
            .iter()
            .map(|(beside, share)| share * grown((wavelength.recip() + beside / found.segment).recip()).exp());
        seen.sum::<Complex64>().ln()
    }

    /// Real and imaginary parts lie off the truth by as much as they say: 40 records of 100 m with noise of 0.3 at the later date
    /// have 1100 values of each, whose mean square scatters by √(2/1100) = 4 %; what a window sees of a curved growth adds to it.
    #[test]
    fn growth_is_found_with_its_error() {
        let (mut squares, mut count) = ([0.0; 2], 0.0);
        for seed in 0..40 {
            let [before, after] = rails(seed, 100.0, 0.3, 0.0);
            let found = WaveGrowths::between(&before, &after, [0.036, 0.22]).unwrap();
            assert_eq!((found.shift, found.lost), (0.0, 0));
            for wave in &found.waves {
                let off = wave.logarithm - expected(&found, wave.wavelength);
                squares[0] += off.re * off.re / wave.variance;
                squares[1] += off.im * off.im / wave.variance;
                count += 1.0;
            }
        }
        for square in squares {
            let mean: f64 = square / count;
            assert!((mean - 1.0).abs() < 0.15, "{mean} of {count}");
        }
    }

    /// A record whose positions are 0.137 m off: its shift to half a sample, the rest in the phases.
    #[test]
    fn positions_that_are_off_are_found() {
        let [before, after] = rails(3, 60.0, 0.0, 0.1372);
        let found = WaveGrowths::between(&before, &after, [0.036, 0.22]).unwrap();
        // Growth itself drifts: the best lag is that of its mean phase.
        assert!((found.shift - 0.1372).abs() < 6e-3, "{}", found.shift);
        for wave in &found.waves {
            let rest = 0.1372 - found.shift;
            let turn = Complex64::new(0.0, TAU * rest / wave.wavelength);
            let off = wave.logarithm + turn - expected(&found, wave.wavelength);
            assert!(off.norm() < 0.08, "{} {off}", wave.wavelength);
        }
    }

    #[test]
    fn what_cannot_be_compared_is_refused() {
        let window = [0.036, 0.22];
        let [before, after] = rails(1, 60.0, 0.0, 0.0);
        let rule = |before: &Profile, after: &Profile| {
            let error = WaveGrowths::between(before, after, window).unwrap_err();
            error.to_string()
        };
        let short = before.between(0.0, 7.0).unwrap();
        assert!(rule(&short, &after).contains("36 longest waves"));
        let other = Profile::new(0.0, 1e-3, after.heights().to_vec()).unwrap();
        assert!(rule(&before, &other).contains("one spacing"));
        let away = Profile::new(500.0, SPACING, after.heights().to_vec()).unwrap();
        assert!(rule(&before, &away).contains("in common"));
        let [another, _] = rails(9, 60.0, 0.0, 0.0);
        let found = WaveGrowths::between(&before, &another, window);
        assert!(found.is_err() || found.unwrap().lost > 8);
    }
}
