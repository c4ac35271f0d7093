//! Quantities at points, as columns of arrays.

use std::sync::Arc;

use num_complex::Complex64;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use rayon::prelude::*;
use riffel_answers::WearLimitDocument;
use riffel_case::{Case, DamagePoint, Point, PointValue};
use serde_json::Value;

use crate::interrupt::interruptible;

/// A key with its unit, what it is and its values.
pub(super) type Column<'py> = (String, &'static str, &'static str, Bound<'py, PyAny>);

/// The quantities at each pair of wavelength and speed, with the limits by wear.
pub(super) fn at(
    py: Python<'_>,
    case: Arc<Case>,
    wavelengths: Vec<f64>,
    speeds: Vec<f64>,
) -> PyResult<Vec<(Point, WearLimitDocument)>> {
    /// From here on the wait may be worth interrupting.
    const MANY: usize = 1000;
    let at = move |wavelength: f64, speed: f64| {
        let state = case.feedback.at(wavelength, speed);
        let limit = WearLimitDocument::new(&case, Some(state.growth_rate));
        (Point::new(&case, &state), limit)
    };
    if wavelengths.len() < MANY {
        let pairs = wavelengths.iter().zip(&speeds);
        Ok(py.detach(|| pairs.map(|(&wavelength, &speed)| at(wavelength, speed)).collect()))
    } else {
        interruptible(py, move || {
            let pairs = wavelengths.par_iter().zip(&speeds);
            pairs.map(|(&wavelength, &speed)| at(wavelength, speed)).collect()
        })
    }
}

/// The object `damage` of points, a column for each of its numbers, `damage.growth_by_law.flow` for one inside.
fn damage_columns<'py>(py: Python<'py>, points: &[&DamagePoint]) -> PyResult<Vec<Column<'py>>> {
    let mut columns: Vec<(String, Vec<Value>)> = Vec::new();
    for (index, point) in points.iter().enumerate() {
        let value =
            serde_json::to_value(point).map_err(|error| pyo3::exceptions::PyValueError::new_err(error.to_string()))?;
        let mut leaves = Vec::new();
        collect_numbers("damage", &value, &mut leaves);
        for (place, (key, value)) in leaves.into_iter().enumerate() {
            match index {
                0 => columns.push((key, vec![value])),
                // Every point of a case has the same numbers.
                _ => columns[place].1.push(value),
            }
        }
    }
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let columns = columns.into_iter().map(|(key, values)| {
        let array = match values[0].is_array() {
            false => {
                let values: Vec<f64> = values.iter().map(number).collect();
                values.into_pyarray(py).into_any()
            }
            true => {
                let complex = |value: &Value| Complex64::new(number(&value[0]), number(&value[1]));
                let values: Vec<Complex64> = values.iter().map(complex).collect();
                values.into_pyarray(py).into_any()
            }
        };
        // The unit is in the name of the quantity, `damage.depth_by_law_m.flow`.
        let quantity = key.split('.').nth(1).unwrap_or_default();
        let units = [("_pa", "Pa"), ("_m", "m"), ("_nm", "N m"), ("_deg", "deg")];
        let unit = units.iter().find(|(ending, _)| quantity.ends_with(ending));
        let unit = unit.map_or("1", |unit| unit.1);
        (key, unit, "damage beside wear", array)
    });
    Ok(columns.collect())
}

/// The numbers of a document below a key, real or `[re, im]`, in its order.
fn collect_numbers(key: &str, value: &Value, into: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                collect_numbers(&format!("{key}.{name}"), value, into);
            }
        }
        value => into.push((key.to_owned(), value.clone())),
    }
}

/// The quantities of points, what damage says of them, and the limits by wear.
pub(super) fn columns<'py>(py: Python<'py>, points: &[(Point, WearLimitDocument)]) -> PyResult<Vec<Column<'py>>> {
    let columns = points[0].0.quantities.iter().enumerate();
    let columns = columns.map(|(index, (quantity, _))| {
        let values = || points.iter().map(|point| point.0.quantities[index].1);
        let reals: Option<Vec<f64>> = values()
            .map(|value| match value {
                PointValue::Real(value) => Some(value),
                PointValue::Complex(_) => None,
            })
            .collect();
        let array = match reals {
            Some(reals) => reals.into_pyarray(py).into_any(),
            None => values()
                .map(|value| match value {
                    PointValue::Real(value) => value.into(),
                    PointValue::Complex(value) => value,
                })
                .collect::<Vec<Complex64>>()
                .into_pyarray(py)
                .into_any(),
        };
        let key = quantity.key().to_owned();
        (key, quantity.unit(), quantity.name(), array)
    });
    let limits = |value: fn(&WearLimitDocument) -> f64| {
        let values = points.iter().map(|point| value(&point.1));
        values.collect::<Vec<f64>>().into_pyarray(py).into_any()
    };
    let coefficient = limits(|limit| limit.wear_coefficient_kg_per_j.unwrap_or(f64::NAN));
    let wear = limits(|limit| limit.mean_wear_mm_per_100_mgt);
    let amplitude = limits(|limit| limit.amplitude_limit_m.unwrap_or(f64::NAN));
    let beside = [
        ("wear_coefficient_kg_per_j".to_owned(), "kg/J", "wear coefficient that the rate goes by", coefficient),
        ("mean_wear_mm_per_100_mgt".to_owned(), "mm", "mean wear under 100 MGT", wear),
        ("amplitude_limit_m".to_owned(), "m", "amplitude beyond which the rate cannot last", amplitude),
    ];
    let damage = points.iter().map(|(point, _)| point.damage.as_ref());
    let damage = match damage.collect::<Option<Vec<_>>>() {
        Some(damage) => damage_columns(py, &damage)?,
        None => Vec::new(),
    };
    Ok(columns.chain(damage).chain(beside).collect())
}
