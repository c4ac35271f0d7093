//! A wheel at fixed wavelengths and one speed after the other.

use rayon::prelude::*;

use super::{LineGroup, Loop};

/// The loops of a wheel at places along the track, at some wavelengths, with all that depends on these alone done beforehand; to
/// the last bit those of [`Loop::at`].
pub(crate) struct AtSpeeds<'a> {
    places: &'a [(Loop, f64)],
    wavelengths: &'a [f64],
    /// Of as many wavelengths at once as a vector register holds; none where a loop has a closed form.
    groups: Option<Vec<LineGroup>>,
}

impl<'a> AtSpeeds<'a> {
    /// Loops with their weights at wavelengths \[m\].
    pub(crate) fn new(places: &'a [(Loop, f64)], wavelengths: &'a [f64]) -> Self {
        Self {
            places,
            wavelengths,
            groups: LineGroup::all(places, wavelengths),
        }
    }

    /// Growth rate per passage \[-\] and |P₁/Δ|² \[N²/m²\] of the first contact, by wavelength, at a speed \[m/s\]; means over
    /// the places.
    pub(crate) fn at(&mut self, speed: f64) -> Vec<[f64; 2]> {
        if let Some(groups) = &mut self.groups {
            let groups = groups.par_iter_mut();
            return groups.flat_map_iter(|group| group.at(speed)).collect();
        }
        let mean = |wavelength: &f64| {
            let mut mean = [0.0; 2];
            for (feedback, weight) in self.places {
                let state = feedback.at(*wavelength, speed);
                mean[0] += weight * state.growth_rate;
                mean[1] += weight * state.normal_force().norm_sqr() / feedback.amplitude().powi(2);
            }
            mean
        };
        self.wavelengths.par_iter().map(mean).collect()
    }
}
