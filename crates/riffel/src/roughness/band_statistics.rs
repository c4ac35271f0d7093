//! What a band of wavelengths does along the rail.

use std::ops::Range;

use rayon::prelude::*;

use super::{WavelengthBand, moving_peak_to_peak, moving_rms};

/// Windows that one task looks at.
const CHUNK: usize = 1 << 16;

/// Statistics of one stretch in one band.
#[derive(Debug, Clone, PartialEq)]
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
}

/// Samples around which the moving RMS is over a limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Exceedance {
    /// The middles of these windows.
    pub samples: Range<usize>,
    /// The largest moving RMS \[m\].
    pub rms_max: f64,
}

impl BandStatistics {
    /// Statistics of heights in one band \[m\], as [`BandPass::filter`](super::BandPass::filter) gives
    /// them.
    ///
    /// The moving RMS belongs to the middle of its window of `window` samples, at most all; the first
    /// and last value hold to the ends. `limit` is that of the moving RMS \[m\], `block` the number of
    /// samples of a block, `margin` the number at either end that peak-to-peak values leave out: there the
    /// band-pass knows only one side. Cost: some ten nanoseconds a sample; parallel.
    pub fn new(
        band: WavelengthBand,
        heights: &[f64],
        window: usize,
        limit: Option<f64>,
        block: usize,
        margin: usize,
    ) -> Self {
        let window = window.clamp(1, heights.len().max(1));
        let windows = (heights.len() + 1).saturating_sub(window);
        let starts: Vec<usize> = (0..windows).step_by(CHUNK).collect();
        let parts: Vec<Part> = starts
            .into_par_iter()
            .map(|start| {
                let end = (start + CHUNK).min(windows);
                Part::new(&heights[start..end + window - 1], window, limit, start)
            })
            .collect();
        let block_rms: Vec<f64> = heights
            .par_chunks(block.max(1))
            .map(|block| mean_square(block).sqrt())
            .collect();
        // Sums of blocks, in their order.
        let sum: f64 = heights
            .chunks(block.max(1))
            .zip(&block_rms)
            .map(|(block, rms)| block.len() as f64 * rms * rms)
            .sum();
        let largest = |value: fn(&Part) -> f64| parts.iter().map(value).fold(0.0, f64::max);
        let moving_rms_max = largest(|part| part.rms_max);
        let over = parts.into_iter().flat_map(|part| part.over);
        Self {
            band,
            samples: heights.len(),
            window,
            mean_square: sum / heights.len().max(1) as f64,
            moving_rms_max,
            peak_to_peak_max: peak_to_peak_max(heights, window, margin),
            exceedances: placed(over, windows, window, heights.len()),
            block_rms,
        }
    }

    /// Samples over the limit.
    pub fn samples_over_limit(&self) -> usize {
        self.exceedances.iter().map(|over| over.samples.len()).sum()
    }
}

/// Windows that begin in one chunk.
struct Part {
    rms_max: f64,
    /// By the first sample of the window.
    over: Vec<Exceedance>,
}

impl Part {
    fn new(heights: &[f64], window: usize, limit: Option<f64>, start: usize) -> Self {
        let rms = moving_rms(heights, window);
        let mut over: Vec<Exceedance> = Vec::new();
        if let Some(limit) = limit {
            for (index, &rms) in rms.iter().enumerate().filter(|(_, rms)| **rms > limit) {
                let index = start + index;
                match over.last_mut() {
                    Some(run) if run.samples.end == index => {
                        run.samples.end += 1;
                        run.rms_max = run.rms_max.max(rms);
                    }
                    _ => over.push(Exceedance {
                        samples: index..index + 1,
                        rms_max: rms,
                    }),
                }
            }
        }
        Self {
            rms_max: rms.iter().copied().fold(0.0, f64::max),
            over,
        }
    }
}

/// Largest moving peak-to-peak value away from the ends, in windows of at most what is left.
fn peak_to_peak_max(heights: &[f64], window: usize, margin: usize) -> f64 {
    let margin = margin.min(heights.len().saturating_sub(1) / 2);
    let inner = &heights[margin..heights.len() - margin];
    let window = window.min(inner.len());
    let windows = (inner.len() + 1).saturating_sub(window);
    let starts: Vec<usize> = (0..windows).step_by(CHUNK).collect();
    starts
        .into_par_iter()
        .map(|start| {
            let end = (start + CHUNK).min(windows);
            let moving = moving_peak_to_peak(&inner[start..end + window - 1], window);
            moving.into_iter().fold(0.0, f64::max)
        })
        .reduce(|| 0.0, f64::max)
}

/// Exceedances by the middle of their windows, joined over the chunks and held to the ends.
fn placed(
    over: impl Iterator<Item = Exceedance>,
    windows: usize,
    window: usize,
    samples: usize,
) -> Vec<Exceedance> {
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
        let end = if run.end == windows {
            samples
        } else {
            run.end + middle
        };
        let start = if run.start == 0 {
            0
        } else {
            run.start + middle
        };
        *run = start..end;
    }
    joined
}

fn mean_square(heights: &[f64]) -> f64 {
    heights.iter().map(|height| height * height).sum::<f64>() / heights.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: WavelengthBand = WavelengthBand::GRINDING[1];

    /// Alternating heights of ±a: every RMS is a, every peak-to-peak value 2a.
    fn alternating(samples: usize, amplitude: impl Fn(usize) -> f64) -> Vec<f64> {
        (0..samples)
            .map(|i| {
                if i % 2 == 0 {
                    amplitude(i)
                } else {
                    -amplitude(i)
                }
            })
            .collect()
    }

    #[test]
    fn statistics_of_one_amplitude() {
        let heights = alternating(200_000, |_| 2e-6);
        let statistics = BandStatistics::new(BAND, &heights, 1000, Some(3e-6), 10_000, 100);
        assert!((statistics.mean_square.sqrt() - 2e-6).abs() < 1e-15);
        assert!((statistics.moving_rms_max - 2e-6).abs() < 1e-15);
        assert_eq!(statistics.peak_to_peak_max, 4e-6);
        assert_eq!(statistics.block_rms.len(), 20);
        assert_eq!(statistics.samples_over_limit(), 0);
        let all = BandStatistics::new(BAND, &heights, 1000, Some(1e-6), 10_000, 100);
        assert_eq!(all.samples_over_limit(), 200_000);
        assert_eq!(all.exceedances.len(), 1);
    }

    /// A stretch of 10 µm from 60 000 to 80 000, over the edge of a chunk: a window is over 4 µm while
    /// 16 % of it lies inside.
    #[test]
    fn exceedances_are_where_the_windows_have_their_middles() {
        let heights = alternating(200_000, |i| {
            if (60_000..80_000).contains(&i) {
                10e-6
            } else {
                0.0
            }
        });
        let statistics = BandStatistics::new(BAND, &heights, 1001, Some(4e-6), 10_000, 100);
        let [over] = &statistics.exceedances[..] else {
            panic!("{:?}", statistics.exceedances);
        };
        // 1001 × 0.16 = 160.2: 161 samples inside.
        assert_eq!(over.samples, 60_000 + 161 - 501..80_000 - 161 + 501);
        assert!((over.rms_max - 10e-6).abs() < 1e-15);
    }

    #[test]
    fn a_window_longer_than_the_stretch_is_the_stretch() {
        let statistics =
            BandStatistics::new(BAND, &alternating(50, |_| 1e-6), 1000, Some(0.0), 7, 60);
        assert_eq!(statistics.window, 50);
        assert_eq!(statistics.samples_over_limit(), 50);
        assert_eq!(statistics.block_rms.len(), 8);
    }
}
