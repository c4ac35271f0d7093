//! Equilibrium of a vehicle in a curve.

use rayon::prelude::*;
use riffel::Error;
use riffel::cancel::check;

use super::balance::Balance;
use super::newton::{Root, root};
use super::state::ContinuationStep;
use super::two_point_path;
use super::{VehicleInCurve, VehicleState, WheelState};

/// Largest residual over the static load of a wheel that counts as equilibrium. Rounding leaves 1e-14 to 1e-12.
const TOLERANCE: f64 = 1e-10;
/// Shortest step from straight track to the curve, as a share.
const SHORTEST: f64 = 1.0 / 4096.0;
/// Most steps of the continuation, of which some ten are usual.
const MOST_STEPS: usize = 400;
/// Two states are one if no shift \[m\] and no yaw \[rad\] differs by more.
const SAME: f64 = 1e-8;
/// Shifts \[m\] of the wheelsets of a frame from which further states are sought.
const STARTS: [f64; 5] = [-6e-3, -2.5e-3, 0.0, 2.5e-3, 6e-3];

/// Unknowns at the curve, with the steps that led there.
type Reached = (Vec<f64>, Vec<ContinuationStep>);

impl VehicleInCurve {
    /// The equilibrium that straight track leads to as curvature, uncompensated acceleration, torques and moments
    /// grow together; where that way breaks off, one found from other starts.
    ///
    /// Method: Newton with halved steps, steps of the continuation halved where it fails. Unknown are the shifts, ψ and Ω of the
    /// wheelsets, y and ψ of frames and the normal forces of the wheels. Where a wheel stands on two points its shift is held,
    /// and the share of each in the normal force takes its place as unknown, 0 to 1: both are what complementarity asks.
    /// With FASTSIM the equilibrium of Shen, Hedrick & Elkins is the start of its own.
    /// Cost: 0.2 ms with a closed creep law, some 50 ms with FASTSIM.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a value that no vehicle has; [`Error::OffTheRails`] for an equilibrium beyond
    /// [`FARTHEST_SHIFT`](riffel::FARTHEST_SHIFT) or [`LARGEST_YAW`](riffel::LARGEST_YAW), as cones without a flange have in
    /// tight curves; [`Error::TorqueBeyondFriction`] and [`Error::NoEquilibrium`] where none is found, as in a curve that is
    /// tighter than the wheelsets can take.
    pub fn equilibrium(&self) -> Result<VehicleState, Error> {
        self.check()?;
        let (found, steps) = self.reach()?;
        self.state(&found, steps).on_the_rails()
    }

    /// Every equilibrium found: first that of [`equilibrium`](Self::equilibrium), then those which other starts lead to.
    /// That no other exists is not proved. Cost: that of 25 equilibria of a wheelset or a bogie, and 45 of a vehicle, shared by
    /// all threads.
    ///
    /// # Errors
    /// Errors of [`equilibrium`](Self::equilibrium).
    pub fn equilibria(&self) -> Result<Vec<VehicleState>, Error> {
        let mut states = vec![self.equilibrium()?];
        let others = match self.with_closed_laws() {
            None => self.by_other_starts().0,
            Some(closed) => closed
                .distinct(closed.by_other_starts().0)
                .into_par_iter()
                .filter_map(|start| Some(self.solve(1.0, start).ok()?.unknowns))
                .collect(),
        };
        for found in others {
            let Ok(state) = self.state(&found, Vec::new()).on_the_rails() else {
                continue;
            };
            if states.iter().all(|known| differ(known, &state)) {
                states.push(state);
            }
        }
        Ok(states)
    }

    /// The unknowns of the equilibrium, with the steps that led there.
    fn reach(&self) -> Result<Reached, Error> {
        if let Some(closed) = self.with_closed_laws() {
            let (start, mut steps) = closed.reach()?;
            if let Ok(found) = self.solve(1.0, start) {
                steps.push(step(1.0, &found));
                return Ok((found.unknowns, steps));
            }
        }
        let (reached, failure) = match self.continued() {
            Ok(found) => return Ok(found),
            Err(broken_off) => broken_off,
        };
        let (others, failure_of_others) = self.by_other_starts();
        if let Some(found) = others.into_iter().next() {
            return Ok((found, Vec::new()));
        }
        if let Some(error) = self.torque_beyond_friction(self.loads(1.0)) {
            return Err(error);
        }
        let failure = failure.or(failure_of_others);
        Err(failure.unwrap_or(Error::NoEquilibrium { reached }))
    }

    /// The vehicle with closed creep laws in the place of those that cost much more; `None` if it has no other.
    fn with_closed_laws(&self) -> Option<Self> {
        let [left, right] = &self.creep;
        let closed = [left.closed(), right.closed()];
        closed.iter().any(Option::is_some).then(|| {
            let [of_left, of_right] = closed;
            Self {
                creep: [of_left.unwrap_or_else(|| left.clone()), of_right.unwrap_or_else(|| right.clone())],
                ..self.clone()
            }
        })
    }

    /// Roots that lead to states of their own.
    fn distinct(&self, roots: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        let mut known: Vec<(VehicleState, Vec<f64>)> = Vec::new();
        for unknowns in roots {
            let state = self.state(&unknowns, Vec::new());
            if known.iter().all(|(other, _)| differ(other, &state)) {
                known.push((state, unknowns));
            }
        }
        known.into_iter().map(|(_, unknowns)| unknowns).collect()
    }

    fn scales(&self) -> Vec<f64> {
        let places = self.places();
        let of_frame = (0..places.unknowns).map(|place| match place < places.normal {
            true => 1e-3,
            false => self.static_load(),
        });
        of_frame.collect::<Vec<_>>().repeat(self.frames())
    }

    /// A start with the wheelsets of each frame at their shifts \[m\], all in line with the track.
    fn start(&self, fraction: f64, of_frames: &[[f64; 2]]) -> Vec<f64> {
        let [left, right] = self.loads(fraction);
        let places = self.places();
        let of_frame = |shifts: &[f64; 2]| {
            let mut start = vec![0.0; places.unknowns];
            for (own, shift) in shifts.iter().enumerate().take(places.wheelsets) {
                start[3 * own] = two_point_path::coordinate(self.kinematics.two_points(), *shift);
                start[places.normal + 2 * own] = left;
                start[places.normal + 2 * own + 1] = right;
            }
            if places.normal > places.frame {
                start[places.frame] = 0.5 * (shifts[0] + shifts[1]);
            }
            start
        };
        of_frames.iter().flat_map(of_frame).collect()
    }

    /// Frames, that of a lone wheelset too.
    fn frames(&self) -> usize {
        self.running_gear.wheelsets() / self.places().wheelsets
    }

    /// A root near a start, or the first failure that is not one of the equations.
    fn solve(&self, fraction: f64, start: Vec<f64>) -> Result<Root, Option<Error>> {
        let balance = Balance::at(self, fraction);
        root(&balance, start, &self.scales(), TOLERANCE).ok_or_else(|| balance.failure())
    }

    /// The root at the curve by continuation from straight track, or the share of the curve that was reached and what failed.
    fn continued(&self) -> Result<Reached, (f64, Option<Error>)> {
        let centred = vec![[0.0; 2]; self.frames()];
        let straight = self.solve(0.0, self.start(0.0, &centred));
        let found = straight.map_err(|failure| (0.0, failure))?;
        let mut steps = vec![step(0.0, &found)];
        let (mut reached, mut unknowns, mut stride) = (0.0, found.unknowns, 0.25);
        let mut failure = None;
        for _ in 0..MOST_STEPS {
            check();
            let target = f64::min(reached + stride, 1.0);
            match self.solve(target, unknowns.clone()) {
                Ok(found) => {
                    steps.push(step(target, &found));
                    (reached, unknowns) = (target, found.unknowns);
                    if reached == 1.0 {
                        return Ok((unknowns, steps));
                    }
                    stride *= 2.0;
                }
                Err(failed) => {
                    failure = failure.or(failed);
                    if stride <= SHORTEST {
                        return Err((reached, failure));
                    }
                    stride *= 0.5;
                }
            }
        }
        Err((reached, failure))
    }

    /// Roots at the curve from starts of shifted wheelsets, in the order of the starts, and the first failure.
    fn by_other_starts(&self) -> (Vec<Vec<f64>>, Option<Error>) {
        let pairs = STARTS.iter().flat_map(|first| STARTS.map(|second| [*first, second]));
        let mut starts: Vec<Vec<[f64; 2]>> = pairs.map(|shifts| vec![shifts; self.frames()]).collect();
        if self.frames() == 2 {
            // Bogies that stand at different places.
            let apart = STARTS.iter().flat_map(|leading| {
                let trailing = STARTS.iter().filter(move |trailing| *trailing != leading);
                trailing.map(|trailing| vec![[*leading; 2], [*trailing; 2]])
            });
            starts.extend(apart);
        }
        let solved: Vec<Result<Root, Option<Error>>> =
            starts.par_iter().map(|shifts| self.solve(1.0, self.start(1.0, shifts))).collect();
        let mut found = Vec::new();
        let mut failure = None;
        for solved in solved {
            match solved {
                Ok(root) => found.push(root.unknowns),
                Err(failed) => failure = failure.or(failed),
            }
        }
        (found, failure)
    }

    fn state(&self, unknowns: &[f64], continuation: Vec<ContinuationStep>) -> VehicleState {
        let balance = Balance::at(self, 1.0).whole(unknowns);
        let balance = balance.expect("a root has a balance");
        let largest = |most: f64, residual: &f64| most.max(residual.abs());
        let spacing = self.axle.contact_spacing;
        let speed = self.curve.speed;
        let turn = |index: usize| balance.wheelsets[index].rotation_ratio * speed / self.axle.rolling_radii[1];
        VehicleState {
            uncompensated_acceleration: self.curve.uncompensated_acceleration(spacing),
            normal_acceleration: self.curve.normal_acceleration(spacing),
            frictional_power: speed * balance.wheels.iter().map(WheelState::whole_t_gamma).sum::<f64>(),
            drive_power: self.drive_torque.iter().enumerate().map(|(index, torque)| turn(index) * torque).sum(),
            residual: balance.residuals.iter().fold(0.0, largest),
            wheelsets: balance.wheelsets,
            wheels: balance.wheels,
            frames: balance.frames,
            body: balance.body,
            continuation,
        }
    }
}

fn step(fraction: f64, found: &Root) -> ContinuationStep {
    ContinuationStep { fraction, residual: found.residual, iterations: found.iterations }
}

fn differ(one: &VehicleState, other: &VehicleState) -> bool {
    let pairs = one.wheelsets.iter().zip(&other.wheelsets);
    pairs.into_iter().any(|(one, other)| {
        (one.lateral_shift - other.lateral_shift).abs() > SAME || (one.yaw - other.yaw).abs() > SAME
    })
}
