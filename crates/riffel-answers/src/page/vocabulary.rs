//! `GET /api/vocabulary`: the keys of a case, the presets with their sources, the nominal case and lines to begin with.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use riffel_case::{
    FREIGHT_CASE, MAIN_LINE_CASE, METRO_CASE, NOMINAL_CASE, TRAM_CASE, descriptions, json_schema, presets,
};
use riffel_keys::message::as_data;
use riffel_keys::{Message, Words};
use serde_json::{Value, json};

/// Lines to begin with, each on a supported track.
const LINES: [(&str, &str); 4] =
    [("main-line", MAIN_LINE_CASE), ("freight", FREIGHT_CASE), ("metro", METRO_CASE), ("tram", TRAM_CASE)];

/// The vocabulary with the nominal case to begin with, in JSON.
pub static VOCABULARY: LazyLock<String> = LazyLock::new(|| vocabulary_of(&NOMINAL_CASE.parse().unwrap_or_default()));

/// The vocabulary in JSON, with the keys of the case to begin with; its words are data.
pub fn vocabulary_of(case: &toml::Table) -> String {
    as_data(|| written(case))
}

fn written(case: &toml::Table) -> String {
    let said = |words: &Words| Message::from(words);
    let presets: Vec<Value> = presets()
        .iter()
        .map(|preset| {
            let values: Vec<Value> = preset
                .values
                .iter()
                .map(|value| {
                    json!({ "key": value.key, "value": value.value, "badge": value.badge.to_string(),
                        "source": said(&value.source) })
                })
                .collect();
            json!({ "name": preset.name, "key": preset.kind.key(), "title": said(&preset.title), "values": values })
        })
        .collect();
    let lines: Vec<Value> = LINES.iter().map(|&(name, text)| json!({ "name": name, "case": keys(text) })).collect();
    let titled = LINES.into_iter().chain([("nominal", NOMINAL_CASE)]);
    let titles = titled.filter_map(|(name, text)| Some(Words::new("Line", name, keys(text).get("title")?.as_str()?)));
    let descriptions = descriptions().into_iter().map(|(english, words)| (english, json!(said(&words)))).collect();
    let mut schema = json_schema().to_value();
    describe(&mut schema, &descriptions);
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "schema": schema,
        "presets": presets,
        "nominal": case,
        "lines": lines,
        "titles": titles.map(|title| json!(said(&title))).collect::<Vec<_>>(),
    })
    .to_string()
}

/// Put words that may have other languages in the place of descriptions.
fn describe(schema: &mut Value, words: &BTreeMap<String, Value>) {
    match schema {
        Value::Object(table) => {
            let english = table.get("description").and_then(Value::as_str).map(|text| text.replace('\n', " "));
            if let Some(words) = english.and_then(|english| words.get(&english)) {
                table.insert("description".to_owned(), words.clone());
            }
            table.values_mut().for_each(|value| describe(value, words));
        }
        Value::Array(list) => list.iter_mut().for_each(|value| describe(value, words)),
        _ => {}
    }
}

fn keys(text: &str) -> toml::Table {
    text.parse().unwrap_or_default()
}
