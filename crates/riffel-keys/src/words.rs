//! Words of a file of data in several languages.

use std::fmt;

use crate::{Language, Message, say};

/// Words in English and, where the file has them, in German.
#[derive(Debug, Clone, PartialEq)]
pub struct Words {
    english: String,
    german: Option<String>,
}

impl Words {
    /// As they stand in the file.
    pub fn new(english: String, german: Option<String>) -> Self {
        Self { english, german }
    }

    /// In a language; in English where the file has no others.
    pub fn text(&self, language: Language) -> &str {
        match language {
            Language::English => &self.english,
            Language::German => self.german.as_ref().unwrap_or(&self.english),
        }
    }
}

impl From<&Words> for Message {
    fn from(words: &Words) -> Self {
        let [english, german] = [Language::English, Language::German].map(|language| words.text(language));
        say!(in_both_languages, english = english, german = german)
    }
}

/// In English.
impl fmt::Display for Words {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&self.english)
    }
}
