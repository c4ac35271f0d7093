//! Displacement of the track under a force that is given from step to step.

use num_complex::Complex64;
use pulp::{Arch, Simd, WithSimd};

use super::ImpulseResponse;
use super::step_weights::Weights;

/// Displacement u(t) = ∫ g(t − τ) f(τ) dτ of a track at rest before, under a force that is linear over every step:
/// exact for g as a sum of decaying oscillations, with one complex number of memory for each. Over discrete supports g is
/// that of the place of the force, linear over every step as well.
#[derive(Debug, Clone)]
pub(super) struct TrackMotion {
    /// Poles p of the terms, and e^{ph} of each.
    poles: Vec<Complex64>,
    decay: Vec<Complex64>,
    /// At equal places over the bay, both ends included, or at one where the track is even.
    places: Vec<AtPlace>,
    /// State of each term at the end of the step, but for the force there.
    states: Vec<Complex64>,
    /// Places to a step, and the place now, counted in them from a support.
    stride: f64,
    place: f64,
}

/// A track with the force at one place.
#[derive(Debug, Clone)]
struct AtPlace {
    /// What the force at the beginning and at the end of a step leaves in the next state, for each term.
    by_force: Vec<Complex64>,
    /// Displacement and speed by the force at the end of the step \[m/N, m/(s N)\].
    by_new_force: f64,
    speed_by_new_force: f64,
    /// Displacement by a steady load, beside its mean over the bay \[m/N\], and its slope \[1/N\].
    sag: f64,
    slope: f64,
}

impl TrackMotion {
    /// Places to a bay: linear between them, the eighth harmonic is right to 5·10⁻³.
    const PLACES: usize = 256;

    /// The track at rest with the force a distance before a support \[m\], for steps of the given time \[s\] at a speed \[m/s\].
    pub(super) fn new(response: &ImpulseResponse, step: f64, speed: f64, distance: f64) -> Self {
        let terms: Vec<(Complex64, Complex64)> = response.terms().collect();
        let weights: Vec<Weights> = terms.iter().map(|(pole, _)| Weights::new(pole * step)).collect();
        let bay = response.bay();
        let last = if bay.is_some() { Self::PLACES } else { 0 };
        let at_place = |index: usize| {
            let mut at = AtPlace {
                by_force: Vec::with_capacity(terms.len()),
                by_new_force: 0.0,
                speed_by_new_force: 0.0,
                sag: 0.0,
                slope: 0.0,
            };
            let place = bay.map(|bay| bay.spacing * index as f64 / Self::PLACES as f64);
            for (term, ((_, mean), Weights { decay, old, new })) in terms.iter().zip(&weights).enumerate() {
                let residue = match (bay, place) {
                    (Some(bay), Some(place)) => mean + bay.residue(term, place),
                    _ => *mean,
                };
                let scale = residue * step;
                at.by_force.push(scale * (decay * new + old));
                at.by_new_force += (scale * new).re;
                // p · new + 1 = (e^{z} − 1)/z
                at.speed_by_new_force += (residue * (old + new)).re;
            }
            if let (Some(bay), Some(place)) = (bay, place) {
                [at.sag, at.slope] = bay.sag(place);
            }
            at
        };
        Self {
            poles: terms.iter().map(|(pole, _)| *pole).collect(),
            decay: weights.iter().map(|weights| weights.decay).collect(),
            places: (0..=last).map(at_place).collect(),
            states: vec![Complex64::ZERO; terms.len()],
            stride: bay.map_or(0.0, |bay| speed * step / bay.spacing * Self::PLACES as f64),
            place: bay.map_or(0.0, |bay| (-distance / bay.spacing).rem_euclid(1.0) * Self::PLACES as f64),
        }
    }

    /// Displacement by the force at the end of a step \[m/N\].
    pub(super) fn by_new_force(&self) -> f64 {
        self.between(|at| at.by_new_force)
    }

    /// Speed by the force at the end of a step \[m/(s N)\].
    pub(super) fn speed_by_new_force(&self) -> f64 {
        self.between(|at| at.speed_by_new_force)
    }

    /// Displacement there by a steady load, beside its mean over the bay \[m/N\].
    pub(super) fn sag(&self) -> f64 {
        self.between(|at| at.sag)
    }

    /// Its slope along the rail \[1/N\].
    pub(super) fn slope_of_sag(&self) -> f64 {
        self.between(|at| at.slope)
    }

    fn between(&self, value: impl Fn(&AtPlace) -> f64) -> f64 {
        let (before, share) = self.before();
        let here = value(&self.places[before]);
        match self.places.get(before + 1) {
            Some(after) => here + share * (value(after) - here),
            None => here,
        }
    }

    /// The place before the force, and its share of the way to the next.
    fn before(&self) -> (usize, f64) {
        let last = self.places.len().saturating_sub(2);
        let before = (self.place as usize).min(last);
        (before, self.place - before as f64)
    }

    /// A step begins with the force at its start; returns the displacement at its end but for the force there \[m\].
    pub(super) fn advance(&mut self, force: f64) -> f64 {
        let [displacement, _] = self.step::<false>(force);
        displacement
    }

    /// Advance a step, with the speed \[m, m/s\].
    pub(super) fn advance_with_speed(&mut self, force: f64) -> [f64; 2] {
        self.step::<true>(force)
    }

    fn step<const SPEED: bool>(&mut self, force: f64) -> [f64; 2] {
        let (before, share) = self.before();
        let after = (before + 1).min(self.places.len() - 1);
        let sums = Arch::new().dispatch(Advance::<SPEED> {
            states: &mut self.states,
            poles: &self.poles,
            decay: &self.decay,
            by_force: [before, after].map(|place| self.places[place].by_force.as_slice()),
            forces: [(1.0 - share) * force, share * force],
        });
        self.place += self.stride;
        // A step is shorter than a bay but for a coarse one.
        if self.place >= Self::PLACES as f64 {
            self.place %= Self::PLACES as f64;
        }
        sums
    }
}

/// Every state decays over the step and takes its share of the force, of which a part counts at either place; their sum, and,
/// where the speed is asked for, that of the states times their poles.
struct Advance<'a, const SPEED: bool> {
    states: &'a mut [Complex64],
    poles: &'a [Complex64],
    decay: &'a [Complex64],
    by_force: [&'a [Complex64]; 2],
    forces: [f64; 2],
}

impl<const SPEED: bool> WithSimd for Advance<'_, SPEED> {
    type Output = [f64; 2];

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> [f64; 2] {
        let (states, last_states) = S::as_mut_simd_c64s(self.states);
        let (poles, last_poles) = S::as_simd_c64s(self.poles);
        let (decay, last_decay) = S::as_simd_c64s(self.decay);
        let [(one, last_one), (other, last_other)] = self.by_force.map(S::as_simd_c64s);
        let forces = self.forces.map(|force| simd.splat_c64s(force.into()));
        let mut sum = simd.splat_c64s(Complex64::ZERO);
        let mut speed = simd.splat_c64s(Complex64::ZERO);
        let steps = decay.iter().zip(one.iter().zip(other)).zip(poles);
        for (state, ((&decay, (&one, &other)), &pole)) in states.iter_mut().zip(steps) {
            let given = simd.mul_add_e_c64s(forces[1], other, simd.mul_e_c64s(forces[0], one));
            *state = simd.mul_add_e_c64s(decay, *state, given);
            sum = simd.add_c64s(sum, *state);
            if SPEED {
                speed = simd.mul_add_e_c64s(pole, *state, speed);
            }
        }
        let (mut sum, mut speed) = (simd.reduce_sum_c64s(sum).re, simd.reduce_sum_c64s(speed).re);
        let steps = last_decay.iter().zip(last_one.iter().zip(last_other)).zip(last_poles);
        for (state, ((decay, (one, other)), pole)) in last_states.iter_mut().zip(steps) {
            *state = decay * *state + one * self.forces[0] + other * self.forces[1];
            sum += state.re;
            speed += (pole * *state).re;
        }
        [sum, speed]
    }
}
