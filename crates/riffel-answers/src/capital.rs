//! The beginning of a sentence.

use riffel_keys::{Language, Message};

/// Words with a capital first letter.
pub fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// A message as a sentence of its own.
pub fn sentence(message: &Message, language: Language) -> String {
    message.capitalised(language) + "."
}
