//! Equilibrium of a bogie in a curve.

use std::cell::RefCell;
use std::sync::Arc;

use super::newton::{Root, root};
use super::state::ContinuationStep;
use super::way;
use super::wheel_on_rail::{WheelOnRail, WheelsetMotion, wheel_on_rail};
use super::{
    Bogie, BogieState, Creep, Curve, FrameState, RunningSurfaces, TwoPoints, WheelState,
    WheelsetState,
};
use crate::{Error, Rail};

/// A bogie in a curve.
#[derive(Clone)]
pub struct BogieInCurve {
    /// The curve.
    pub curve: Curve,
    /// The bogie.
    pub bogie: Bogie,
    /// How the wheels roll.
    pub kinematics: Kinematics,
    /// Creep on the left and on the right rail.
    pub creep: [Creep; 2],
}

/// How the wheels roll.
#[derive(Clone)]
pub enum Kinematics {
    /// Linear steering theory: cones of conicity λ \[-\] on a level plane, small angles, no flange. Source: Boocock (1969),
    /// Newland (1969).
    Linear {
        /// Conicity λ \[-\].
        conicity: f64,
    },
    /// Any running surfaces, yaw and rotation without linearisation.
    Nonlinear {
        /// Rolling radius and contact angle over lateral shift.
        surfaces: Arc<dyn RunningSurfaces>,
        /// In which plane the contact forces act.
        contact_plane: ContactPlane,
        /// A flange that is a spring without friction.
        flange: Option<FlangeSpring>,
    },
}

/// In which plane the contact forces act.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactPlane {
    /// In that of the track: the contact angle enters the spin alone.
    Horizontal,
    /// In that of the contact, under its angle.
    Tilted {
        /// Whether contacts that lie ahead of the axle have a yaw moment: a flange runs ahead, and a yawed axle carries
        /// its contacts along. Both nearly cancel.
        shift_moment: bool,
    },
}

/// A flange that meets its rail like a spring, without friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlangeSpring {
    /// Lateral shift that it leaves free \[m\], to either side.
    pub clearance: f64,
    /// Lateral stiffness beyond \[N/m\].
    pub stiffness: f64,
}

/// Places of the unknowns: [`way`] across the track, yaw and rotation of both wheelsets, shift and yaw of the frame, sums of
/// the normal forces of the wheels.
const UNKNOWNS: usize = 12;
const FRAME: usize = 6;
const NORMAL: usize = 8;

/// Largest residual over the static load of a wheel that counts as equilibrium. Rounding leaves 1e-14 to 1e-12.
const TOLERANCE: f64 = 1e-10;
/// Shortest step from straight track to the curve, as a share.
const SHORTEST: f64 = 1.0 / 4096.0;
/// Two states are one if no shift \[m\] and no yaw \[rad\] differs by more.
const SAME: f64 = 1e-8;
/// Lateral shifts \[m\] of both wheelsets from which further states are sought.
const STARTS: [f64; 5] = [-6e-3, -2.5e-3, 0.0, 2.5e-3, 6e-3];

impl BogieInCurve {
    /// The equilibrium that straight track leads to as curvature, uncompensated acceleration, torques and yaw moment
    /// grow together; where that way breaks off, one found from other starts.
    ///
    /// Method: Newton with halved steps, steps of the continuation halved where it fails. Unknown are y, ψ and Ω of both
    /// wheelsets, y and ψ of the frame and the normal forces of four wheels. Where a wheel stands on two points y is held,
    /// and the share of each in the normal force takes its place as unknown, 0 to 1: both are what complementarity asks.
    /// Cost: 0.2 ms with a closed creep law.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a value that no bogie has; [`Error::OffTheRails`] for an equilibrium beyond
    /// [`FARTHEST_SHIFT`](super::FARTHEST_SHIFT) or [`LARGEST_YAW`](super::LARGEST_YAW), as cones without a flange have in
    /// tight curves; [`Error::TorqueBeyondFriction`] and [`Error::NoEquilibrium`] where none is found, as in a curve that is
    /// tighter than the wheelsets can take.
    pub fn equilibrium(&self) -> Result<BogieState, Error> {
        self.check()?;
        let failure = RefCell::new(None);
        let reached = match self.continued(&failure) {
            Ok((found, steps)) => return self.state(&found, steps).on_the_rails(),
            Err(reached) => reached,
        };
        if let Some(found) = self.by_other_starts(&failure).into_iter().next() {
            return self.state(&found, Vec::new()).on_the_rails();
        }
        if let Some(error) = self.torque_beyond_friction(self.loads(1.0)) {
            return Err(error);
        }
        Err(failure
            .into_inner()
            .unwrap_or(Error::NoEquilibrium { reached }))
    }

    /// Every equilibrium found: first that of [`equilibrium`](Self::equilibrium), then those which other starts lead to.
    /// That no other exists is not proved.
    ///
    /// # Errors
    /// As [`equilibrium`](Self::equilibrium).
    pub fn equilibria(&self) -> Result<Vec<BogieState>, Error> {
        let mut states = vec![self.equilibrium()?];
        for found in self.by_other_starts(&RefCell::new(None)) {
            let Ok(state) = self.state(&found, Vec::new()).on_the_rails() else {
                continue;
            };
            if states.iter().all(|known| differ(known, &state)) {
                states.push(state);
            }
        }
        Ok(states)
    }

    fn check(&self) -> Result<(), Error> {
        self.bogie.check()?;
        self.curve.check(self.bogie.contact_spacing)?;
        match self.lowest_load() > 0.0 {
            true => Ok(()),
            false => Err(Error::OutOfRange {
                quantity: "load of a wheel",
                value: self.lowest_load(),
                unit: "N",
                rule: "must stay above zero: the vehicle tips over in this curve at this speed",
            }),
        }
    }

    fn lowest_load(&self) -> f64 {
        let [left, right] = self.loads(1.0);
        left.min(right)
    }

    /// Vertical loads of the left and the right wheel \[N\] at a share of the uncompensated acceleration.
    fn loads(&self, fraction: f64) -> [f64; 2] {
        let bogie = &self.bogie;
        let spacing = bogie.contact_spacing;
        let mean = 0.5 * bogie.mass_per_axle * self.curve.normal_acceleration(spacing);
        let transfer =
            bogie.mass_per_axle * self.outward_acceleration(fraction) * bogie.centre_of_mass_height
                / spacing;
        let to_the_left = self.curve.side() * transfer;
        [mean + to_the_left, mean - to_the_left]
    }

    fn outward_acceleration(&self, fraction: f64) -> f64 {
        fraction
            * self
                .curve
                .uncompensated_acceleration(self.bogie.contact_spacing)
    }

    /// Load by which residuals are measured \[N\].
    fn static_load(&self) -> f64 {
        0.5 * self.bogie.mass_per_axle * super::GRAVITY
    }

    /// Shifts at which a wheel stands on two points.
    fn two_points(&self) -> &[TwoPoints] {
        match &self.kinematics {
            Kinematics::Linear { .. } => &[],
            Kinematics::Nonlinear { surfaces, .. } => surfaces.two_points(),
        }
    }

    fn scales(&self) -> [f64; UNKNOWNS] {
        let load = self.static_load();
        let wheelset = [1e-3, 1e-3, 1e-3];
        let mut scales = [1e-3; UNKNOWNS];
        scales[..3].copy_from_slice(&wheelset);
        scales[3..FRAME].copy_from_slice(&wheelset);
        scales[NORMAL..].fill(load);
        scales
    }

    fn start(&self, fraction: f64, shifts: [f64; 2]) -> [f64; UNKNOWNS] {
        let [left, right] = self.loads(fraction);
        let mut start = [0.0; UNKNOWNS];
        start[0] = way::coordinate(self.two_points(), shifts[0]);
        start[3] = way::coordinate(self.two_points(), shifts[1]);
        start[FRAME] = 0.5 * (shifts[0] + shifts[1]);
        start[NORMAL..].copy_from_slice(&[left, right, left, right]);
        start
    }

    fn solve(
        &self,
        fraction: f64,
        start: [f64; UNKNOWNS],
        failure: &RefCell<Option<Error>>,
    ) -> Option<Root<UNKNOWNS>> {
        let residuals = |unknowns: &[f64; UNKNOWNS]| match self.balance(fraction, unknowns) {
            Ok(balance) => balance.map(|balance| balance.residuals),
            Err(error) => {
                failure.borrow_mut().get_or_insert(error);
                None
            }
        };
        root(residuals, start, &self.scales(), TOLERANCE)
    }

    /// The root at the curve by continuation from straight track, or the share of the curve that was reached.
    fn continued(
        &self,
        failure: &RefCell<Option<Error>>,
    ) -> Result<([f64; UNKNOWNS], Vec<ContinuationStep>), f64> {
        let mut steps = Vec::new();
        let mut record = |fraction: f64, found: &Root<UNKNOWNS>| {
            steps.push(ContinuationStep {
                fraction,
                residual: found.residual,
                iterations: found.iterations,
            });
        };
        let straight = self.solve(0.0, self.start(0.0, [0.0; 2]), failure);
        let found = straight.ok_or(0.0)?;
        record(0.0, &found);
        let (mut reached, mut unknowns, mut step) = (0.0, found.unknowns, 0.25);
        while reached < 1.0 {
            let target = f64::min(reached + step, 1.0);
            match self.solve(target, unknowns, failure) {
                Some(found) => {
                    record(target, &found);
                    (reached, unknowns) = (target, found.unknowns);
                    step *= 2.0;
                }
                None if step > SHORTEST => step *= 0.5,
                None => return Err(reached),
            }
        }
        Ok((unknowns, steps))
    }

    /// Roots at the curve from starts of shifted wheelsets.
    fn by_other_starts(&self, failure: &RefCell<Option<Error>>) -> Vec<[f64; UNKNOWNS]> {
        let pairs = STARTS
            .iter()
            .flat_map(|first| STARTS.map(|second| [*first, second]));
        let found = pairs.filter_map(|shifts| self.solve(1.0, self.start(1.0, shifts), failure));
        found.map(|found| found.unknowns).collect()
    }

    /// Forces and moments at values of the unknowns; none off the track or without contact.
    fn balance(&self, fraction: f64, unknowns: &[f64; UNKNOWNS]) -> Result<Option<Balance>, Error> {
        let Bogie {
            wheelbase,
            primary_spacing,
            contact_spacing,
            ..
        } = self.bogie;
        let half_spacing = 0.5 * contact_spacing;
        let curvature = fraction / self.curve.radius;
        let outward = -self.curve.side() * self.outward_acceleration(fraction);
        let lateral_stiffness = 2.0 * self.bogie.primary_lateral_stiffness;
        let yaw_stiffness =
            0.5 * primary_spacing * primary_spacing * self.bogie.primary_longitudinal_stiffness;
        let (frame_shift, frame_yaw) = (unknowns[FRAME], unknowns[FRAME + 1]);
        let load = self.static_load();
        let loads = self.loads(fraction);
        let frame_mass = 2.0 * (self.bogie.mass_per_axle - self.bogie.wheelset_mass);
        let frame_force = frame_mass * outward;

        let mut residuals = [0.0; UNKNOWNS];
        let mut wheels = Vec::with_capacity(4);
        let mut wheelsets = Vec::with_capacity(2);
        let (mut on_frame, mut moment_on_frame) =
            (frame_force, fraction * self.bogie.frame_yaw_moment);
        for index in 0..2 {
            let own = &unknowns[3 * index..3 * index + 3];
            // Ahead of the middle of the bogie.
            let ahead = if index == 0 {
                0.5 * wheelbase
            } else {
                -0.5 * wheelbase
            };
            let place = way::place(self.two_points(), own[0]);
            let lateral_shift = place.lateral_shift;
            let motion = WheelsetMotion {
                curvature,
                half_spacing,
                reference_radius: self.bogie.rolling_radii[1],
                lateral_shift,
                yaw: own[1],
                rotation: own[2],
            };
            let inertial = self.bogie.wheelset_mass * outward;
            let flange = self.flange_force(lateral_shift);
            let suspension = -lateral_stiffness * (lateral_shift - frame_shift - ahead * frame_yaw);
            let suspension_moment = -yaw_stiffness * (own[1] + ahead * curvature - frame_yaw);
            on_frame -= suspension;
            moment_on_frame -= suspension_moment + ahead * suspension;
            let mut lateral = suspension + flange + inertial;
            let mut moment = 0.0;
            let mut torque = fraction * self.bogie.drive_torque[index];
            for (side, rail) in Rail::BOTH.into_iter().enumerate() {
                let row = NORMAL + 2 * index + side;
                let normal_force = unknowns[row];
                if normal_force <= 0.0 || normal_force.is_nan() {
                    return Ok(None);
                }
                let radius = self.bogie.rolling_radii[side];
                let creep = &self.creep[side];
                let wheel = wheel_on_rail(
                    rail,
                    radius,
                    &motion,
                    &place,
                    normal_force,
                    &self.kinematics,
                    creep,
                )?;
                let Some(wheel) = wheel else {
                    return Ok(None);
                };
                let WheelOnRail {
                    mut state,
                    carried,
                    yaw_moment,
                    torque: own_torque,
                } = wheel;
                state.wheelset = index + 1;
                state.vertical_load = loads[side];
                lateral -= state.whole_track_lateral_force();
                moment += yaw_moment;
                torque += own_torque;
                residuals[row] = (carried - loads[side]) / load;
                wheels.push(state);
            }
            residuals[3 * index] = lateral / load;
            residuals[3 * index + 1] = (moment + suspension_moment) / (load * half_spacing);
            residuals[3 * index + 2] = torque / (load * self.bogie.rolling_radii[1]);
            wheelsets.push(WheelsetState {
                lateral_shift,
                yaw: own[1],
                angle_of_attack: -own[1] * self.curve.side(),
                rotation_ratio: 1.0 + own[2],
                flange_force: flange,
                suspension_lateral_force: suspension,
                suspension_yaw_moment: suspension_moment,
                contact_yaw_moment: moment,
                inertial_lateral_force: inertial,
            });
        }
        residuals[FRAME] = on_frame / load;
        residuals[FRAME + 1] = moment_on_frame / (load * half_spacing);
        Ok(Some(Balance {
            residuals,
            wheelsets,
            wheels,
            frame: FrameState {
                lateral_shift: frame_shift,
                yaw: frame_yaw,
                inertial_lateral_force: frame_force,
            },
        }))
    }

    fn flange_force(&self, lateral_shift: f64) -> f64 {
        match self.kinematics {
            Kinematics::Nonlinear {
                flange: Some(spring),
                ..
            } => {
                let beyond = (lateral_shift.abs() - spring.clearance).max(0.0);
                -spring.stiffness * beyond * lateral_shift.signum()
            }
            _ => 0.0,
        }
    }

    fn state(&self, unknowns: &[f64; UNKNOWNS], continuation: Vec<ContinuationStep>) -> BogieState {
        let balance = self.balance(1.0, unknowns);
        let balance = balance.ok().flatten().expect("a root has a balance");
        let largest = |most: f64, residual: &f64| most.max(residual.abs());
        let spacing = self.bogie.contact_spacing;
        let speed = self.curve.speed;
        let turn = |index: usize| {
            balance.wheelsets[index].rotation_ratio * speed / self.bogie.rolling_radii[1]
        };
        BogieState {
            wheelsets: [balance.wheelsets[0], balance.wheelsets[1]],
            wheels: std::array::from_fn(|index| balance.wheels[index]),
            frame: balance.frame,
            uncompensated_acceleration: self.curve.uncompensated_acceleration(spacing),
            normal_acceleration: self.curve.normal_acceleration(spacing),
            frictional_power: speed
                * balance
                    .wheels
                    .iter()
                    .map(WheelState::whole_t_gamma)
                    .sum::<f64>(),
            drive_power: (0..2)
                .map(|index| turn(index) * self.bogie.drive_torque[index])
                .sum(),
            residual: balance.residuals.iter().fold(0.0, largest),
            continuation,
        }
    }
}

/// Forces and moments at values of the unknowns.
struct Balance {
    residuals: [f64; UNKNOWNS],
    wheelsets: Vec<WheelsetState>,
    wheels: Vec<WheelState>,
    frame: FrameState,
}

fn differ(one: &BogieState, other: &BogieState) -> bool {
    let coordinates = |state: &BogieState| {
        let [first, second] = state.wheelsets;
        [
            first.lateral_shift,
            first.yaw,
            second.lateral_shift,
            second.yaw,
        ]
    };
    let pairs = coordinates(one).into_iter().zip(coordinates(other));
    pairs
        .into_iter()
        .any(|(one, other)| (one - other).abs() > SAME)
}
