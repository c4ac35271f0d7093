//! The wheelset of a case.

use riffel::wheelset::{ContactReceptances, FlexibleWheelset, RigidWheelset, Wheelset};

/// A wheelset of any of the models of a case.
#[derive(Debug, Clone)]
pub enum CaseWheelset {
    /// One rigid body.
    Rigid(RigidWheelset),
    /// A flexible axle with rigid discs.
    Flexible(FlexibleWheelset),
}

impl Wheelset for CaseWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        match self {
            Self::Rigid(wheelset) => wheelset.receptances(angular_frequency),
            Self::Flexible(wheelset) => wheelset.receptances(angular_frequency),
        }
    }
}
