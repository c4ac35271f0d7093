//! Growth under one kind of wheel, in the mean over its speeds.

use rayon::prelude::*;

use super::{LINES_PER_BAND, SpeedDistribution};
use crate::feedback::{AtSpeeds, Loop};

/// Growth rate and normal force by wavelength, in the mean over a distribution of speeds and over the
/// places of the wheel on the track.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct MeanGrowth {
    /// Growth rate of the amplitude per passage \[-\], by wavelength.
    pub rates: Vec<f64>,
    /// Mean of |P₁/Δ|² \[N²/m²\], by wavelength: the normal force that a profile of amplitude Δ excites.
    pub squared_force_per_amplitude: Vec<f64>,
    /// Largest change of a rate on halving the step in speed for the last time \[-\]; 0 where speeds are listed.
    pub rate_error: f64,
    /// Number of speeds at which the loop was evaluated: the most of a band.
    pub speeds: usize,
}

impl MeanGrowth {
    /// The means at some wavelengths \[m\] for a loop, or for the loops of a wheel at several places along
    /// the track with weights that sum to one, such as [`Bay::places`](crate::growth::Bay::places).
    ///
    /// A passage at the speed V multiplies the amplitude by exp g(λ, V). Many passages at different speeds
    /// multiply it by exp of the sum, so that the arithmetic mean of g is the rate of the mix, in whatever
    /// order the wheels come.
    ///
    /// Method: see [`SpeedDistribution`]; bands of 16 wavelengths in parallel on the current rayon pool, each at as many
    /// speeds as it needs. Cost: one turn of the loop for each place, wavelength and speed, 65 speeds for a smooth normal
    /// distribution, 1025 at most; what the wheels answer is asked once for all places.
    pub fn compute(places: &[(Loop, f64)], wavelengths: &[f64], speeds: &SpeedDistribution) -> Self {
        Self::between(&[(speeds.mean(), places)], wavelengths, speeds)
    }

    /// Means for a wheel whose mean state depends on its speed: its loops at some speeds \[m/s\], rising. Between two of them
    /// each counts by its nearness, so that the error is of second order in their distance; beyond the ends the nearest counts.
    ///
    /// Cost: twice that of [`compute`](Self::compute) between speeds.
    pub fn between(states: &[(f64, &[(Loop, f64)])], wavelengths: &[f64], speeds: &SpeedDistribution) -> Self {
        let bands = wavelengths.par_chunks(LINES_PER_BAND).map(|lines| {
            let states = states.iter();
            let states = states.map(|(at, places)| (*at, AtSpeeds::new(places, lines))).collect::<Vec<_>>();
            (lines.len(), states)
        });
        let means = speeds.means(bands.collect::<Vec<_>>(), |(lines, states), speed| {
            let mut means = vec![[0.0; 2]; *lines];
            for (index, share) in near(states, speed) {
                for (mean, [rate, force]) in means.iter_mut().zip(states[index].1.at(speed)) {
                    mean[0] += share * rate;
                    mean[1] += share * force;
                }
            }
            means
        });
        Self {
            rates: means.values.iter().map(|mean| mean[0]).collect(),
            squared_force_per_amplitude: means.values.iter().map(|mean| mean[1]).collect(),
            rate_error: means.error[0],
            speeds: means.speeds,
        }
    }
}

/// Which states stand on either side of a speed, each with its share; of one state alone, that state.
pub(super) fn near<T>(states: &[(f64, T)], speed: f64) -> Vec<(usize, f64)> {
    let above = states.partition_point(|state| state.0 < speed);
    match (above.checked_sub(1), states.get(above)) {
        (None, None) => Vec::new(),
        (Some(below), None) => vec![(below, 1.0)],
        (None, Some(_)) => vec![(above, 1.0)],
        (Some(_), Some(upper)) if upper.0 == speed => vec![(above, 1.0)],
        (Some(below), Some(upper)) => {
            let share = (speed - states[below].0) / (upper.0 - states[below].0);
            vec![(below, 1.0 - share), (above, share)]
        }
    }
}
