//! Rolling and shifting followed in time.

use super::REMEDY;
use super::friction::{Friction, Slip};
use super::influence::{Convolution, Influence};
use super::patch::{Field, Patch, Step};
use super::steady::rigid_slip;
use crate::Error;
use crate::contact::{CreepForces, Creepages, HertzContact};

/// Residual of the friction law, see [`Friction`].
const TOLERANCE: f64 = 1e-5;
/// Error of a force that is asked for, as a share of full slip.
const FORCE_TOLERANCE: f64 = 1e-5;

/// A Hertz contact of two alike elastic half-spaces that is shifted and rolled step by step, under any
/// course of load, creepages or force.
///
/// The patch is followed by a fixed grid of elements that is as large as the contact under the largest
/// load; the material passes by one element in each step of rolling. Sticking material keeps the
/// displacement it had a step before, at the place where it was then:
/// S = c dx − (u(x, t) − u(x + dx, t − dt)).
///
/// Method: each step is a friction problem of the half-space, to 1e-5 of the tractions, by
/// semismooth Newton. Errors are of first order in the length of an element; a change of load moves the
/// edge over whole elements, which adds some 1 % to the response to load. The frequency response
/// itself is had at a fortieth of the cost from [`HalfSpace::response`](super::HalfSpace::response);
/// this is for courses that are not harmonic, and to prove that one right. Cost: 1 to 2 ms a step with
/// 40 × 40 elements.
///
/// Source: Kalker (1990), *Three-dimensional elastic bodies in rolling contact*, chapter 1, for the
/// equations. Range of validity: that of [`HalfSpace`](super::HalfSpace).
pub struct TransientRolling {
    pub(super) hertz: HertzContact,
    pub(super) friction: f64,
    pub(super) patch: Patch,
    influence: Influence,
    /// Largest displacement by unit tractions everywhere \[m/Pa\].
    compliance: f64,
    tractions: Field<f64>,
    /// Tractions of the next step, if they go on changing as in the last: where its solution begins.
    guess: Field<f64>,
    /// Displacement at both ends of every step of the material.
    displacement: Displacement,
}

/// Displacement at the rear and at the front of every step of the material \[m\].
struct Displacement {
    rear: Field<f64>,
    front: Field<f64>,
}

/// What the wheel does in a step.
#[derive(Debug, Clone, Copy)]
enum Motion {
    /// Shifted along the rail \[m\].
    Shift(f64),
    /// Rolled by one element.
    Roll(Creepages),
}

/// What a step of time has done.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct TransientStep {
    /// Creep forces at its end \[N\].
    pub forces: CreepForces,
    /// Creepages during a step of rolling; none in a shift.
    pub creepages: Creepages,
    /// Energy dissipated \[J\].
    pub dissipation: f64,
    /// Energy dissipated by each column of elements \[J\]; the first lies behind the rearmost column, see
    /// [`place`](TransientRolling::place).
    pub dissipation_along: Vec<f64>,
}

impl TransientRolling {
    /// A contact without tangential tractions, with `across` elements (8 to 200) over a diameter of the
    /// patch under the normal force of `hertz`, which no load may exceed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the friction is not positive or the number of elements out of range.
    pub fn new(hertz: HertzContact, friction: f64, across: usize) -> Result<Self, Error> {
        Self::with_room(hertz, friction, across, 0)
    }

    /// Contact with `room` elements more on each side, over which a rail that is not straight moves the patch.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn with_room(hertz: HertzContact, friction: f64, across: usize, room: usize) -> Result<Self, Error> {
        Error::unless_positive("coefficient of friction", friction, "")?;
        // One element more on each side: all that the edge covers in part carry their share, so that nothing
        // jumps when the load moves it.
        let more = across + 2 * (1 + room);
        let wider = more as f64 / across as f64;
        let patch = Patch::new(wider * hertz.semi_axis_longitudinal(), wider * hertz.semi_axis_lateral(), more)?;
        let influence = Influence::new(hertz.material(), &patch);
        let ones = vec![1.0; patch.len()];
        let moved = Convolution::new(&influence, &patch).real([&ones, &ones], [1.0, 0.0]);
        let nothing = |count: usize| [vec![0.0; count], vec![0.0; count]];
        Ok(Self {
            hertz,
            friction,
            compliance: moved.iter().flatten().fold(0.0, |a: f64, b| a.max(b.abs())),
            tractions: nothing(patch.len()),
            guess: nothing(patch.len()),
            displacement: Displacement { rear: nothing(patch.steps.len()), front: nothing(patch.steps.len()) },
            influence,
            patch,
        })
    }

    /// The contact under the largest load, for which the grid was made.
    pub fn hertz(&self) -> HertzContact {
        self.hertz
    }

    /// Distance that a step rolls, the length of an element \[m\].
    pub fn step_length(&self) -> f64 {
        self.patch.dx
    }

    /// Place of a column of [`TransientStep::dissipation_along`] relative to the centre of the patch at
    /// the middle of the step \[m\].
    pub fn place(&self, column: usize) -> f64 {
        (column as f64 - 0.5 * self.patch.across as f64) * self.patch.dx
    }

    /// Columns of elements along the patch; [`TransientStep::dissipation_along`] has one more.
    pub fn columns(&self) -> usize {
        self.patch.across
    }

    /// Lift the wheel off the rail: the next step begins without tractions.
    pub fn lift(&mut self) {
        let fields = [&mut self.tractions, &mut self.guess, &mut self.displacement.rear, &mut self.displacement.front];
        for part in fields.into_iter().flatten() {
            part.fill(0.0);
        }
    }

    /// Press with the normal force \[N\] and shift the wheel along the rail \[m\] without rolling, at once.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the normal force is not positive or beyond the largest;
    /// [`Error::NotConverged`].
    pub fn shift(&mut self, normal_force: f64, shift: f64) -> Result<TransientStep, Error> {
        self.step(normal_force, Motion::Shift(shift))
    }

    /// Press and shift until the tangential force along the rail is Q \[N\], to 1e-5 of full slip, at once.
    ///
    /// # Errors
    /// Errors of [`shift`](Self::shift), and [`Error::OutOfRange`] unless |Q| < μP.
    pub fn shift_to_force(&mut self, normal_force: f64, force: f64) -> Result<TransientStep, Error> {
        self.step_to_force(normal_force, force, 0.0, Motion::Shift)
    }

    /// Roll on by one element under the normal force \[N\] with these creepages.
    ///
    /// # Errors
    /// Errors of [`shift`](Self::shift).
    pub fn roll(&mut self, normal_force: f64, creepages: Creepages) -> Result<TransientStep, Error> {
        self.step(normal_force, Motion::Roll(creepages))
    }

    /// Roll on by one element under the normal force \[N\] with the longitudinal creepage that makes
    /// the creep force along the rail Q \[N\] at the end of the step, to 1e-5 of full slip; `creepage` is a
    /// first guess of it.
    ///
    /// # Errors
    /// Errors of [`shift_to_force`](Self::shift_to_force).
    pub fn roll_at_force(&mut self, normal_force: f64, force: f64, creepage: f64) -> Result<TransientStep, Error> {
        let dx = self.patch.dx;
        self.step_to_force(normal_force, force, creepage * dx, |distance| {
            Motion::Roll(Creepages::longitudinal(distance / dx))
        })
    }

    /// Roll on by one element under bounds of the tractions \[Pa\].
    pub(super) fn roll_under(&mut self, bound: &[f64], creepages: Creepages) -> Result<TransientStep, Error> {
        let motion = Motion::Roll(creepages);
        let slip = self.solve(motion, bound, &self.guess)?;
        Ok(self.accept(slip, motion))
    }

    fn step(&mut self, normal_force: f64, motion: Motion) -> Result<TransientStep, Error> {
        let bound = self.bound(normal_force)?;
        let slip = self.solve(motion, &bound, &self.guess)?;
        Ok(self.accept(slip, motion))
    }

    /// A step of the rigid distance \[m\] that ends with a force, by secants from a first guess.
    fn step_to_force(
        &mut self,
        normal_force: f64,
        force: f64,
        mut distance: f64,
        motion: impl Fn(f64) -> Motion,
    ) -> Result<TransientStep, Error> {
        const MOST_STEPS: usize = 30;
        let bound = self.bound(normal_force)?;
        let limit = self.friction * normal_force;
        if force.is_nan() || force.abs() >= limit {
            return Err(Error::OutOfRange {
                quantity: "creep force",
                value: force,
                unit: "N",
                rule: "must be less than the coefficient of friction times the normal force",
            });
        }
        // Before there is a secant: about the stiffness of a patch in stick.
        let area = self.patch.area() * self.patch.len() as f64;
        let mut slope = area / (self.compliance * limit);
        let mut before: Option<(f64, f64)> = None;
        let mut start = self.guess.clone();
        let mut error = f64::NAN;
        for _ in 0..MOST_STEPS {
            let slip = self.solve(motion(distance), &bound, &start)?;
            error = (self.patch.forces(&slip.tractions).longitudinal - force) / limit;
            if error.abs() <= FORCE_TOLERANCE {
                return Ok(self.accept(slip, motion(distance)));
            }
            start = slip.tractions;
            if let Some((other, other_error)) = before {
                let secant = (error - other_error) / (distance - other);
                // Noise of the last digits has no slope.
                slope = if secant > 0.0 { secant } else { slope };
            }
            before = Some((distance, error));
            distance -= error / slope;
        }
        Err(Error::NotConverged {
            problem: "motion for the creep force",
            residual: error.abs(),
            tolerance: FORCE_TOLERANCE,
            remedy: REMEDY,
        })
    }

    /// Traction bound of each element under a normal force \[Pa\].
    fn bound(&self, normal_force: f64) -> Result<Vec<f64>, Error> {
        Error::unless_positive("normal force", normal_force, "N")?;
        if normal_force > self.hertz.normal_force() {
            return Err(Error::OutOfRange {
                quantity: "normal force",
                value: normal_force,
                unit: "N",
                rule: "must not exceed the largest one, for which the grid was made",
            });
        }
        let hertz = self.hertz.under(normal_force);
        Ok(self.patch.traction_bound(hertz, self.friction))
    }

    fn solve(&self, motion: Motion, bound: &[f64], start: &Field<f64>) -> Result<Slip, Error> {
        let (mut forcing, before) = match motion {
            Motion::Shift(shift) => {
                let steps = self.patch.steps.len();
                ([vec![shift; steps], vec![0.0; steps]], &self.displacement.rear)
            }
            Motion::Roll(creepages) => {
                let slip = |x, y| creepages.rigid_slip(x, y);
                (rigid_slip(&self.patch, slip), &self.displacement.front)
            }
        };
        for (forcing, before) in forcing.iter_mut().zip(before) {
            for (value, before) in forcing.iter_mut().zip(before) {
                *value += before;
            }
        }
        let friction = Friction {
            patch: &self.patch,
            influence: &self.influence,
            operator: [1.0, 0.0],
            forcing: &forcing,
            bound,
            compliance: self.compliance,
            tolerance: TOLERANCE,
        };
        friction.solve(start).map_err(|residual| Error::NotConverged {
            problem: "step of transient rolling",
            residual,
            tolerance: TOLERANCE,
            remedy: REMEDY,
        })
    }

    /// Take a solution as the new state.
    fn accept(&mut self, slip: Slip, motion: Motion) -> TransientStep {
        // Where the material was before: rolling takes it on by an element.
        let (before, creepages): (fn(&Step) -> Option<usize>, _) = match motion {
            Motion::Shift(_) => (|step| step.to, Creepages::default()),
            Motion::Roll(creepages) => (|step| step.from, creepages),
        };
        let mut along = vec![0.0; self.patch.across + 1];
        for (index, step) in self.patch.steps.iter().enumerate() {
            for part in 0..2 {
                let old = before(step).map_or(0.0, |element| self.tractions[part][element]);
                let new = step.to.map_or(0.0, |element| slip.tractions[part][element]);
                along[(step.end.0 + 1) as usize] += self.patch.area() * 0.5 * (old + new) * slip.distance[part][index];
            }
        }
        let forces = self.patch.forces(&slip.tractions);
        let mut convolution = Convolution::new(&self.influence, &self.patch);
        let tractions = [slip.tractions[0].as_slice(), slip.tractions[1].as_slice()];
        self.displacement = Displacement {
            rear: convolution.real(tractions, [1.0, 0.0]),
            front: convolution.real(tractions, [0.0, 1.0]),
        };
        // Rolling goes on, a shift does not.
        let onward = if matches!(motion, Motion::Roll(_)) { 1.0 } else { 0.0 };
        self.guess = [0, 1].map(|part| {
            let both = slip.tractions[part].iter().zip(&self.tractions[part]);
            both.map(|(now, before)| now + onward * (now - before)).collect()
        });
        self.tractions = slip.tractions;
        TransientStep { forces, creepages, dissipation: along.iter().sum(), dissipation_along: along }
    }
}

#[cfg(test)]
#[path = "transient_tests.rs"]
mod tests;
