//! The wheels of a vehicle in its curve.

use numpy::{PyArray1, ToPyArray};
use pyo3::prelude::*;
use riffel_answers::wheels::WheelsAnswer;

use crate::case::Case;
use crate::document::document;
use crate::errors::of_answer;

/// An array of NumPy.
type Array<'py> = Bound<'py, PyArray1<f64>>;

/// What `riffel map --wheels --json` prints, with speeds and wavelengths of the map, and the growth rates of each wheel on its grid.
#[pyfunction]
pub(crate) fn wheels_of_curve<'py>(
    py: Python<'py>,
    case: &Case,
) -> PyResult<(Bound<'py, PyAny>, [Array<'py>; 2], Vec<Option<Array<'py>>>)> {
    let answer = case.compute(py, |case| WheelsAnswer::new(case, |_| ()))?;
    let answer = answer.map_err(of_answer)?;
    let maps = (answer.wheels.iter())
        .map(|wheel| {
            let rates: Vec<f64> = wheel.in_loop.as_ref()?.rates_on_the_grid().collect();
            Some(rates.to_pyarray(py))
        })
        .collect();
    let axes = [case.case.speed, case.case.wavelength].map(|axis| axis.values().to_pyarray(py));
    let document = document(py, &answer)?;
    Ok((document, axes, maps))
}
