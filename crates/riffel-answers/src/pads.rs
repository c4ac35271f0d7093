//! A case on other pads.

use riffel_case::Case;
use riffel_keys::CaseError;
use riffel_keys::quantity::Quantity;

/// The case with pads of another stiffness \[N/m\].
pub(crate) fn with_pads_of(case: &Case, stiffness: f64) -> Result<Case, CaseError> {
    case.edit(|keys| {
        let pad = keys.track.pad.get_or_insert_default();
        pad.stiffness = Some(Quantity::new(stiffness));
    })
}
