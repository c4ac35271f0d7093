//! What the keys of a case and their choices are, in every language.

use std::collections::BTreeMap;

use riffel_keys::Language;
use serde_json::Value;
use toml::Table;

use crate::json_schema;

/// The wordings of a language; English ones are the comments on the types of the file.
fn wordings(language: Language) -> &'static str {
    match language {
        Language::English => "",
        Language::German => include_str!("file/de.toml"),
    }
}

/// A key of a type of the case file, or one of its choices.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    kind: String,
    name: String,
}

/// What each key and each choice is: the description of the schema, in one line, and that in the language, if it has one of its own.
pub fn descriptions(language: Language) -> BTreeMap<String, String> {
    let file: Table = wordings(language).parse().unwrap_or_default();
    let wording = |place: &Place| file.get(&place.kind)?.get(&place.name)?.as_str();
    let places = english().into_iter();
    let pairs = places.filter_map(|(place, english)| Some((english, wording(&place)?.to_owned())));
    pairs.collect()
}

/// The description of each key and choice in the schema, in one line.
fn english() -> Vec<(Place, String)> {
    let schema = json_schema().to_value();
    let others = schema["$defs"].as_object().into_iter().flatten();
    let others = others.map(|(kind, schema)| (kind.as_str(), schema));
    let types = std::iter::once(("CaseFile", &schema)).chain(others);
    types.flat_map(|(kind, schema)| of_type(kind, schema)).collect()
}

fn of_type(kind: &str, schema: &Value) -> Vec<(Place, String)> {
    let keys = schema["properties"].as_object().into_iter().flatten();
    let keys = keys.map(|(name, key)| (name.as_str(), key));
    let choices = schema["oneOf"].as_array().into_iter().flatten();
    let choices = choices.filter_map(|choice| Some((choice["const"].as_str()?, choice)));
    let described = keys.chain(choices).filter_map(|(name, schema)| {
        let place = Place { kind: kind.to_owned(), name: name.to_owned() };
        Some((place, schema["description"].as_str()?.replace('\n', " ")))
    });
    described.collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Every key and every choice is described in every language, in the same words where it is in English, and none that is not
    /// there.
    #[test]
    fn languages_have_no_gaps() {
        let english = english();
        let places: BTreeSet<&Place> = english.iter().map(|(place, _)| place).collect();
        assert!(places.len() > 300, "{}", places.len());
        for language in Language::ALL.into_iter().skip(1) {
            let file: Table = wordings(language).parse().unwrap();
            let of_type = |(kind, names): (&String, &toml::Value)| {
                let names = names.as_table().unwrap().keys().cloned();
                let place = |name| Place { kind: kind.clone(), name };
                names.map(place).collect::<Vec<_>>()
            };
            let known: Vec<Place> = file.iter().flat_map(of_type).collect();
            assert_eq!(known.iter().collect::<BTreeSet<_>>(), places, "{language:?}");
            let descriptions = descriptions(language);
            for (place, english) in &english {
                let own = file[&place.kind][&place.name].as_str();
                assert_eq!(descriptions.get(english).map(String::as_str), own, "{place:?}");
            }
        }
    }
}
