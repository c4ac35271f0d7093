//! What quantities are called, in every language.

use crate::Words;

/// A quantity, by the English name that physics and keys give it, in every language: "wheel load" of an error of the physics,
/// "a force" of a [`Kind`](super::Kind).
pub fn named(english: &str) -> Words {
    Words::by_english("Quantity", english)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;
    use crate::quantity::KINDS;
    use crate::{Language, say};

    /// All sources of some crates, tests aside.
    fn sources() -> String {
        fn collect(folder: &Path, text: &mut String) {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    collect(&path, text);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let source = fs::read_to_string(&path).unwrap();
                    *text += source.split("#[cfg(test)]\nmod tests {").next().unwrap();
                }
            }
        }
        let mut text = String::new();
        for name in ["riffel", "riffel-keys", "riffel-case", "riffel-answers", "riffel-cli"] {
            let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
            collect(&crates.join(name).join("src"), &mut text);
        }
        text
    }

    #[test]
    fn every_name_has_its_german_and_is_given_to_something() {
        let sources = sources();
        let places = ["unless_positive(", "unless_not_negative(", "quantity:", "problem:", "creepage:"];
        let after = places.iter().flat_map(|place| sources.split(place).skip(1));
        let given = after.filter_map(|rest| rest.trim_start().strip_prefix('"')?.split('"').next());
        let given: Vec<&str> = given.chain(KINDS.iter().map(|kind| kind.name)).collect();
        assert!(given.len() > 200, "{}", given.len());
        for name in given {
            assert!(named(name).is_in(Language::German), "no German of {name:?}");
        }
    }

    #[test]
    fn a_name_is_a_value_of_a_message() {
        let message = say!(quoted, words = named("wheel load"));
        let texts = [Language::English, Language::German].map(|language| message.text(language));
        assert_eq!(texts, ["\"wheel load\"", "„die Radlast“"]);
    }
}
