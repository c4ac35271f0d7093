//! The motion of wheels along rails on all axes, step by step.

use super::motion::StructuresMotion;
use super::{ContactInTime, GeneralPassage};
use crate::contact::{CreepForces, Creepages};
use crate::passage::ContactInstant;

/// Wheels under way.
///
/// Over a step all forces are linear in time, and track and wheels move exactly under them; the forces at its end follow from
/// one equation for P and two for Q at each contact in turn, until those of the others change nothing. Second order in the step
/// (test `second_order_on_all_axes`).
#[derive(Clone)]
pub struct GeneralMarch<'a> {
    model: &'a GeneralPassage,
    motion: StructuresMotion<'a>,
    now: Vec<ContactInstant>,
    /// f − f₀ at the contacts and axes.
    forces: Vec<f64>,
    /// Displacements and speeds at the end of the step but for the forces there.
    displacement: Vec<f64>,
    speed: Vec<f64>,
    /// dQ/dξ met last at the contacts.
    slopes: Vec<Slopes>,
    /// Changes of the creepages and of the forces over the last step, at which the next begins.
    drift: Vec<[f64; 2]>,
    force_drift: Vec<f64>,
    /// Scratch: creepages and forces before a step, and heights of the rails under the contacts.
    before: Vec<[f64; 2]>,
    forces_before: Vec<f64>,
    heights: Vec<f64>,
}

impl<'a> GeneralMarch<'a> {
    /// On discrete supports the first wheel begins a distance before one of them \[m\].
    pub(super) fn new(model: &'a GeneralPassage, step: f64, distance: f64) -> Self {
        let size = model.structures.size();
        let mean_forces = model.contacts.iter().flat_map(|contact| {
            let CreepForces {
                longitudinal,
                lateral,
            } = contact.mean.forces;
            [longitudinal, lateral, contact.spring.normal_force()]
        });
        let at_rest = |contact: &ContactInTime| {
            let (mean, forces) = (contact.mean.creepages, contact.mean.forces);
            let energy = contact.mean.energy_per_metre();
            ContactInstant {
                normal_force: contact.spring.normal_force(),
                tangential_force: forces.longitudinal,
                lateral_force: forces.lateral,
                creepage: mean.longitudinal,
                lateral_creepage: mean.lateral,
                approach: contact.spring.approach(),
                energy_at_rail: energy,
            }
        };
        Self {
            motion: StructuresMotion::new(
                &model.structures,
                mean_forces.collect(),
                step / model.speed,
                model.speed,
                distance,
            ),
            now: model.contacts.iter().map(at_rest).collect(),
            forces: vec![0.0; size],
            displacement: vec![0.0; size],
            speed: vec![0.0; size],
            slopes: vec![Slopes::default(); model.contacts.len()],
            drift: vec![[0.0; 2]; model.contacts.len()],
            force_drift: vec![0.0; size],
            before: Vec::with_capacity(model.contacts.len()),
            forces_before: Vec::with_capacity(size),
            heights: vec![0.0; model.contacts.len()],
            model,
        }
    }

    /// The contacts where the march stands.
    pub fn now(&self) -> &[ContactInstant] {
        &self.now
    }

    /// One step on, to places where the profiles under the contacts have the heights r \[m\], along their normals.
    pub fn advance(&mut self, heights: &[f64]) -> &[ContactInstant] {
        /// Forces of the others come into an equation with the mass of a wheel: a sweep leaves a hundredth of the change.
        const SWEEPS: usize = 40;
        const REST: f64 = 1e-8;
        self.motion
            .advance(&self.forces, &mut self.displacement, &mut self.speed);
        self.before.clear();
        let creepages = self.now.iter();
        self.before
            .extend(creepages.map(|now| [now.creepage, now.lateral_creepage]));
        self.forces_before.clone_from(&self.forces);
        for (now, drift) in self.now.iter_mut().zip(&self.drift) {
            now.creepage += drift[0];
            now.lateral_creepage += drift[1];
        }
        for (force, drift) in self.forces.iter_mut().zip(&self.force_drift) {
            *force += drift;
        }
        for sweep in 0..SWEEPS {
            let mut change = 0f64;
            for (index, height) in heights.iter().enumerate() {
                change = change.max(self.meet(index, *height, sweep > 0));
            }
            if change < REST {
                break;
            }
        }
        let pairs = self.before.iter().zip(&self.now).zip(&mut self.drift);
        for ((before, now), drift) in pairs {
            *drift = [now.creepage - before[0], now.lateral_creepage - before[1]];
        }
        let pairs = self.forces.iter().zip(&self.forces_before);
        for (drift, (now, before)) in self.force_drift.iter_mut().zip(pairs) {
            *drift = now - before;
        }
        self.motion.end(&self.forces);
        &self.now
    }

    /// One step on along a rail whose height under study is told at a distance ahead of the first wheel \[m\].
    pub(in crate::passage) fn advance_along(&mut self, height: impl Fn(f64) -> f64) {
        let mut heights = std::mem::take(&mut self.heights);
        for (own, contact) in heights.iter_mut().zip(&self.model.contacts) {
            *own = match contact.profile {
                0.0 => 0.0,
                profile => profile * height(contact.along),
            };
        }
        self.advance(&heights);
        self.heights = heights;
    }

    /// One contact under the present forces of all others; the change of its forces over its mean load. It `is_met` where its
    /// creep forces are those of its creepages already.
    fn meet(&mut self, index: usize, height: f64, is_met: bool) -> f64 {
        /// Change of the normal force, over the load, that creep forces need not know of.
        const SAME: f64 = 1e-9;
        let size = self.forces.len();
        let [displacement_by, speed_by] = &self.motion.by_new_force;
        let contact = &self.model.contacts[index];
        let own = 3 * index;
        let load = contact.spring.normal_force();
        let sum = |by: &[f64], row: usize| -> f64 {
            let row = &by[row * size..][..size];
            row.iter().zip(&self.forces).map(|(a, b)| a * b).sum()
        };
        let entry = |by: &[f64], row: usize, column: usize| by[row * size + column];
        let normal = own + 2;
        let give_way = entry(displacement_by, normal, normal);
        let others = self.displacement[normal] + sum(displacement_by, normal)
            - give_way * self.forces[normal];
        let gap = contact.spring.approach() + height - others + give_way * load;
        let before = self.now[index];
        let (approach, normal_force) = contact.spring.meet(gap, give_way, before.approach);

        // Speeds but for those by its own creep forces.
        let by_own = [0, 1].map(|row| [0, 1].map(|to| entry(speed_by, own + row, own + to)));
        let mean = &contact.mean;
        let held = &contact.held;
        let known = [0, 1].map(|axis| {
            let row = own + axis;
            let own_share: f64 = (0..2)
                .map(|from| by_own[axis][from] * self.forces[own + from])
                .sum();
            let by_load =
                entry(speed_by, row, normal) * (normal_force - load - self.forces[normal]);
            self.speed[row] + sum(speed_by, row) + by_load - own_share
        });
        let at_rest = [mean.creepages.longitudinal, mean.creepages.lateral];
        let mean_force = [mean.forces.longitudinal, mean.forces.lateral];
        let v = self.model.speed;
        let equation = TangentEquation {
            contact,
            normal_force,
            known: [0, 1].map(|axis| match held[axis] {
                true => at_rest[axis],
                false => at_rest[axis] - known[axis] / v,
            }),
            by_force: [0, 1].map(|axis| match held[axis] {
                true => [0.0; 2],
                false => by_own[axis].map(|by| by / v),
            }),
            mean_force,
        };
        let near = [before.creepage, before.lateral_creepage];
        let is_met = is_met && (normal_force - before.normal_force).abs() <= SAME * load;
        let force = match is_met {
            true => [before.tangential_force, before.lateral_force],
            false => equation.force(near),
        };
        let (creepage, force) = equation.solve(near, force, &mut self.slopes[index]);
        let new = [
            force[0] - mean_force[0],
            force[1] - mean_force[1],
            normal_force - load,
        ];
        let old = &mut self.forces[own..=normal];
        let change = old
            .iter()
            .zip(new)
            .fold(0f64, |most, (old, new)| most.max((old - new).abs()));
        old.copy_from_slice(&new);
        let energy = creepage[0] * force[0] + creepage[1] * force[1];
        self.now[index] = ContactInstant {
            normal_force,
            tangential_force: force[0],
            lateral_force: force[1],
            creepage: creepage[0],
            lateral_creepage: creepage[1],
            approach,
            energy_at_rail: energy,
        };
        change / load
    }
}

/// ξ + B (Q(P, ξ) − Q₀) = ξ_known in the plane of contact.
struct TangentEquation<'a> {
    contact: &'a ContactInTime,
    normal_force: f64,
    known: [f64; 2],
    by_force: [[f64; 2]; 2],
    mean_force: [f64; 2],
}

impl TangentEquation<'_> {
    fn creepages(&self, [longitudinal, lateral]: [f64; 2]) -> Creepages {
        Creepages {
            longitudinal,
            lateral,
            spin: self.contact.mean.creepages.spin,
        }
    }

    fn force(&self, creepage: [f64; 2]) -> [f64; 2] {
        if self.normal_force <= 0.0 {
            return [0.0; 2];
        }
        pair(
            self.contact
                .law
                .forces(self.normal_force, self.creepages(creepage)),
        )
    }

    fn missed(&self, creepage: [f64; 2], force: [f64; 2]) -> [f64; 2] {
        let beyond = [force[0] - self.mean_force[0], force[1] - self.mean_force[1]];
        [0, 1].map(|axis| {
            let [a, b] = self.by_force[axis];
            creepage[axis] + a * beyond[0] + b * beyond[1] - self.known[axis]
        })
    }

    /// Broyden's method from a creepage near by and the force there, with the slopes met last, and Newton's where these do not lead there; to 10⁻¹⁰
    /// of the creepage. Returns creepage and force.
    fn solve(&self, near: [f64; 2], force: [f64; 2], slopes: &mut Slopes) -> ([f64; 2], [f64; 2]) {
        const STEPS: usize = 60;
        const SMALL: f64 = 1e-10;
        /// Steps with old slopes.
        const PATIENCE: usize = 6;
        let size = |pair: [f64; 2]| pair[0].hypot(pair[1]);
        // What the known creepages, tiny as they may be, are told to.
        let enough = SMALL * (size(self.known) + 1e-6);
        let (mut creepage, mut force) = (near, force);
        let mut missed = self.missed(creepage, force);
        for count in 0..STEPS {
            if size(missed) <= enough {
                break;
            }
            if count >= PATIENCE {
                *slopes = self.slopes(creepage);
            }
            let step = self.newton_step(missed, slopes);
            let mut share = 1.0;
            loop {
                let change = step.map(|step| -share * step);
                let next = [creepage[0] + change[0], creepage[1] + change[1]];
                let force_there = self.force(next);
                let left = self.missed(next, force_there);
                if count < PATIENCE {
                    slopes.learn(change, [0, 1].map(|axis| force_there[axis] - force[axis]));
                }
                if size(left) < size(missed) || count < PATIENCE || share < 1e-4 {
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
        match determinant.abs() > f64::MIN_POSITIVE {
            true => [
                (d * missed[0] - b * missed[1]) / determinant,
                (a * missed[1] - c * missed[0]) / determinant,
            ],
            false => missed,
        }
    }

    /// dQ/dξ of the law.
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
struct Slopes([[f64; 2]; 2]);

impl Slopes {
    /// The nearest slopes that make of a change of the creepage the change of the force that was met (Broyden 1965).
    fn learn(&mut self, creepage: [f64; 2], force: [f64; 2]) {
        let square = creepage[0] * creepage[0] + creepage[1] * creepage[1];
        if square <= f64::MIN_POSITIVE {
            return;
        }
        for (row, force) in self.0.iter_mut().zip(force) {
            let missed = force - row[0] * creepage[0] - row[1] * creepage[1];
            row[0] += missed * creepage[0] / square;
            row[1] += missed * creepage[1] / square;
        }
    }
}

fn pair(forces: CreepForces) -> [f64; 2] {
    [forces.longitudinal, forces.lateral]
}
