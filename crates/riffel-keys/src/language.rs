//! The languages of messages. A further one is a Fluent file and a line here.

use serde::Deserialize;

/// A language in which messages can be had.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
pub enum Language {
    /// English, that of documents and of the Python package.
    #[default]
    #[serde(rename = "en")]
    English,
    /// German.
    #[serde(rename = "de")]
    German,
}

impl Language {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// Its ISO 639 code.
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// What stands between the whole part of a number and the rest.
    pub fn decimal_mark(self) -> &'static str {
        match self {
            Self::English => ".",
            Self::German => ",",
        }
    }

    /// Its Fluent file.
    pub(crate) fn wordings(self) -> &'static str {
        match self {
            Self::English => include_str!("../messages/en.ftl"),
            Self::German => include_str!("../messages/de.ftl"),
        }
    }

    /// Words with numbers as this language writes them: a point between digits becomes its decimal mark.
    pub fn numbers(self, words: &str) -> String {
        let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        let mut written = String::with_capacity(words.len());
        let mut rest = words.chars().peekable();
        while let Some(c) = rest.next() {
            let before = written.chars().next_back();
            match c == '.' && is_digit(before) && is_digit(rest.peek().copied()) {
                true => written.push_str(self.decimal_mark()),
                false => written.push(c),
            }
        }
        written
    }
}
