//! A bogie in its curve: shifts, angles of attack, creepages, forces and wear number of each wheel.

mod document;
mod over_radius;
mod remarks;

use riffel::curving::{BogieInCurve, BogieState};
use riffel_case::CurvingCase;
use riffel_keys::{CaseError, Remark};

pub use document::CurveDocument;
pub use over_radius::OverRadius;

/// The equilibrium of the bogie of a case.
pub struct CurveAnswer {
    bogie: BogieInCurve,
    /// The equilibrium that straight track leads to.
    pub state: BogieState,
    /// Further ones that were found.
    pub others: Vec<BogieState>,
    /// What the reader should know.
    pub remarks: Vec<Remark>,
}

impl CurveAnswer {
    /// The bogie of a case in its curve.
    ///
    /// # Errors
    /// [`CaseError`] for a key that is missing or has a value that is not allowed, and where no equilibrium is found.
    pub fn new(case: &CurvingCase) -> Result<Self, CaseError> {
        let bogie = case.bogie_in_curve()?;
        let mut states = case.equilibria(&bogie)?.into_iter();
        let state = states.next().expect("at least one equilibrium");
        let mut remarks = case.remarks_of_profiles()?;
        remarks.extend(remarks::of(case, &bogie, &state));
        Ok(Self {
            remarks,
            bogie,
            state,
            others: states.collect(),
        })
    }

    /// The bogie in curves of other radii \[m\], none of them zero, each at the lateral acceleration of the case; by default
    /// from a fifth to twenty times that of the case.
    pub fn over_radius(&self, radii: Option<&[f64]>) -> OverRadius {
        OverRadius::new(&self.bogie, radii)
    }

    /// What `riffel curve --json` prints, with equilibria at listed radii \[m\].
    pub fn document(&self, radii: Option<&[f64]>) -> CurveDocument {
        let over_radius = radii.map(|radii| self.over_radius(Some(radii)).document());
        CurveDocument::new(self, over_radius)
    }
}
