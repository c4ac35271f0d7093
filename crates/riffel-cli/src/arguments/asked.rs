//! Quantities of the command line that have a physical range.

use std::fmt::Display;
use std::marker::PhantomData;
use std::str::FromStr;

use riffel_keys::PhysicalRange;
use riffel_keys::quantity::{Dimension, Quantity, QuantityError};

use crate::error::CliError;
use crate::messages::print_remarks;

/// A quantity as it was written, which its number in SI does not tell: 108, or 108 km/h.
#[derive(Clone)]
pub(crate) struct Asked<D> {
    text: String,
    dimension: PhantomData<fn() -> D>,
}

impl<D: Dimension> FromStr for Asked<D> {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let _: Quantity<D> = text.parse()?;
        Ok(Self { text: text.to_owned(), dimension: PhantomData })
    }
}

impl<D: Dimension> From<Quantity<D>> for Asked<D> {
    /// A quantity that was not written on the command line, with its unit.
    fn from(quantity: Quantity<D>) -> Self {
        Self { text: quantity.to_string(), dimension: PhantomData }
    }
}

impl<D: Dimension> Asked<D> {
    /// The value in SI, within the physical range of the argument. What is not usual is asked about on standard error.
    pub(crate) fn within(&self, argument: &'static str) -> Result<f64, CliError> {
        within::<D>(argument, &self.text)
    }
}

/// [`Asked::within`] of a text.
pub(crate) fn within<D: Dimension>(argument: &'static str, text: &str) -> Result<f64, CliError> {
    let wrong = |message: &dyn Display| CliError::Range { argument, message: message.to_string() };
    let _: Quantity<D> = text.parse().map_err(|error: QuantityError| wrong(&format!(": {error}")))?;
    let (si, remark) = PhysicalRange::read::<D>(argument, text).map_err(|rule| wrong(&format!(" {rule}")))?;
    print_remarks(remark.as_slice());
    Ok(si)
}
