//! The German of what an answer says, beside it.

use std::collections::BTreeMap;

use serde_json::Value;

/// Key of the table.
const GERMAN: &str = "german";

/// An answer with a table `german` beside its other keys: the German of its messages, by their English. The page changes its
/// language without asking anew. What is an answer itself may have brought such a table, which goes into this one.
pub(crate) fn beside(mut answer: Value, mut german: BTreeMap<String, String>) -> Value {
    take(&mut answer, &mut german);
    if let (Value::Object(answer), false) = (&mut answer, german.is_empty()) {
        answer.insert(GERMAN.to_owned(), serde_json::json!(german));
    }
    answer
}

fn take(value: &mut Value, german: &mut BTreeMap<String, String>) {
    match value {
        Value::Object(table) => {
            if let Some(Value::Object(own)) = table.remove(GERMAN) {
                let texts = own.into_iter();
                german.extend(
                    texts.filter_map(|(english, text)| Some((english, text.as_str()?.to_owned()))),
                );
            }
            table.values_mut().for_each(|value| take(value, german));
        }
        Value::Array(list) => list.iter_mut().for_each(|value| take(value, german)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use riffel_keys::message::with_translations;
    use riffel_keys::say;
    use serde_json::json;

    use super::*;

    #[test]
    fn what_is_said_has_its_german_beside_it() {
        let inner = json!({ "value": 1, "german": { "low": "innen" } });
        let (answer, german) =
            with_translations(|| json!({ "rule": say!(is_missing), "inner": inner }));
        let expected = json!({ "rule": "is missing", "inner": { "value": 1 }, "german": { "is missing": "fehlt", "low": "innen" } });
        assert_eq!(beside(answer, german), expected);
        assert_eq!(
            beside(json!({ "value": 1 }), BTreeMap::new()),
            json!({ "value": 1 })
        );
    }
}
