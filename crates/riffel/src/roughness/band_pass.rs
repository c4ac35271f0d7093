//! Zero-phase band-pass over bands of wavelength.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::ops::Range;
use std::sync::Arc;

use num_complex::Complex64;
use rayon::prelude::*;
use riffel_numerics::fourier::{ComplexToReal, Plans, RealToComplex};

use super::{Profile, WavelengthBand};
use crate::Error;

/// Half the width of the transition at each edge, in decades of wavelength: a fifth of a decade from
/// pass to stop.
const HALF_TRANSITION: f64 = 0.1;
/// Half the length of the impulse response in longest wavelengths.
const REACH: f64 = 6.0;
/// Part of the reach over which the impulse response is kept as it is.
const FLAT: f64 = 0.6;
/// Blocks of a section at least, and lengths of the overlap that a section has.
const BLOCKS: usize = 4;

/// A bank of zero-phase band-passes that share their transforms.
///
/// Gain over wavenumber k about each edge k₀, with t = lg(k/k₀)/0.1 from −1 to 1:
/// H = cos(π/4 (1 ± sin(π t/2))), one inside, nought outside, −3 dB at the edge. Squares of gains of
/// neighbouring bands add up to one, so mean squares of the bands add up to that of the profile. The
/// response is symmetric, tapered to nothing between 3.6 and six of the longest wavelengths (change of
/// gain below 1 %), and applied by overlapping transforms. At the ends the profile is continued by its
/// mirror image about the straight line it ends with. EN 13231 and trolleys use other filters, often Butterworth's run forward and
/// back, whose edges are less steep.
///
/// Cost: one transform and one inverse for each band, some ten nanoseconds a sample and band; parallel.
pub struct BandPass {
    /// Gains of each band over the lines of a block.
    gains: Vec<Vec<f64>>,
    /// Half the length of the impulse response in samples.
    reach: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

impl BandPass {
    /// Band-passes for profiles of this spacing \[m\] and at least `samples` samples.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where the shortest wavelength of a band, less its transition, is not two
    /// samples long, or the spacing is not above zero.
    pub fn new(spacing: f64, samples: usize, bands: &[WavelengthBand]) -> Result<Self, Error> {
        Error::unless_positive("sample spacing", spacing, "m")?;
        for band in bands {
            if !Self::resolves(*band, spacing) {
                return Err(Error::OutOfRange {
                    quantity: "shortest wavelength of a band",
                    value: band.from(),
                    unit: "m",
                    rule: "must be at least 2.52 sample spacings",
                });
            }
        }
        let longest = bands.iter().map(WavelengthBand::to).fold(0.0, f64::max);
        let reach = ((REACH * longest / spacing).ceil() as usize).min(samples.saturating_sub(1));
        let block = (8 * reach + 8).next_power_of_two();
        let mut plans = Plans::default();
        let (forward, inverse) = (plans.real_forward(block), plans.real_inverse(block));
        let mut bank = Self { gains: Vec::new(), reach, forward, inverse };
        bank.gains = bands.iter().map(|band| bank.tapered(|k| gain(*band, k), spacing)).collect();
        Ok(bank)
    }

    /// Whether samples of this spacing \[m\] tell the shortest waves of a band, transition included, from
    /// others.
    pub fn resolves(band: WavelengthBand, spacing: f64) -> bool {
        band.from() * 10f64.powf(-HALF_TRANSITION) >= 2.0 * spacing
    }

    /// Gains of a response cut to the reach, over the lines of a block and with the scale of the two
    /// transforms in them.
    fn tapered(&self, gain: impl Fn(f64) -> f64, spacing: f64) -> Vec<f64> {
        let block = self.forward.len();
        let mut lines: Vec<Complex64> =
            (0..=block / 2).map(|line| gain(line as f64 / (block as f64 * spacing)).into()).collect();
        let mut response = self.inverse.make_output_vec();
        // Both fail only for buffers of another length, or an imaginary part where there is none.
        let inverted = self.inverse.process(&mut lines, &mut response);
        debug_assert!(inverted.is_ok());
        let taper: Vec<f64> = (0..block)
            .map(|index| index.min(block - index) as f64 / (self.reach as f64 + 1.0))
            .map(|distance| {
                let fallen = ((distance - FLAT) / (1.0 - FLAT)).clamp(0.0, 1.0);
                // Nothing at all where the response must be cut for the blocks to join.
                if fallen < 1.0 { (FRAC_PI_2 * fallen).cos().powi(2) } else { 0.0 }
            })
            .collect();
        for (value, taper) in response.iter_mut().zip(&taper) {
            *value *= taper;
        }
        // An offset passes no band: the taper must not let it.
        let offset = response.iter().sum::<f64>() / taper.iter().sum::<f64>();
        for (value, taper) in response.iter_mut().zip(&taper) {
            *value -= offset * taper;
        }
        let transformed = self.forward.process(&mut response, &mut lines);
        debug_assert!(transformed.is_ok());
        let scale = (block as f64).powi(2).recip();
        lines.iter().map(|line| line.re * scale).collect()
    }

    /// The profile's heights in each band \[m\], as many as the profile has.
    pub fn filter(&self, profile: &Profile) -> Vec<Vec<f64>> {
        let mut filtered = vec![Vec::with_capacity(profile.heights().len()); self.gains.len()];
        for (band, part) in self.sections(profile, 0, |_, section| section.heights.to_vec()) {
            filtered[band].extend(part);
        }
        filtered
    }

    /// What `of` makes of each section of the filtered profile, with the index of its band and in the order
    /// of sections. A section's heights are its own and up to `overlap` of those behind.
    pub(super) fn sections<T: Send>(
        &self,
        profile: &Profile,
        overlap: usize,
        of: impl Fn(usize, Section<'_>) -> T + Sync,
    ) -> Vec<(usize, T)> {
        let samples = profile.heights().len();
        let continued = Continued::new(profile.heights(), self.reach / 3);
        let step = self.forward.len() - 2 * self.reach;
        // Whole blocks, so many that the overlap weighs little.
        let blocks = BLOCKS.max((BLOCKS * overlap).div_ceil(step));
        let own = (blocks * step).saturating_sub(overlap).max(1);
        let starts: Vec<usize> = (0..samples).step_by(own).collect();
        let made: Vec<Vec<(usize, T)>> = starts
            .into_par_iter()
            .map_init(
                || Scratch::new(self),
                |scratch, start| {
                    let end = (start + own + overlap).min(samples);
                    scratch.filter(self, &continued, start..end);
                    let own = own.min(samples - start);
                    let filtered = scratch.filtered.iter().enumerate();
                    filtered
                        .map(|(band, heights)| {
                            let section = Section { start, own, heights };
                            (band, of(band, section))
                        })
                        .collect()
                },
            )
            .collect();
        made.into_iter().flatten().collect()
    }
}

/// Heights of a part of the profile in one band.
pub(super) struct Section<'a> {
    /// Index of the first sample.
    pub(super) start: usize,
    /// Number of samples that are in no other section's own.
    pub(super) own: usize,
    /// The section's own samples, and those behind that its windows reach into \[m\].
    pub(super) heights: &'a [f64],
}

impl Section<'_> {
    /// The samples of all windows that begin in this section and lie within a range.
    pub(super) fn windows_within(&self, range: &Range<usize>, window: usize) -> &[f64] {
        let from = range.start.saturating_sub(self.start);
        let to = (self.own + window - 1).min(range.end.saturating_sub(self.start)).min(self.heights.len());
        self.heights.get(from..to).unwrap_or_default()
    }
}

/// Gain of a band at a wavenumber \[1/m\].
fn gain(band: WavelengthBand, wavenumber: f64) -> f64 {
    edge(wavenumber * band.to()) * edge((wavenumber * band.from()).recip())
}

/// Gain over an edge, from zero to one as the ratio of wavenumbers goes from a tenth of a decade below it to
/// a tenth above.
fn edge(ratio: f64) -> f64 {
    let decades = ratio.log10() / HALF_TRANSITION;
    if decades <= -1.0 {
        return 0.0;
    }
    if decades >= 1.0 {
        return 1.0;
    }
    (FRAC_PI_4 * (1.0 - (FRAC_PI_2 * decades).sin())).cos()
}

/// What one thread needs.
struct Scratch {
    heights: Vec<f64>,
    lines: Vec<Complex64>,
    product: Vec<Complex64>,
    output: Vec<f64>,
    forward: Vec<Complex64>,
    inverse: Vec<Complex64>,
    /// Heights of a section in each band.
    filtered: Vec<Vec<f64>>,
}

impl Scratch {
    fn new(bank: &BandPass) -> Self {
        Self {
            heights: bank.forward.make_input_vec(),
            lines: bank.forward.make_output_vec(),
            product: bank.inverse.make_input_vec(),
            output: bank.inverse.make_output_vec(),
            forward: bank.forward.make_scratch_vec(),
            inverse: bank.inverse.make_scratch_vec(),
            filtered: vec![Vec::new(); bank.gains.len()],
        }
    }

    /// A section, block by block.
    fn filter(&mut self, bank: &BandPass, heights: &Continued<'_>, section: Range<usize>) {
        let reach = bank.reach;
        self.filtered.iter_mut().for_each(Vec::clear);
        for start in section.clone().step_by(bank.forward.len() - 2 * reach) {
            let own = (section.end - start).min(bank.forward.len() - 2 * reach);
            heights.copy(start as isize - reach as isize, &mut self.heights[..own + 2 * reach]);
            self.heights[own + 2 * reach..].fill(0.0);
            // Fails only for buffers of another length.
            let done = bank.forward.process_with_scratch(&mut self.heights, &mut self.lines, &mut self.forward);
            debug_assert!(done.is_ok());
            for (gains, filtered) in bank.gains.iter().zip(&mut self.filtered) {
                for ((product, line), gain) in self.product.iter_mut().zip(&self.lines).zip(gains) {
                    *product = line * gain;
                }
                let done = bank.inverse.process_with_scratch(&mut self.product, &mut self.output, &mut self.inverse);
                debug_assert!(done.is_ok());
                filtered.extend_from_slice(&self.output[reach..reach + own]);
            }
        }
    }
}

/// A profile continued beyond its ends by its mirror image about the straight line it ends with: a trend
/// goes on, and a wave keeps its size.
struct Continued<'a> {
    heights: &'a [f64],
    /// Slopes at the beginning and at the end, a sample.
    slopes: [f64; 2],
}

impl<'a> Continued<'a> {
    /// With slopes of least squares over `length` samples.
    fn new(heights: &'a [f64], length: usize) -> Self {
        let length = length.clamp(2, heights.len());
        let slopes = [&heights[..length], &heights[heights.len() - length..]].map(slope);
        Self { heights, slopes }
    }

    /// Copy heights from a place on, up to one record before or behind.
    fn copy(&self, start: isize, to: &mut [f64]) {
        let within = start >= 0 && start as usize + to.len() <= self.heights.len();
        if within {
            to.copy_from_slice(&self.heights[start as usize..][..to.len()]);
        } else {
            for (index, height) in to.iter_mut().enumerate() {
                *height = self.at(start + index as isize);
            }
        }
    }

    /// Height at a place up to one record before or behind.
    fn at(&self, place: isize) -> f64 {
        let last = self.heights.len() as isize - 1;
        let at = |place: isize| self.heights[place.clamp(0, last) as usize];
        if place < 0 {
            at(-place) + 2.0 * self.slopes[0] * place as f64
        } else if place > last {
            at(2 * last - place) + 2.0 * self.slopes[1] * (place - last) as f64
        } else {
            at(place)
        }
    }
}

/// Slope of the straight line of least squares, a sample.
fn slope(heights: &[f64]) -> f64 {
    let count = heights.len() as f64;
    let middle = 0.5 * (count - 1.0);
    let moment: f64 =
        heights.iter().enumerate().map(|(index, height)| (index as f64 - middle) * (height - heights[0])).sum();
    moment / (count * (count * count - 1.0) / 12.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rms(values: &[f64]) -> f64 {
        (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
    }

    fn profile(samples: usize, height: impl Fn(f64) -> f64) -> Profile {
        let heights = (0..samples).map(|i| height(1e-3 * i as f64)).collect();
        Profile::new(0.0, 1e-3, heights).unwrap()
    }

    /// A wave inside a band passes unchanged, in phase, and leaves the others empty.
    #[test]
    fn a_wave_stays_in_its_band() -> Result<(), Error> {
        let bands = WavelengthBand::GRINDING;
        let bank = BandPass::new(1e-3, 40_000, &bands)?;
        for (own, wavelength) in [(0, 0.017), (1, 0.055), (2, 0.17), (3, 0.55)] {
            let wave = |x: f64| 3e-6 * (std::f64::consts::TAU * x / wavelength + 0.3).sin();
            let profile = profile(40_000, wave);
            for (index, filtered) in bank.filter(&profile).iter().enumerate() {
                // Away from the ends, where the continuation has a kink.
                let inside = 7000..33_000;
                if index == own {
                    let difference: Vec<f64> = inside.map(|i| filtered[i] - profile.heights()[i]).collect();
                    assert!(rms(&difference) < 0.01 * 3e-6, "{wavelength} {}", rms(&difference));
                } else {
                    assert!(rms(&filtered[inside]) < 0.01 * 3e-6, "{wavelength} in {index}");
                }
            }
        }
        Ok(())
    }

    /// Gains at the edges are −3 dB, and squares of neighbours add up to one.
    #[test]
    fn bands_share_what_lies_between_them() {
        let [one, two, ..] = WavelengthBand::GRINDING;
        for k in [25.0f64, 30.0, 1.0 / 0.030, 38.0, 43.0] {
            let sum = gain(one, k).powi(2) + gain(two, k).powi(2);
            assert!((sum - 1.0).abs() < 1e-12, "{k}");
        }
        assert!((gain(one, 1.0 / 0.030).powi(2) - 0.5).abs() < 1e-12);
        assert!(gain(one, 0.0) < 1e-15);
    }

    #[test]
    fn the_taper_hardly_changes_the_gain() -> Result<(), Error> {
        let bank = BandPass::new(1e-3, 40_000, &WavelengthBand::GRINDING)?;
        let block = bank.forward.len() as f64;
        for (band, gains) in WavelengthBand::GRINDING.into_iter().zip(&bank.gains) {
            for (line, tapered) in gains.iter().enumerate() {
                let ideal = gain(band, line as f64 / (block * 1e-3));
                assert!((tapered * block - ideal).abs() < 0.01, "{band:?} {line}");
            }
        }
        Ok(())
    }

    /// A slope of 1 mm/m and an offset leave nothing behind, to the ends.
    #[test]
    fn a_trend_is_not_in_any_band() -> Result<(), Error> {
        let bank = BandPass::new(1e-3, 20_000, &WavelengthBand::GRINDING)?;
        for filtered in bank.filter(&profile(20_000, |x| 5e-3 + 1e-3 * x)) {
            assert!(filtered.iter().all(|height| height.abs() < 1e-12));
        }
        Ok(())
    }

    #[test]
    fn blocks_join_and_short_records_work() -> Result<(), Error> {
        let band = [WavelengthBand::GRINDING[0]];
        // Blocks of 2048 samples with a reach of 180.
        let wave = |x: f64| 1e-6 * (std::f64::consts::TAU * x / 0.02).sin();
        for samples in [400, 5000] {
            let profile = profile(samples, wave);
            let bank = BandPass::new(1e-3, samples, &band)?;
            let filtered = &bank.filter(&profile)[0];
            let middle = samples / 2 - 50..samples / 2 + 50;
            for index in middle {
                assert!((filtered[index] - profile.heights()[index]).abs() < 0.02e-6);
            }
        }
        assert!(BandPass::new(5e-3, 1000, &band).is_err());
        Ok(())
    }
}
