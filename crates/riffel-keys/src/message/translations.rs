//! The messages of an answer in another language, beside it.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::Message;
use crate::Language;
use crate::text_file::in_a_message;

thread_local! {
    /// English of each message that was written since somebody listens, with its German.
    static WRITTEN: RefCell<Option<BTreeMap<String, String>>> = const { RefCell::new(None) };
}

/// The result of `write`, and the German of every message that it serializes, by its English: for a reader that changes
/// its language without asking anew.
pub fn with_translations<T>(write: impl FnOnce() -> T) -> (T, BTreeMap<String, String>) {
    let outer = WRITTEN.replace(Some(BTreeMap::new()));
    let written = write();
    let german = WRITTEN.replace(outer).unwrap_or_default();
    (written, german)
}

/// The German of messages by their English, both as they are shown where no character commands a terminal; what is the same
/// in both languages is left out.
pub fn translations<'a>(
    messages: impl IntoIterator<Item = &'a Message>,
) -> BTreeMap<String, String> {
    let shown = |message: &Message, language| in_a_message(&message.text(language)).into_owned();
    let both = messages.into_iter().map(|message| {
        let english = shown(message, Language::English);
        (english, shown(message, Language::German))
    });
    both.filter(|(english, german)| english != german).collect()
}

/// Keep the German of a message, if somebody listens and it differs.
pub(super) fn note(message: &Message, english: &str) {
    WRITTEN.with_borrow_mut(|written| {
        let Some(written) = written else { return };
        if !written.contains_key(english) {
            let german = message.text(Language::German);
            if german != english {
                written.insert(english.to_owned(), german);
            }
        }
    });
}
