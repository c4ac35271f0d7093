//! What can be wrong with the text of a quantity.

use std::fmt;

use super::{Kind, named};
use crate::{Message, Value, say};

/// A text that is not the quantity it should be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct QuantityError {
    /// What was written.
    pub(super) text: String,
    /// What is needed.
    pub(super) kind: Kind,
    /// What is wrong.
    pub(super) problem: QuantityProblem,
}

/// What is wrong with the text of a quantity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum QuantityProblem {
    /// No number at the beginning.
    NoNumber,
    /// Infinite or not a number.
    NotFinite,
    /// A comma or a separator of thousands in the number.
    Separator,
    /// A range where one value is needed.
    Range,
    /// A unit of which this part is not understood.
    UnknownUnit(String),
    /// The unit of another kind of quantity, in SI base units, empty for a plain number.
    WrongUnit(String),
}

impl QuantityError {
    /// What is wrong.
    pub fn message(&self) -> Message {
        let (text, kind, example) = (&self.text, named(self.kind.name), self.kind.example);
        match &self.problem {
            QuantityProblem::NoNumber => {
                say!(not_a_number, text, kind, example)
            }
            QuantityProblem::NotFinite => say!(not_finite, text, kind),
            QuantityProblem::Separator => say!(number_with_separator, text, kind, example),
            QuantityProblem::Range => say!(range_for_one_value, text, kind, example),
            QuantityProblem::UnknownUnit(unit) => {
                say!(unknown_unit, text, unit, kind, example)
            }
            QuantityProblem::WrongUnit(got) => say!(
                wrong_unit,
                text,
                got = match got.as_str() {
                    "" => say!(plain_number),
                    unit => say!(in_unit, unit),
                },
                kind = match self.kind.unit {
                    "" => Value::from(kind),
                    unit => say!(kind_in_unit, kind, unit).into(),
                },
                example
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
