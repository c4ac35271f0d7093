//! A vehicle balanced in its curve.

use std::sync::OnceLock;

use riffel_curving::profile::ProfileContact;
use riffel_curving::{VehicleInCurve, VehicleState};

use super::CurvingCase;

/// A vehicle balanced in its curve, which several cases take their mean states from.
pub(crate) struct Equilibrium {
    pub(crate) curving: CurvingCase,
    pub(crate) vehicle: VehicleInCurve,
    /// First that to which straight track leads; there is one at least.
    pub(crate) states: Vec<VehicleState>,
    /// Contacts of each wheelset beside where it stands in the first state, once they were asked for.
    pub(crate) beside: Vec<OnceLock<Vec<[ProfileContact; 2]>>>,
}

impl Equilibrium {
    pub(crate) fn new(curving: CurvingCase, vehicle: VehicleInCurve, states: Vec<VehicleState>) -> Self {
        let beside = vec![OnceLock::new(); vehicle.running_gear.wheelsets()];
        Self { curving, vehicle, states, beside }
    }
}
