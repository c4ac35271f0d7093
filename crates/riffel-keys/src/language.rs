//! The languages of messages.

use serde::Deserialize;

/// Languages, each with its ISO 639 code, by which its Fluent file is called, and its decimal mark.
macro_rules! languages {
    ($($(#[$doc:meta])* $name:ident $code:literal $decimal_mark:literal;)*) => {
        /// A language in which messages can be had.
        #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
        pub enum Language {
            $($(#[$doc])* #[serde(rename = $code)] $name,)*
        }

        impl Language {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Its ISO 639 code.
            pub fn code(self) -> &'static str {
                match self { $(Self::$name => $code),* }
            }

            /// What stands between the whole part of a number and the rest.
            pub fn decimal_mark(self) -> &'static str {
                match self { $(Self::$name => $decimal_mark),* }
            }

            /// Its Fluent file.
            pub(crate) fn wordings(self) -> &'static str {
                match self { $(Self::$name => include_str!(concat!("../messages/", $code, ".ftl"))),* }
            }
        }
    };
}

// A further language is a Fluent file and a line here; what the file leaves out is said in English.
languages! {
    /// English, that of documents and of the Python package.
    #[default]
    English "en" ".";
    /// German.
    German "de" ",";
    /// French.
    French "fr" ",";
}

impl Language {
    /// The language of a code.
    pub fn of_code(code: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|language| language.code() == code)
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
