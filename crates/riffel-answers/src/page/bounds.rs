//! What numbers a page may ask with, beyond the rules of the program.

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

/// `Ok` if the numbers of a question are within what the page computes.
///
/// # Errors
/// A [`Fault`] with the key, the value and the rule.
pub fn check_bounds(question: &Map<String, Value>) -> Result<(), Fault> {
    for (key, argument, least, most) in BOUNDS {
        if let Some(value) = question.get(key).and_then(Value::as_f64)
            && !(least..=most).contains(&value)
        {
            let rule = if least == f64::MIN_POSITIVE {
                format!("above zero and at most {most}")
            } else {
                format!("from {least} to {most}")
            };
            return Err(AnswerError::Argument { argument, value: value.to_string(), rule }.into());
        }
    }
    Ok(())
}
