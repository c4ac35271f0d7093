//! A wheel at fixed wavelengths and one speed after the other.

use std::sync::Arc;

use super::{ClosedForm, Derivatives, LineGroup, Loop};

/// The loops of a wheel at places along the track, at some wavelengths, with all that depends on these alone done beforehand; to
/// the last bit those of [`Loop::at`] where wear is alone.
pub(crate) enum AtSpeeds {
    /// Of as many wavelengths at once as a vector register holds.
    Groups(Vec<LineGroup>),
    /// Loops of which one has a closed form, by wavelength.
    Single(Vec<(f64, Vec<AtPlace>)>),
}

/// A loop at one wavelength, with its weight.
pub(crate) struct AtPlace {
    feedback: AtWavelength,
    weight: f64,
}

enum AtWavelength {
    /// In closed form with the derivatives of its contact.
    Closed(Box<(Arc<ClosedForm>, Derivatives)>),
    General(Loop),
}

impl AtSpeeds {
    /// Loops with their weights at wavelengths \[m\].
    pub(crate) fn new(places: &[(Loop, f64)], wavelengths: &[f64]) -> Self {
        if let Some(groups) = LineGroup::all(places, wavelengths) {
            return Self::Groups(groups);
        }
        let single = wavelengths.iter().map(|&wavelength| {
            let places = places.iter().map(|(feedback, weight)| AtPlace {
                feedback: match feedback.closed_form() {
                    Some(closed) => {
                        let derivatives = closed.contact.derivatives(wavelength);
                        AtWavelength::Closed(Box::new((closed.clone(), derivatives)))
                    }
                    None => AtWavelength::General(feedback.clone()),
                },
                weight: *weight,
            });
            (wavelength, places.collect())
        });
        Self::Single(single.collect())
    }

    /// Growth rate per passage \[-\] and |P₁/Δ|² \[N²/m²\] of the first contact, by wavelength, at a speed \[m/s\]; means over
    /// the places.
    pub(crate) fn at(&mut self, speed: f64) -> Vec<[f64; 2]> {
        match self {
            Self::Groups(groups) => groups.iter_mut().flat_map(|group| group.at(speed)).collect(),
            Self::Single(single) => {
                let mean = |(wavelength, places): &(f64, Vec<AtPlace>)| {
                    places.iter().fold([0.0; 2], |mean, place| {
                        let [growth, force] = place.at(*wavelength, speed);
                        [mean[0] + place.weight * growth, mean[1] + place.weight * force]
                    })
                };
                single.iter().map(mean).collect()
            }
        }
    }
}

impl AtPlace {
    fn at(&self, wavelength: f64, speed: f64) -> [f64; 2] {
        let (growth, force, amplitude) = match &self.feedback {
            AtWavelength::Closed(at) => {
                let (closed, derivatives) = &**at;
                let (dissipation, force) = closed.dissipation_and_force(derivatives, wavelength, speed);
                (closed.growth_rate(dissipation), force, closed.amplitude)
            }
            AtWavelength::General(feedback) => {
                let state = feedback.at(wavelength, speed);
                let force = state.normal_force();
                (state.growth_rate, force, feedback.amplitude())
            }
        };
        [growth, force.norm_sqr() / amplitude.powi(2)]
    }
}
