//! The values of a message.

use std::borrow::Cow;
use std::fmt::Display;

use super::Message;
use crate::excerpt::clipped;
use crate::{Language, Words};

/// A value of a [`Message`].
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Words that are the same in every language: a name, a file, what somebody typed.
    Text(String),
    /// A number in words, with a decimal point; each language has its own mark.
    Number(String),
    /// A quantity.
    Quantity {
        /// Number and unit as they are displayed, with a decimal point.
        shown: String,
        /// In SI.
        si: f64,
        /// The SI unit.
        unit: &'static str,
    },
    /// A speed, or the slowest and the fastest of several; each reader may have another unit.
    Speeds {
        /// In km/h, with its unit and a decimal point.
        shown: String,
        /// In m/s.
        speeds_m_per_s: Vec<f64>,
    },
    /// How many: languages choose between singular and plural by it.
    Count(u64),
    /// A key of the case, dotted, or an option of the program.
    Key(String),
    /// Words of a file of data, or the name of a quantity.
    Words(Words),
    /// Another message.
    Message(Box<Message>),
    /// Another message with a capital first letter.
    Capital(Box<Message>),
    /// Several of them, separated by commas.
    List(Vec<Value>),
}

impl Value {
    pub(super) fn clipped(self) -> Self {
        match self {
            Self::Text(text) => Self::Text(clipped(&text).into_owned()),
            Self::Key(key) => Self::Key(clipped(&key).into_owned()),
            Self::Message(message) => Self::Message(Box::new(message.clipped())),
            Self::Capital(message) => Self::Capital(Box::new(message.clipped())),
            Self::List(values) => Self::List(values.into_iter().map(Self::clipped).collect()),
            number => number,
        }
    }

    /// Data of the value: numbers as numbers, other messages with their own id and values.
    pub(super) fn document(&self, language: Language) -> serde_json::Value {
        match self {
            Self::Text(text)
            | Self::Key(text)
            | Self::Quantity { shown: text, .. }
            | Self::Speeds { shown: text, .. } => text.as_str().into(),
            Self::Number(number) => {
                serde_json::from_str::<serde_json::Number>(number).map_or_else(|_| number.as_str().into(), Into::into)
            }
            Self::Count(count) => (*count).into(),
            Self::Words(words) => words.text(language).into(),
            Self::Message(message) | Self::Capital(message) => message.document(language),
            Self::List(values) => values.iter().map(|value| value.document(language)).collect(),
        }
    }
}

/// A number as it is displayed: `number(format_args!("{x:.1e}"))`.
pub fn number(shown: impl Display) -> Value {
    Value::Number(shown.to_string())
}

/// A value in SI as it is displayed: `quantity(5e4, "N", "50 kN")`. Without a unit it is a number.
pub fn quantity(si: f64, unit: &'static str, shown: impl Display) -> Value {
    let shown = shown.to_string();
    match unit {
        "" => Value::Number(shown),
        unit => Value::Quantity { shown, si, unit },
    }
}

/// A speed \[m/s\] with so many digits after the decimal mark of its km/h.
pub fn shown_speed(speed: f64, digits: usize) -> Value {
    Value::Speeds { shown: format!("{} km/h", decimal(3.6 * speed, digits)), speeds_m_per_s: vec![speed] }
}

/// The slowest and the fastest of several speeds \[m/s\], as in "40–70 km/h".
pub fn shown_speeds([slowest, fastest]: [f64; 2]) -> Value {
    let range = range([slowest, fastest], |speed| decimal(3.6 * speed, 0));
    Value::Speeds { shown: format!("{range} km/h"), speeds_m_per_s: vec![slowest, fastest] }
}

/// Two numbers as they are written: "31–39", or one where they are written alike.
pub fn range<T>(ends: [T; 2], written: impl Fn(T) -> String) -> String {
    let [from, to] = ends.map(written);
    match from == to {
        true => from,
        false => format!("{from}–{to}"),
    }
}

/// A number with so many digits after the decimal mark.
pub fn fixed(value: f64, digits: usize) -> Value {
    Value::Number(decimal(value, digits))
}

/// Text of a number with so many digits after the decimal mark.
pub fn decimal(value: f64, digits: usize) -> String {
    let written = format!("{value:.digits$}");
    // A little below zero is no minus zero.
    let zero = written.bytes().all(|byte| b"-0.".contains(&byte));
    match zero {
        true => written.trim_start_matches('-').to_owned(),
        false => written,
    }
}

/// A number rounded to so many significant digits: 13.72 is 14 of two, 6,014 is 6,000.
pub fn significant(value: f64, digits: usize) -> Value {
    Value::Number(significant_digits(value, digits))
}

/// Text of a number rounded to so many significant digits.
pub fn significant_digits(value: f64, digits: usize) -> String {
    if !value.is_finite() || value == 0.0 {
        return decimal(value, 0);
    }
    // Rounding may add a digit: 9.96 of two is 10.
    let size = |value: f64| value.abs().log10().floor() as i32;
    let step = |value: f64| 10f64.powi(size(value) + 1 - digits as i32);
    let rounded = (value / step(value)).round() * step(value);
    let decimals = (digits as i32 - 1 - size(rounded)).max(0);
    decimal(rounded, decimals as usize)
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<Cow<'_, str>> for Value {
    fn from(text: Cow<'_, str>) -> Self {
        Self::Text(text.into_owned())
    }
}

impl From<&Message> for Value {
    fn from(message: &Message) -> Self {
        message.clone().into()
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&String> for Value {
    fn from(text: &String) -> Self {
        Self::Text(text.clone())
    }
}

impl From<std::path::Display<'_>> for Value {
    fn from(path: std::path::Display<'_>) -> Self {
        Self::Text(path.to_string())
    }
}

impl From<Words> for Value {
    fn from(words: Words) -> Self {
        Self::Words(words)
    }
}

impl From<Message> for Value {
    fn from(message: Message) -> Self {
        Self::Message(Box::new(message))
    }
}

/// With as many digits as it has.
impl From<f64> for Value {
    fn from(value: f64) -> Self {
        number(value)
    }
}

impl From<u64> for Value {
    fn from(count: u64) -> Self {
        Self::Count(count)
    }
}

impl From<u8> for Value {
    fn from(count: u8) -> Self {
        Self::Count(count.into())
    }
}

impl From<u32> for Value {
    fn from(count: u32) -> Self {
        Self::Count(count.into())
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl<T: Into<Value>> FromIterator<T> for Value {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        Self::List(values.into_iter().map(Into::into).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 49.6 and 50.4 mm are both written as 50.
    #[test]
    fn a_range_whose_ends_are_written_alike_is_one_number() {
        let whole = |ends: [f64; 2]| range(ends, |end| decimal(end, 0));
        assert_eq!([whole([49.6, 50.4]), whole([49.6, 50.6])], ["50", "50–51"]);
    }

    #[test]
    fn significant_digits_are_those_of_the_rounded_number() {
        let said = |value, digits| match significant(value, digits) {
            Value::Number(text) => text,
            other => panic!("{other:?}"),
        };
        for (value, digits, text) in [
            (13.72, 2, "14"),
            (6014.0, 2, "6000"),
            (892_810.0, 2, "890000"),
            (9.96, 2, "10"),
            (0.0996, 2, "0.10"),
            (1.07, 2, "1.1"),
            (-0.04, 1, "-0.04"),
            (-0.0, 2, "0"),
            (65.53, 3, "65.5"),
        ] {
            assert_eq!(said(value, digits), text);
        }
        assert_eq!((decimal(-0.04, 1), decimal(-0.06, 1)), ("0.0".into(), "-0.1".into()));
    }
}
