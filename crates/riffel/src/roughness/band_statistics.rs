//! What a band of wavelengths does along the rail.

use std::ops::Range;

use super::band_pass::Section;
use super::curvature::runs;
use super::moving::moving_mean_squares;
use super::{BandPass, Profile, WavelengthBand, largest_peak_to_peak};
use crate::Error;

/// Statistics of one stretch in one band.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct BandStatistics {
    /// The band.
    pub band: WavelengthBand,
    /// Number of samples.
    pub samples: usize,
    /// Samples of the moving window.
    pub window: usize,
    /// Mean square of the whole stretch \[m²\].
    pub mean_square: f64,
    /// Largest moving RMS \[m\].
    pub moving_rms_max: f64,
    /// Largest moving peak-to-peak value \[m\].
    pub peak_to_peak_max: f64,
    /// Where the moving RMS is over the limit.
    pub exceedances: Vec<Exceedance>,
    /// RMS of consecutive blocks \[m\]; the last may be shorter.
    pub block_rms: Vec<f64>,
    /// The largest moving RMS \[m\] of windows with their middle in each block; that of the nearest window
    /// where there is none.
    pub block_moving_rms_max: Vec<f64>,
}

/// Samples around which the moving RMS is over a limit.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Exceedance {
    /// The middles of these windows.
    pub samples: Range<usize>,
    /// The largest moving RMS \[m\].
    pub rms_max: f64,
}

/// What the statistics of one band are to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandSettings {
    /// The band.
    pub band: WavelengthBand,
    /// Samples of the moving window.
    pub window: usize,
    /// Limit of the moving RMS \[m\].
    pub limit: Option<f64>,
    /// Samples of a block.
    pub block: usize,
    /// Samples at either end that peak-to-peak values leave out: there the band-pass knows only one side.
    pub margin: usize,
}

impl BandStatistics {
    /// Statistics of a profile in each of some bands.
    ///
    /// The moving RMS belongs to the middle of its window, at most all of the profile; the first and last
    /// value hold to the ends. Filtered heights are looked at section by section and not kept. Cost: that
    /// of [`BandPass::filter`] and some five nanoseconds a sample and band; parallel.
    ///
    /// # Errors
    /// Errors of [`BandPass::new`].
    pub fn of_profile(profile: &Profile, settings: &[BandSettings]) -> Result<Vec<Self>, Error> {
        let samples = profile.heights().len();
        let bands: Vec<WavelengthBand> = settings.iter().map(|settings| settings.band).collect();
        let bank = BandPass::new(profile.spacing(), samples, &bands)?;
        let longest = settings.iter().map(|settings| settings.window).max();
        let overlap = longest.unwrap_or(1).clamp(1, samples) - 1;
        let mut parts: Vec<Vec<Part>> = settings.iter().map(|_| Vec::new()).collect();
        let sections = bank.sections(profile, overlap, |index, section| Part::new(&section, samples, &settings[index]));
        for (band, part) in sections {
            parts[band].push(part);
        }
        let each = settings.iter().zip(parts);
        Ok(each.map(|(settings, parts)| Self::joined(parts, samples, settings)).collect())
    }

    fn joined(parts: Vec<Part>, samples: usize, settings: &BandSettings) -> Self {
        let window = settings.window.clamp(1, samples.max(1));
        let block = settings.block.max(1);
        let mut squares = vec![0.0; samples.div_ceil(block)];
        for (index, sum) in parts.iter().flat_map(|part| &part.squares) {
            squares[*index] += sum;
        }
        let largest = |value: fn(&Part) -> f64| parts.iter().map(value).fold(0.0, f64::max);
        let (moving_rms_max, peak_to_peak_max) =
            (largest(|part| part.mean_square_max).sqrt(), largest(|part| part.peak_to_peak_max));
        let mut highest = vec![None; squares.len()];
        for (index, square) in parts.iter().flat_map(|part| &part.moving) {
            let own: &mut Option<f64> = &mut highest[*index];
            *own = Some(own.map_or(*square, |own| larger(own, *square)));
        }
        let over = parts.into_iter().flat_map(|part| part.over);
        Self {
            band: settings.band,
            samples,
            window,
            mean_square: squares.iter().sum::<f64>() / samples.max(1) as f64,
            moving_rms_max,
            peak_to_peak_max,
            exceedances: placed(over, samples + 1 - window, window, samples),
            block_rms: squares
                .iter()
                .enumerate()
                .map(|(index, sum)| (sum / block.min(samples - index * block) as f64).sqrt())
                .collect(),
            block_moving_rms_max: held(&highest),
        }
    }

    /// Samples over the limit.
    pub fn samples_over_limit(&self) -> usize {
        self.exceedances.iter().map(|over| over.samples.len()).sum()
    }
}

/// Windows that begin in one section.
struct Part {
    mean_square_max: f64,
    peak_to_peak_max: f64,
    /// By the first sample of the window.
    over: Vec<Exceedance>,
    /// Largest mean squares by block, of windows with their middle there.
    moving: Vec<(usize, f64)>,
    /// Sums of squares by block, of the section's own samples.
    squares: Vec<(usize, f64)>,
}

impl Part {
    /// `samples` is the length of the whole profile.
    fn new(section: &Section<'_>, samples: usize, settings: &BandSettings) -> Self {
        let window = settings.window.clamp(1, samples);
        let Moving { mean_square_max, over, blocks } = Moving::new(section, window, settings);
        let margin = settings.margin.min(samples.saturating_sub(1) / 2);
        let inner = margin..samples - margin;
        Self {
            mean_square_max,
            peak_to_peak_max: largest_peak_to_peak(
                section.windows_within(&inner, window.min(inner.len())),
                window.min(inner.len()),
            ),
            over,
            moving: blocks,
            squares: block_squares(section, settings.block.max(1)),
        }
    }
}

/// What the moving mean square does in a section.
struct Moving {
    mean_square_max: f64,
    over: Vec<Exceedance>,
    blocks: Vec<(usize, f64)>,
}

impl Moving {
    fn new(section: &Section<'_>, window: usize, settings: &BandSettings) -> Self {
        let limit = settings.limit.map_or(f64::INFINITY, |limit| limit * limit);
        let (middle, block) = ((window - 1) / 2, settings.block.max(1));
        let mut found = Self { mean_square_max: 0.0, over: Vec::new(), blocks: Vec::new() };
        let heights = section.windows_within(&(0..usize::MAX), window);
        moving_mean_squares(heights, window, |start, squares| {
            let start = section.start + start;
            let (mut highest, mut from) = (0.0, 0);
            while from < squares.len() {
                let index = (start + from + middle) / block;
                let to = ((index + 1) * block - middle - start).min(squares.len());
                let own = squares[from..to].iter().copied().fold(0.0, larger);
                found.blocks.push((index, own));
                highest = larger(highest, own);
                from = to;
            }
            found.mean_square_max = larger(found.mean_square_max, highest);
            if highest > limit {
                for run in runs(squares.iter().map(|square| *square > limit)) {
                    let highest = squares[run.clone()].iter().copied().fold(0.0, larger);
                    found
                        .over
                        .push(Exceedance { samples: start + run.start..start + run.end, rms_max: highest.sqrt() });
                }
            }
        });
        found
    }
}

/// Roots of mean squares by block, the first and the last held to the ends.
fn held(squares: &[Option<f64>]) -> Vec<f64> {
    let mut last = squares.iter().flatten().next().copied().unwrap_or(0.0);
    let roots = squares.iter().map(|square| {
        last = square.unwrap_or(last);
        last.sqrt()
    });
    roots.collect()
}

/// The larger of two numbers; unlike `max` it takes no time to look for NaN, which a profile never has.
fn larger(one: f64, two: f64) -> f64 {
    if two > one { two } else { one }
}

/// Sums of squares of a section's own samples by block.
fn block_squares(section: &Section<'_>, block: usize) -> Vec<(usize, f64)> {
    let (start, end) = (section.start, section.start + section.own);
    (start / block..end.div_ceil(block))
        .map(|index| {
            let from = (index * block).max(start) - start;
            let to = ((index + 1) * block).min(end) - start;
            let heights = &section.heights[from..to];
            (index, heights.iter().map(|height| height * height).sum())
        })
        .collect()
}

/// Exceedances by the middle of their windows, joined over the chunks and held to the ends.
fn placed(over: impl Iterator<Item = Exceedance>, windows: usize, window: usize, samples: usize) -> Vec<Exceedance> {
    let mut joined: Vec<Exceedance> = Vec::new();
    for next in over {
        match joined.last_mut() {
            Some(run) if run.samples.end == next.samples.start => {
                run.samples.end = next.samples.end;
                run.rms_max = run.rms_max.max(next.rms_max);
            }
            _ => joined.push(next),
        }
    }
    for Exceedance { samples: run, .. } in &mut joined {
        let middle = (window - 1) / 2;
        let end = if run.end == windows { samples } else { run.end + middle };
        let start = if run.start == 0 { 0 } else { run.start + middle };
        *run = start..end;
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: WavelengthBand = WavelengthBand::GRINDING[1];

    /// Alternating heights of ±a: every RMS is a, every peak-to-peak value 2a.
    fn alternating(samples: usize, amplitude: impl Fn(usize) -> f64) -> Vec<f64> {
        (0..samples).map(|i| if i % 2 == 0 { amplitude(i) } else { -amplitude(i) }).collect()
    }

    /// Statistics of heights that no band-pass has touched, in sections of 30 011 samples.
    fn statistics(heights: &[f64], window: usize, limit: Option<f64>, block: usize, margin: usize) -> BandStatistics {
        const OWN: usize = 30_011;
        let settings = BandSettings { band: BAND, window, limit, block, margin };
        let starts = (0..heights.len()).step_by(OWN);
        let parts = starts.map(|start| {
            let section = Section {
                start,
                own: OWN.min(heights.len() - start),
                heights: &heights[start..(start + OWN + window - 1).min(heights.len())],
            };
            Part::new(&section, heights.len(), &settings)
        });
        BandStatistics::joined(parts.collect(), heights.len(), &settings)
    }

    #[test]
    fn statistics_of_one_amplitude() {
        let heights = alternating(200_000, |_| 2e-6);
        let found = statistics(&heights, 1000, Some(3e-6), 10_000, 100);
        assert!((found.mean_square.sqrt() - 2e-6).abs() < 1e-15);
        assert!((found.moving_rms_max - 2e-6).abs() < 1e-15);
        assert_eq!(found.peak_to_peak_max, 4e-6);
        assert_eq!(found.block_rms.len(), 20);
        assert_eq!(found.samples_over_limit(), 0);
        let all = statistics(&heights, 1000, Some(1e-6), 10_000, 100);
        assert_eq!(all.samples_over_limit(), 200_000);
        assert_eq!(all.exceedances.len(), 1);
    }

    /// A stretch of 10 µm from 60 000 to 80 000, over the edge of a chunk: a window is over 4 µm while
    /// 16 % of it lies inside.
    #[test]
    fn exceedances_are_where_the_windows_have_their_middles() {
        let heights = alternating(200_000, |i| if (60_000..80_000).contains(&i) { 10e-6 } else { 0.0 });
        let found = statistics(&heights, 1001, Some(4e-6), 10_000, 100);
        let [over] = &found.exceedances[..] else {
            panic!("{:?}", found.exceedances);
        };
        // 1001 × 0.16 = 160.2: 161 samples inside.
        assert_eq!(over.samples, 60_000 + 161 - 501..80_000 - 161 + 501);
        assert!((over.rms_max - 10e-6).abs() < 1e-15);
        // Blocks of 10 000: the middles of windows reach 500 samples beyond the stretch.
        let highest = &found.block_moving_rms_max;
        assert_eq!(highest.len(), 20);
        let beside = 10e-6 * (500.0f64 / 1001.0).sqrt();
        for (block, expected) in [(4, 0.0), (5, beside), (6, 10e-6), (7, 10e-6), (9, 0.0)] {
            // One sample of a thousand more or less.
            assert!((highest[block] - expected).abs() < 1e-8, "{block} {highest:?}");
        }
    }

    #[test]
    fn a_window_longer_than_the_stretch_is_the_stretch() {
        let found = statistics(&alternating(50, |_| 1e-6), 1000, Some(0.0), 7, 60);
        assert_eq!(found.window, 50);
        assert_eq!(found.samples_over_limit(), 50);
        assert_eq!(found.block_rms.len(), 8);
        assert!(found.block_moving_rms_max.iter().all(|rms| (rms - 1e-6).abs() < 1e-15));
    }
}
