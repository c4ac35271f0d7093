//! A question as JSON on standard input, and the documents that stand in it where a command line names files.
//!
//! A key that holds an object is read through the path `question:KEY`: as TOML where a file of keys is wanted, as CSV where a
//! table is.

use std::io;
use std::path::Path;

use serde_json::{Map, Value};

use crate::standard_input::{LARGEST_RESPONSES, standard_input};

/// What a path to a document of the question begins with.
const HERE: &str = "question:";

/// The path by which the document of a key is read; keys below each other are parted by `.`, as in `variants.0`.
pub fn path_of(key: &str) -> String {
    format!("{HERE}{key}")
}

/// True for the path of a document that stands in the question.
pub fn holds(path: &Path) -> bool {
    key_of(path).is_some()
}

fn key_of(path: &Path) -> Option<&str> {
    path.to_str()?.strip_prefix(HERE)
}

/// The question on standard input.
///
/// # Errors
/// [`io::Error`] if it cannot be read, is larger than [`LARGEST_RESPONSES`] or is not a JSON object.
pub fn read() -> io::Result<Map<String, Value>> {
    let bytes = standard_input(LARGEST_RESPONSES + 1)?;
    if bytes.len() as u64 > LARGEST_RESPONSES {
        let most = LARGEST_RESPONSES >> 20;
        return Err(wrong(format!("the question is larger than {most} MiB")));
    }
    match serde_json::from_slice(&bytes) {
        Ok(Value::Object(question)) => Ok(question),
        Ok(_) => Err(wrong("the question is not a JSON object")),
        Err(error) => Err(wrong(format!("the question is not JSON: {error}"))),
    }
}

/// The document of a path as TOML; `None` for the path of a file.
pub(crate) fn as_toml(path: &Path) -> Option<io::Result<Vec<u8>>> {
    let document = document(path)?;
    Some(document.and_then(|mut keys| {
        leave_out_null(&mut keys);
        let text = toml::to_string(&keys).map_err(|error| wrong(error.to_string()))?;
        Ok(text.into_bytes())
    }))
}

/// The document of a path as CSV, its keys the names of the columns; `None` for the path of a file.
pub fn as_csv(path: &Path) -> Option<io::Result<Vec<u8>>> {
    Some(document(path)?.and_then(|table| columns(&table)))
}

fn document(path: &Path) -> Option<io::Result<Value>> {
    let pointer = format!("/{}", key_of(path)?.replace('.', "/"));
    let missing = || io::Error::new(io::ErrorKind::NotFound, "the question has no such key");
    Some(read().and_then(|question| {
        let question = Value::Object(question);
        question.pointer(&pointer).cloned().ok_or_else(missing)
    }))
}

fn leave_out_null(value: &mut Value) {
    match value {
        Value::Object(table) => {
            table.retain(|_, value| !value.is_null());
            table.values_mut().for_each(leave_out_null);
        }
        Value::Array(list) => list.iter_mut().for_each(leave_out_null),
        _ => {}
    }
}

fn columns(table: &Value) -> io::Result<Vec<u8>> {
    let columns: Vec<(&String, &Vec<Value>)> = table
        .as_object()
        .into_iter()
        .flatten()
        .map(|(name, values)| match values {
            Value::Array(values) => Ok((name, values)),
            other => Err(wrong(format!("{name} is {other}, but must be a list"))),
        })
        .collect::<io::Result<_>>()?;
    let rows = columns.first().map_or(0, |(_, values)| values.len());
    if let Some((name, values)) = columns.iter().find(|(_, values)| values.len() != rows) {
        let count = values.len();
        let message = format!("{name} has {count} values, but the first column has {rows}");
        return Err(wrong(message));
    }
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let names = columns.iter().map(|(name, _)| quoted(name));
    let mut text = names.collect::<Vec<_>>().join(",");
    for row in 0..rows {
        let cells = columns.iter().map(|(_, values)| match &values[row] {
            Value::Null => String::new(),
            Value::String(text) => quoted(text),
            other => other.to_string(),
        });
        text += &format!("\n{}", cells.collect::<Vec<_>>().join(","));
    }
    text.push('\n');
    Ok(text.into_bytes())
}

fn wrong(message: impl Into<String>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, message.into())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn columns_become_a_table_of_equal_length() {
        let table = json!({ "wavelength_m": [0.05, 0.063], "rail": ["left, \"L\"", null] });
        let csv = String::from_utf8(columns(&table).unwrap()).unwrap();
        let expected = "\"wavelength_m\",\"rail\"\n0.05,\"left, \"\"L\"\"\"\n0.063,\n";
        assert_eq!(csv, expected);
        let of = |table| columns(&table).unwrap_err().to_string();
        assert_eq!(of(json!({ "a": [1, 2], "b": [1] })), "b has 1 values, but the first column has 2");
        assert_eq!(of(json!({ "a": 1 })), "a is 1, but must be a list");
    }
}
