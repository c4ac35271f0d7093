//! A piece of a run that is divided by the transfer at once.

use std::f64::consts::FRAC_PI_2;

use num_complex::Complex64;
use riffel_numerics::cubic::cubic;

use super::transforms::{backward, forward, length};
use super::{AxleBoxTransfer, Inverse, PatchAverageProfile, RunSettings};
use crate::Error;
use crate::roughness::{Profile, ThirdOctave, WavelengthBand};

/// Samples of roughness in time to one of acceleration, so that cubics between them err by less than 1e-3.
const FINER: usize = 4;
/// Part of the sampling rate up to which a recorder's filter lets accelerations through, and from which nothing is
/// taken.
const PASSED: (f64, f64) = (0.4, 0.48);
/// Ratio of frequencies over which what is let through fades.
pub(super) const FADE: f64 = 1.25;

/// Samples with what lies before and behind them.
pub(super) struct Segment<'a> {
    /// \[m/s²\], upward.
    pub(super) accelerations: &'a [f64],
    /// \[m\], rising.
    pub(super) positions: &'a [f64],
    /// \[m/s\].
    pub(super) speeds: &'a [f64],
    /// Samples at either end that are not its own.
    pub(super) edge: usize,
}

impl Segment<'_> {
    /// The roughness felt; `None` if the segment is shorter than two heights.
    pub(super) fn averaged_profile(
        &self,
        transfer: &AxleBoxTransfer,
        settings: &RunSettings,
    ) -> Result<Option<PatchAverageProfile>, Error> {
        let own = self.edge..self.accelerations.len() - self.edge;
        let speeds = &self.speeds[own.clone()];
        let slowest = speeds.iter().copied().fold(f64::INFINITY, f64::min);
        let fastest = speeds.iter().copied().fold(0.0, f64::max);
        let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
        let rate = settings.sampling_rate;
        let (lowest, highest) = transfer.known();
        let longest = settings.longest.min(fastest / lowest);
        let shortest = settings.shortest.max(fastest / (PASSED.0 * rate).min(highest));
        if 2.0 * shortest > longest {
            return Err(Error::OutOfRange {
                quantity: "sampling rate",
                value: rate,
                unit: "Hz",
                rule: "must be at least five times the highest speed over the longest wavelength",
            });
        }
        // One-third octaves that lie wholly within.
        let edge = 10f64.powf(ThirdOctave::HALF_WIDTH_DECADES);
        let passed = (slowest / (longest * edge), fastest / shortest * edge);
        let stops = (passed.0 / FADE, (passed.1 * FADE).min(PASSED.1 * rate));
        let passed = (passed.0, passed.1.min(PASSED.0 * rate));
        let inverse = Inverse::new(transfer, settings.contact_filter, mean, stops);
        let heights = self.divided(&inverse, rate, stops, passed);
        let spacing = settings.spacing();
        let (start, heights) = self.along(&heights, spacing);
        if heights.len() < 2 {
            return Ok(None);
        }
        Ok(Some(PatchAverageProfile {
            profile: Profile::new(start, spacing, heights)?,
            known: WavelengthBand::new(shortest, longest)?,
            speeds: [slowest, mean, fastest],
        }))
    }

    /// Roughness \[m\] in time, `FINER` times as many as there are accelerations.
    fn divided(&self, inverse: &Inverse, rate: f64, stops: (f64, f64), passed: (f64, f64)) -> Vec<f64> {
        let samples = self.accelerations.len();
        let size = length(samples);
        let mut input = vec![0.0; size];
        let ramp = (self.edge / 2).max(1);
        for (index, (value, acceleration)) in input.iter_mut().zip(self.accelerations).enumerate() {
            let from_end = (index + 1).min(samples - index);
            *value = match from_end < ramp {
                true => acceleration * rising(from_end as f64 / ramp as f64),
                false => *acceleration,
            };
        }
        let lines = forward(&mut input);
        // The line at the highest frequency is beyond the stop.
        let mut fine = vec![Complex64::ZERO; FINER * size / 2 + 1];
        let step = rate / size as f64;
        for (line, (value, found)) in fine.iter_mut().zip(&lines).enumerate() {
            let frequency = line as f64 * step;
            if frequency <= stops.0 || frequency >= stops.1 {
                continue;
            }
            let share = faded(frequency, stops.0, passed.0) * faded(frequency, stops.1, passed.1);
            *value = found * inverse.gain(frequency) * (share / size as f64);
        }
        let mut heights = backward(&mut fine);
        heights.truncate(FINER * samples);
        heights
    }

    /// The first position \[m\] and the heights \[m\] at multiples of a spacing \[m\] on the samples of the segment's own.
    fn along(&self, heights: &[f64], spacing: f64) -> (f64, Vec<f64>) {
        let own = self.edge..self.positions.len() - self.edge;
        let mut number = (self.positions[own.start] / spacing).ceil();
        let start = number * spacing;
        let mut found = Vec::new();
        for index in own.start..own.end.min(self.positions.len() - 1) {
            let (here, next) = (self.positions[index], self.positions[index + 1]);
            while number * spacing < next {
                let share = ((number * spacing - here) / (next - here)).max(0.0);
                found.push(between(heights, FINER as f64 * (index as f64 + share)));
                number += 1.0;
            }
        }
        (start, found)
    }
}

/// From zero at one frequency to one at the other, even in the logarithm.
fn faded(frequency: f64, zero: f64, one: f64) -> f64 {
    if (frequency > one) == (one > zero) {
        return 1.0;
    }
    rising(((frequency / zero).ln() / (one / zero).ln()).clamp(0.0, 1.0))
}

/// From zero to one as a share goes there.
fn rising(share: f64) -> f64 {
    (FRAC_PI_2 * share).sin().powi(2)
}

/// The cubic through the four values about a place among them (Lagrange).
fn between(values: &[f64], place: f64) -> f64 {
    let last = values.len() - 1;
    let at = (place as usize).clamp(1, last - 2);
    cubic([values[at - 1], values[at], values[at + 1], values[at + 2]], place - at as f64)
}
