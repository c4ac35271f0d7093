//! What can be wrong with the text of a quantity.

use std::fmt;

use super::named;
use crate::{Message, Value, say};

/// A text that is not the quantity it should be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum QuantityError {
    /// No number at the beginning.
    NoNumber {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// Infinite or not a number.
    NotFinite {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
    },
    /// A comma or a separator of thousands in the number.
    Separator {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// A range where one value is needed.
    Range {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// A unit that is not known.
    UnknownUnit {
        /// What was written.
        text: String,
        /// The part of it that is not understood.
        unit: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// The unit of another kind of quantity.
    WrongUnit {
        /// What was written.
        text: String,
        /// Its unit in SI base units, empty for a plain number.
        got: String,
        /// What is needed, with its article.
        name: &'static str,
        /// Its unit, empty for a ratio.
        unit: &'static str,
        /// How to write it.
        example: &'static str,
    },
}

impl QuantityError {
    /// What is wrong.
    pub fn message(&self) -> Message {
        match self {
            Self::NoNumber {
                text,
                name,
                example,
            } => say!(
                not_a_number,
                text = text,
                kind = named(name),
                example = *example
            ),
            Self::NotFinite { text, name } => say!(not_finite, text = text, kind = named(name)),
            Self::Separator {
                text,
                name,
                example,
            } => say!(
                number_with_separator,
                text = text,
                kind = named(name),
                example = *example
            ),
            Self::Range {
                text,
                name,
                example,
            } => say!(
                range_for_one_value,
                text = text,
                kind = named(name),
                example = *example
            ),
            Self::UnknownUnit {
                text,
                unit,
                name,
                example,
            } => say!(
                unknown_unit,
                text = text,
                unit = unit,
                kind = named(name),
                example = *example
            ),
            Self::WrongUnit {
                text,
                got,
                name,
                unit,
                example,
            } => say!(
                wrong_unit,
                text = text,
                got = match got.as_str() {
                    "" => say!(plain_number),
                    unit => say!(in_unit, unit = unit),
                },
                kind = match *unit {
                    "" => Value::from(named(name)),
                    unit => say!(kind_in_unit, kind = named(name), unit = unit).into(),
                },
                example = *example
            ),
        }
    }
}

/// In English.
impl fmt::Display for QuantityError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(formatter)
    }
}

impl std::error::Error for QuantityError {}
