//! The rails of a track in words.

use riffel_keys::{Message, say};

/// A rail by its name.
pub(crate) fn side(rail: &str) -> Message {
    match rail {
        "left" => say!(left),
        _ => say!(right),
    }
}
