//! A vehicle balanced in its curve.

use riffel::curving::{VehicleInCurve, VehicleState};

use super::CurvingCase;

/// A vehicle balanced in its curve, which several cases take their mean states from.
#[derive(Clone)]
pub(crate) struct Equilibrium {
    pub(crate) curving: CurvingCase,
    pub(crate) vehicle: VehicleInCurve,
    /// First that to which straight track leads; there is one at least.
    pub(crate) states: Vec<VehicleState>,
}
