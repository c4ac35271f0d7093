//! What the reader of a case should know.

use std::fmt;

use serde::{Serialize, Serializer};

use crate::{Language, Sentence};

/// A sentence on the validity of a case, in English and in German.
///
/// It is shown and serialized in English: that is what the program prints and its documents hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Remark {
    english: String,
    german: String,
    /// The English sentence in short, where it is longer than a line.
    short: Option<String>,
}

impl Remark {
    /// A remark from its two wordings, numbers in both with a decimal point.
    pub fn new(english: impl Into<String>, german: impl AsRef<str>) -> Self {
        Self {
            english: english.into(),
            german: Language::German.numbers(german.as_ref()),
            short: None,
        }
    }

    /// A sentence of the catalogue with its values, which may differ by language. The program prints its short wording
    /// unless it is asked for the whole.
    pub fn of(
        sentence: Sentence,
        values: impl Fn(Language) -> Vec<(&'static str, String)>,
    ) -> Self {
        let filled = |language: Language| {
            let values = values(language);
            let values: Vec<(&str, &dyn fmt::Display)> = values
                .iter()
                .map(|(name, value)| (*name, value as &dyn fmt::Display))
                .collect();
            (language.fill(sentence, &values), sentence.in_short(&values))
        };
        let (english, short) = filled(Language::English);
        Self {
            short,
            ..Self::new(english, filled(Language::German).0)
        }
    }

    /// The English sentence in one line.
    pub fn short(&self) -> &str {
        self.short.as_deref().unwrap_or(&self.english)
    }

    /// The sentence in a language.
    pub fn in_language(&self, language: Language) -> &str {
        language.pick(&self.english, &self.german)
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&self.english)
    }
}

impl Serialize for Remark {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.english)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_shown_and_serialized_in_english() {
        let remark = Remark::new("below 4.5 mm", "unter 4.5 mm");
        assert_eq!(remark.to_string(), "below 4.5 mm");
        assert_eq!(serde_json::to_string(&remark).unwrap(), "\"below 4.5 mm\"");
        assert_eq!(remark.in_language(Language::German), "unter 4,5 mm");
        assert_eq!(remark.short(), "below 4.5 mm");
    }
}
