//! What the keys of a case and their choices are, in every language.

use std::collections::BTreeMap;

use riffel_keys::Words;
use serde_json::Value;

use crate::json_schema;

/// What each key and each choice is, by its description in the schema in one line.
pub fn descriptions() -> BTreeMap<String, Words> {
    let schema = json_schema().to_value();
    let others = schema["$defs"].as_object().into_iter().flatten();
    let others = others.map(|(kind, schema)| (kind.as_str(), schema));
    let types = std::iter::once(("CaseFile", &schema)).chain(others);
    let described = types.flat_map(|(kind, schema)| of_type(kind, schema));
    described.map(|words| (words.to_string(), words)).collect()
}

/// The description of each key and choice of a type, in one line.
fn of_type(kind: &str, schema: &Value) -> Vec<Words> {
    let keys = schema["properties"].as_object().into_iter().flatten();
    let keys = keys.map(|(name, key)| (name.as_str(), key));
    let choices = schema["oneOf"].as_array().into_iter().flatten();
    let choices = choices.filter_map(|choice| Some((choice["const"].as_str()?, choice)));
    let described = keys.chain(choices).filter_map(|(name, schema)| {
        let description = schema["description"].as_str()?.replace('\n', " ");
        Some(Words::new("Key", &format!("{kind}-{name}"), description))
    });
    described.collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use riffel_keys::Language;
    use riffel_keys::message::wordings;

    use super::*;

    /// Every key and every choice is described in German, and none that is not there.
    #[test]
    fn german_has_no_gaps() {
        let schema = json_schema().to_value();
        let others = schema["$defs"].as_object().unwrap().iter().map(|(kind, schema)| (kind.as_str(), schema));
        let types = std::iter::once(("CaseFile", &schema)).chain(others);
        let words: Vec<Words> = types.flat_map(|(kind, schema)| of_type(kind, schema)).collect();
        let ids: BTreeSet<&str> = words.iter().map(Words::id).collect();
        assert!(ids.len() > 300, "{}", ids.len());
        let german = wordings(Language::German);
        let known = german.keys().map(String::as_str).filter(|id| id.starts_with("Key-"));
        assert_eq!(known.collect::<BTreeSet<_>>(), ids);
    }

    /// Keys of other types with the same description have the same words.
    #[test]
    fn one_description_has_one_wording() {
        let schema = json_schema().to_value();
        let described = descriptions();
        for (kind, schema) in schema["$defs"].as_object().unwrap() {
            for words in of_type(kind, schema) {
                let known = described[&words.to_string()].text(Language::German).into_owned();
                assert_eq!(words.text(Language::German), known, "{kind}: {words}");
            }
        }
    }
}
