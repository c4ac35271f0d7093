//! `GET /api/vocabulary`: the keys of a case, the presets with their sources, the nominal case and lines to begin with.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use riffel_case::{
    FREIGHT_CASE, MAIN_LINE_CASE, METRO_CASE, NOMINAL_CASE, TRAM_CASE, descriptions, json_schema, presets,
};
use riffel_keys::{Language, Words};
use serde_json::{Value, json};

/// Lines to begin with, each on a supported track, with the German of their titles.
const LINES: [(&str, &str, &str); 4] = [
    ("main-line", MAIN_LINE_CASE, "Hauptstrecke: 60E1 im Schotter, Schwellen alle 0,6 m"),
    ("freight", FREIGHT_CASE, "Güterstrecke: 60E1 im Schotter, Achslast 22,5 t"),
    ("metro", METRO_CASE, "U-Bahn: 54E1 mit direkter Befestigung alle 0,65 m"),
    ("tram", TRAM_CASE, "Straßenbahn: 54E1 mit direkter Befestigung alle 0,65 m"),
];
/// The German of the title of the nominal case.
const NOMINAL_TITLE: &str = "Hauptstrecke der BR, gerades Gleis";

/// The vocabulary with the nominal case to begin with, in JSON.
pub static VOCABULARY: LazyLock<String> = LazyLock::new(|| vocabulary_of(&NOMINAL_CASE.parse().unwrap_or_default()));

/// The vocabulary in JSON, with the keys of the case to begin with.
pub fn vocabulary_of(case: &toml::Table) -> String {
    let presets: Vec<Value> = presets()
        .iter()
        .map(|preset| {
            let values: Vec<Value> = preset
                .values
                .iter()
                .map(|value| {
                    json!({ "key": value.key, "value": value.value, "badge": value.badge.to_string(),
                        "source": value.source.to_string() })
                })
                .collect();
            json!({ "name": preset.name, "key": preset.kind.key(), "title": preset.title.to_string(), "values": values })
        })
        .collect();
    let lines: Vec<Value> = LINES.iter().map(|&(name, text, _)| json!({ "name": name, "case": keys(text) })).collect();
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "schema": json_schema(),
        "presets": presets,
        "nominal": case,
        "lines": lines,
        "german": german(),
    })
    .to_string()
}

fn keys(text: &str) -> toml::Table {
    text.parse().unwrap_or_default()
}

/// The German of what the keys of a case are, of titles of presets and lines and of sources that are words of our own, by the English.
fn german() -> BTreeMap<String, String> {
    let of_preset = |words: &Words| Language::ALL.map(|language| words.text(language).to_owned());
    let presets = presets().iter().flat_map(|preset| {
        let sources = preset.values.iter().map(|value| &value.source);
        sources.chain([&preset.title]).map(of_preset)
    });
    let presets = presets.filter(|[english, german]| english != german);
    let mut german = descriptions(Language::German);
    german.extend(presets.map(|[english, german]| (english, german)));
    let titled = LINES.map(|(_, text, german)| (text, german));
    let titled = titled.into_iter().chain([(NOMINAL_CASE, NOMINAL_TITLE)]);
    german.extend(titled.filter_map(|(text, german)| {
        let title = keys(text).remove("title")?;
        Some((title.as_str()?.to_owned(), german.to_owned()))
    }));
    german
}
