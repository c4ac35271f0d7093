//! What no vehicle does: limits of an equilibrium.

use riffel::{Error, FARTHEST_SHIFT, LARGEST_YAW};

use super::{Creep, VehicleInCurve, VehicleState};

impl VehicleState {
    /// `Ok` for wheelsets on their rails, shifted by less than [`FARTHEST_SHIFT`] and yawed by less than [`LARGEST_YAW`].
    pub(super) fn on_the_rails(self) -> Result<Self, Error> {
        for (index, wheelset) in self.wheelsets.iter().enumerate() {
            let (lateral_shift, yaw) = (wheelset.lateral_shift, wheelset.yaw);
            if lateral_shift.abs() >= FARTHEST_SHIFT || yaw.abs() >= LARGEST_YAW {
                return Err(Error::OffTheRails { wheelset: index + 1, lateral_shift, yaw });
            }
        }
        Ok(self)
    }
}

impl VehicleInCurve {
    /// A drive torque that is larger than Σ μ r W under the vertical loads W of the wheels of its wheelset \[N\], left and
    /// right. On a flange normal forces are larger than W: this is why no equilibrium is found, but does not preclude one.
    pub(super) fn torque_beyond_friction(&self, loads: [f64; 2]) -> Option<Error> {
        let radii = self.axle.rolling_radii;
        let largest: f64 = (0..2)
            .map(|side| match &self.creep[side] {
                Creep::Linear { .. } => f64::INFINITY,
                creep => creep.friction() * radii[side] * loads[side],
            })
            .sum();
        let torques = self.drive_torque.iter().enumerate();
        let (index, torque) = torques.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()))?;
        (torque.abs() > largest).then_some(Error::TorqueBeyondFriction {
            wheelset: index + 1,
            torque: *torque,
            largest,
        })
    }
}
