//! A wheelset, a bogie or a vehicle in its curve: shifts, angles of attack, creepages, forces and wear number of each wheel.

mod document;
mod over_radius;
mod remarks;

use riffel::curving::{VehicleInCurve, VehicleState};
use riffel_case::CurvingCase;
use riffel_keys::{CaseError, Message};

pub use document::CurveDocument;
pub use over_radius::OverRadius;

/// The equilibrium of the vehicle of a case.
pub struct CurveAnswer {
    vehicle: VehicleInCurve,
    /// The equilibrium that straight track leads to.
    pub state: VehicleState,
    /// Further ones that were found.
    pub others: Vec<VehicleState>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

impl CurveAnswer {
    /// The vehicle of a case in its curve.
    ///
    /// # Errors
    /// [`CaseError`] for a key that is missing or has a value that is not allowed, and where no equilibrium is found.
    pub fn new(case: &CurvingCase) -> Result<Self, CaseError> {
        Self::of_vehicle(case, case.vehicle_in_curve()?)
    }

    /// The same with the vehicle of the case, which takes most of the time.
    ///
    /// # Errors
    /// [`CaseError`] where no equilibrium is found.
    pub fn of_vehicle(case: &CurvingCase, vehicle: VehicleInCurve) -> Result<Self, CaseError> {
        let mut states = case.equilibria(&vehicle)?.into_iter();
        let state = states.next().expect("at least one equilibrium");
        let mut remarks = case.remarks_of_profiles()?;
        remarks.extend(remarks::of(case, &vehicle, &state));
        Ok(Self { remarks, vehicle, state, others: states.collect() })
    }

    /// The vehicle in curves of other radii \[m\], none of them zero, each at the lateral acceleration of the case; by default
    /// from a fifth to twenty times that of the case.
    pub fn over_radius(&self, radii: Option<&[f64]>) -> OverRadius {
        OverRadius::new(&self.vehicle, radii)
    }

    /// What `riffel curve --json` prints, with equilibria at listed radii \[m\].
    pub fn document(&self, radii: Option<&[f64]>) -> CurveDocument {
        let over_radius = radii.map(|radii| self.over_radius(Some(radii)).document());
        CurveDocument::new(self, over_radius)
    }
}
