//! A question as JSON, and the documents and values that stand in it where a command line names files.
//!
//! What stands under a key is read through the path `question:KEY`: a document as TOML where a file of keys is wanted, as CSV where
//! a table is.

use std::any::Any;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use serde_json::{Map, Value};

use crate::json::Unambiguous;
use crate::standard_input::{LARGEST_RESPONSES, standard_input};
use crate::{Message, say};

/// A value of any type.
type Shared = Arc<dyn Any + Send + Sync>;

/// What stands in the questions that are being answered, by path, for the threads of all of them.
static STANDING: Mutex<BTreeMap<PathBuf, Shared>> = Mutex::new(BTreeMap::new());

fn standing() -> MutexGuard<'static, BTreeMap<PathBuf, Shared>> {
    STANDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What stands in one question: it can be read until this goes.
#[derive(Debug, Default)]
#[must_use]
pub struct Held(Vec<PathBuf>);

impl Held {
    /// Hold a document, a [`Value`], or a value in memory under a key; returns the path by which it is read. Where another question
    /// holds the same key, a number follows.
    pub fn hold(&mut self, key: &str, value: Arc<impl Any + Send + Sync>) -> PathBuf {
        let mut standing = standing();
        let mut path = PathBuf::from(format!("question:{key}"));
        for number in 2.. {
            if !standing.contains_key(&path) {
                break;
            }
            path = format!("question:{key}#{number}").into();
        }
        standing.insert(path.clone(), value);
        self.0.push(path.clone());
        path
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        let mut standing = standing();
        self.0.iter().for_each(|path| _ = standing.remove(path));
    }
}

/// True for the path of what stands in a question.
pub fn holds(path: &Path) -> bool {
    standing().contains_key(path)
}

/// True for the path of a value in memory that stands in a question without a document.
pub fn is_value(path: &Path) -> bool {
    standing().get(path).is_some_and(|shared| !shared.is::<Value>())
}

/// The key under which a document or a value stands in a question; `None` for the path of a file.
pub fn key_of(path: &Path) -> Option<&Path> {
    let key = path.to_str()?.strip_prefix("question:").filter(|_| holds(path))?;
    Some(Path::new(key.split_once('#').map_or(key, |(key, _)| key)))
}

/// The value in memory that stands in a question under this path, if it is of this type.
pub fn value<T: Any + Send + Sync>(path: &Path) -> Option<Arc<T>> {
    let shared = standing().get(path)?.clone();
    shared.downcast().ok()
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
    of_json(&bytes).map_err(|message| wrong(message.to_string()))
}

/// A question of its JSON.
///
/// # Errors
/// A [`Message`] if it is not a JSON object, or names a key twice.
pub fn of_json(bytes: &[u8]) -> Result<Map<String, Value>, Message> {
    match serde_json::from_slice(bytes) {
        Ok(Unambiguous(Value::Object(question))) => Ok(question),
        Ok(_) => Err("the question is not a JSON object".into()),
        Err(error) if error.is_data() => {
            let told = error.to_string();
            let (key, _) = told.rsplit_once(" at line ").unwrap_or((&told, ""));
            Err(say!(key_is_given_twice, key, line = error.line()))
        }
        Err(error) => Err(format!("the question is not JSON: {error}").into()),
    }
}

/// The document of a path as TOML; `None` for the path of a file.
pub(crate) fn as_toml(path: &Path) -> Option<io::Result<Vec<u8>>> {
    let keys = without_null(Value::clone(&*value(path)?));
    let text = toml::to_string(&keys).map_err(|error| wrong(error.to_string()));
    Some(text.map(String::into_bytes))
}

/// The document of a path as CSV, its keys the names of the columns; `None` for the path of a file.
pub fn as_csv(path: &Path) -> Option<io::Result<Vec<u8>>> {
    Some(columns(&*value(path)?))
}

/// A document without the keys that are null: they are left out.
#[must_use]
pub fn without_null(mut value: Value) -> Value {
    match &mut value {
        Value::Object(table) => {
            table.retain(|_, value| !value.is_null());
            table.values_mut().for_each(|value| *value = without_null(value.take()));
        }
        Value::Array(list) => list.iter_mut().for_each(|value| *value = without_null(value.take())),
        _ => {}
    }
    value
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
    fn what_two_questions_hold_is_read_apart_until_they_go() {
        let (mut one, mut other) = (Held::default(), Held::default());
        let paths = [one.hold("held", Arc::new(json!({ "a": 1 }))), other.hold("held", Arc::new(2.5_f64))];
        assert_eq!(paths.each_ref().map(|path| path.to_str().unwrap()), ["question:held", "question:held#2"]);
        assert_eq!(paths.each_ref().map(|path| key_of(path).unwrap().to_str().unwrap()), ["held"; 2]);
        assert_eq!(as_toml(&paths[0]).unwrap().unwrap(), b"a = 1\n");
        assert_eq!((value(&paths[1]).as_deref(), as_toml(&paths[1]).is_none()), (Some(&2.5), true));
        drop(one);
        assert_eq!(paths.each_ref().map(|path| holds(path)), [false, true]);
    }

    #[test]
    fn a_key_that_is_given_twice_is_refused() {
        let told = |json: &str| of_json(json.as_bytes()).unwrap_err().to_string();
        assert_eq!(told(r#"{ "speed": 30, "speed": 20 }"#), "`speed` is given twice, the second time in line 1");
        let nested = "{ \"traffic\": { \"vehicle\": [{ \"share\": 1,\n \"share\": 1 }] } }";
        assert_eq!(told(nested), "`share` is given twice, the second time in line 2");
        let same = r#"{ "a": { "x": -1 }, "b": [{ "x": 1.5 }, { "x": null }, true, "text", 18446744073709551615] }"#;
        assert_eq!(
            of_json(same.as_bytes()).unwrap(),
            *serde_json::from_str::<Value>(same).unwrap().as_object().unwrap()
        );
    }

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
