//! Words that stand in English where they are used.

use std::borrow::Cow;
use std::fmt;

use super::Message;
use super::text::wording_of;
use crate::{Language, say};

/// Words whose English stands in the physics, in a file of data or at a type, and whose other languages stand in the Fluent files.
#[derive(Debug, Clone, PartialEq)]
pub struct Words {
    id: String,
    english: String,
}

impl Words {
    /// Words of a kind, such as `Preset`, by a name among those of the kind.
    ///
    /// Their id in the Fluent files is `KIND-NAME`, with a hyphen for whatever is no letter, digit or underscore.
    pub fn new(kind: &str, name: &str, english: impl Into<String>) -> Self {
        let is_of_id = |letter: &char| letter.is_ascii_alphanumeric() || *letter == '_';
        let mut id = format!("{kind}-");
        for letter in name.chars() {
            match is_of_id(&letter) {
                true => id.push(letter),
                false if !id.ends_with('-') => id.push('-'),
                false => {}
            }
        }
        id.truncate(id.trim_end_matches('-').len());
        Self { id, english: english.into() }
    }

    /// Words of a kind that go by their English, such as the name of a quantity.
    pub(crate) fn by_english(kind: &str, english: &str) -> Self {
        Self::new(kind, english, english)
    }

    /// Their id in the Fluent files.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// In a language; in English where it has no others.
    pub fn text(&self, language: Language) -> Cow<'_, str> {
        wording_of(&self.id, language).unwrap_or(Cow::Borrowed(&self.english))
    }

    /// Whether a language has words of its own.
    pub fn is_in(&self, language: Language) -> bool {
        wording_of(&self.id, language).is_some()
    }
}

impl From<&Words> for Message {
    fn from(words: &Words) -> Self {
        say!(verbatim, words = words.clone())
    }
}

/// In English.
impl fmt::Display for Words {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&self.english)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;
    use crate::message::wordings;
    use crate::physics_in_words::PHYSICS;

    /// All texts that stand in the sources of some crates.
    fn literals(folder: &Path, found: &mut BTreeSet<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                literals(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let source = std::fs::read_to_string(&path).unwrap();
                let mut lines = source.split("\\\n");
                let first = lines.next().unwrap_or_default().to_owned();
                let joined = lines.fold(first, |text, line| text + line.trim_start());
                found.extend(joined.split('"').map(str::to_owned));
            }
        }
    }

    #[test]
    fn words_that_go_by_their_english_stand_in_the_sources() {
        let mut found = BTreeSet::new();
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        for name in PHYSICS.into_iter().chain(["riffel-keys", "riffel-case", "riffel-answers", "riffel-cli"]) {
            literals(&crates.join(name).join("src"), &mut found);
        }
        for kind in ["Rule", "Quantity", "Field", "Format"] {
            let known: BTreeSet<String> = found.iter().map(|text| Words::by_english(kind, text).id).collect();
            for id in wordings(Language::German).keys().filter(|id| id.starts_with(kind)) {
                assert!(known.contains(id), "nothing is called {id}");
            }
        }
    }
}
