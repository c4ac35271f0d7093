//! The beginning of a sentence.

use riffel_keys::{Language, Message, Value, say};

/// A message as a sentence of its own.
pub fn sentence(message: &Message, language: Language) -> String {
    message.capitalised(language) + "."
}

/// Message that begins as a sentence of its own.
pub(crate) fn as_sentence(message: &Message) -> Message {
    say!(sentence, words = Value::Capital(message.clone().into()))
}

/// A message with a capital first letter.
pub(crate) fn capitalised(message: &Message) -> Message {
    say!(verbatim, words = Value::Capital(message.clone().into()))
}
