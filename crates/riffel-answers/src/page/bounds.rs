//! What numbers a page may ask with, beyond the rules of the program.

use riffel_keys::quantity::{Length, Quantity};
use serde::Deserialize;
use serde_json::{Map, Value};

use crate::AnswerError;
use crate::page::Fault;

/// Keys of questions, and the least and the most that they may be on the page.
const BOUNDS: [(&str, &str, f64, f64); 4] = [
    ("months", "--months", f64::MIN_POSITIVE, 1200.0),
    ("limit_dba", "--limit-dba", 0.0, 200.0),
    ("block", "--block", 1.0, 1e6),
    ("passages_between", "--passages-between", f64::MIN_POSITIVE, 1e12),
];

/// A number, or the text of one or of a length \[m\]; what is none is refused by the question.
fn number(value: &Value) -> Option<f64> {
    let text = || value.as_str()?.trim().parse().ok();
    let length = || Some(Quantity::<Length>::deserialize(value).ok()?.si());
    value.as_f64().or_else(text).or_else(length)
}

/// `Ok` if the numbers of a question are within what the page computes.
///
/// # Errors
/// A [`Fault`] with the key, the value and the rule.
pub fn check_bounds(question: &Map<String, Value>) -> Result<(), Fault> {
    for (key, argument, least, most) in BOUNDS {
        if let Some(value) = question.get(key).and_then(number)
            && !(least..=most).contains(&value)
        {
            let rule = if least == f64::MIN_POSITIVE {
                format!("above zero and at most {most}")
            } else {
                format!("from {least} to {most}")
            };
            return Err(AnswerError::argument(argument, value, rule).into());
        }
    }
    Ok(())
}
