//! The direction of the normal force in time.

use num_complex::Complex64;

use super::step_weights::Weights;

/// Displacement along the rail after impulses P₀r' through the hubs of the wheels and on the rail, see
/// [`NormalDirection`](crate::feedback::NormalDirection): A t + Σ Re(R_j e^{p_j t}) as of all structures, with their poles; by rows over contacts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DirectionInTime {
    pub(super) contacts: usize,
    /// A \[1/kg\].
    pub(super) free: Vec<f64>,
    /// R_j, one for each pole of the structures.
    pub(super) residues: Vec<Vec<Complex64>>,
}

/// The speeds that they leave.
#[derive(Debug, Clone)]
pub(super) struct DirectionMotion<'a> {
    of: &'a DirectionInTime,
    /// \[s\]
    step: f64,
    poles: Vec<Complex64>,
    decay: Vec<Complex64>,
    by_force: Vec<Complex64>,
    by_new_force: Vec<Complex64>,
    /// Of each term and contact, at the end of the step but for the force there.
    states: Vec<Complex64>,
    /// ∫ N dt.
    once: Vec<f64>,
    before: Vec<f64>,
}

impl<'a> DirectionMotion<'a> {
    /// At rest, for steps of the given time \[s\].
    pub(super) fn new(of: &'a DirectionInTime, poles: impl Iterator<Item = Complex64>, step: f64) -> Self {
        let poles: Vec<Complex64> = poles.collect();
        let (mut decays, mut by_force, mut by_new_force) = (Vec::new(), Vec::new(), Vec::new());
        for pole in &poles {
            let Weights { decay, old, new } = Weights::new(pole * step);
            decays.push(decay);
            by_force.push(step * (decay * new + old));
            by_new_force.push(old + new);
        }
        Self {
            of,
            step,
            decay: decays,
            by_force,
            by_new_force,
            states: vec![Complex64::ZERO; poles.len() * of.contacts],
            poles,
            once: vec![0.0; of.contacts],
            before: vec![0.0; of.contacts],
        }
    }

    /// One step on, to these forces \[N\]; the speeds along the rail at its end \[m/s\] are added to those of the contacts, of which three axes
    /// follow each other.
    pub(super) fn advance(&mut self, forces: &[f64], speeds: &mut [f64]) {
        let count = self.of.contacts;
        for ((once, before), now) in self.once.iter_mut().zip(&self.before).zip(forces) {
            *once += 0.5 * self.step * (before + now);
        }
        for (speed, free) in speeds.iter_mut().step_by(3).zip(self.of.free.chunks_exact(count)) {
            *speed += free.iter().zip(&self.once).map(|(a, b)| a * b).sum::<f64>();
        }
        let states = self.states.chunks_exact_mut(count);
        for (term, states) in states.enumerate() {
            for (state, force) in states.iter_mut().zip(&self.before) {
                *state = self.decay[term] * *state + self.by_force[term] * force;
            }
            let rows = self.of.residues[term].chunks_exact(count);
            for (speed, row) in speeds.iter_mut().step_by(3).zip(rows) {
                for ((residue, state), force) in row.iter().zip(&*states).zip(forces) {
                    let own = self.poles[term] * state + self.by_new_force[term] * force;
                    *speed += (residue * own).re;
                }
            }
        }
        self.before.copy_from_slice(forces);
    }
}
