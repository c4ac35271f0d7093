//! The beginning of a sentence.

use riffel_keys::{Language, Message, Words, say};

/// Words with a capital first letter.
pub fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// A message as a sentence of its own.
pub fn sentence(message: &Message, language: Language) -> String {
    message.capitalised(language) + "."
}

/// The same as a message.
pub(crate) fn as_sentence(message: &Message) -> Message {
    in_each(|language| sentence(message, language))
}

/// A message with a capital first letter.
pub(crate) fn capitalised(message: &Message) -> Message {
    in_each(|language| message.capitalised(language))
}

fn in_each(words: impl Fn(Language) -> String) -> Message {
    say!(verbatim, words = Words::new(words(Language::English), Some(words(Language::German))))
}
