//! The languages of sentences.

use serde::Deserialize;

/// A language in which a sentence can be had.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
pub enum Language {
    /// English, that of the program, its documents and the Python package.
    #[default]
    #[serde(rename = "en")]
    English,
    /// German, for the page.
    #[serde(rename = "de")]
    German,
}

impl Language {
    /// The wording in this language of one that stands in both.
    pub(crate) fn pick<T>(self, english: T, german: T) -> T {
        match self {
            Self::English => english,
            Self::German => german,
        }
    }

    /// Words with numbers as this language writes them: 0.5 and 0,5. Only a point between digits is
    /// taken for that of a number.
    pub fn numbers(self, words: &str) -> String {
        if self == Self::English {
            return words.to_owned();
        }
        let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        let mut written = String::with_capacity(words.len());
        let mut rest = words.chars().peekable();
        while let Some(c) = rest.next() {
            let between =
                c == '.' && is_digit(written.chars().next_back()) && is_digit(rest.peek().copied());
            written.push(if between { ',' } else { c });
        }
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_point_or_the_comma_of_their_language() {
        let words = "R = 0.46 m, I = 2.350e-5 m⁴. Eq. 2 of contact.hertz.";
        assert_eq!(Language::English.numbers(words), words);
        assert_eq!(
            Language::German.numbers(words),
            "R = 0,46 m, I = 2,350e-5 m⁴. Eq. 2 of contact.hertz."
        );
    }
}
