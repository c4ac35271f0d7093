//! Points of a ridge, as arrays.

use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use riffel::growth::RidgePoint;

use super::Real;

/// Wavelength, frequency, Re Ŵ₁ and growth rate of points of a ridge, and whether each sits at the edge.
pub(super) fn over_speed<'py>(py: Python<'py>, points: &[RidgePoint]) -> ([Real<'py>; 4], Bound<'py, PyArray1<bool>>) {
    let column = |value: fn(&RidgePoint) -> f64| {
        let values = points.iter().map(value);
        values.collect::<Vec<_>>().into_pyarray(py)
    };
    let columns = [
        column(|point| point.wavelength),
        column(|point| point.frequency),
        column(|point| point.normalized_dissipation),
        column(|point| point.growth_rate),
    ];
    let edges: Vec<bool> = points.iter().map(|point| point.at_edge).collect();
    (columns, edges.into_pyarray(py))
}
