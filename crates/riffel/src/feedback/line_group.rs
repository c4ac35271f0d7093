//! Growth and normal force at a few wavelengths, in the mean over places of the wheels, speed by speed.

use std::sync::{Arc, Mutex};

use num_complex::Complex64;
use pulp::Arch;

use super::{Answers, Loop, System};
use crate::Place;
use crate::cancel::check;
use crate::receptance::Structure;
use crate::vector::lanes_of;

/// Wavelengths, as many as a vector register holds, under one wheel at several places of the track: what depends on the wavelength
/// or the frequency alone is done once for all places.
pub(crate) struct LineGroup {
    wavelengths: Vec<f64>,
    answers: Answers,
    /// The loop at each place, with its scratch and its weight.
    places: Vec<(Loop, System, f64)>,
}

impl LineGroup {
    /// Groups of the wavelengths \[m\] for the loops of a wheel at places, with their weights; `None` if a loop has a closed form,
    /// which is faster.
    pub(crate) fn all(places: &[(Loop, f64)], wavelengths: &[f64]) -> Option<Vec<Self>> {
        let closed = |(feedback, _): &(Loop, f64)| feedback.is_along_one_axis();
        if places.iter().any(closed) {
            return None;
        }
        let groups = wavelengths.chunks(lanes_of(Arch::new()));
        let groups = groups.map(|wavelengths| {
            let (first, others) = places.split_first()?;
            // A wheel at one place asks for nothing twice.
            let wheels: Arc<dyn Structure> = match others {
                [] => first.0.wheels.clone(),
                _ => Arc::new(Remembered::new(first.0.wheels.clone())),
            };
            let places = places.iter().map(|(feedback, weight)| {
                let feedback = Loop { wheels: wheels.clone(), ..feedback.clone() };
                let system = System::new(&feedback);
                (feedback, system, *weight)
            });
            let places: Vec<(Loop, System, f64)> = places.collect();
            let (feedback, system, _) = places.first()?;
            Some(Self { answers: system.answers(feedback, wavelengths), wavelengths: wavelengths.to_vec(), places })
        });
        groups.collect()
    }

    /// Growth rate per passage \[-\] and |P₁/Δ|² \[N²/m²\] of each wavelength at a speed \[m/s\], in the mean over the places.
    pub(crate) fn at(&mut self, speed: f64) -> impl Iterator<Item = [f64; 2]> + use<> {
        check();
        let mut means = vec![[0.0; 2]; self.wavelengths.len()];
        for (feedback, system, weight) in &mut self.places {
            system.solve(feedback, &self.answers, speed);
            let per_dissipation = feedback.growth_rate_per_dissipation();
            for (lane, (mean, wavelength)) in means.iter_mut().zip(&self.wavelengths).enumerate() {
                let growth = per_dissipation * system.equivalent(feedback, *wavelength, speed, lane).re;
                let force = system.normal_force(feedback, 0, *wavelength, lane);
                mean[0] += *weight * growth;
                mean[1] += *weight * force.norm_sqr() / feedback.amplitude().powi(2);
            }
        }
        means.into_iter()
    }
}

/// A structure that remembers what it answered at its last frequencies, for loops that ask it alike one after the other.
struct Remembered {
    of: Arc<dyn Structure>,
    last: Mutex<Vec<Answered>>,
}

struct Answered {
    at: [f64; 2],
    places: Vec<Place>,
    matrix: Vec<Complex64>,
}

impl Remembered {
    /// Frequencies of a group.
    const MOST: usize = 16;

    fn new(of: Arc<dyn Structure>) -> Self {
        Self { of, last: Mutex::default() }
    }
}

impl Structure for Remembered {
    fn cross_receptance(&self, w: f64, speed: f64, at: Place, from: Place) -> Complex64 {
        self.of.cross_receptance(w, speed, at, from)
    }

    fn free(&self, places: &[Place]) -> Vec<f64> {
        self.of.free(places)
    }

    fn receptance_matrix(&self, w: f64, speed: f64, places: &[Place], matrix: &mut [Complex64]) {
        let asked = [w, speed];
        let Ok(mut last) = self.last.lock() else {
            return self.of.receptance_matrix(w, speed, places, matrix);
        };
        if let Some(known) = last.iter().find(|known| known.at == asked && known.places == places) {
            return matrix.copy_from_slice(&known.matrix);
        }
        self.of.receptance_matrix(w, speed, places, matrix);
        if last.len() == Self::MOST {
            last.remove(0);
        }
        last.push(Answered { at: asked, places: places.to_vec(), matrix: matrix.to_vec() });
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// What is remembered is what the structure answers, in any order of frequencies.
    #[test]
    fn remembers_what_it_was_told() {
        let wheel = crate::receptance::Uncoupled {
            vertical: Some(Arc::new(crate::wheelset::RigidMass::new(350.0).unwrap())),
            ..Default::default()
        };
        let wheel: Arc<dyn Structure> = Arc::new(wheel);
        let remembered = Remembered::new(wheel.clone());
        let places = [Place { along: 0.0, rail: crate::Rail::Right, direction: crate::Direction::Vertical }];
        let [mut one, mut other] = [[Complex64::ZERO]; 2];
        for step in [1, 2, 1, 3, 3, 20, 1, 2].into_iter().chain(4..30).chain([5, 29]) {
            let w = 2.0 * PI * 50.0 * f64::from(step);
            remembered.receptance_matrix(w, 20.0, &places, &mut one);
            wheel.receptance_matrix(w, 20.0, &places, &mut other);
            assert_eq!(one, other, "{step}");
        }
    }
}
