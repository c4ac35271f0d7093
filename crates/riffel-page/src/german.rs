//! The German of what an answer says, beside it.

use riffel_words::in_german;
use serde_json::{Map, Value};

/// An answer with a table `german` beside its other keys: of each of its texts that the catalogue knows, in one line, the German. The
/// page changes its language without asking anew.
pub(crate) fn with_german(mut answer: Value) -> Value {
    let mut german = Map::new();
    collect(&answer, &mut german);
    if let (Value::Object(answer), false) = (&mut answer, german.is_empty()) {
        answer.insert("german".to_owned(), german.into());
    }
    answer
}

fn collect(value: &Value, german: &mut Map<String, Value>) {
    match value {
        // Has both languages itself.
        Value::Object(note) if note.contains_key("en") && note.contains_key("de") => {}
        Value::Object(table) => table.values().for_each(|value| collect(value, german)),
        Value::Array(list) => list.iter().for_each(|value| collect(value, german)),
        // The lines of a text are broken anywhere.
        Value::String(text) => {
            let text = text.trim().replace('\n', " ");
            if let (false, Some(words)) = (german.contains_key(&text), in_german(&text)) {
                german.insert(text, words.into());
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn what_is_said_has_its_german_beside_it() {
        let answer = json!({
            "verdict": ["over the limit", 3.5],
            "hint": "within\nthe limit",
            "note": { "en": "low", "de": "innen" },
        });
        let german = with_german(answer)["german"].clone();
        let expected = json!({ "over the limit": "über der Grenze", "within the limit": "innerhalb der Grenze" });
        assert_eq!(german, expected);
        assert_eq!(with_german(json!({ "value": 1 })), json!({ "value": 1 }));
    }
}
