//! Growth under one kind of wheel, in the mean over its speeds.

use rayon::prelude::*;

use super::SpeedDistribution;
use crate::feedback::Loop;

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
    /// Largest change of a rate on halving the step in speed \[-\]; 0 where speeds are listed.
    pub rate_error: f64,
    /// Number of speeds at which the loop was evaluated.
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
    /// Method: see [`SpeedDistribution`]; wavelengths in parallel on the current rayon pool. Cost: one
    /// [`Loop::at`] for each place, wavelength and speed, 65 speeds for a smooth normal
    /// distribution, 1025 at most.
    pub fn compute(
        places: &[(Loop, f64)],
        wavelengths: &[f64],
        speeds: &SpeedDistribution,
    ) -> Self {
        Self::between(&[(speeds.mean(), places)], wavelengths, speeds)
    }

    /// The same for a wheel whose mean state depends on its speed: its loops at some speeds \[m/s\], rising. Between two of them
    /// each counts by its nearness, so that the error is of second order in their distance; beyond the ends the nearest counts.
    ///
    /// Cost: twice that of [`compute`](Self::compute) between speeds.
    pub fn between(
        states: &[(f64, &[(Loop, f64)])],
        wavelengths: &[f64],
        speeds: &SpeedDistribution,
    ) -> Self {
        let means = speeds.means(|speed| {
            let near = near(states, speed);
            wavelengths
                .par_iter()
                .map(|&wavelength| match near {
                    [Some((places, _)), None] | [None, Some((places, _))] => {
                        of_places(places, wavelength, speed)
                    }
                    _ => near
                        .iter()
                        .flatten()
                        .fold([0.0; 2], |mean, (places, share)| {
                            let [rate, force] = of_places(places, wavelength, speed);
                            [mean[0] + share * rate, mean[1] + share * force]
                        }),
                })
                .collect()
        });
        Self {
            rates: means.values.iter().map(|mean| mean[0]).collect(),
            squared_force_per_amplitude: means.values.iter().map(|mean| mean[1]).collect(),
            rate_error: means.error[0],
            speeds: means.speeds,
        }
    }
}

/// The loops of the states on either side of a speed, each with its share; of one state alone, that state.
fn near<'a>(
    states: &[(f64, &'a [(Loop, f64)])],
    speed: f64,
) -> [Option<(&'a [(Loop, f64)], f64)>; 2] {
    let above = states.partition_point(|state| state.0 < speed);
    let alone = |state: &(f64, &'a [(Loop, f64)])| [Some((state.1, 1.0)), None];
    match (
        above.checked_sub(1).and_then(|below| states.get(below)),
        states.get(above),
    ) {
        (None, None) => [None, None],
        (Some(state), None) | (None, Some(state)) => alone(state),
        (Some(_), Some(upper)) if upper.0 == speed => alone(upper),
        (Some(lower), Some(upper)) => {
            let share = (speed - lower.0) / (upper.0 - lower.0);
            [Some((lower.1, 1.0 - share)), Some((upper.1, share))]
        }
    }
}

/// Growth rate, and |P₁/Δ|² \[N²/m²\], in the mean over places of the wheel.
fn of_places(places: &[(Loop, f64)], wavelength: f64, speed: f64) -> [f64; 2] {
    let mut mean = [0.0; 2];
    for (feedback, weight) in places {
        let state = feedback.at(wavelength, speed);
        mean[0] += weight * state.growth_rate;
        mean[1] += weight * state.normal_force().norm_sqr() / feedback.amplitude().powi(2);
    }
    mean
}
