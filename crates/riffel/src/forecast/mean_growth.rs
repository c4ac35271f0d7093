//! Growth under one kind of wheel, in the mean over its speeds.

use rayon::prelude::*;

use super::SpeedDistribution;
use super::speed_distribution::Means;
use crate::feedback::{LineGroup, Loop};

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
    /// turn of the loop for each place, wavelength and speed, 65 speeds for a smooth normal
    /// distribution, 1025 at most; what the wheels answer is asked once for all places.
    pub fn compute(
        places: &[(Loop, f64)],
        wavelengths: &[f64],
        speeds: &SpeedDistribution,
    ) -> Self {
        if let Some(mut groups) = LineGroup::all(places, wavelengths) {
            return Self::of_means(speeds.means(|speed| {
                let groups = groups.par_iter_mut();
                groups.flat_map_iter(|group| group.at(speed)).collect()
            }));
        }
        Self::of_means(speeds.means(|speed| {
            wavelengths
                .par_iter()
                .map(|&wavelength| {
                    let mut mean = [0.0; 2];
                    for (feedback, weight) in places {
                        let state = feedback.at(wavelength, speed);
                        mean[0] += weight * state.growth_rate;
                        mean[1] +=
                            weight * state.normal_force().norm_sqr() / feedback.amplitude().powi(2);
                    }
                    mean
                })
                .collect()
        }))
    }

    fn of_means(means: Means<2>) -> Self {
        Self {
            rates: means.values.iter().map(|mean| mean[0]).collect(),
            squared_force_per_amplitude: means.values.iter().map(|mean| mean[1]).collect(),
            rate_error: means.error[0],
            speeds: means.speeds,
        }
    }
}
