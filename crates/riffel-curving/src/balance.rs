//! Forces and moments on the wheelsets and frames of a vehicle at values of its unknowns.
//!
//! The unknowns of a frame and its wheelsets stand together: [`two_point_path`] across the track, yaw and rotation of each wheelset,
//! shift and yaw of the frame, sums of the normal forces of each wheel. A lone wheelset has no unknowns of its frame.

use std::cell::RefCell;

use riffel::{Error, Rail};

use super::creep::{CreepOnRail, KnownEllipses};
use super::newton::Equations;
use super::running_gear::Secondary;
use super::state::{BodyState, FrameState, WheelState, WheelsetState};
use super::two_point_path;
use super::wheel_on_rail::{WheelOnRail, WheelsetMotion, wheel_on_rail};
use super::{GRAVITY, RunningGear, VehicleInCurve};

/// The equations of a vehicle at a share of its curve: of curvature, uncompensated acceleration, torques and moments.
pub(super) struct Balance<'a> {
    vehicle: &'a VehicleInCurve,
    fraction: f64,
    /// The first failure that is not one of the equations.
    failure: RefCell<Option<Error>>,
    /// Of the left and the right rail.
    known: [KnownEllipses; 2],
}

/// The wheels of one wheelset on their rails.
pub(super) struct Rolling {
    lateral_shift: f64,
    wheels: [WheelOnRail; 2],
}

/// What the suspension does to a wheelset, and what the frame bears of it.
struct Suspension {
    lateral_force: f64,
    yaw_moment: f64,
    /// Force and moment; none on the frame of a lone wheelset, which has no equations.
    on_frame: [f64; 2],
}

/// Forces and moments, and all they consist of.
pub(super) struct Balanced {
    pub(super) residuals: Vec<f64>,
    pub(super) wheelsets: Vec<WheelsetState>,
    pub(super) wheels: Vec<WheelState>,
    pub(super) frames: Vec<FrameState>,
    pub(super) body: Option<BodyState>,
}

/// Places of the unknowns of a frame with its wheelsets.
#[derive(Debug, Clone, Copy)]
pub(super) struct Places {
    /// Wheelsets in a frame.
    pub(super) wheelsets: usize,
    /// Of shift and yaw of the frame, from the first unknown of the frame and its wheelsets.
    pub(super) frame: usize,
    /// Of the first normal force.
    pub(super) normal: usize,
    /// Unknowns of all.
    pub(super) unknowns: usize,
}

impl Places {
    pub(super) fn of(running_gear: &RunningGear) -> Self {
        let wheelsets = running_gear.wheelsets().min(2);
        let frame = 3 * wheelsets;
        let normal = frame + 2 * running_gear.frames().min(1);
        Self { wheelsets, frame, normal, unknowns: normal + 2 * wheelsets }
    }

    /// The frame of a wheelset, its number in that frame, and where the unknowns of both begin.
    fn of_wheelset(&self, wheelset: usize) -> (usize, usize, usize) {
        let frame = wheelset / self.wheelsets;
        (frame, wheelset % self.wheelsets, frame * self.unknowns)
    }

    /// The wheelset whose contacts an unknown changes, and which of its wheels if not both; `None` for those of a frame.
    fn wheels_of(&self, unknown: usize) -> Option<(usize, Option<usize>)> {
        let (frame, place) = (unknown / self.unknowns, unknown % self.unknowns);
        let (own, side) = match place {
            place if place < self.frame => (place / 3, None),
            place if place < self.normal => return None,
            place => ((place - self.normal) / 2, Some((place - self.normal) % 2)),
        };
        Some((frame * self.wheelsets + own, side))
    }
}

impl<'a> Balance<'a> {
    pub(super) fn at(vehicle: &'a VehicleInCurve, fraction: f64) -> Self {
        Self { vehicle, fraction, failure: RefCell::new(None), known: Default::default() }
    }

    /// The failure that was met, if any.
    pub(super) fn failure(self) -> Option<Error> {
        self.failure.into_inner()
    }

    /// All forces and moments; none off the track or without contact.
    pub(super) fn whole(&self, unknowns: &[f64]) -> Option<Balanced> {
        let rolling = self.evaluate(unknowns)?;
        Some(self.balanced(unknowns, &rolling.iter().collect::<Vec<_>>()))
    }

    /// A wheelset on its rails, of which a wheel that is `known` is not found anew; none off the track or without contact.
    fn rolling(
        &self,
        wheelset: usize,
        unknowns: &[f64],
        known: [Option<WheelOnRail>; 2],
    ) -> Result<Option<Rolling>, Error> {
        let vehicle = self.vehicle;
        let places = vehicle.places();
        let (_, own, first) = places.of_wheelset(wheelset);
        let motion = &unknowns[first + 3 * own..first + 3 * own + 3];
        let normal = first + places.normal + 2 * own;
        let place = two_point_path::place(vehicle.kinematics.two_points(), motion[0]);
        let Some(lateral_shift) = vehicle.kinematics.axle_shift(place.shift) else {
            return Ok(None);
        };
        let motion = WheelsetMotion {
            curvature: self.fraction / vehicle.curve.radius,
            half_spacing: 0.5 * vehicle.axle.contact_spacing,
            reference_radius: vehicle.axle.rolling_radii[1],
            yaw: motion[1],
            rotation: motion[2],
        };
        let wheel = |side: usize| {
            if known[side].is_some() {
                return Ok(known[side]);
            }
            let normal_force = unknowns[normal + side];
            if normal_force <= 0.0 || normal_force.is_nan() {
                return Ok(None);
            }
            wheel_on_rail(
                Rail::BOTH[side],
                vehicle.axle.rolling_radii[side],
                &motion,
                &place,
                normal_force,
                &vehicle.kinematics,
                CreepOnRail { creep: &vehicle.creep[side], known: &self.known[side] },
            )
        };
        let Some(left) = wheel(0)? else {
            return Ok(None);
        };
        Ok(wheel(1)?.map(|right| Rolling { lateral_shift, wheels: [left, right] }))
    }

    fn rolling_or_failure(
        &self,
        wheelset: usize,
        unknowns: &[f64],
        known: [Option<WheelOnRail>; 2],
    ) -> Option<Rolling> {
        self.rolling(wheelset, unknowns, known).unwrap_or_else(|error| {
            self.failure.borrow_mut().get_or_insert(error);
            None
        })
    }

    /// Sums of forces and moments over their scales: the load of a wheel, and an arm.
    fn balanced(&self, unknowns: &[f64], rolling: &[&Rolling]) -> Balanced {
        let vehicle = self.vehicle;
        let axle = &vehicle.axle;
        let places = vehicle.places();
        let half_spacing = 0.5 * axle.contact_spacing;
        let curvature = self.fraction / vehicle.curve.radius;
        let outward = -vehicle.curve.side() * vehicle.outward_acceleration(self.fraction);
        let load = vehicle.static_load();
        let loads = vehicle.loads(self.fraction);

        let (mut frames, body) = self.frames(unknowns, outward, curvature);
        // What a frame's own forces, and below its wheelsets, leave of it.
        let mut on_frames: Vec<[f64; 2]> = frames.iter().map(|frame| self.own_forces(frame)).collect();
        let mut residuals = vec![0.0; unknowns.len()];
        let mut wheels = Vec::with_capacity(2 * rolling.len());
        let mut wheelsets = Vec::with_capacity(rolling.len());
        for (index, rolling) in rolling.iter().enumerate() {
            let (of_frame, own, first) = places.of_wheelset(index);
            let row = first + 3 * own;
            let yaw = unknowns[row + 1];
            let lateral_shift = rolling.lateral_shift;
            let inertial = axle.wheelset_mass * outward;
            let flange = vehicle.kinematics.flange_force(lateral_shift);
            let link = self.suspension(own, lateral_shift, yaw, &mut frames[of_frame]);
            let Suspension { lateral_force: suspension, yaw_moment: suspension_moment, .. } = link;
            on_frames[of_frame][0] -= link.on_frame[0];
            on_frames[of_frame][1] -= link.on_frame[1];
            let mut lateral = suspension + flange + inertial;
            let mut moment = 0.0;
            let mut torque = self.fraction * vehicle.drive_torque[index];
            for (side, wheel) in rolling.wheels.iter().enumerate() {
                let mut state = wheel.state;
                state.wheelset = index + 1;
                state.vertical_load = loads[side];
                lateral -= state.whole_track_lateral_force();
                moment += wheel.yaw_moment;
                torque += wheel.torque;
                residuals[first + places.normal + 2 * own + side] = (wheel.carried - loads[side]) / load;
                wheels.push(state);
            }
            residuals[row] = lateral / load;
            residuals[row + 1] = (moment + suspension_moment) / (load * half_spacing);
            residuals[row + 2] = torque / (load * axle.rolling_radii[1]);
            wheelsets.push(WheelsetState {
                lateral_shift,
                yaw,
                angle_of_attack: -yaw * vehicle.curve.side(),
                rotation_ratio: 1.0 + unknowns[row + 2],
                flange_force: flange,
                suspension_lateral_force: suspension,
                suspension_yaw_moment: suspension_moment,
                contact_yaw_moment: moment,
                inertial_lateral_force: inertial,
            });
        }
        // A lone wheelset's frame has no equations.
        let frames_of_equations = vehicle.running_gear.frames();
        for (index, [force, moment]) in on_frames.into_iter().take(frames_of_equations).enumerate() {
            let row = index * places.unknowns + places.frame;
            residuals[row] = force / load;
            residuals[row + 1] = moment / (load * half_spacing);
        }
        Balanced { residuals, wheelsets, wheels, frames, body }
    }

    /// Lateral force and yaw moment on a frame without its wheelsets.
    fn own_forces(&self, frame: &FrameState) -> [f64; 2] {
        let bogie = self.vehicle.running_gear.bogie();
        let moment = bogie.map_or(0.0, |bogie| bogie.yaw_moment);
        [
            frame.inertial_lateral_force + frame.secondary_lateral_force,
            self.fraction * moment + frame.secondary_yaw_moment,
        ]
    }

    /// What the suspension does to the wheelset of this number in its frame; the frame of a lone wheelset that is held nowhere follows.
    fn suspension(&self, own: usize, lateral_shift: f64, yaw: f64, frame: &mut FrameState) -> Suspension {
        let axle = &self.vehicle.axle;
        let (lateral_stiffness, yaw_stiffness) = (axle.lateral_stiffness(), axle.yaw_stiffness());
        match &self.vehicle.running_gear {
            RunningGear::Wheelset(following) => {
                let force = match following.held_at {
                    Some(held) => -lateral_stiffness * (lateral_shift - self.fraction * held),
                    None => {
                        let force = frame.inertial_lateral_force;
                        frame.lateral_shift = lateral_shift + force / lateral_stiffness;
                        force
                    }
                };
                Suspension { lateral_force: force, yaw_moment: -yaw_stiffness * (yaw - frame.yaw), on_frame: [0.0; 2] }
            }
            RunningGear::Bogie(bogie) | RunningGear::Vehicle { bogies: bogie, .. } => {
                let curvature = self.fraction / self.vehicle.curve.radius;
                // Ahead of the middle of the bogie.
                let ahead = [0.5, -0.5][own] * bogie.wheelbase;
                let force = -lateral_stiffness * (lateral_shift - frame.lateral_shift - ahead * frame.yaw);
                let moment = -yaw_stiffness * (yaw + ahead * curvature - frame.yaw);
                Suspension { lateral_force: force, yaw_moment: moment, on_frame: [force, moment + ahead * force] }
            }
        }
    }

    /// The frames with their own forces and those of the body, under an outward acceleration \[m/s²\] that is signed as y is.
    fn frames(&self, unknowns: &[f64], outward: f64, curvature: f64) -> (Vec<FrameState>, Option<BodyState>) {
        let vehicle = self.vehicle;
        let places = vehicle.places();
        let sprung = vehicle.axle.mass_per_axle - vehicle.axle.wheelset_mass;
        let frame = |shift: f64, yaw: f64, mass: f64, secondary: Secondary| FrameState {
            lateral_shift: shift,
            yaw,
            inertial_lateral_force: mass * outward,
            secondary_lateral_force: secondary.lateral_force,
            secondary_yaw_moment: secondary.yaw_moment,
        };
        let of = |index: usize| {
            let place = index * places.unknowns + places.frame;
            (unknowns[place], unknowns[place + 1])
        };
        match &vehicle.running_gear {
            RunningGear::Wheelset(following) => {
                let (shift, yaw) = (following.held_at.unwrap_or(0.0), following.yaw);
                let at = |value: f64| self.fraction * value;
                let lone = frame(at(shift), at(yaw), sprung, Secondary::default());
                (vec![lone], None)
            }
            RunningGear::Bogie(_) => {
                let (shift, yaw) = of(0);
                (vec![frame(shift, yaw, 2.0 * sprung, Secondary::default())], None)
            }
            RunningGear::Vehicle { body, .. } => {
                let inertial = body.mass * outward;
                let (shift, yaw, secondary) = body.on_frames(inertial, [of(0), of(1)], curvature);
                let own = 2.0 * sprung - 0.5 * body.mass;
                let frames = (0..2).map(|index| {
                    let (shift, yaw) = of(index);
                    frame(shift, yaw, own, secondary[index])
                });
                let body = BodyState { lateral_shift: shift, yaw, inertial_lateral_force: inertial };
                (frames.collect(), Some(body))
            }
        }
    }
}

impl Equations for Balance<'_> {
    type Evaluated = Vec<Rolling>;

    fn evaluate(&self, unknowns: &[f64]) -> Option<Vec<Rolling>> {
        let wheelsets = 0..self.vehicle.running_gear.wheelsets();
        wheelsets.map(|wheelset| self.rolling_or_failure(wheelset, unknowns, [None; 2])).collect()
    }

    fn residuals(&self, unknowns: &[f64], rolling: &Vec<Rolling>) -> Vec<f64> {
        let rolling: Vec<&Rolling> = rolling.iter().collect();
        self.balanced(unknowns, &rolling).residuals
    }

    /// Contacts are those of one wheelset, or of one of its wheels: only these are found anew.
    fn moved(&self, unknowns: &[f64], rolling: &Vec<Rolling>, unknown: usize) -> Option<Vec<f64>> {
        let mut parts: Vec<&Rolling> = rolling.iter().collect();
        let Some((wheelset, side)) = self.vehicle.places().wheels_of(unknown) else {
            return Some(self.balanced(unknowns, &parts).residuals);
        };
        let mut known = [None; 2];
        if let Some(side) = side {
            known[1 - side] = Some(parts[wheelset].wheels[1 - side]);
        }
        let own = self.rolling_or_failure(wheelset, unknowns, known)?;
        parts[wheelset] = &own;
        Some(self.balanced(unknowns, &parts).residuals)
    }
}

impl VehicleInCurve {
    pub(super) fn places(&self) -> Places {
        Places::of(&self.running_gear)
    }

    /// Vertical loads of the left and the right wheel \[N\] at a share of the uncompensated acceleration.
    pub(super) fn loads(&self, fraction: f64) -> [f64; 2] {
        let axle = &self.axle;
        let spacing = axle.contact_spacing;
        let mean = 0.5 * axle.mass_per_axle * self.curve.normal_acceleration(spacing);
        let transfer = axle.mass_per_axle * self.outward_acceleration(fraction) * axle.centre_of_mass_height / spacing;
        let to_the_left = self.curve.side() * transfer;
        [mean + to_the_left, mean - to_the_left]
    }

    fn outward_acceleration(&self, fraction: f64) -> f64 {
        fraction * self.curve.uncompensated_acceleration(self.axle.contact_spacing)
    }

    /// Load by which residuals are measured \[N\].
    pub(super) fn static_load(&self) -> f64 {
        0.5 * self.axle.mass_per_axle * GRAVITY
    }
}
