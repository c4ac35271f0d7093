//! What is said to a reader, as data: which message it is, and its values. Words are made of it where it is shown.
//!
//! The wordings are Fluent files, one a language (`messages/en.ftl`, `messages/de.ftl`). The English one also declares the
//! messages: [`say!`](crate::say) takes its ids and the names of their values, and a wrong one does not compile.
//!
//! ```
//! use riffel_keys::{Language, number, say};
//!
//! let remark = say!(no_average_over_patch, shortest = number(4.5));
//! assert!(remark.text(Language::English).ends_with("below 4.5 mm growth is overstated"));
//! assert!(remark.text(Language::German).contains("unter 4,5 mm"));
//! ```

mod data;
mod text;
mod value;
pub mod wording;
mod wordings;
mod words;

use std::fmt;

use serde::ser::{Serialize, Serializer};

use crate::Language;

pub use data::as_data;
pub use value::{
    Value, decimal, fixed, number, quantity, range, shown_speed, shown_speeds, significant, significant_digits,
};
pub use wordings::wordings;
pub use words::Words;

/// A message of the Fluent files with the values that it names.
#[derive(Debug, Clone, PartialEq)]
pub struct Message {
    id: &'static str,
    values: Box<[(&'static str, Value)]>,
}

/// A [`Message`] by its id, with underscores for hyphens, and its values: `say!(far_away, distance = number(x))`, or `say!(far_away, distance)`
/// where a variable has the name of the value.
#[macro_export]
macro_rules! say {
    (@value $name:ident) => {
        $crate::Value::from($name)
    };
    (@value $name:ident = $value:expr) => {
        $crate::Value::from($value)
    };
    ($id:ident $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        $crate::Message::from($crate::message::wording::$id { $($name: $crate::say!(@value $name $(= $value)?)),* })
    };
}

impl Message {
    /// What a message calls `key` is one.
    fn new(id: &'static str, values: Vec<(&'static str, Value)>) -> Self {
        let values = values.into_iter().map(|(name, value)| match value {
            Value::Text(key) if name == "key" => (name, Value::Key(key)),
            value => (name, value),
        });
        let values = values.collect();
        Self { id, values }
    }

    /// Words that are the same in every language, such as the title of a case that somebody wrote.
    pub fn verbatim(words: impl Into<String>) -> Self {
        say!(verbatim, words = words.into())
    }

    /// With what it is about before it: a rail, a file.
    #[must_use]
    pub fn about(self, subject: impl Into<Value>) -> Self {
        say!(about, subject = subject.into(), remark = self)
    }

    /// Several sentences as one; None without any.
    pub fn one_after_other(said: impl IntoIterator<Item = Self>) -> Option<Self> {
        said.into_iter().reduce(Self::followed_by)
    }

    /// With another sentence behind it.
    #[must_use]
    pub fn followed_by(self, other: Self) -> Self {
        say!(one_after_other, one = self, other)
    }

    /// Which message it is, as in the Fluent files.
    pub fn id(&self) -> &'static str {
        self.id
    }

    /// Whether it is a sentence of its own. What a key is or is not begins with `is` in its id, and what it is together with
    /// another with `and`: these come after the key.
    pub fn has_subject(&self) -> bool {
        let begins = match &self.values[..] {
            // What no language file has, has its words alone.
            [(_, Value::Text(words))] if self.id == "verbatim" => words.replace(' ', "-"),
            _ => self.id.to_owned(),
        };
        !begins.starts_with("is-") && !begins.starts_with("and-")
    }

    /// Its values by their names.
    pub fn values(&self) -> &[(&'static str, Value)] {
        &self.values
    }

    /// In words.
    pub fn text(&self, language: Language) -> String {
        text::text(self, language, None)
    }

    /// In words, in one line of a terminal where the language has a shorter wording for that.
    pub fn short(&self, language: Language) -> String {
        text::text(self, language, Some("short"))
    }

    /// In words, the first letter a capital.
    pub fn capitalised(&self, language: Language) -> String {
        let text = self.text(language);
        let mut letters = text.chars();
        let first = letters.next().map(char::to_uppercase);
        first.into_iter().flatten().chain(letters).collect()
    }

    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.text(Language::English).is_empty()
    }

    /// The message with what somebody wrote at length cut short.
    #[must_use]
    pub fn clipped(self) -> Self {
        let values = self.values.into_iter();
        let values = values.map(|(name, value)| (name, value.clipped())).collect();
        Self { values, ..self }
    }

    /// Data of the message: `id`, `text` in the language, `values` by their names.
    pub fn document(&self, language: Language) -> serde_json::Value {
        let values = self.values.iter();
        let values = values.map(|(name, value)| ((*name).to_owned(), value.document(language)));
        serde_json::json!({
            "id": self.id,
            "text": self.text(language),
            "values": values.collect::<serde_json::Map<_, _>>(),
        })
    }
}

/// Words that are the same in every language.
impl From<String> for Message {
    fn from(words: String) -> Self {
        Self::verbatim(words)
    }
}

/// Words that are the same in every language.
impl From<&str> for Message {
    fn from(words: &str) -> Self {
        Self::verbatim(words)
    }
}

/// Words that are the same in every language.
impl From<&String> for Message {
    fn from(words: &String) -> Self {
        Self::verbatim(words)
    }
}

/// Words that are the same in every language.
impl From<fmt::Arguments<'_>> for Message {
    fn from(words: fmt::Arguments<'_>) -> Self {
        Self::verbatim(words.to_string())
    }
}

impl From<&Self> for Message {
    fn from(message: &Self) -> Self {
        message.clone()
    }
}

/// In English.
impl fmt::Display for Message {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&self.text(Language::English))
    }
}

/// In English, or as data where the reader makes the words of it ([`as_data`]).
impl Serialize for Message {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match data::is_asked_for() {
            true => data::of_message(self).serialize(serializer),
            false => serializer.serialize_str(&self.text(Language::English)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_shown_and_serialized_in_english() {
        let message = say!(no_average_over_patch, shortest = fixed(4.5, 1));
        let english =
            "the contact is quasi-static and does not average over its patch: below 4.5 mm growth is overstated";
        assert_eq!(message.to_string(), english);
        assert_eq!(serde_json::to_string(&message).unwrap(), format!("\"{english}\""));
        assert_eq!(
            message.short(Language::English),
            "the contact does not average over its patch: growth is overstated below 4.5 mm"
        );
        assert_eq!(message.short(Language::German), message.text(Language::German));
        assert!(message.capitalised(Language::English).starts_with("The "));
    }

    /// French has some messages only.
    #[test]
    fn what_a_language_leaves_out_is_said_in_english() {
        let inner = say!(no_average_over_patch, shortest = fixed(4.5, 1));
        assert_eq!(inner.text(Language::French), inner.text(Language::English).replace("4.5", "4,5"));
        let outer = say!(note, remark = inner.clone()).text(Language::French);
        assert_eq!(outer, format!("remarque : {}", inner.text(Language::French)));
    }

    #[test]
    fn messages_stand_within_messages_and_words_of_others_stay() {
        let name = say!(mechanism_p2);
        let message = say!(branch_with_share, words = name, share = Message::verbatim("0.5 {%}"));
        assert_eq!(message.text(Language::German), "P2-Resonanz mit 0.5 {%} seines Wachstums");
    }
}
