//! The names of rails in sentences.

use riffel_keys::{Message, say};

/// The name of a rail by itself: of the usual ones each language has its own.
pub fn name_in_words(name: &str) -> Message {
    match name {
        "left" => say!(left),
        "right" => say!(right),
        "low" => say!(low),
        "high" => say!(high),
        name => Message::verbatim(name),
    }
}

/// A rail in a sentence.
pub fn rail_in_words(name: &str) -> Message {
    match name.starts_with("rail") || name.starts_with("column") {
        true => Message::verbatim(name),
        false => say!(rail_named, name = name_in_words(name)),
    }
}
