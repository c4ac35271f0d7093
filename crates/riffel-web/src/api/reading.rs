//! How a record is read, and which part of it.

use riffel_rail::ReaderFormat;
use serde::Deserialize;
use serde_json::{Value, json};

/// What all questions about a record say of it.
#[derive(Default, Deserialize)]
pub(super) struct Reading {
    /// How the file is laid out, where the reader has chosen columns.
    #[serde(default)]
    format: Option<ReaderFormat>,
    /// Where the part begins and ends that is asked about; none, and it is the whole record.
    #[serde(default)]
    from_m: Option<f64>,
    #[serde(default)]
    to_m: Option<f64>,
}

impl Reading {
    /// Say it in a question to the program.
    pub(super) fn add_to(&self, mut question: Value) -> Value {
        question["format"] = json!(self.format);
        for (key, place) in [("from", self.from_m), ("to", self.to_m)] {
            question[key] = json!(place.map(|metres| format!("{metres} m")));
        }
        question
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_is_told_of_a_part_in_metres() {
        let reading: Reading = serde_json::from_str(r#"{"from_m": -2.5, "to_m": 1200}"#).unwrap();
        let question = reading.add_to(json!({ "file": "a.csv" }));
        assert_eq!((&question["from"], &question["to"]), (&json!("-2.5 m"), &json!("1200 m")));
        let whole = Reading::default().add_to(json!({}));
        assert_eq!(whole["from"], Value::Null);
    }
}
