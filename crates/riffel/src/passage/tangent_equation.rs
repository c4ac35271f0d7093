//! The creep forces and creepages at the end of a step.

use super::ContactInTime;
use super::late_contact::LateMotion;
use crate::contact::{CreepForces, Creepages};

/// ξ + B (Q(P, ξ) − Q₀) = ξ_known in the plane of contact.
pub(super) struct TangentEquation<'a> {
    pub(super) contact: &'a ContactInTime,
    /// Of a contact that answers late.
    pub(super) late: Option<&'a LateMotion>,
    pub(super) normal_force: f64,
    /// κ of the wave under it.
    pub(super) curvature: f64,
    /// What the wave itself makes of the creep forces \[N\], and of the energy of a late contact \[J/m\].
    pub(super) by_wave: [f64; 2],
    pub(super) energy_of_wave: f64,
    pub(super) known: [f64; 2],
    pub(super) by_force: [[f64; 2]; 2],
}

impl TangentEquation<'_> {
    fn creepages(&self, [longitudinal, lateral]: [f64; 2]) -> Creepages {
        Creepages { longitudinal, lateral, spin: (1.0 + self.curvature) * self.contact.mean.creepages.spin }
    }

    /// Q at the end of the step, if that ends with this creepage.
    pub(super) fn force(&self, creepage: [f64; 2]) -> [f64; 2] {
        if self.normal_force <= 0.0 {
            return [0.0; 2];
        }
        let Some(late) = self.late else {
            let creepages = self.creepages(creepage);
            let force = pair(self.contact.law.forces(self.normal_force, creepages));
            return match self.contact.wave {
                Some(_) => {
                    let change = self.by_wave;
                    self.within_friction([0, 1].map(|axis| force[axis] + change[axis]))
                }
                None => force,
            };
        };
        let slip = creepage[0] / (1.0 + self.curvature);
        let (load, along) = late.for_force(self.contact, self.normal_force, slip);
        let [along, across] = self.steady_force(load, [along, creepage[1]]);
        self.within_friction([along + self.by_wave[0], across])
    }

    /// A creep force, no larger than friction.
    fn within_friction(&self, force: [f64; 2]) -> [f64; 2] {
        let (size, bound) = (force[0].hypot(force[1]), self.contact.law.friction() * self.normal_force);
        match size > bound {
            true => force.map(|force| force * bound / size),
            false => force,
        }
    }

    /// Energy that a metre of the rail receives where the step ends with this creepage and force.
    pub(super) fn energy(&self, creepage: [f64; 2], force: [f64; 2]) -> f64 {
        let (creepage, force) = match self.late {
            None => (creepage, force),
            Some(late) => {
                let slip = creepage[0] / (1.0 + self.curvature);
                let (load, along) = late.for_energy(self.contact, self.normal_force, slip);
                let creepage = [along, creepage[1]];
                (creepage, self.steady_force(load, creepage))
            }
        };
        self.energy_of_wave + creepage[0] * force[0] + creepage[1] * force[1]
    }

    /// Q of the steady law; none without a load.
    fn steady_force(&self, load: f64, creepage: [f64; 2]) -> [f64; 2] {
        match load > 0.0 {
            true => pair(self.contact.law.forces(load, self.creepages(creepage))),
            false => [0.0; 2],
        }
    }

    fn missed(&self, creepage: [f64; 2], force: [f64; 2]) -> [f64; 2] {
        let mean = pair(self.contact.mean.forces);
        let beyond = [force[0] - mean[0], force[1] - mean[1]];
        [0, 1].map(|axis| {
            let [a, b] = self.by_force[axis];
            creepage[axis] + a * beyond[0] + b * beyond[1] - self.known[axis]
        })
    }

    /// Broyden's method from a creepage near by and the force there, with the slopes met last, and Newton's where these do not lead there; to 10⁻¹⁰
    /// of the creepage, or until a step is 10⁻⁴ of the change since the time step began: it leaves 10⁻³ of itself. Returns creepage and
    /// force.
    pub(super) fn solve(
        &self,
        before: [f64; 2],
        near: [f64; 2],
        force: [f64; 2],
        slopes: &mut Slopes,
    ) -> ([f64; 2], [f64; 2]) {
        const STEPS: usize = 60;
        const SMALL: f64 = 1e-10;
        const SHORT: f64 = 1e-4;
        /// Steps with old slopes.
        const PATIENCE: usize = 6;
        let square = |[a, b]: [f64; 2]| a * a + b * b;
        // What the known creepages, tiny as they may be, are told to.
        let enough = SMALL * SMALL * (square(self.known) + 1e-12);
        let (mut creepage, mut force) = (near, force);
        let mut missed = self.missed(creepage, force);
        for count in 0..STEPS {
            if square(missed) <= enough {
                break;
            }
            if count >= PATIENCE {
                *slopes = self.slopes(creepage);
            }
            let step = self.newton_step(missed, slopes).map(|step| -step);
            let moved = [creepage[0] - before[0], creepage[1] - before[1]];
            if square(step) <= SHORT * SHORT * square(moved) {
                let change = slopes.change(step);
                creepage = [creepage[0] + step[0], creepage[1] + step[1]];
                force = [force[0] + change[0], force[1] + change[1]];
                break;
            }
            let mut share = 1.0;
            loop {
                let change = step.map(|step| share * step);
                let next = [creepage[0] + change[0], creepage[1] + change[1]];
                let force_there = self.force(next);
                let left = self.missed(next, force_there);
                if count < PATIENCE {
                    slopes.learn(change, [0, 1].map(|axis| force_there[axis] - force[axis]));
                }
                if square(left) < square(missed) || count < PATIENCE || share < 1e-4 {
                    (creepage, force, missed) = (next, force_there, left);
                    break;
                }
                share *= 0.5;
            }
        }
        (creepage, force)
    }

    /// (1 + B dQ/dξ)⁻¹ of what is missed.
    fn newton_step(&self, missed: [f64; 2], Slopes(slopes): &Slopes) -> [f64; 2] {
        let [[a, b], [c, d]] = [0, 1].map(|axis| {
            let [along, across] = self.by_force[axis];
            let mut row = [0, 1].map(|to| along * slopes[0][to] + across * slopes[1][to]);
            row[axis] += 1.0;
            row
        });
        let determinant = a * d - b * c;
        if determinant.abs() <= f64::MIN_POSITIVE {
            return missed;
        }
        let inverse = determinant.recip();
        [(d * missed[0] - b * missed[1]) * inverse, (a * missed[1] - c * missed[0]) * inverse]
    }

    /// dQ/dξ of the steady law.
    fn slopes(&self, creepage: [f64; 2]) -> Slopes {
        if self.normal_force <= 0.0 {
            return Slopes::default();
        }
        let creepages = self.creepages(creepage);
        let derivatives = self.contact.law.derivatives(self.normal_force, creepages);
        let [along, across] = [derivatives.by_longitudinal, derivatives.by_lateral].map(pair);
        Slopes([0, 1].map(|axis| [along[axis], across[axis]]))
    }
}

/// dQ/dξ \[N\]: of the force by rows, by the creepage by columns.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Slopes([[f64; 2]; 2]);

impl Slopes {
    /// Change of the force by one of the creepage.
    fn change(&self, creepage: [f64; 2]) -> [f64; 2] {
        self.0.map(|row| row[0] * creepage[0] + row[1] * creepage[1])
    }

    /// The nearest slopes that make of a change of the creepage the change of the force that was met (Broyden 1965).
    fn learn(&mut self, creepage: [f64; 2], force: [f64; 2]) {
        let square = creepage[0] * creepage[0] + creepage[1] * creepage[1];
        if square <= f64::MIN_POSITIVE {
            return;
        }
        let expected = self.change(creepage);
        let along = creepage.map(|creepage| creepage / square);
        for (axis, row) in self.0.iter_mut().enumerate() {
            let missed = force[axis] - expected[axis];
            row[0] += missed * along[0];
            row[1] += missed * along[1];
        }
    }
}

fn pair(forces: CreepForces) -> [f64; 2] {
    [forces.longitudinal, forces.lateral]
}
