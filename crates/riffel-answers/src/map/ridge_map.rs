//! A growth map with its ridge.

use riffel::{GrowthMap, Ridge};
use riffel_case::Case;

use crate::ridge::{BranchDocument, ridge_of};

/// The growth map of a case with its ridge.
pub struct RidgeMap {
    /// Ŵ₁ over the window of the case.
    pub map: GrowthMap,
    /// Its ridge.
    pub ridge: Ridge,
    /// The branches of the ridge, the strongest first.
    pub branches: Vec<BranchDocument>,
}

impl RidgeMap {
    /// The map over the window of the case; `progress` is told of rows done, one for each speed.
    pub fn new(case: &Case, progress: impl Fn(usize) + Sync) -> Self {
        let map = GrowthMap::compute(&case.feedback, case.wavelength, case.speed, progress);
        let ridge = ridge_of(case, &case.feedback);
        Self { branches: BranchDocument::all(case, &ridge), map, ridge }
    }
}
