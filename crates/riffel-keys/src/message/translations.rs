//! The messages of an answer in another language and in pieces, beside it.

use std::cell::RefCell;
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{Message, Piece, piece};
use crate::Language;
use crate::text_file::in_a_message;

thread_local! {
    /// What is known of each message that was written since somebody listens.
    static WRITTEN: RefCell<Option<Translations>> = const { RefCell::new(None) };
}

/// What a reader who knows the English of some messages may need beside it, to change the language or to show keys and
/// quantities in its own way.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Translations {
    /// The German of each message, by its English; what is the same in both languages is left out.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub german: BTreeMap<String, String>,
    /// The pieces of each message that names a key or a quantity, by its English and the code of a language.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub message_pieces: BTreeMap<String, BTreeMap<String, Vec<Piece>>>,
}

impl Translations {
    /// Keys of its tables.
    pub const KEYS: [&str; 2] = ["german", "message_pieces"];

    /// Take in what is known of others.
    pub fn extend(&mut self, other: Self) {
        self.german.extend(other.german);
        self.message_pieces.extend(other.message_pieces);
    }

    /// Take in a message whose English and German are shown as `shown`.
    fn add(&mut self, message: &Message, shown: impl Fn(&str) -> String) {
        let [english, german] = Language::ALL.map(|language| message.pieces(language));
        let english_words = shown(&piece::join(&english));
        let german_words = shown(&piece::join(&german));
        if english.iter().any(|piece| !matches!(piece, Piece::Words(_))) {
            let languages = Language::ALL.map(|language| language.code().to_owned());
            let pieces = languages.into_iter().zip([english, german]).collect();
            self.message_pieces.insert(english_words.clone(), pieces);
        }
        if english_words != german_words {
            self.german.insert(english_words, german_words);
        }
    }
}

/// The result of `write`, and what is known of every message that it serializes: for a reader that changes its language
/// without asking anew.
pub fn with_translations<T>(write: impl FnOnce() -> T) -> (T, Translations) {
    let outer = WRITTEN.replace(Some(Translations::default()));
    let written = write();
    let known = WRITTEN.replace(outer).unwrap_or_default();
    (written, known)
}

/// What is known of messages, by their English as it is shown where no character commands a terminal.
pub fn translations<'a>(messages: impl IntoIterator<Item = &'a Message>) -> Translations {
    let mut known = Translations::default();
    for message in messages {
        known.add(message, |words| in_a_message(words).into_owned());
    }
    known
}

/// Keep what is known of a message, if somebody listens.
pub(super) fn note(message: &Message) {
    WRITTEN.with_borrow_mut(|written| {
        if let Some(written) = written {
            written.add(message, str::to_owned);
        }
    });
}
