//! Cases that tests share.

use riffel_case::Case;
use riffel_keys::CaseError;

/// The case of a text, with overrides.
pub(crate) fn parsed(text: &str, overrides: &[&str]) -> Result<Case, CaseError> {
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    Case::parse("case.toml", text, &overrides)
}

/// One that is right.
pub(crate) fn case(text: &str, overrides: &[&str]) -> Case {
    parsed(text, overrides).unwrap()
}

/// A flexible wheelset on a track whose layers are viscous, so that nothing of it is cut.
pub(crate) fn trailer(overrides: &[&str]) -> Case {
    let viscous = [
        "track.model=one-layer",
        "track.pad.loss_factor=0",
        "track.pad.damping=20e3",
        "rail.loss_factor=0",
        "contact.creep_law=polach",
    ];
    case(include_str!("../../../../cases/wheelset-metro-trailer.toml"), &[&viscous, overrides].concat())
}
