//! The motion of a wheel along a rail, step by step.

use super::along_profile::faded;
use super::late_contact::LateMotion;
use super::over_supports::ONSET_BAYS;
use super::track_motion::TrackMotion;
use super::{PassageModel, Turning};

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
    /// Energy left on a metre of rail \[J/m\]: Qξ of a steady law, and of a contact that answers late what the place
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

/// A wheel under way; on discrete supports it begins over one of them.
///
/// Over a step all forces are linear in time, and track, wheel and rotation move exactly under them; the forces at its
/// end follow from one equation for P, then one for Q. Second order in the step: without loss of contact halving it
/// quarters the error, ω²h²/12 of the part of a force that oscillates with ω (test `second_order`). Stable at any step
/// (forces at the end of a step are implicit).
#[derive(Clone)]
pub struct March<'a> {
    model: &'a PassageModel,
    track: TrackMotion,
    /// \[s\]
    step: f64,
    /// Displacement and speed of the wheel from its position at rest, downward \[m, m/s\].
    wheel: [f64; 2],
    now: ContactInstant,
    late: Option<LateMotion>,
    /// R²h/(2I_wV) \[1/N\]: what Q − Q₀ at the beginning or end of a step takes off the creepage; zero if held.
    creepage_per_force: f64,
    /// Share of the sag between supports that has set in, and what each step adds.
    onset: f64,
    onset_step: f64,
    /// dQ/dξ met last \[N\].
    slope: f64,
    /// Change of the creepage over the last step, at which the next begins.
    drift: f64,
}

impl<'a> March<'a> {
    /// Steady rolling on a smooth rail, with steps of the given length \[m\], from a distance before a support \[m\].
    pub(super) fn new(model: &'a PassageModel, step: f64, distance: f64) -> Self {
        let late = model.late.as_deref();
        let late = late.map(|late| LateMotion::new(late, step));
        let step = step / model.speed;
        let creepage = model.mean.creepages.longitudinal;
        Self {
            track: TrackMotion::new(&model.track, step, model.speed, distance),
            onset: model.track.support_spacing().map_or(1.0, |_| 0.0),
            onset_step: match model.track.support_spacing() {
                Some(spacing) => step * model.speed / (ONSET_BAYS * spacing),
                None => 0.0,
            },
            step,
            wheel: [0.0; 2],
            now: ContactInstant {
                normal_force: model.spring.normal_force(),
                tangential_force: model.mean.forces.longitudinal,
                lateral_force: 0.0,
                creepage,
                lateral_creepage: 0.0,
                approach: model.spring.approach(),
                energy_at_rail: model.mean.forces.longitudinal * creepage,
            },
            late,
            creepage_per_force: match model.turning {
                Turning::Inertia {
                    inertia,
                    rolling_radius,
                } => rolling_radius * rolling_radius * step / (2.0 * inertia * model.speed),
                Turning::Held => 0.0,
            },
            slope: model.mean.forces.longitudinal / creepage,
            drift: 0.0,
            model,
        }
    }

    /// The contact where the march stands.
    pub fn now(&self) -> ContactInstant {
        self.now
    }

    pub(super) fn at_contact(&self) -> &ContactInstant {
        &self.now
    }

    /// One step on, to a place where the profile has the height r \[m\], upward.
    pub fn advance(&mut self, height: f64) -> ContactInstant {
        let spring = &self.model.spring;
        let load = spring.normal_force();
        let [place, speed] = self.wheel;
        let (h, mass) = (self.step, self.model.wheel_mass);
        // m_w z'' = −f, f = P − P₀ linear: what the force at the beginning does, and what that at the end adds.
        let force = self.now.normal_force - load;
        let mean_creepage = self.model.mean.creepages.longitudinal;
        if let Some(late) = &mut self.late {
            late.advance(force, self.now.creepage - mean_creepage);
        }
        let mut rail = self.track.advance(force);
        if self.onset_step > 0.0 {
            self.onset += self.onset_step;
            rail += load * self.track.sag() * faded(self.onset);
        }
        let wheel = place + h * speed - h * h / (3.0 * mass) * force;
        let wheel_by_new = h * h / (6.0 * mass);
        let give_way = self.track.by_new_force() + wheel_by_new;
        let gap = spring.approach() + wheel - rail + height + give_way * load;
        let (approach, normal_force) = spring.meet(gap, give_way, self.now.approach);
        let new_force = normal_force - load;
        self.wheel = [
            wheel - wheel_by_new * new_force,
            speed - 0.5 * h / mass * (force + new_force),
        ];
        let (tangential_force, creepage) = self.creep(normal_force);
        self.now = ContactInstant {
            normal_force,
            tangential_force,
            lateral_force: 0.0,
            creepage,
            lateral_creepage: 0.0,
            approach,
            energy_at_rail: match &self.late {
                None => tangential_force * creepage,
                Some(late) => {
                    let felt = late.for_energy(new_force, creepage - mean_creepage);
                    let creepage = mean_creepage + felt.creepage;
                    creepage * self.model.steady_force(load + felt.load, creepage)
                }
            },
        };
        self.now
    }

    /// Q and ξ at the end of a step: ξ + cQ(P, ξ) = ξ_before − c(Q_before − 2Q₀), c the creepage per force.
    ///
    /// The left side grows with ξ where Q does. Secants within a bracket, since |Q| ≤ μP; bisection where they leave it.
    fn creep(&mut self, normal_force: f64) -> (f64, f64) {
        /// Last change of the creepage, as a part of its change over the step: a secant leaves of it no more than
        /// c ΔdQ/dξ, 10⁻³ or less. And as a part of itself, where it does not change.
        const TOLERANCE: f64 = 1e-4;
        const ROUNDING: f64 = 1e-13;
        let c = self.creepage_per_force;
        let mean = self.model.mean.forces.longitudinal;
        let goal = self.now.creepage - c * (self.now.tangential_force - 2.0 * mean);
        if normal_force <= 0.0 {
            return (0.0, goal);
        }
        let model = self.model;
        let bound = model.law.friction() * normal_force;
        let (load, mean_creepage) = (
            model.spring.normal_force(),
            model.mean.creepages.longitudinal,
        );
        let force = |creepage: f64| match &self.late {
            None => model.steady_force(normal_force, creepage),
            Some(late) => {
                let felt = late.for_force(normal_force - load, creepage - mean_creepage);
                let force = model.steady_force(load + felt.load, mean_creepage + felt.creepage);
                force.clamp(-bound, bound)
            }
        };
        if c == 0.0 {
            return (force(goal), goal);
        }
        let most = c * bound;
        let (mut low, mut high) = (goal - most, goal + most);
        let mut creepage = (self.now.creepage + self.drift).clamp(low, high);
        let mut tangential_force = force(creepage);
        for _ in 0..100 {
            let excess = creepage + c * tangential_force - goal;
            if excess > 0.0 {
                high = creepage;
            } else {
                low = creepage;
            }
            let secant = creepage - excess / (1.0 + c * self.slope);
            let next = match secant > low && secant < high {
                true => secant,
                false => 0.5 * (low + high),
            };
            let before = (creepage, tangential_force);
            creepage = next;
            let change = (creepage - self.now.creepage).abs();
            if (creepage - before.0).abs() <= TOLERANCE * change + ROUNDING * creepage.abs() {
                // The force that goes with the creepage in the equation of the wheel, to second order in what is left.
                tangential_force += self.slope * (creepage - before.0);
                break;
            }
            tangential_force = force(creepage);
            let slope = (tangential_force - before.1) / (creepage - before.0);
            self.slope = slope.max(0.0);
        }
        self.drift = creepage - self.now.creepage;
        (tangential_force, creepage)
    }
}
