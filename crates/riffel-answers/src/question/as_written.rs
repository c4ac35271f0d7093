//! Quantities whose range depends on the key.

use std::borrow::Cow;
use std::marker::PhantomData;
use std::str::FromStr;

use riffel_keys::PhysicalRange;
use riffel_keys::quantity::{Dimension, Quantity, QuantityError};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use super::Client;
use crate::{AnswerError, Result};

/// A text or a number as it was written.
pub(super) fn written(value: Value) -> String {
    match value {
        Value::String(text) => text,
        other => other.to_string(),
    }
}

/// A quantity as it was written, which its number in SI does not tell: 108, or 108 km/h.
#[derive(Debug)]
pub struct AsWritten<D> {
    text: String,
    dimension: PhantomData<fn() -> D>,
}

impl<D> Clone for AsWritten<D> {
    fn clone(&self) -> Self {
        Self { text: self.text.clone(), dimension: PhantomData }
    }
}

impl<D: Dimension> AsWritten<D> {
    /// The values of a list, each as by [`within`](Self::within).
    ///
    /// # Errors
    /// Errors of [`within`](Self::within).
    pub fn all_within(list: &[Self], argument: &'static str, client: &dyn Client) -> Result<Vec<f64>> {
        list.iter().map(|quantity| quantity.within(argument, client)).collect()
    }

    /// The value in SI, whatever it is.
    pub fn si(&self) -> f64 {
        // It was read when it was written.
        self.text.parse::<Quantity<D>>().map_or(f64::NAN, |quantity| quantity.si())
    }

    /// The value in SI, within the physical range of the argument, which has one; `client` is told what is not usual.
    ///
    /// # Errors
    /// [`AnswerError::Range`] for a value outside the range.
    pub fn within(&self, argument: &'static str, client: &dyn Client) -> Result<f64> {
        debug_assert!(PhysicalRange::of(argument).is_some(), "{argument} has no range");
        let wrong = |rule| AnswerError::Range { argument, message: format!(" {rule}") };
        let (si, remark) = PhysicalRange::read::<D>(argument, &self.text).map_err(wrong)?;
        client.remark(remark.as_slice());
        Ok(si)
    }
}

impl<D> AsWritten<D> {
    /// Whether it was written without a unit: in a list that commas part it may be the head of a number with a comma in it.
    pub fn is_bare(&self) -> bool {
        self.text.trim().parse::<f64>().is_ok()
    }
}

impl<D: Dimension> FromStr for AsWritten<D> {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let _: Quantity<D> = text.parse()?;
        Ok(Self { text: text.to_owned(), dimension: PhantomData })
    }
}

impl<D: Dimension> From<Quantity<D>> for AsWritten<D> {
    /// A quantity that nobody wrote, with its unit.
    fn from(quantity: Quantity<D>) -> Self {
        Self { text: quantity.to_string(), dimension: PhantomData }
    }
}

impl<'de, D: Dimension> Deserialize<'de> for AsWritten<D> {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        written(Value::deserialize(deserializer)?).parse().map_err(serde::de::Error::custom)
    }
}

impl<D: Dimension> JsonSchema for AsWritten<D> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        Quantity::<D>::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = Quantity::<D>::json_schema(generator);
        let name = D::NAME.trim_start_matches("an ").trim_start_matches("a ");
        schema.insert("value_name".to_owned(), name.to_uppercase().into());
        schema
    }
}
