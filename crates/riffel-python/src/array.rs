//! Arrays of NumPy as vectors.

use numpy::{Element, PyReadonlyArray1};

/// The values of an array, of any stride, for work without the interpreter.
pub(crate) fn owned<T: Element + Copy>(values: &PyReadonlyArray1<'_, T>) -> Vec<T> {
    values.as_array().iter().copied().collect()
}
