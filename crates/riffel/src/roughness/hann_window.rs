//! Power of parts of a record over wavenumber, each seen through a Hann window.

use std::ops::RangeInclusive;

use rayon::prelude::*;
use riffel_numerics::fourier::Plans;

use super::{Profile, ThirdOctave};
use crate::Error;

/// Shortest record \[m\]: the shortest segment that EN 15610 allows.
pub(super) const SHORTEST_RECORD: f64 = 1.0;
/// Parts whose powers are added before the sums are added, whatever the number of threads.
pub(super) const BATCH: usize = 32;

/// Mean square of each line of the transform, from wavenumber zero upward, summed over parts of `samples` heights with
/// a weight each. Mean and trend are removed, and the window leaves the mean square of a stationary part as it is.
pub(super) fn line_powers(parts: &[(&[f64], f64)], samples: usize) -> Vec<f64> {
    let transform = Plans::default().real_forward(samples);
    let window = window(samples);
    let energy: f64 = window.iter().map(|weight| weight * weight).sum();
    let batches: Vec<Vec<f64>> = parts
        .par_chunks(BATCH)
        .map(|batch| {
            let mut sum = vec![0.0; samples / 2 + 1];
            let mut input = transform.make_input_vec();
            let mut output = transform.make_output_vec();
            let mut scratch = transform.make_scratch_vec();
            for (heights, share) in batch {
                input.copy_from_slice(heights);
                remove_trend(&mut input);
                for (height, weight) in input.iter_mut().zip(&window) {
                    *height *= weight;
                }
                // Fails only for a buffer of another length.
                let transformed = transform.process_with_scratch(&mut input, &mut output, &mut scratch);
                debug_assert!(transformed.is_ok());
                for (sum, line) in sum.iter_mut().zip(&output) {
                    *sum += share * line.norm_sqr();
                }
            }
            sum
        })
        .collect();
    let mut lines = vec![0.0; samples / 2 + 1];
    for batch in &batches {
        for (line, part) in lines.iter_mut().zip(batch) {
            *line += part;
        }
    }
    let scale = 1.0 / (samples as f64 * energy);
    for (index, line) in lines.iter_mut().enumerate() {
        // Negative wavenumbers have the same power; zero and the highest have no counterpart.
        let both = index > 0 && 2 * index != samples;
        *line *= if both { 2.0 * scale } else { scale };
    }
    lines
}

/// The weights of a window of so many samples.
pub(super) fn window(samples: usize) -> Vec<f64> {
    let weight = |index: usize| {
        let phase = std::f64::consts::TAU * index as f64 / samples as f64;
        0.5 - 0.5 * phase.cos()
    };
    (0..samples).map(weight).collect()
}

/// The lines that lie in a band, a distance \[1/m\] apart, each with its share: a line stands for half a step to either
/// side, and where it straddles the edge of a band, each band has its part (EN 15610:2009, Annex C).
pub(super) fn lines_of_band(samples: usize, line_spacing: f64, band: ThirdOctave) -> (RangeInclusive<usize>, Vec<f64>) {
    let (low, high) = band.wavenumber_range();
    let (low, high) = (low / line_spacing, high / line_spacing);
    let lines = low.round() as usize..=(high.round() as usize).min(samples / 2);
    let share = |line: usize| {
        let (from, to) = (line as f64 - 0.5, line as f64 + 0.5);
        (to.min(high) - from.max(low)).max(0.0)
    };
    let shares = lines.clone().map(share).collect();
    (lines, shares)
}

/// Step between two heights and length of the longest stretch \[m\] of one record.
///
/// # Errors
/// [`Error::OutOfRange`] where no stretch is as long as 1 m; [`Error::Measurement`] without a stretch or where their
/// spacings differ.
pub(super) fn spacing_and_longest(stretches: &[Profile]) -> Result<(f64, f64), Error> {
    let Some(first) = stretches.first() else {
        return Err(Error::Measurement { index: 0, rule: "a record must have a stretch without gaps" });
    };
    let spacing = first.spacing();
    let differs = |stretch: &Profile| stretch.spacing() != spacing;
    if let Some(index) = stretches.iter().position(differs) {
        return Err(Error::Measurement { index, rule: "all stretches of a record must have one spacing" });
    }
    let longest = stretches.iter().map(Profile::length).fold(0.0, f64::max);
    // A record of 1000 samples of 1 mm is 0.999 m from its first to its last.
    if longest < SHORTEST_RECORD * (1.0 - 2e-3) {
        return Err(Error::OutOfRange {
            quantity: "longest stretch without gaps",
            value: longest,
            unit: "m",
            rule: "a record must have at least 1 m",
        });
    }
    Ok((spacing, longest))
}

/// Subtract the straight line of least squares.
pub(super) fn remove_trend(heights: &mut [f64]) {
    let count = heights.len() as f64;
    let middle = 0.5 * (count - 1.0);
    let mean = heights.iter().sum::<f64>() / count;
    let places = || (0..heights.len()).map(|index| index as f64 - middle);
    let moment: f64 = places().zip(heights.iter()).map(|(place, height)| place * height).sum();
    // Sum of the squares of the places.
    let slope = moment / (count * (count * count - 1.0) / 12.0);
    for (index, height) in heights.iter_mut().enumerate() {
        *height -= mean + slope * (index as f64 - middle);
    }
}
