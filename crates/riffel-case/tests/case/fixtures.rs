//! Cases that tests share.

use proptest::prelude::*;
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

/// Changes of a text: a place, how many characters are cut there, and what is put in.
type Edits = Vec<(prop::sample::Index, usize, String)>;

/// Pieces of case files, and noise, at any places.
pub(crate) fn edits() -> impl Strategy<Value = Edits> {
    let pieces = "= [ ] { } \" ' \n . , # - 1e999 nan 0 -1 \"5_kN/%\" \"1_m-9\" \"90_deg\" \"0.3_1/m\" [contact] [train] [wheelset] \
                  mass segments points wheel creepage µ 9999999999999999999999";
    let pieces: Vec<String> = pieces.split(' ').map(|piece| piece.replace('_', " ")).collect();
    let piece = prop_oneof![prop::sample::select(pieces), "\\PC{0,8}"];
    prop::collection::vec((any::<prop::sample::Index>(), 0..12usize, piece), 1..6)
}

/// The text with these changes.
pub(crate) fn mutated(text: &str, edits: &Edits) -> String {
    let mut text: Vec<char> = text.chars().collect();
    for (place, cut, piece) in edits {
        let start = place.index(text.len());
        let end = (start + cut).min(text.len());
        text.splice(start..end, piece.chars());
    }
    text.into_iter().collect()
}
