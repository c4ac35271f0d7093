//! A vehicle, or a part of it, in a curve.

use riffel::Error;

use super::{Axle, Creep, Curve, Kinematics, RunningGear};

/// A vehicle in a curve: one wheelset, a bogie, or two bogies under a body.
#[derive(Clone)]
pub struct VehicleInCurve {
    /// The curve.
    pub curve: Curve,
    /// Every wheelset with its suspension and what it carries.
    pub axle: Axle,
    /// What holds the wheelsets.
    pub running_gear: RunningGear,
    /// Torque on each wheelset \[N m\], positive where it drives forward.
    pub drive_torque: Vec<f64>,
    /// How the wheels roll.
    pub kinematics: Kinematics,
    /// Creep on the left and on the right rail.
    pub creep: [Creep; 2],
}

impl VehicleInCurve {
    pub(super) fn check(&self) -> Result<(), Error> {
        self.axle.check()?;
        self.running_gear.check(&self.axle)?;
        self.curve.check(self.axle.contact_spacing)?;
        let (torques, wheelsets) = (self.drive_torque.len(), self.running_gear.wheelsets());
        if torques != wheelsets {
            return Err(Error::OutOfRange {
                quantity: "number of drive torques",
                value: torques as f64,
                unit: "",
                rule: "must be that of the wheelsets",
            });
        }
        let [left, right] = self.loads(1.0);
        let lowest = left.min(right);
        match lowest > 0.0 {
            true => Ok(()),
            false => Err(Error::OutOfRange {
                quantity: "load of a wheel",
                value: lowest,
                unit: "N",
                rule: "must stay above zero: the vehicle tips over in this curve at this speed",
            }),
        }
    }
}
