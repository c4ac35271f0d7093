//! `GET /api/vocabulary`: the keys of a case, the presets with their sources, the nominal case and lines to begin with.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use riffel_case::{
    FREIGHT_CASE, MAIN_LINE_CASE, METRO_CASE, NOMINAL_CASE, TRAM_CASE, descriptions, json_schema,
    presets,
};
use riffel_keys::{Language, Words};
use serde_json::{Value, json};

/// Lines to begin with, each on a supported track.
const LINES: [(&str, &str); 4] = [
    ("main-line", MAIN_LINE_CASE),
    ("freight", FREIGHT_CASE),
    ("metro", METRO_CASE),
    ("tram", TRAM_CASE),
];

/// The vocabulary with the nominal case to begin with, in JSON.
pub static VOCABULARY: LazyLock<String> =
    LazyLock::new(|| vocabulary_of(&NOMINAL_CASE.parse().unwrap_or_default()));

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
    let keys = |text: &str| text.parse::<toml::Table>().unwrap_or_default();
    let lines: Vec<Value> = LINES
        .iter()
        .map(|&(name, text)| json!({ "name": name, "case": keys(text) }))
        .collect();
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

/// The German of what the keys of a case are, of titles of presets and of sources that are words of our own, by the English.
fn german() -> BTreeMap<String, String> {
    let of_preset = |words: &Words| Language::ALL.map(|language| words.text(language).to_owned());
    let presets = presets().iter().flat_map(|preset| {
        let sources = preset.values.iter().map(|value| &value.source);
        sources.chain([&preset.title]).map(of_preset)
    });
    let presets = presets.filter(|[english, german]| english != german);
    let mut german = descriptions(Language::German);
    german.extend(presets.map(|[english, german]| (english, german)));
    german
}
