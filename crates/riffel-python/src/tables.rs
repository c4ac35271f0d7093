//! Dicts of Python as tables of TOML.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyList, PyString};
use toml::{Table, Value};

/// A dict as a table; `path` is the dotted key that leads to it.
pub(crate) fn table(dict: &Bound<'_, PyDict>, path: &str) -> PyResult<Table> {
    let mut table = Table::new();
    for (key, item) in dict {
        let key: String = key
            .extract()
            .map_err(|_| PyTypeError::new_err(format!("keys of a case are strings, but one is {key:?}")))?;
        let path = match path {
            "" => key.clone(),
            path => format!("{path}.{key}"),
        };
        table.insert(key, value(&item, &path)?);
    }
    Ok(table)
}

/// A value of the key `path`.
pub(crate) fn value(item: &Bound<'_, PyAny>, path: &str) -> PyResult<Value> {
    if let Ok(text) = item.cast::<PyString>() {
        return Ok(Value::String(text.to_string()));
    }
    if let Ok(truth) = item.cast::<PyBool>() {
        return Ok(Value::Boolean(truth.is_true()));
    }
    if let Ok(dict) = item.cast::<PyDict>() {
        return Ok(Value::Table(table(dict, path)?));
    }
    if let Ok(list) = item.cast::<PyList>() {
        let items = list.iter().enumerate();
        let items = items.map(|(index, item)| value(&item, &format!("{path}[{index}]")));
        return Ok(Value::Array(items.collect::<PyResult<_>>()?));
    }
    // NumPy's integers are whole by __index__, its floats real by __float__.
    if (item.is_instance_of::<PyInt>() || item.hasattr("__index__")?)
        && let Ok(whole) = item.extract::<i64>()
    {
        return Ok(Value::Integer(whole));
    }
    if let Ok(real) = item.extract::<f64>() {
        return Ok(Value::Float(real));
    }
    let kind = item.get_type().name()?;
    Err(PyTypeError::new_err(format!(
        "`{path}` is of type {kind}, but must be a number, a string, a bool, a list or a dict"
    )))
}
