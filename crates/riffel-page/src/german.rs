//! The German of what an answer says, and its pieces, beside it.

use riffel_keys::message::Translations;
use serde_json::Value;

/// An answer with the tables of [`Translations`] beside its other keys. The page changes its language without asking anew.
/// What is an answer itself may have brought such tables, which go into these.
pub(crate) fn beside(mut answer: Value, mut known: Translations) -> Value {
    take(&mut answer, &mut known);
    if let (Value::Object(answer), Ok(Value::Object(known))) = (&mut answer, serde_json::to_value(known)) {
        answer.extend(known);
    }
    answer
}

fn take(value: &mut Value, known: &mut Translations) {
    match value {
        Value::Object(table) => {
            let tables = Translations::KEYS.into_iter();
            let own: Value = tables.filter_map(|key| table.remove_entry(key)).collect();
            known.extend(serde_json::from_value(own).unwrap_or_default());
            table.values_mut().for_each(|value| take(value, known));
        }
        Value::Array(list) => list.iter_mut().for_each(|value| take(value, known)),
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
        let (answer, known) = with_translations(|| json!({ "rule": say!(is_missing), "inner": inner }));
        let expected = json!({ "rule": "is missing", "inner": { "value": 1 }, "german": { "is missing": "fehlt", "low": "innen" } });
        assert_eq!(beside(answer, known), expected);
        assert_eq!(beside(json!({ "value": 1 }), Translations::default()), json!({ "value": 1 }));
    }
}
