//! What vehicles are called in sentences.

use riffel_keys::{Message, say};

/// The name of the only vehicle where a traffic has none of its own.
pub const WHEEL_OF_THE_CASE: &str = "the wheel of the case";

/// The name of a vehicle, as somebody wrote it; that of the case is called so in each language.
pub fn vehicle_in_words(name: &str) -> Message {
    match name {
        WHEEL_OF_THE_CASE => say!(wheel_of_the_case),
        name => Message::verbatim(name),
    }
}
