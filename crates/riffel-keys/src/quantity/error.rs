//! What can be wrong with the text of a quantity.

use thiserror::Error;

/// A text that is not the quantity it should be.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// No number at the beginning.
    #[error("\"{text}\" does not begin with a number; write {name} as in \"{example}\"")]
    NoNumber {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// Infinite or not a number.
    #[error("{text} is not finite, as {name} must be")]
    NotFinite {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
    },
    /// A comma or a separator of thousands in the number.
    #[error(
        "\"{text}\" has a comma or a gap in its number; write a decimal point and no separators of thousands, as in \
         \"{example}\" for {name}"
    )]
    Separator {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// A range where one value is needed.
    #[error("\"{text}\" is a range, but one value is needed; write {name} as in \"{example}\"")]
    Range {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// A unit that is not known.
    #[error("unknown unit \"{unit}\" in \"{text}\"; write {name} as in \"{example}\"")]
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
    #[error("\"{text}\" is {got}, not {name}{in_unit}; write it as in \"{example}\"")]
    WrongUnit {
        /// What was written.
        text: String,
        /// What it is: in its unit in SI base units, or a plain number.
        got: String,
        /// What is needed, with its article.
        name: &'static str,
        /// Its unit, as the words " in N/m".
        in_unit: String,
        /// How to write it.
        example: &'static str,
    },
}
