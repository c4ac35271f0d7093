//! The motion of wheels along rails, step by step.

use super::direction_in_time::DirectionMotion;
use super::late_contact::LateMotion;
use super::patch_average::PatchAverage;
use super::structures_motion::StructuresMotion;
use super::tangent_equation::{Slopes, TangentEquation};
use super::{ContactInTime, PassageModel};
use crate::contact::CreepForces;

/// The contact at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactInstant {
    /// Normal force P \[N\], zero without contact.
    pub normal_force: f64,
    /// Creep force Q \[N\].
    pub tangential_force: f64,
    /// Creep force across the rail Q_t \[N\]; zero where nothing moves across.
    pub lateral_force: f64,
    /// Creepage ξ \[-\].
    pub creepage: f64,
    /// Lateral creepage η \[-\].
    pub lateral_creepage: f64,
    /// Approach δ of wheel and rail \[m\]; below zero their distance.
    pub approach: f64,
    /// Energy left on a metre of rail \[J/m\]: Qξ + Q_tη of a steady law, and of a contact that answers late what the place
    /// [`behind`](super::LateContact::behind) has received.
    pub energy_at_rail: f64,
}

impl ContactInstant {
    /// Energy dissipated per metre of rail, Qξ + Q_tη \[J/m\], at the wheel centre: the work of the creep force, of which a contact that
    /// answers late stores a part for a while.
    pub fn energy_per_metre(&self) -> f64 {
        self.tangential_force * self.creepage + self.lateral_force * self.lateral_creepage
    }
}

/// Wheels under way.
///
/// Over a step all forces are linear in time, and track and wheels move exactly under them; the forces at its end follow from
/// one equation for P and two for Q at each contact in turn, until those of the others change nothing. Second order in the step:
/// without loss of contact halving it quarters the error, ω²h²/12 of the part of a force that oscillates with ω (tests `second_order`
/// and `second_order_on_all_axes`). Stable at any step (forces at the end of a step are implicit).
#[derive(Clone)]
pub struct March<'a> {
    model: &'a PassageModel,
    motion: StructuresMotion<'a>,
    /// Of the normal forces that turn with the waves.
    direction: Option<DirectionMotion<'a>>,
    now: Vec<ContactInstant>,
    /// f − f₀ at the contacts and axes.
    forces: Vec<f64>,
    /// Displacements and speeds at the end of the step but for the forces there.
    displacement: Vec<f64>,
    speed: Vec<f64>,
    /// Of the contacts that answer late.
    late: Vec<Option<LateMotion>>,
    /// dQ/dξ met last at the contacts.
    slopes: Vec<Slopes>,
    /// Changes of the creepages and of the forces over the last step, at which the next begins.
    drift: Vec<[f64; 2]>,
    force_drift: Vec<f64>,
    /// Scratch: creepages and forces before a step, and heights of the rails under the contacts.
    before: Vec<[f64; 2]>,
    forces_before: Vec<f64>,
    heights: Vec<f64>,
    /// What the contacts feel of the waves beside their heights, and felt a step before.
    averaged: Vec<PatchAverage>,
    averaged_before: Vec<PatchAverage>,
    /// N = P₀r'.
    turned: Vec<f64>,
}

impl<'a> March<'a> {
    /// On discrete supports the first wheel begins a distance before one of them \[m\].
    pub(super) fn new(model: &'a PassageModel, step: f64, distance: f64) -> Self {
        let size = model.structures.size();
        let mean_forces = model.contacts.iter().flat_map(|contact| {
            let CreepForces { longitudinal, lateral } = contact.mean.forces;
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
            direction: model.structures.direction().map(|direction| {
                let poles = model.structures.terms().map(|(pole, _)| pole);
                DirectionMotion::new(direction, poles, step / model.speed)
            }),
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
            late: model.contacts.iter().map(|contact| Some(LateMotion::new(contact.late.as_deref()?, step))).collect(),
            slopes: vec![Slopes::default(); model.contacts.len()],
            drift: vec![[0.0; 2]; model.contacts.len()],
            force_drift: vec![0.0; size],
            before: Vec::with_capacity(model.contacts.len()),
            forces_before: vec![0.0; size],
            heights: vec![0.0; model.contacts.len()],
            averaged: vec![PatchAverage::default(); model.contacts.len()],
            averaged_before: vec![PatchAverage::default(); model.contacts.len()],
            turned: vec![0.0; model.contacts.len()],
            model,
        }
    }

    /// The contacts where the march stands.
    pub fn now(&self) -> &[ContactInstant] {
        &self.now
    }

    /// One step on, to places where the profiles under the contacts have the heights r \[m\], along their normals, and nothing else that
    /// counts.
    pub fn advance(&mut self, heights: &[f64]) -> &[ContactInstant] {
        /// Forces of the others come into an equation with the mass of a wheel: a sweep leaves a hundredth of the change.
        const SWEEPS: usize = 40;
        const REST: f64 = 1e-8;
        self.motion.advance(&self.forces, &mut self.displacement, &mut self.speed);
        let contacts = self.model.contacts.iter().zip(&self.averaged);
        if let Some(direction) = &mut self.direction {
            for (turned, (contact, averaged)) in self.turned.iter_mut().zip(contacts) {
                *turned = contact.spring.normal_force() * averaged.slope;
            }
            direction.advance(&self.turned, &mut self.speed);
        }
        let contacts = self.model.contacts.iter().zip(&self.averaged_before);
        let contacts = contacts.zip(&self.now);
        for (late, ((contact, averaged), now)) in self.late.iter_mut().zip(contacts) {
            if let Some(late) = late {
                late.advance(contact, now, averaged.curvature);
            }
        }
        self.averaged_before.copy_from_slice(&self.averaged);
        self.before.clear();
        let creepages = self.now.iter();
        self.before.extend(creepages.map(|now| [now.creepage, now.lateral_creepage]));
        for (now, drift) in self.now.iter_mut().zip(&self.drift) {
            now.creepage += drift[0];
            now.lateral_creepage += drift[1];
        }
        let forces = self.forces.iter_mut().zip(&mut self.forces_before);
        for ((force, before), drift) in forces.zip(&self.force_drift) {
            *before = *force;
            *force += drift;
        }
        // Creep forces of a lone wheel do not move it along its normal: nothing comes back.
        let [by_new_force, _] = &self.motion.by_new_force;
        let alone =
            matches!(by_new_force[..], [.., along, across, _] if self.now.len() == 1 && along == 0.0 && across == 0.0);
        let sweeps = if alone { 1 } else { SWEEPS };
        for sweep in 0..sweeps {
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

    /// One step on along a rail, of which under study a contact of a number feels what is told at a distance ahead of the first wheel \[m\].
    pub(super) fn advance_along(&mut self, averaged: impl Fn(usize, f64) -> PatchAverage) {
        let mut heights = std::mem::take(&mut self.heights);
        for (index, contact) in self.model.contacts.iter().enumerate() {
            self.averaged[index] = match contact.profile {
                0.0 => PatchAverage::default(),
                profile => averaged(index, contact.along).times(profile),
            };
            heights[index] = self.averaged[index].height;
        }
        self.advance(&heights);
        self.heights = heights;
    }

    /// Of each contact, whether it feels more of waves than their height.
    pub(super) fn feel_more_than_height(&self) -> impl Iterator<Item = bool> + use<'a> {
        let model = self.model;
        let contacts = model.contacts.iter();
        contacts.map(|contact| model.feels_more_than_height(contact))
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
        let others = self.displacement[normal] + sum(displacement_by, normal) - give_way * self.forces[normal];
        let gap = contact.spring.approach() + height - others + give_way * load;
        let before = self.now[index];
        let (approach, normal_force) = contact.spring.meet(gap, give_way, before.approach);

        let mean = &contact.mean;
        let averaged = self.averaged[index];
        let curvature = averaged.curvature;
        let slower = 1.0 + curvature;
        let at_rest = [mean.creepages.longitudinal, mean.creepages.lateral];
        let v = self.model.speed / slower;
        let mut equation = TangentEquation {
            contact,
            late: self.late[index].as_ref(),
            normal_force,
            curvature,
            by_wave: match (&contact.wave, &contact.late) {
                (Some(wave), None) => wave.force(curvature),
                _ => [averaged.force, 0.0],
            },
            energy_of_wave: averaged.energy,
            known: at_rest.map(|creepage| creepage * slower),
            by_force: [[0.0; 2]; 2],
        };
        for axis in [0, 1].into_iter().filter(|&axis| !contact.held[axis]) {
            let row = own + axis;
            let by_own = [0, 1].map(|to| entry(speed_by, row, own + to));
            let by_load = entry(speed_by, row, normal) * (normal_force - load - self.forces[normal]);
            // But for that by its own creep forces.
            let speed = self.speed[row] + sum(speed_by, row) + by_load
                - (by_own[0] * self.forces[own] + by_own[1] * self.forces[own + 1]);
            equation.known[axis] -= speed / v;
            equation.by_force[axis] = by_own.map(|by| by / v);
        }
        let near = [before.creepage, before.lateral_creepage];
        let is_met = is_met && (normal_force - before.normal_force).abs() <= SAME * load;
        let force = match is_met {
            true => [before.tangential_force, before.lateral_force],
            false => equation.force(near),
        };
        let (creepage, force) = equation.solve(self.before[index], near, force, &mut self.slopes[index]);
        let new = [force[0] - mean.forces.longitudinal, force[1] - mean.forces.lateral, normal_force - load];
        let old = &mut self.forces[own..=normal];
        let change = old.iter().zip(new).fold(0f64, |most, (old, new)| most.max((old - new).abs()));
        old.copy_from_slice(&new);
        let energy_at_rail = equation.energy(creepage, force);
        self.now[index] = ContactInstant {
            normal_force,
            tangential_force: force[0],
            lateral_force: force[1],
            creepage: creepage[0],
            lateral_creepage: creepage[1],
            approach,
            energy_at_rail,
        };
        change / load
    }
}
