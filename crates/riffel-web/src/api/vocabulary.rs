//! `GET /api/vocabulary`: the keys of a case, the presets with their sources, and the case to begin with.

use std::sync::LazyLock;

use axum::http::header;
use axum::response::IntoResponse;
use riffel_case::{NOMINAL_CASE, json_schema, presets};
use serde_json::{Value, json};

/// It is the same for every request.
static VOCABULARY: LazyLock<String> = LazyLock::new(|| {
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
    let nominal: toml::Table = NOMINAL_CASE.parse().unwrap_or_default();
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "schema": json_schema(),
        "presets": presets,
        "nominal": nominal,
    })
    .to_string()
});

pub(crate) async fn get() -> impl IntoResponse {
    (
        [(header::CONTENT_TYPE, "application/json")],
        VOCABULARY.as_str(),
    )
}
