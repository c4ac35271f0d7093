//! `GET /api/vocabulary`: the keys of a case, the presets with their sources, the nominal case and lines to begin with.

use std::sync::LazyLock;

use riffel_case::{
    FREIGHT_CASE, MAIN_LINE_CASE, METRO_CASE, NOMINAL_CASE, TRAM_CASE, json_schema, presets,
};
use serde_json::{Value, json};

use riffel_words::in_german;

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
                        "source": value.source })
                })
                .collect();
            json!({ "name": preset.name, "key": preset.kind.key(), "title": preset.title, "values": values })
        })
        .collect();
    let keys = |text: &str| text.parse::<toml::Table>().unwrap_or_default();
    let lines: Vec<Value> = LINES
        .iter()
        .map(|&(name, text)| json!({ "name": name, "case": keys(text) }))
        .collect();
    let vocabulary = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "schema": json_schema(),
        "presets": presets,
        "nominal": case,
        "lines": lines,
    });
    with_german(vocabulary).to_string()
}

fn with_german(mut answer: Value) -> Value {
    let mut german = serde_json::Map::new();
    collect(&answer, &mut german);
    answer["german"] = german.into();
    answer
}

fn collect(value: &Value, german: &mut serde_json::Map<String, Value>) {
    match value {
        Value::Object(table) => table.values().for_each(|value| collect(value, german)),
        Value::Array(list) => list.iter().for_each(|value| collect(value, german)),
        Value::String(text) => {
            let text = text.trim().replace('\n', " ");
            if let Some(words) = in_german(&text) {
                german.insert(text, words.into());
            }
        }
        _ => {}
    }
}
