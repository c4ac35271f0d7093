//! Messages as data, for a reader who makes words of them in its own language and units.

use std::cell::Cell;

use serde_json::{Map, Value as Json, json};

use super::{Message, Value};
use crate::printable::in_a_message;

thread_local! {
    /// Whether messages are serialized as data.
    static AS_DATA: Cell<bool> = const { Cell::new(false) };
}

/// Sets back what was asked for, whatever happens meanwhile.
struct Before(bool);

impl Drop for Before {
    fn drop(&mut self) {
        AS_DATA.set(self.0);
    }
}

/// The result of `write`, in which each message is serialized as an object of its `id` and its `values`.
///
/// What a message takes over verbatim stands in its place. Words that are the same in every language are texts. Another value is a count, a list, an inner message or
/// an object: `{number}` with a decimal point; `{text, si, unit}` and `{text, speeds_m_per_s}` as they are displayed and in SI;
/// `{key}` of the case; `{id, english}` of words that may have other languages; `{capital}`, a message that begins with a capital
/// letter.
pub fn as_data<T>(write: impl FnOnce() -> T) -> T {
    let _before = Before(AS_DATA.replace(true));
    write()
}

pub(super) fn is_asked_for() -> bool {
    AS_DATA.get()
}

pub(super) fn of_message(message: &Message) -> Json {
    if let ("verbatim", [(_, words)]) = (message.id, &message.values[..]) {
        return of_value(words);
    }
    let values = message.values.iter().map(|(name, value)| ((*name).to_owned(), of_value(value)));
    json!({ "id": message.id, "values": values.collect::<Map<_, _>>() })
}

fn of_value(value: &Value) -> Json {
    match value {
        Value::Text(text) => in_a_message(text).into(),
        Value::Number(number) => json!({ "number": number }),
        Value::Quantity { shown, si, unit } => json!({ "text": shown, "si": si, "unit": unit }),
        Value::Speeds { shown, speeds_m_per_s } => json!({ "text": shown, "speeds_m_per_s": speeds_m_per_s }),
        Value::Count(count) => json!(count),
        Value::Key(key) => json!({ "key": key }),
        Value::Words(words) => json!({ "id": words.id(), "english": words.to_string() }),
        Value::Message(message) => of_message(message),
        Value::Capital(message) => json!({ "capital": of_message(message) }),
        Value::List(values) => values.iter().map(of_value).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::named;
    use crate::{number, say};

    #[test]
    fn a_message_is_its_id_and_values_while_that_is_asked_for() {
        let load = crate::message::quantity(1500.0, "N", "1.5 kN");
        let rule = say!(is_but_must_be, value = load, rule = "more");
        let message = say!(key_and_rule, key = "contact.normal_load", rule);
        let expected = json!({
            "id": "key-and-rule",
            "values": {
                "key": { "key": "contact.normal_load" },
                "rule": {
                    "id": "is-but-must-be",
                    "values": { "rule": "more", "value": { "text": "1.5 kN", "si": 1500.0, "unit": "N" } },
                },
            },
        });
        let written = as_data(|| json!(message));
        assert_eq!(written, expected);
        assert_eq!(json!(message), json!(message.to_string()));
        let title = Message::verbatim("Metro\u{7}");
        assert_eq!(as_data(|| json!(title)), json!("Metro\\u{7}"));
        let name = as_data(|| json!(say!(quoted, words = named("wheel load"))));
        assert_eq!(name["values"]["words"], json!({ "id": "Quantity-wheel-load", "english": "wheel load" }));
        let traffic = say!(traffic_at_speeds, traffic = "trains", speeds = crate::shown_speeds([10.0, 25.0]));
        let speeds = as_data(|| json!(traffic))["values"]["speeds"].clone();
        assert_eq!(speeds, json!({ "text": "36–90 km/h", "speeds_m_per_s": [10.0, 25.0] }));
        let shortest = as_data(|| json!(say!(no_average_over_patch, shortest = number(4.5))));
        assert_eq!(shortest["values"]["shortest"], json!({ "number": "4.5" }));
    }

    #[test]
    fn what_breaks_off_asks_for_nothing_later() {
        let broken = std::panic::catch_unwind(|| as_data(|| panic!("on purpose")));
        assert!(broken.is_err() && !is_asked_for());
    }
}
