//! The wheels of a vehicle in its curve.

use numpy::{PyArray1, ToPyArray};
use pyo3::prelude::*;
use riffel_answers::wheels::WheelsAnswer;

use crate::case::Case;
use crate::document::document;
use crate::errors::of_answer;

/// What `riffel map --wheels --json` prints, with the growth rates of each wheel on the grid of the map.
#[pyfunction]
pub(crate) fn wheels_of_curve<'py>(
    py: Python<'py>,
    case: &Case,
) -> PyResult<(Bound<'py, PyAny>, Vec<Option<Bound<'py, PyArray1<f64>>>>)> {
    let answer = case.compute(py, |case| WheelsAnswer::new(case, |_| ()))?;
    let answer = answer.map_err(of_answer)?;
    let maps = (answer.wheels.iter())
        .map(|wheel| {
            let growth = wheel.growth.as_ref().ok()?;
            let rates: Vec<f64> = growth.rates_on_the_grid().collect();
            Some(rates.to_pyarray(py))
        })
        .collect();
    Ok((document(py, &answer.document(&case.case))?, maps))
}
