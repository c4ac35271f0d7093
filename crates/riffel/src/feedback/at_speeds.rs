//! A loop at fixed wavelengths and one speed after the other.

use rayon::prelude::*;

use super::Loop;
use super::answers::Answers;
use super::system::System;

/// A loop at some wavelengths, with all that depends on them alone done beforehand; to the last bit that of
/// [`Loop::at`].
pub(crate) struct AtSpeeds<'a> {
    feedback: &'a Loop,
    wavelengths: &'a [f64],
    /// Of as many wavelengths at once as a vector register holds; none where the loop has a closed form.
    groups: Option<(System, Vec<Answers>)>,
}

impl<'a> AtSpeeds<'a> {
    /// A loop at wavelengths \[m\].
    pub(crate) fn new(feedback: &'a Loop, wavelengths: &'a [f64]) -> Self {
        let groups = feedback.closed_form().is_none().then(|| {
            let system = System::new(feedback);
            let groups = wavelengths.par_chunks(system.lanes());
            let groups = groups.map(|group| system.answers(feedback, group));
            let groups = groups.collect();
            (system, groups)
        });
        Self {
            feedback,
            wavelengths,
            groups,
        }
    }

    /// Growth rate per passage \[-\] and |P₁/Δ|² \[N²/m²\] of the first contact, by wavelength, at a speed \[m/s\].
    pub(crate) fn at(&self, speed: f64) -> Vec<[f64; 2]> {
        let square = self.feedback.amplitude().powi(2);
        let Some((system, groups)) = &self.groups else {
            let wavelengths = self.wavelengths.par_iter();
            return wavelengths
                .map(|&wavelength| {
                    let state = self.feedback.at(wavelength, speed);
                    [state.growth_rate, state.normal_force().norm_sqr() / square]
                })
                .collect();
        };
        let rate = self.feedback.growth_rate_per_dissipation();
        groups
            .par_iter()
            .map_init(
                || system.clone(),
                |system, group| {
                    system.turn(self.feedback, group, speed);
                    let lanes = 0..group.wavelengths().len();
                    let of_lane = |lane| {
                        let growth = rate * system.normalized_dissipation(lane).re;
                        let force = system.first_normal_force(self.feedback, lane);
                        [growth, force.norm_sqr() / square]
                    };
                    lanes.map(of_lane).collect::<Vec<_>>()
                },
            )
            .flatten_iter()
            .collect()
    }
}
