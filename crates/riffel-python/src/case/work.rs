//! Long work on a case, and failures of the receptances that it asks in Python.

use std::sync::Arc;

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel::{Axis, Ridge};
use riffel_case::CaseStructure;
use riffel_keys::CaseError;

use super::Case;
use crate::array::owned;
use crate::errors::{of_case, of_physics};
use crate::interrupt::interruptible;
use crate::receptance_arg::{self, CallableReceptance};

/// The first failure of callables. Those of all are taken, so that none is left for the next computation.
fn take_failure(callables: &[Arc<CallableReceptance>]) -> Option<PyErr> {
    let failures = callables.iter().map(|callable| callable.take_failure());
    failures.fold(None, Option::or)
}

/// Smallest and largest value.
pub(super) fn ends(values: &[f64]) -> (f64, f64) {
    let fold = |fold: fn(f64, f64) -> f64| values.iter().copied().fold(values[0], fold);
    (fold(f64::min), fold(f64::max))
}

impl Case {
    /// What a callable of the case raised goes before any result.
    pub(crate) fn unless_callable_failed<T>(&self, result: T) -> PyResult<T> {
        match take_failure(&self.callables) {
            Some(error) => Err(error),
            None => Ok(result),
        }
    }

    /// Long work on the case, without the interpreter.
    pub(crate) fn compute<T: Send + 'static>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&riffel_case::Case) -> T + Send + 'static,
    ) -> PyResult<T> {
        let case = self.case.clone();
        let result = interruptible(py, move || work(&case));
        self.unless_callable_failed(result?)
    }

    /// The case on wavelengths and speeds that may leave its window.
    pub(super) fn over(&self, py: Python<'_>, wavelengths: &[f64], speeds: &[f64]) -> PyResult<Arc<riffel_case::Case>> {
        let ((shortest, longest), (slowest, fastest)) = (ends(wavelengths), ends(speeds));
        self.case.check_points([shortest, longest], [slowest, fastest]).map_err(of_case)?;
        if self.case.wavelength.min() <= shortest && longest <= self.case.wavelength.max() {
            return Ok(self.case.clone());
        }
        let covering = self.compute(py, move |case| case.covering(shortest, longest))?;
        Ok(Arc::new(covering.map_err(of_case)?))
    }

    /// The ridge at any speeds, with the case on which it was searched.
    pub(super) fn search_ridge(
        &self,
        py: Python<'_>,
        (shortest, longest, points): (f64, f64, usize),
        speeds: &PyReadonlyArray1<'_, f64>,
    ) -> PyResult<(Arc<riffel_case::Case>, Ridge)> {
        let axis = Axis::new(shortest, longest, points).map_err(of_physics)?;
        let speeds = owned(speeds);
        let case = self.over(py, &[shortest, longest], &speeds)?;
        let searched = case.clone();
        let ridge = interruptible(py, move || Ridge::search_at(&searched.feedback, axis, &speeds))?;
        Ok((case, self.unless_callable_failed(ridge)?))
    }

    /// A case that was built with callables, whose failure explains any other.
    pub(super) fn built(
        built: Result<riffel_case::Case, CaseError>,
        callables: Vec<Arc<CallableReceptance>>,
    ) -> PyResult<Self> {
        match take_failure(&callables) {
            Some(error) => Err(error),
            None => Ok(Self { case: Arc::new(built.map_err(of_case)?), callables }),
        }
    }

    pub(super) fn with_given(
        &self,
        py: Python<'_>,
        given: &Bound<'_, PyAny>,
        what: &'static str,
        structure: CaseStructure,
    ) -> PyResult<Self> {
        let (receptance, callable) = receptance_arg::extract(given, what)?;
        let mut callables: Vec<_> = self.callables.iter().filter(|callable| !callable.is_of(what)).cloned().collect();
        callables.extend(callable);
        let case = self.case.clone();
        let built = interruptible(py, move || case.substitute(structure, receptance))?;
        Self::built(built, callables)
    }
}
