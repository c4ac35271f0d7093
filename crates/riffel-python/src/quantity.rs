//! Quantities as the case file writes them.

use pyo3::prelude::*;
use riffel_keys::quantity::{Area, Dimension, Force, Frequency, Length, Mass, Quantity, QuantityError, Ratio, Speed};

use crate::errors::wrong;

/// SI value of a text such as "80 km/h" that must be a quantity of the kind named.
#[pyfunction]
pub(crate) fn si(text: &str, kind: &str) -> PyResult<f64> {
    fn read<D: Dimension>(text: &str) -> Result<f64, QuantityError> {
        text.parse::<Quantity<D>>().map(|quantity| quantity.si())
    }
    let read = match kind {
        "length" => read::<Length>,
        "speed" => read::<Speed>,
        "frequency" => read::<Frequency>,
        "ratio" => read::<Ratio>,
        "mass" => read::<Mass>,
        "force" => read::<Force>,
        "area" => read::<Area>,
        _ => return Err(wrong(format!("no kind of quantity is called \"{kind}\""))),
    };
    read(text).map_err(|error| wrong(error.to_string()))
}
