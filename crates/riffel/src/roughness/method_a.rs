//! One-third-octave levels by Fourier transform: method A of EN 15610.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::few_lines::KeptLines;
use super::hann_window::{SHORTEST_RECORD, line_powers, lines_of_band, spacing_and_longest};
use super::{Profile, Spectrum, ThirdOctave, level};
use crate::Error;

/// Length of a segment in waves: the shortest part at its ends still has sixteen.
const WAVES: f64 = 48.0;
/// Least waves of a part: at ten, half a decibel of a sinusoid goes to the neighbours of its band.
const FEWEST_WAVES: f64 = 10.0;
/// Parts at either end of a stretch, as shares of a segment, with their weights by length. Segments overlap by two
/// thirds, where their windows add up to a constant. The weights are those with which bursts of ten waves and more
/// count most evenly wherever they lie, in stretches of 18 to 600 waves.
const AT_AN_END: [(f64, f64); 2] = [(2.0 / 3.0, 0.5), (1.0 / 3.0, 1.75)];
/// Samples of a wave from which every other one is enough.
const SAMPLES_OF_A_WAVE: f64 = 32.0;

/// Levels of a record with how they were got.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RecordLevels {
    pub spectrum: Spectrum,
    /// Length of a segment for the longest wavelengths \[m\].
    pub segment_length: f64,
    /// Number of such segments.
    pub segments: usize,
}

/// A part of a stretch, in samples, with its weight.
struct Part {
    start: usize,
    samples: usize,
    weight: f64,
}

impl Spectrum {
    /// One-third-octave levels of one record, its stretches together, up to wavelengths of `longest` \[m\], at most a
    /// quarter of the longest stretch, and down to the last band that lies wholly above two samples.
    ///
    /// A level is the mean square over the record: a burst of twelve waves or more counts the same within 1 dB at an
    /// end, in the middle or anywhere else, for waves of which the record has thirty (a test moves it along).
    ///
    /// Method A of EN 15610:2009 with segments for each band: 48 waves, or the whole stretch where that is shorter, and
    /// 1 m at least; mean and trend removed, Hann window, |DFT|² averaged. Segments overlap by two thirds or more;
    /// shorter ones at either end make up for what the windows hide there. A sinusoid leaks less than −65 dB into bands
    /// two away; at the edge of two bands, each of which sees it through a window of its own, they share its power to
    /// within 6 %. Stretches with fewer than ten waves of a band are left out of it beside longer ones. Long waves are
    /// looked at with fewer samples, 16 or more a wave, halved by a binomial filter whose gain is undone; what it lets
    /// through of waves of two samples is below −100 dB. Cost: one transform of the record for all bands with segments
    /// of 1 m, for each other band some forty products for each sample that is left; parallel.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where no stretch is as long as 1 m; [`Error::Measurement`] without a stretch, where
    /// their spacings differ or where no band is left.
    pub fn of_record(stretches: &[Profile], longest: f64) -> Result<Self, Error> {
        Ok(RecordLevels::new(stretches, 0.0, longest, &KeptLines::default())?.spectrum)
    }
}

impl RecordLevels {
    /// Spectrum of [`Spectrum::of_record`] over bands that lie wholly above the shortest wavelength \[m\].
    pub(super) fn new(stretches: &[Profile], shortest: f64, longest: f64, kept: &KeptLines) -> Result<Self, Error> {
        Error::unless_positive("longest wavelength", longest, "m")?;
        let (spacing, record) = spacing_and_longest(stretches)?;
        // The record is known to a sample at either end.
        let longest = longest.min(0.25 * (record + spacing)) * (1.0 + 1e-9);
        let nyquist = 0.5 / spacing * (1.0 + 1e-9);
        let bands = (-60..=(10.0 * longest.log10()).floor() as i32)
            .map(ThirdOctave::new)
            .filter(|band| band.wavenumber_range().1 <= nyquist && band.wavelength_range().0 >= shortest);
        let heights = stretches.iter().map(|one| one.heights().into());
        let mut samples = Samples { spacing, stretches: heights.collect(), halvings: 0, before: BTreeMap::new() };
        let mut levels = Vec::new();
        let (mut segment_length, mut segments) = (0.0, 0);
        for band in bands {
            let wave = band.wavelength();
            while wave >= SAMPLES_OF_A_WAVE * samples.spacing {
                samples = samples.halved();
            }
            let count = |length: f64| (length.min(record) / samples.spacing).round() as usize;
            let segment = count((WAVES * wave).max(SHORTEST_RECORD));
            let fewest = count(FEWEST_WAVES * wave);
            let (power, averaged) = samples.power(band, segment, fewest, kept);
            levels.push((band, level(power)));
            (segment_length, segments) = (segment as f64 * samples.spacing, averaged);
        }
        Ok(Self { spectrum: Spectrum::new(levels)?, segment_length, segments })
    }
}

/// A part of one of the stretches, in samples, with its share of the mean square.
#[derive(Debug, Clone, PartialEq)]
struct Seen {
    stretch: usize,
    start: usize,
    share: f64,
}

/// The stretches of a record, every so many samples.
struct Samples<'a> {
    spacing: f64,
    stretches: Vec<Cow<'a, [f64]>>,
    halvings: i32,
    /// Parts of the band before, by their number of samples, with the powers of all lines of those that were transformed: short
    /// waves have the same segments.
    before: BTreeMap<usize, (Vec<Seen>, Option<Vec<f64>>)>,
}

impl Samples<'_> {
    /// Half as many samples: gain cos⁵(π k · spacing).
    fn halved(&self) -> Self {
        Self {
            spacing: 2.0 * self.spacing,
            stretches: self.stretches.iter().map(|one| halved(one).into()).collect(),
            halvings: self.halvings + 1,
            before: BTreeMap::new(),
        }
    }

    /// Gain of all halvings at a wavenumber \[1/m\].
    fn gain(&self, wavenumber: f64) -> f64 {
        let spacings = (1..=self.halvings).map(|back| self.spacing * 0.5f64.powi(back));
        spacings.map(|spacing| (PI * wavenumber * spacing).cos().powi(5)).product()
    }

    /// Mean square of a band over all stretches with `fewest` samples or the longest one, and the number of segments.
    fn power(&mut self, band: ThirdOctave, segment: usize, fewest: usize, kept: &KeptLines) -> (f64, usize) {
        let (seen, segments) = self.seen(segment, fewest);
        let mut sum = 0.0;
        let mut before = std::mem::take(&mut self.before);
        for (samples, parts) in seen {
            let line_spacing = 1.0 / (samples as f64 * self.spacing);
            let (lines, shares) = lines_of_band(samples, line_spacing, band);
            let known = before.remove(&samples).filter(|(known, _)| *known == parts);
            let mut all = known.and_then(|(_, all)| all);
            let heights = || -> Vec<(&[f64], f64)> {
                let heights = |part: &Seen| &self.stretches[part.stretch][part.start..part.start + samples];
                parts.iter().map(|part| (heights(part), part.share)).collect()
            };
            let few = if all.is_none() { kept.of(samples, lines.clone()) } else { None };
            let powers = match few {
                Some(few) => few.powers(&heights()),
                None => all.get_or_insert_with(|| line_powers(&heights(), samples))[lines.clone()].to_vec(),
            };
            let gain = |line: usize| self.gain(line as f64 * line_spacing);
            let shared = lines.zip(powers).zip(shares);
            sum += shared.map(|((line, power), share)| power * share / gain(line).powi(2)).sum::<f64>();
            self.before.insert(samples, (parts, all));
        }
        (sum, segments)
    }

    /// Parts of all stretches with `fewest` samples or the longest one, by their number of samples, and the number of segments.
    fn seen(&self, segment: usize, fewest: usize) -> (BTreeMap<usize, Vec<Seen>>, usize) {
        let longest = self.stretches.iter().map(|heights| heights.len()).max();
        let fewest_of_all = fewest.min(longest.unwrap_or(0));
        let counting = || {
            let all = self.stretches.iter().enumerate();
            all.filter(|(_, heights)| heights.len() >= fewest_of_all)
        };
        let total: usize = counting().map(|(_, heights)| heights.len()).sum();
        let mut by_samples = BTreeMap::<usize, Vec<Seen>>::new();
        let mut segments = 0;
        for (stretch, heights) in counting() {
            let parts = parts(heights.len(), segment, fewest);
            segments += parts.iter().filter(|part| part.samples == parts[0].samples).count();
            let sum: f64 = parts.iter().map(|part| part.weight).sum();
            let share = heights.len() as f64 / (total as f64 * sum);
            for part in parts {
                let of_length = by_samples.entry(part.samples).or_default();
                of_length.push(Seen { stretch, start: part.start, share: share * part.weight });
            }
        }
        (by_samples, segments)
    }
}

/// Binomial means of six samples, (1, 5, 10, 10, 5, 1)/32, in the middle of every other one and the next; the record is continued by its
/// mirror image about its first and last height.
fn halved(heights: &[f64]) -> Vec<f64> {
    let [first, second, third, ..] = heights else {
        return Vec::new();
    };
    let [.., before_two, before, last] = heights else {
        return Vec::new();
    };
    let mut all = Vec::with_capacity(heights.len() + 4);
    all.extend([2.0 * first - third, 2.0 * first - second]);
    all.extend_from_slice(heights);
    all.extend([2.0 * last - before, 2.0 * last - before_two]);
    let pairs = all.as_chunks::<2>().0.windows(3);
    pairs
        .map(|pairs| {
            let sum = |of: [f64; 2]| of[0] + of[1];
            let (outer, inner) = ([pairs[0][0], pairs[2][1]], [pairs[0][1], pairs[2][0]]);
            0.03125 * sum(outer) + 0.15625 * sum(inner) + 0.3125 * sum(pairs[1])
        })
        .collect()
}

/// The segments of a stretch and the shorter parts at its ends.
fn parts(samples: usize, segment: usize, fewest: usize) -> Vec<Part> {
    let segment = segment.min(samples);
    let part = |start, samples: usize, weight: f64| Part { start, samples, weight: weight * samples as f64 };
    let mut parts: Vec<Part> = starts(samples, segment).map(|start| part(start, segment, 1.0)).collect();
    for (share, weight) in AT_AN_END {
        let short = ((share * segment as f64).round() as usize).max(fewest);
        if short < segment {
            parts.push(part(0, short, weight));
            parts.push(part(samples - short, short, weight));
        }
    }
    parts
}

/// Where segments that overlap by two thirds or more begin.
fn starts(samples: usize, segment: usize) -> impl Iterator<Item = usize> {
    let room = samples.saturating_sub(segment);
    let steps = room.div_ceil((segment / 3).max(1));
    (0..=steps).map(move |step| (room * step).checked_div(steps).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roughness::mean_square;

    /// A sinusoid of 3 µm over part of a record of 1 mm steps.
    fn burst(samples: usize, wavelength: f64, from: f64, to: f64) -> Result<Profile, Error> {
        let wave = |i: usize| {
            let x = i as f64 * 1e-3;
            let inside = (from..to).contains(&x);
            let phase = std::f64::consts::TAU * x / wavelength + 0.3;
            if inside { 3e-6 * phase.sin() } else { 0.0 }
        };
        Profile::new(0.0, 1e-3, (0..samples).map(wave).collect())
    }

    fn sinusoid(samples: usize, wavelength: f64) -> Result<Profile, Error> {
        burst(samples, wavelength, 0.0, f64::INFINITY)
    }

    #[test]
    fn a_sinusoid_keeps_to_its_band() -> Result<(), Error> {
        for index in [-22, -17, -13, -10, -5] {
            let band = ThirdOctave::new(index);
            let record = [sinusoid(20_011, band.wavelength())?];
            let spectrum = Spectrum::of_record(&record, 2.0)?;
            for level in spectrum.levels() {
                match (level.band.index() - index).abs() {
                    0 => assert!((level.level - 6.532).abs() < 0.01, "{level:?}"),
                    1 => {}
                    _ => assert!(level.level < -60.0, "{index}: {level:?}"),
                }
            }
        }
        Ok(())
    }

    /// Two bands between which a sinusoid lies have its power to within 6 %, others nothing.
    #[test]
    fn a_sinusoid_at_an_edge_is_shared_by_two_bands() -> Result<(), Error> {
        let edge = ThirdOctave::new(-12).wavelength_range().1;
        for step in -10..=10 {
            let record = [sinusoid(40_000, edge * (1.0 + 0.002 * f64::from(step)))?];
            let spectrum = Spectrum::of_record(&record, 1.0)?;
            let of = |index| spectrum.level(ThirdOctave::new(index)).map_or(0.0, mean_square);
            let shared = (of(-12) + of(-11)) / 4.5e-12;
            assert!((shared - 1.0).abs() < 0.06, "{step} {shared}");
            assert!(of(-13) + of(-10) < 1e-3 * 4.5e-12, "{step}");
        }
        Ok(())
    }

    /// 10 lg(A²/2 · share) of the power of a burst, wherever it lies in records long and short; its own sudden ends
    /// put some tenths of a decibel elsewhere.
    #[test]
    fn a_level_is_the_mean_square_wherever_the_wave_lies() -> Result<(), Error> {
        let mut worst = 0.0f64;
        for index in [-17, -15, -13, -10, -7, -5] {
            let band = ThirdOctave::new(index);
            for length in [8.0, 12.0, 30.0] {
                for waves in [12.0, 40.0] {
                    let long = waves * band.wavelength();
                    if long > 0.7 * length || 30.0 * band.wavelength() > length {
                        continue;
                    }
                    for place in [0, 1, 3, 5, 10] {
                        let from = f64::from(place) / 10.0 * (length - long);
                        let samples = (1e3 * length) as usize;
                        let record = [burst(samples, band.wavelength(), from, from + long)?];
                        let spectrum = Spectrum::of_record(&record, 1.0)?;
                        let expected = 6.532 + 10.0 * (long / length).log10();
                        let error = spectrum.level(band).unwrap_or(f64::NAN) - expected;
                        worst = worst.max(error.abs());
                    }
                }
            }
        }
        assert!(worst < 1.0, "{worst}");
        Ok(())
    }

    /// A wave in a short stretch beside a long one counts by its length.
    #[test]
    fn short_stretches_count_by_their_length() -> Result<(), Error> {
        let record = [burst(30_000, 0.05, 0.0, 0.0)?, sinusoid(2_000, 0.05)?];
        let spectrum = Spectrum::of_record(&record, 2.0)?;
        let level = spectrum.level(ThirdOctave::containing(0.05)?);
        assert!((level.unwrap() - (6.532 - 10.0 * 16f64.log10())).abs() < 0.1);
        Ok(())
    }

    #[test]
    fn bands_end_at_a_quarter_of_the_record_and_at_two_samples() -> Result<(), Error> {
        let record = [sinusoid(10_000, 0.1)?];
        let spectrum = Spectrum::of_record(&record, 100.0)?;
        let (first, last) = (spectrum.levels()[0].band, spectrum.levels().last().unwrap().band);
        assert_eq!(first.nominal_millimetres(), 2.5);
        // 2.512 m is longer than a quarter of 10 m.
        assert_eq!(last.nominal_millimetres(), 2000.0);
        assert!(Spectrum::of_record(&[sinusoid(900, 0.1)?], 0.1).is_err());
        assert!(Spectrum::of_record(&[], 0.1).is_err());
        Ok(())
    }
}
