//! Numbers in the cells of tables.

use std::fmt::Display;

use riffel_keys::{Message, number, say};

/// A number by itself, as in the cell of a table.
pub fn number_alone(alone: impl Display) -> Message {
    say!(number_alone, number = number(alone))
}
