//! Displacement and speed of wheels against the rail under forces that are given from step to step.

use num_complex::Complex64;

use super::StructuresInTime;
use super::rail_in_time::RailMotion;
use super::step_weights::Weights;

/// u(t) = ∫ g(t − τ) f(τ) dτ of structures at rest before, and du/dt, under forces that are linear over every step: exact,
/// with one complex number of memory for each term and axis.
#[derive(Debug, Clone)]
pub(super) struct StructuresMotion<'a> {
    structures: &'a StructuresInTime,
    /// \[s\]
    step: f64,
    /// e^{ph} of each term, and what the forces at the beginning and at the end of a step leave in the next state.
    decay: Vec<Complex64>,
    by_force: Vec<Complex64>,
    /// Of each term and axis, at the end of the step but for the force there.
    states: Vec<Complex64>,
    /// ∫f dt and ∬f dt² of each axis, likewise.
    once: Vec<f64>,
    twice: Vec<f64>,
    /// Displacement and speed by the forces at the end of a step, by rows \[m/N, m/(s N)\].
    pub(super) by_new_force: [Vec<f64>; 2],
    /// The rail where it is fitted by itself, and `by_new_force` without it.
    rail: Option<(RailMotion<'a>, [Vec<f64>; 2])>,
}

impl<'a> StructuresMotion<'a> {
    /// At rest under mean forces \[N\], for steps of the given time \[s\] at a speed \[m/s\], on discrete supports with the first
    /// wheel a distance before one of them \[m\].
    pub(super) fn new(
        structures: &'a StructuresInTime,
        mean: Vec<f64>,
        step: f64,
        speed_along: f64,
        distance: f64,
    ) -> Self {
        let size = structures.size();
        let count = structures.terms().count();
        let mut displacement = vec![0.0; size * size];
        let mut speed = vec![0.0; size * size];
        let (mut decays, mut by_force) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (pole, residues) in structures.terms() {
            let z = pole * step;
            let Weights { decay, old, new } = Weights::new(z);
            // p · new + 1 = (e^{z} − 1)/z
            let constant = old + new;
            for ((displacement, speed), residue) in displacement.iter_mut().zip(&mut speed).zip(residues) {
                *displacement += (residue * new * step).re;
                *speed += (residue * constant).re;
            }
            by_force.push(step * (decay * new + old));
            decays.push(decay);
        }
        for ((displacement, speed), free) in displacement.iter_mut().zip(&mut speed).zip(structures.free()) {
            *displacement += free * step * step / 6.0;
            *speed += free * step / 2.0;
        }
        let mut by_new_force = [displacement, speed];
        let rail = structures.rail();
        let rail = rail.map(|rail| {
            let rail = RailMotion::new(rail, mean, step, speed_along, distance);
            let without = by_new_force.clone();
            rail.set_by_new_force(&mut by_new_force, &without);
            (rail, without)
        });
        Self {
            structures,
            step,
            rail,
            decay: decays,
            by_force,
            states: vec![Complex64::ZERO; count * size],
            once: vec![0.0; size],
            twice: vec![0.0; size],
            by_new_force,
        }
    }

    /// A step begins with the forces at its start; displacement and speed at its end, but for the forces there.
    pub(super) fn advance(&mut self, forces: &[f64], displacement: &mut [f64], speed: &mut [f64]) {
        let (size, h) = (self.structures.size(), self.step);
        for ((once, twice), force) in self.once.iter_mut().zip(&mut self.twice).zip(forces) {
            // Of the force at the beginning h/2 and h²/3, and of that at the end, taken in with the next step, h/2 and h²/6.
            *twice += h * *once + h * h * force / 3.0;
            *once += h * force / 2.0;
        }
        for (row, (displacement, speed)) in displacement.iter_mut().zip(&mut *speed).enumerate() {
            let free = &self.structures.free()[row * size..][..size];
            let sum = |integrals: &[f64]| -> f64 { free.iter().zip(integrals).map(|(a, b)| a * b).sum() };
            (*displacement, *speed) = (sum(&self.twice), sum(&self.once));
        }
        let states = self.states.chunks_exact_mut(size);
        let steps = self.decay.iter().zip(&self.by_force);
        for ((states, (decay, by_force)), (pole, residues)) in states.zip(steps).zip(self.structures.terms()) {
            for (state, force) in states.iter_mut().zip(forces) {
                *state = decay * *state + by_force * force;
            }
            let rows = residues.chunks_exact(size);
            for ((displacement, speed), row) in displacement.iter_mut().zip(&mut *speed).zip(rows) {
                let mut sum = Complex64::ZERO;
                for (residue, state) in row.iter().zip(&*states) {
                    sum += residue * state;
                }
                *displacement += sum.re;
                *speed += (pole * sum).re;
            }
        }
        if let Some((rail, without)) = &mut self.rail {
            rail.advance(forces, displacement, speed);
            if self.structures.support_spacing().is_some() {
                rail.set_by_new_force(&mut self.by_new_force, without);
            }
        }
    }

    /// The step ends with these forces.
    pub(super) fn end(&mut self, forces: &[f64]) {
        let h = self.step;
        for ((once, twice), force) in self.once.iter_mut().zip(&mut self.twice).zip(forces) {
            *twice += h * h * force / 6.0;
            *once += h * force / 2.0;
        }
    }
}
