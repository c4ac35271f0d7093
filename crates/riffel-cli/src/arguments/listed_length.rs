//! A length of a list that commas part.

use std::str::FromStr;

use riffel_keys::quantity::{Length, Quantity, QuantityError};

/// A length, and whether it was written without a unit: beside others with one it may be the head of a number with a comma in it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ListedLength {
    pub(crate) length: Quantity<Length>,
    pub(crate) is_bare: bool,
}

impl FromStr for ListedLength {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Ok(Self { length: text.parse()?, is_bare: text.trim().parse::<f64>().is_ok() })
    }
}
