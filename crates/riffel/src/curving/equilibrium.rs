//! Equilibrium of a vehicle in a curve.

use super::balance::Balance;
use super::newton::{Root, root};
use super::state::ContinuationStep;
use super::way;
use super::{VehicleInCurve, VehicleState, WheelState};
use crate::Error;

/// Largest residual over the static load of a wheel that counts as equilibrium. Rounding leaves 1e-14 to 1e-12.
const TOLERANCE: f64 = 1e-10;
/// Shortest step from straight track to the curve, as a share.
const SHORTEST: f64 = 1.0 / 4096.0;
/// Two states are one if no shift \[m\] and no yaw \[rad\] differs by more.
const SAME: f64 = 1e-8;
/// Lateral shifts \[m\] of the wheelsets of a frame from which further states are sought.
const STARTS: [f64; 5] = [-6e-3, -2.5e-3, 0.0, 2.5e-3, 6e-3];

impl VehicleInCurve {
    /// The equilibrium that straight track leads to as curvature, uncompensated acceleration, torques and moments
    /// grow together; where that way breaks off, one found from other starts.
    ///
    /// Method: Newton with halved steps, steps of the continuation halved where it fails. Unknown are y, ψ and Ω of the
    /// wheelsets, y and ψ of frames and the normal forces of the wheels. Where a wheel stands on two points y is held,
    /// and the share of each in the normal force takes its place as unknown, 0 to 1: both are what complementarity asks.
    /// Cost: 0.2 ms with a closed creep law.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a value that no vehicle has; [`Error::OffTheRails`] for an equilibrium beyond
    /// [`FARTHEST_SHIFT`](super::FARTHEST_SHIFT) or [`LARGEST_YAW`](super::LARGEST_YAW), as cones without a flange have in
    /// tight curves; [`Error::TorqueBeyondFriction`] and [`Error::NoEquilibrium`] where none is found, as in a curve that is
    /// tighter than the wheelsets can take.
    pub fn equilibrium(&self) -> Result<VehicleState, Error> {
        self.check()?;
        let mut failure = None;
        let reached = match self.continued(&mut failure) {
            Ok((found, steps)) => return self.state(&found, steps).on_the_rails(),
            Err(reached) => reached,
        };
        if let Some(found) = self.by_other_starts(&mut failure).into_iter().next() {
            return self.state(&found, Vec::new()).on_the_rails();
        }
        if let Some(error) = self.torque_beyond_friction(self.loads(1.0)) {
            return Err(error);
        }
        Err(failure.unwrap_or(Error::NoEquilibrium { reached }))
    }

    /// Every equilibrium found: first that of [`equilibrium`](Self::equilibrium), then those which other starts lead to.
    /// That no other exists is not proved.
    ///
    /// # Errors
    /// As [`equilibrium`](Self::equilibrium).
    pub fn equilibria(&self) -> Result<Vec<VehicleState>, Error> {
        let mut states = vec![self.equilibrium()?];
        for found in self.by_other_starts(&mut None) {
            let Ok(state) = self.state(&found, Vec::new()).on_the_rails() else {
                continue;
            };
            if states.iter().all(|known| differ(known, &state)) {
                states.push(state);
            }
        }
        Ok(states)
    }

    fn scales(&self) -> Vec<f64> {
        let places = self.places();
        let of_frame = (0..places.unknowns).map(|place| match place < places.normal {
            true => 1e-3,
            false => self.static_load(),
        });
        let frames = self.running_gear.wheelsets() / places.wheelsets;
        of_frame.collect::<Vec<_>>().repeat(frames)
    }

    /// A start with the wheelsets of every frame at these shifts, all in line with the track.
    fn start(&self, fraction: f64, shifts: [f64; 2]) -> Vec<f64> {
        let [left, right] = self.loads(fraction);
        let places = self.places();
        let mut start = vec![0.0; places.unknowns];
        for (own, shift) in shifts.iter().enumerate().take(places.wheelsets) {
            start[3 * own] = way::coordinate(self.kinematics.two_points(), *shift);
            start[places.normal + 2 * own] = left;
            start[places.normal + 2 * own + 1] = right;
        }
        if places.normal > places.frame {
            start[places.frame] = 0.5 * (shifts[0] + shifts[1]);
        }
        start.repeat(self.running_gear.wheelsets() / places.wheelsets)
    }

    fn solve(&self, fraction: f64, start: Vec<f64>, failure: &mut Option<Error>) -> Option<Root> {
        let balance = Balance::at(self, fraction);
        let found = root(&balance, start, &self.scales(), TOLERANCE);
        if failure.is_none() {
            *failure = balance.failure();
        }
        found
    }

    /// The root at the curve by continuation from straight track, or the share of the curve that was reached.
    fn continued(
        &self,
        failure: &mut Option<Error>,
    ) -> Result<(Vec<f64>, Vec<ContinuationStep>), f64> {
        let mut steps = Vec::new();
        let mut record = |fraction: f64, found: &Root| {
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
            match self.solve(target, unknowns.clone(), failure) {
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
    fn by_other_starts(&self, failure: &mut Option<Error>) -> Vec<Vec<f64>> {
        let pairs = STARTS
            .iter()
            .flat_map(|first| STARTS.map(|second| [*first, second]));
        let found = pairs.filter_map(|shifts| self.solve(1.0, self.start(1.0, shifts), failure));
        found.map(|found| found.unknowns).collect()
    }

    fn state(&self, unknowns: &[f64], continuation: Vec<ContinuationStep>) -> VehicleState {
        let balance = Balance::at(self, 1.0).whole(unknowns);
        let balance = balance.expect("a root has a balance");
        let largest = |most: f64, residual: &f64| most.max(residual.abs());
        let spacing = self.axle.contact_spacing;
        let speed = self.curve.speed;
        let turn = |index: usize| {
            balance.wheelsets[index].rotation_ratio * speed / self.axle.rolling_radii[1]
        };
        VehicleState {
            uncompensated_acceleration: self.curve.uncompensated_acceleration(spacing),
            normal_acceleration: self.curve.normal_acceleration(spacing),
            frictional_power: speed
                * balance
                    .wheels
                    .iter()
                    .map(WheelState::whole_t_gamma)
                    .sum::<f64>(),
            drive_power: self
                .drive_torque
                .iter()
                .enumerate()
                .map(|(index, torque)| turn(index) * torque)
                .sum(),
            residual: balance.residuals.iter().fold(0.0, largest),
            wheelsets: balance.wheelsets,
            wheels: balance.wheels,
            frames: balance.frames,
            body: balance.body,
            continuation,
        }
    }
}

fn differ(one: &VehicleState, other: &VehicleState) -> bool {
    let pairs = one.wheelsets.iter().zip(&other.wheelsets);
    pairs.into_iter().any(|(one, other)| {
        (one.lateral_shift - other.lateral_shift).abs() > SAME || (one.yaw - other.yaw).abs() > SAME
    })
}
