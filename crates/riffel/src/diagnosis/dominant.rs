//! Dominant wavelengths of a profile.

use riffel_numerics::normal_distribution::above;

use super::median_line::{extrapolation, median_line};
use super::normal;
use crate::Error;
use crate::roughness::{PowerSpectrum, Profile, level};

/// Bands of an octave.
const BANDS_AN_OCTAVE: f64 = 24.0;
/// Bands to either side of a band from which its trend is taken: an octave.
const TREND: usize = 24;
/// Bands to either side that are left out: a quarter of an octave, so that corrugation ±19 % wide does not
/// become its own trend.
const LEFT_OUT: usize = 6;
/// Decibels above the trend from which a wavelength is called dominant: twice the power.
const PROMINENT: f64 = 3.0;
/// How many bands of noise may look like this in one spectrum.
const FALSE_ALARMS: f64 = 0.01;
/// Ratio of the wavelengths of half the power above which a peak is a hump of the trend and no wave: an octave.
const BROADEST: f64 = 2.0;
/// Shortest wavelength \[m\]; below, rails are not measured.
const SHORTEST: f64 = 0.005;
/// Most that are named: those that stand out most.
pub(super) const MOST: usize = 6;

/// A wavelength that stands out of the roughness.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct DominantWavelength {
    /// Wavelength λ \[m\]: the middle of the power between `from` and `to`, or the nominal one of the one-third
    /// octave.
    pub wavelength: f64,
    /// Where the spectrum is down to half its peak on the short side \[m\]; the edge of a one-third octave.
    pub from: f64,
    /// Wavelength on the long side at which the spectrum is down to half its peak \[m\].
    pub to: f64,
    /// Level of all between the two \[dB re 1 µm\].
    pub level: f64,
    /// Decibels above the trend of the neighbouring wavelengths.
    pub prominence: f64,
    /// Standard deviation of the prominence by chance \[dB\]; unknown for a single spectrum.
    pub scatter: Option<f64>,
    /// How many peaks as high a spectrum of pure noise has, in the mean, or all windows of a rail together; unknown
    /// for a single spectrum.
    pub false_peaks: Option<f64>,
    /// Number n of a longer dominant wavelength nλ of which this may be a harmonic.
    pub harmonic_of: Option<(u32, f64)>,
}

impl DominantWavelength {
    /// Uncertainty of ln λ: that of a value somewhere between `from` and `to`.
    pub fn uncertainty(&self) -> f64 {
        (self.to / self.from).ln() / 12f64.sqrt()
    }
}

/// Power of a record in narrow bands with its trend.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct FineSpectrum {
    power: PowerSpectrum,
    bands: Vec<FineBand>,
}

/// A band of 1/24 octave, or as wide as a line of the transform where that is wider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FineBand {
    /// Middle \[m\].
    pub wavelength: f64,
    /// Level, brought to 1/24 octave \[dB re 1 µm\].
    pub level: f64,
    /// Level that the neighbours let expect \[dB re 1 µm\].
    pub trend: f64,
    /// Degrees of freedom of the mean of its squares, less what the trend scatters.
    freedom: f64,
    /// Lowest and highest wavenumber \[1/m\].
    edges: (f64, f64),
}

impl FineBand {
    /// Standard deviation by chance of the level over its trend \[dB\], for a stationary random profile.
    pub fn scatter(&self) -> f64 {
        10.0 / std::f64::consts::LN_10 * (2.0 / self.freedom).sqrt()
    }
}

impl FineSpectrum {
    /// The spectrum of one record, all rails and stretches averaged.
    ///
    /// Segments are a fifth of the whole length or 20 m, whichever is shorter, and 1 m at least, so that some nine are
    /// averaged; wavelengths reach from 5 mm, or four samples, to an eighth of a segment. The trend is the
    /// line through the neighbours up to an octave away, those nearer than a quarter left out, with the
    /// median of all slopes between them (Theil 1950, Sen 1968): a second peak does not bend it.
    ///
    /// # Errors
    /// Errors of [`PowerSpectrum::of_record`].
    pub fn of_record(stretches: &[Profile]) -> Result<Self, Error> {
        /// Longest wavelength asked of the transform \[m\], of which a segment has twenty.
        const LONGEST: f64 = 1.0;
        let total: f64 = stretches.iter().map(Profile::length).sum();
        let longest = (total / 100.0).clamp(0.05, LONGEST);
        let power = PowerSpectrum::of_record(stretches, longest)?;
        let spacing = stretches.first().map_or(0.0, Profile::spacing);
        let mut bands = fine_bands(&power, SHORTEST.max(4.0 * spacing));
        set_trend(&mut bands);
        Ok(Self { power, bands })
    }

    /// The bands, the longest wavelength first.
    pub fn bands(&self) -> &[FineBand] {
        &self.bands
    }

    /// Number of segments averaged.
    pub fn segments(&self) -> usize {
        self.power.segments()
    }

    /// Length of a segment \[m\].
    pub fn segment_length(&self) -> f64 {
        self.power.segment_length()
    }

    /// Level of all that lies between two wavelengths \[dB re 1 µm\], and its standard deviation by chance.
    pub fn level_between(&self, from: f64, to: f64) -> (f64, f64) {
        let inside = self.wavenumbers(from, to);
        let lines = self.power.lines().filter(|(k, _)| inside.contains(k));
        let (count, sum) = lines.fold((0u32, 0.0), |(count, sum), line| (count + 1, sum + line.1));
        let freedom = freedom(f64::from(count.max(1)), self.power.segments());
        let scatter = 10.0 / std::f64::consts::LN_10 * (2.0 / freedom).sqrt();
        (level(sum), scatter)
    }

    /// The wavenumbers \[1/m\] of the lines that hold the power of two wavelengths and of what lies between them, but for
    /// 0.4 dB at most: a line more to either side. Of a sinusoid on a line, the Hann window puts a sixth of the power into each neighbour, which
    /// half the power of the peak leaves out.
    fn wavenumbers(&self, from: f64, to: f64) -> std::ops::RangeInclusive<f64> {
        let step = self.power.segment_length().recip();
        to.recip() - step..=from.recip() + step
    }

    /// The wavelengths that stand 3 dB or more above the trend, and so far that pure noise of the same
    /// trend has such a peak in one spectrum of a hundred, and are no broader than an octave; the most prominent first, six
    /// at most.
    pub fn dominant(&self) -> Vec<DominantWavelength> {
        self.dominant_among(1)
    }

    /// Dominant wavelengths if this is one of several spectra: noise has such a peak in one of a hundred sets of so many.
    pub(super) fn dominant_among(&self, spectra: usize) -> Vec<DominantWavelength> {
        let excess = |index: usize| self.bands[index].level - self.bands[index].trend;
        let false_peaks = |index: usize| {
            let band = &self.bands[index];
            let ratio = 10f64.powf(excess(index) / 10.0);
            let chances = (spectra * self.bands.len()) as f64;
            above(normal::of_mean_square(ratio, band.freedom)) * chances
        };
        let stands_out = |index: usize| excess(index) >= PROMINENT && false_peaks(index) < FALSE_ALARMS;
        let mut order: Vec<usize> =
            (2..self.bands.len().saturating_sub(2)).filter(|&index| stands_out(index)).collect();
        order.sort_by(|&a, &b| excess(b).total_cmp(&excess(a)));
        let mut taken = vec![false; self.bands.len()];
        let mut found: Vec<DominantWavelength> = Vec::new();
        for peak in order {
            if taken[peak] || found.len() == MOST {
                continue;
            }
            for side in [-1, 1] {
                self.take_flank(peak, side, &mut taken);
            }
            taken[peak] = true;
            let measured = self.measured(peak, excess(peak), false_peaks(peak));
            if measured.to <= BROADEST * measured.from {
                found.push(measured);
            }
        }
        for index in 0..found.len() {
            found[index].harmonic_of = harmonic(&found[index], &found);
        }
        found
    }

    /// Mark the flank of a peak: down to the trend, or to where the spectrum has turned up by 3 dB.
    fn take_flank(&self, peak: usize, side: isize, taken: &mut [bool]) {
        let mut lowest = f64::INFINITY;
        let mut index = peak;
        while let Some(next) = index.checked_add_signed(side) {
            let Some(band) = self.bands.get(next) else {
                return;
            };
            lowest = lowest.min(band.level);
            if band.level < band.trend + 0.5 * PROMINENT || band.level > lowest + PROMINENT {
                return;
            }
            taken[next] = true;
            index = next;
        }
    }

    /// Middle, bandwidth and level of a peak.
    fn measured(&self, peak: usize, prominence: f64, false_peaks: f64) -> DominantWavelength {
        let half = self.bands[peak].level - PROMINENT;
        // Where the level is halved, between the middles of two bands.
        let edge = |side: isize| {
            let mut inner = &self.bands[peak];
            let mut index = peak;
            while let Some(outer) = index.checked_add_signed(side).and_then(|next| self.bands.get(next)) {
                if outer.level < half {
                    let share = (inner.level - half) / (inner.level - outer.level);
                    let ratio = outer.wavelength / inner.wavelength;
                    return inner.wavelength * ratio.powf(share);
                }
                inner = outer;
                index = index.wrapping_add_signed(side);
            }
            inner.wavelength
        };
        let (mut to, mut from) = (edge(-1), edge(1));
        let inside = self.wavenumbers(from, to);
        // A wave narrower than its band may lie anywhere in it.
        let (low, high) = self.bands[peak].edges;
        let inside = inside.start().min(low)..=inside.end().max(high);
        let lines = self.power.lines().filter(|(k, _)| inside.contains(k));
        let (sum, moment) = lines.fold((0.0, 0.0), |(sum, moment), (k, line)| (sum + line, moment + k * line));
        if from.recip() - to.recip() < high - low {
            let middle = moment / sum;
            let half_width = (0.5 * (from.recip() - to.recip())).max(self.power.segment_length().recip());
            from = (middle + half_width).recip();
            to = (middle - half_width).recip();
        }
        DominantWavelength {
            wavelength: sum / moment,
            from,
            to,
            level: level(sum),
            prominence,
            scatter: Some(self.bands[peak].scatter()),
            false_peaks: Some(false_peaks),
            harmonic_of: None,
        }
    }
}

/// The longer wavelength of which this is a harmonic, to a fiftieth, if it stands out as much.
pub(super) fn harmonic(short: &DominantWavelength, all: &[DominantWavelength]) -> Option<(u32, f64)> {
    const NEAR: f64 = 0.02;
    all.iter().filter(|long| long.level > short.level).find_map(|long| {
        let ratio = long.wavelength / short.wavelength;
        let near = (2..=4).find(|n| (ratio / f64::from(*n) - 1.0).abs() < NEAR)?;
        Some((near, long.wavelength))
    })
}

/// Degrees of freedom of the mean of some neighbouring lines over half-overlapping segments, both with the
/// Hann window: its lines are correlated by 2/3 and 1/6 of their amplitudes, its halves by 1/6 (Welch 1967).
fn freedom(lines: f64, segments: usize) -> f64 {
    let neighbours = |distance: f64| (1.0 - distance / lines).max(0.0);
    let correlated = 1.0 + 2.0 * (4.0 / 9.0 * neighbours(1.0) + neighbours(2.0) / 36.0);
    let segments = segments as f64;
    let overlap = 1.0 + 2.0 / 36.0 * (1.0 - segments.recip());
    2.0 * segments * lines / (correlated * overlap)
}

fn fine_bands(power: &PowerSpectrum, shortest: f64) -> Vec<FineBand> {
    let step = power.segment_length().recip();
    let lines: Vec<f64> = power.lines().map(|line| line.1).collect();
    let ratio = 2f64.powf(BANDS_AN_OCTAVE.recip());
    let mut bands = Vec::new();
    let mut low = 7.5 * step;
    loop {
        let high = (low * ratio).max(low + step);
        if high * shortest > 1.0 || high > (lines.len() as f64 - 1.5) * step {
            return bands;
        }
        // A line stands for half a step to either side.
        let (first, last) = ((low / step).round() as usize, (high / step).round() as usize);
        let sum: f64 = (first..=last)
            .map(|line| {
                let from = (line as f64 - 0.5).max(low / step);
                let to = (line as f64 + 0.5).min(high / step);
                (to - from).max(0.0) * lines[line]
            })
            .sum();
        let width = (high / low).ln() / ratio.ln();
        let middle = level(sum / width);
        bands.push(FineBand {
            wavelength: (low * high).sqrt().recip(),
            level: middle,
            trend: middle,
            freedom: freedom((high - low) / step, power.segments()),
            edges: (low, high),
        });
        low = high;
    }
}

/// The line through the neighbours of each band.
fn set_trend(bands: &mut [FineBand]) {
    let points: Vec<(f64, f64)> =
        bands.iter().map(|band| ((band.edges.0 * band.edges.1).sqrt().ln(), band.level)).collect();
    let count = points.len();
    for index in 0..count {
        // As many neighbours at the ends of the spectrum as in its middle.
        let first = index.saturating_sub(TREND).min(count.saturating_sub(2 * TREND + 1));
        let last = (first + 2 * TREND).min(count.saturating_sub(1));
        let neighbours: Vec<(f64, f64)> =
            (first..=last).filter(|other| other.abs_diff(index) > LEFT_OUT).map(|other| points[other]).collect();
        // A single narrow spectrum has too few.
        if let Some(trend) = median_line(&neighbours, points[index].0) {
            let band = &mut bands[index];
            band.trend = trend - 10.0 * normal::median_of_mean_square(band.freedom).log10();
            // The trend scatters, too, most at the ends of the spectrum.
            band.freedom /= 1.0 + extrapolation(&neighbours, points[index].0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roughness::{ColouredNoise, Recipe, Sinusoid};

    fn made(length: f64, seed: u64, slope: f64, waves: &[(f64, f64)]) -> FineSpectrum {
        let recipe = Recipe {
            length,
            spacing: 1e-3,
            seed,
            sinusoids: waves
                .iter()
                .map(|&(wavelength, amplitude)| Sinusoid { wavelength, amplitude, phase: 0.3, from: 0.0, to: length })
                .collect(),
            noise: Some(ColouredNoise { level: 0.0, wavelength: 0.1, slope, longest: 3.0 }),
            ..Recipe::default()
        };
        let profile = Profile::new(0.0, 1e-3, recipe.heights().unwrap()).unwrap();
        FineSpectrum::of_record(&[profile]).unwrap()
    }

    /// A hundred rails of noise, white and worn, short and long, have one peak by chance at most: the
    /// threshold is one in a hundred spectra, and 3 dB besides.
    #[test]
    fn noise_has_no_dominant_wavelength() {
        let mut found = 0;
        for seed in 0..100 {
            let slope = if seed % 2 == 0 { -10.0 } else { 15.0 };
            let length = [12.0, 40.0, 120.0][seed as usize % 3];
            found += made(length, seed, slope, &[]).dominant().len();
        }
        assert!(found <= 1, "{found}");
    }

    /// Wherever a sinusoid lies in a band of many lines, on a rail 35 dB quieter, it lies between the two ends that are told,
    /// and its level is 10 lg(A²/2).
    #[test]
    fn the_level_does_not_depend_on_the_place_in_a_band() {
        for wave in 0..12 {
            let wavelength = 0.034 * 1.005f64.powi(wave);
            let found = made(100.0, 5, 15.0, &[(wavelength, 40e-6)]).dominant();
            let peak = &found[0];
            assert!(peak.from < wavelength && wavelength < peak.to, "{wavelength} {peak:?}");
            assert!((peak.wavelength / wavelength - 1.0).abs() < 0.002, "{wavelength} {peak:?}");
            let expected = level(0.5 * 40e-6 * 40e-6);
            assert!((peak.level - expected).abs() < 0.3, "{wavelength} {peak:?}");
        }
    }

    /// Wherever a sinusoid falls between two lines of the transform, its level is 10 lg(A²/2): a neighbour just beyond
    /// takes 0.4 dB at most, a twelfth of the power, and noise 24 dB below it moves nine averaged segments by 0.2 dB.
    #[test]
    fn the_level_does_not_depend_on_the_place_among_the_lines() {
        // Segments of 6 m: lines 1/6 m apart.
        for tenth in 0..10 {
            let wavenumber = (108.0 + 0.1 * f64::from(tenth)) / 6.0;
            let found = made(30.0, 5, 0.0, &[(wavenumber.recip(), 8e-6)]).dominant();
            let expected = level(0.5 * 8e-6 * 8e-6);
            assert!((found[0].level - expected).abs() < 0.6, "{tenth}: {found:?}");
        }
    }

    /// Sinusoids are found within a hundredth of their wavelength; their bandwidth is that of the lines, and
    /// their level 10 lg(A²/2), within 0.3 dB of what the window leaves outside half power and of noise.
    #[test]
    fn sinusoids_are_found_with_their_levels() {
        let waves = [(0.0431, 5e-6), (0.163, 12e-6)];
        let found = made(100.0, 3, 15.0, &waves).dominant();
        assert_eq!(found.len(), 2, "{found:?}");
        for (wavelength, amplitude) in waves {
            let near = |peak: &&DominantWavelength| (peak.wavelength / wavelength - 1.0).abs() < 0.01;
            let peak = found.iter().find(near).unwrap();
            assert!(peak.from < wavelength && wavelength < peak.to, "{peak:?}");
            assert!(peak.to / peak.from < 1.06, "{peak:?}");
            assert!((peak.level - level(0.5 * amplitude * amplitude)).abs() < 0.3, "{peak:?}");
            assert!(peak.false_peaks.unwrap() < 1e-6);
        }
    }

    /// Narrow-band noise of Gaussian shape over ln λ, ±10 % at half power, is as wide as it was made.
    #[test]
    fn bandwidth_is_that_of_the_corrugation() {
        // 400 waves of random-like phases; their powers follow the bell.
        let wave = |index: i32| {
            let place = (f64::from(index) - 199.5) / 199.5;
            let k = (0.05f64.recip()) * (0.4 * place).exp();
            // Half power at ±0.1 of ln λ.
            let amplitude = 1e-6 * 0.5f64.powf(0.5 * (0.4 * place / 0.1).powi(2));
            (k, amplitude, 2.4 * f64::from(index * index))
        };
        let waves: Vec<(f64, f64, f64)> = (0..400).map(wave).collect();
        let height = |sample: i32| {
            let x = 1e-3 * f64::from(sample);
            waves.iter().map(|(k, amplitude, phase)| amplitude * (std::f64::consts::TAU * k * x + phase).sin()).sum()
        };
        let heights: Vec<f64> = (0..200_000).map(height).collect();
        let profile = Profile::new(0.0, 1e-3, heights).unwrap();
        let found = FineSpectrum::of_record(&[profile]).unwrap().dominant();
        let peak = &found[0];
        assert!((peak.wavelength / 0.05 - 1.0).abs() < 0.05, "{peak:?}");
        let width = (peak.to / peak.from).ln();
        // ±1.3 dB of chance in each band moves the half-power points.
        assert!((0.1..0.3).contains(&width), "{width} {peak:?}");
    }

    #[test]
    fn harmonics_are_named() {
        let found = made(100.0, 5, 15.0, &[(0.08, 20e-6), (0.04, 5e-6)]).dominant();
        let short = found.iter().find(|peak| peak.wavelength < 0.05).unwrap();
        let (number, long) = short.harmonic_of.unwrap();
        assert_eq!(number, 2);
        assert!((long - 0.08).abs() < 1e-3);
    }
}
