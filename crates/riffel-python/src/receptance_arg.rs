//! Receptances that come from Python.

use std::f64::consts::TAU;
use std::sync::{Arc, Mutex};

use num_complex::Complex64;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyTuple, PyType};
use riffel::Receptance;
use riffel::receptance::MeasuredReceptance;
use riffel::tile::{Frequencies, SplitComplex};
use riffel_case::SubstituteReceptance;
use riffel_rail::response::{UniversalFunction, VerticalAxis};

use crate::array::owned;
use crate::errors::{ReceptanceError, of_case, of_physics, wrong};

/// A Python callable of an array of frequencies \[Hz\] that returns receptances \[m/N\].
///
/// The interpreter is attached for the calls alone. The first failure is kept for whoever began the computation;
/// until it is taken, the receptance is not a number and nothing is called.
pub(crate) struct CallableReceptance {
    callable: Py<PyAny>,
    /// Of the track or of the wheel.
    what: &'static str,
    failure: Mutex<Option<PyErr>>,
}

impl CallableReceptance {
    /// The failure of a computation that asked this receptance.
    pub(crate) fn take_failure(&self) -> Option<PyErr> {
        self.failure.lock().ok()?.take()
    }

    /// Whether it is that of the track, or of the wheel.
    pub(crate) fn is_of(&self, what: &str) -> bool {
        self.what == what
    }

    /// Call nothing from now on, until the failure is taken.
    pub(crate) fn fail(&self, error: PyErr) {
        if let Ok(mut failure) = self.failure.lock() {
            failure.get_or_insert(error);
        }
    }

    fn has_failed(&self) -> bool {
        self.failure.lock().is_ok_and(|failure| failure.is_some())
    }

    /// Receptances at angular frequencies \[rad/s\].
    fn ask(&self, angular: &[f64], mut set: impl FnMut(usize, Complex64)) {
        let nothing = Complex64::new(f64::NAN, f64::NAN);
        let answer = match self.has_failed() {
            true => None,
            // None while the interpreter shuts down, when nobody waits for the result.
            false => Python::try_attach(|py| self.call(py, angular)),
        };
        match answer {
            Some(Ok(values)) => {
                for (index, value) in values.into_iter().enumerate() {
                    set(index, value);
                }
                return;
            }
            Some(Err(error)) => self.fail(error),
            None => {}
        }
        for index in 0..angular.len() {
            set(index, nothing);
        }
    }

    fn call(&self, py: Python<'_>, angular: &[f64]) -> PyResult<Vec<Complex64>> {
        let what = self.what;
        let fail = |sentence: String| ReceptanceError::new_err(sentence);
        let frequencies: Vec<f64> = angular.iter().map(|w| w / TAU).collect();
        let argument = PyArray1::from_slice(py, &frequencies);
        let returned = self.callable.call1(py, (argument,)).map_err(|error| {
            let name = error.get_type(py).name();
            let name = name.map_or_else(|_| "an error".to_owned(), |name| name.to_string());
            let raised = fail(format!("the receptance of the {what} raised {name}: {}", error.value(py)));
            raised.set_cause(py, Some(error));
            raised
        })?;
        let array = py.import("numpy")?.call_method1("asarray", (&returned, "complex128")).map_err(|error| {
            let raised =
                fail(format!("the receptance of the {what} must return complex numbers, one for each frequency"));
            raised.set_cause(py, Some(error));
            raised
        })?;
        let wrong_shape = |shape: &[usize]| {
            fail(format!(
                "the receptance of the {what} returned an array of shape {shape:?}, but must return one complex \
                 number for each of the {} frequencies",
                frequencies.len()
            ))
        };
        let values: PyReadonlyArray1<'_, Complex64> = array.extract().map_err(|_| {
            let shape: Vec<usize> = array.getattr("shape").and_then(|shape| shape.extract()).unwrap_or_default();
            wrong_shape(&shape)
        })?;
        if values.len() != frequencies.len() {
            return Err(wrong_shape(values.shape()));
        }
        let values = owned(&values);
        match values.iter().position(|value| !value.is_finite()) {
            Some(index) => Err(fail(format!(
                "the receptance of the {what} is {} at {} Hz, but must be finite",
                values[index], frequencies[index]
            ))),
            None => Ok(values),
        }
    }
}

impl Receptance for CallableReceptance {
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        let mut value = Complex64::ZERO;
        self.ask(&[angular_frequency], |_, found| value = found);
        value
    }

    fn receptances(&self, frequencies: &Frequencies, _speed: f64, receptances: &mut SplitComplex) {
        self.ask(&frequencies.angular, |index, value| {
            (receptances.re[index], receptances.im[index]) = (value.re, value.im);
        });
    }

    fn worth_tabulating(&self) -> bool {
        true
    }
}

/// Checked function of a universal file, as its frequencies and receptances are asked for by a case.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct Universal {
    receptance: SubstituteReceptance,
    /// What it was made of, to be pickled.
    function: UniversalFunction,
}

#[pymethods]
impl Universal {
    #[new]
    fn new(
        title: String,
        function_type: i32,
        load_case: i32,
        directions: (i32, i32),
        vertical_axis: &str,
        abscissa_kind: i32,
        numerator: (i32, String),
        denominator: (i32, String),
        frequencies: PyReadonlyArray1<'_, f64>,
        values: PyReadonlyArray1<'_, Complex64>,
    ) -> PyResult<Self> {
        let vertical_axis = match vertical_axis {
            "x" => VerticalAxis::X,
            "y" => VerticalAxis::Y,
            "z" => VerticalAxis::Z,
            other => {
                let sentence = format!("vertical_axis is \"{other}\", but must be \"x\", \"y\" or \"z\"");
                return Err(PyValueError::new_err(sentence));
            }
        };
        let function = UniversalFunction {
            title,
            function_type,
            load_case,
            response_direction: directions.0,
            reference_direction: directions.1,
            vertical_axis,
            abscissa_kind,
            numerator,
            denominator,
            frequencies: owned(&frequencies),
            values: owned(&values),
        };
        Ok(Self { receptance: SubstituteReceptance::of_universal(&function).map_err(of_case)?, function })
    }

    /// How pickle makes it again.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyType>, Bound<'py, PyTuple>)> {
        let function = self.function.clone();
        let arguments = (
            function.title,
            function.function_type,
            function.load_case,
            (function.response_direction, function.reference_direction),
            function.vertical_axis.name(),
            function.abscissa_kind,
            function.numerator,
            function.denominator,
            function.frequencies.into_pyarray(py),
            function.values.into_pyarray(py),
        );
        Ok((py.get_type::<Self>(), arguments.into_pyobject(py)?))
    }
}

/// A callable, or a table (frequencies, receptances); with the callable where it is one, to ask for its failures.
pub(crate) fn extract(
    given: &Bound<'_, PyAny>,
    what: &'static str,
) -> PyResult<(SubstituteReceptance, Option<Arc<CallableReceptance>>)> {
    if given.is_callable() {
        let callable =
            Arc::new(CallableReceptance { callable: given.clone().unbind(), what, failure: Mutex::new(None) });
        return Ok((SubstituteReceptance::new(callable.clone()), Some(callable)));
    }
    if let Ok(universal) = given.cast::<Universal>() {
        return Ok((universal.get().receptance.clone(), None));
    }
    let table: (PyReadonlyArray1<'_, f64>, PyReadonlyArray1<'_, Complex64>) = given.extract().map_err(|_| {
        PyTypeError::new_err(format!("the receptance of the {what} must be a callable or a pair of arrays"))
    })?;
    let angular: Vec<f64> = table.0.as_array().iter().map(|f| TAU * f).collect();
    let measured = MeasuredReceptance::new(&angular, owned(&table.1)).map_err(of_physics)?;
    let given = match what {
        "track" => SubstituteReceptance::measured_on_rail(measured),
        _ => SubstituteReceptance::measured(measured),
    };
    let given = given.map_err(|refusal| wrong(refusal.to_string()))?;
    Ok((given, None))
}
