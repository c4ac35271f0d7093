//! Errors as Python knows them, with the sentences of the program.

use pyo3::create_exception;
use pyo3::exceptions::{PyFileNotFoundError, PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use riffel_answers::AnswerError;
use riffel_calibrate::CalibrationError;
use riffel_keys::CaseError;
use riffel_network::NetworkError;
use riffel_study::StudyError;

create_exception!(riffel, ConvergenceError, PyRuntimeError, "An iteration did not reach its tolerance.");
create_exception!(
    riffel,
    ReceptanceError,
    PyValueError,
    "A receptance given from Python raised, or did not return one finite complex number for each frequency."
);

/// What has no answer; arguments by their names in Python.
pub(crate) fn of_answer(error: AnswerError) -> PyErr {
    let named = |argument: &str| argument.trim_start_matches('-').replace('-', "_");
    match error {
        AnswerError::Case(error) => of_case(error),
        AnswerError::Argument { argument, value, rule } => {
            wrong(format!("{} is {value}, but must be {rule}", named(argument)))
        }
        AnswerError::Range { argument, message } => wrong(format!("{}{message}", named(argument))),
        AnswerError::Option { option, message } => wrong(format!("{}: {message}", named(option))),
        AnswerError::Calibration(error) => of_calibration(*error),
        AnswerError::Network(error) => of_network(*error),
        AnswerError::Study(error) => of_study(*error),
        AnswerError::Physics(error) => of_physics(error),
        error => wrong(error.to_string()),
    }
}

/// An error of a calibration: `FileNotFoundError` or `OSError` where its folder cannot be read or written, or else `ValueError`.
pub(crate) fn of_calibration(error: CalibrationError) -> PyErr {
    match error {
        CalibrationError::Plan(error) => of_case(error),
        CalibrationError::NotThere { .. } => PyFileNotFoundError::new_err(error.to_string()),
        CalibrationError::Read { .. } | CalibrationError::Write { .. } => PyOSError::new_err(error.to_string()),
        error => wrong(error.to_string()),
    }
}

/// An error of a store of surveys, likewise.
pub(crate) fn of_network(error: NetworkError) -> PyErr {
    match error {
        NetworkError::Input(error) => of_case(error),
        NetworkError::NoNetwork { .. } => PyFileNotFoundError::new_err(error.to_string()),
        NetworkError::Read { ref reason, .. } if reason.kind() == std::io::ErrorKind::NotFound => {
            PyFileNotFoundError::new_err(error.to_string())
        }
        NetworkError::Read { .. } | NetworkError::Write { .. } | NetworkError::Locked { .. } => {
            PyOSError::new_err(error.to_string())
        }
        _ => wrong(error.to_string()),
    }
}

/// An error of a study, likewise.
pub(crate) fn of_study(error: StudyError) -> PyErr {
    match error {
        StudyError::Plan(error) => of_case(error),
        StudyError::NoStudy { .. } => PyFileNotFoundError::new_err(error.to_string()),
        StudyError::Read { .. } | StudyError::Write { .. } => PyOSError::new_err(error.to_string()),
        error => wrong(error.to_string()),
    }
}

/// An error of a case: `ValueError`, unless a file is missing or an iteration stopped.
pub(crate) fn of_case(error: CaseError) -> PyErr {
    let message = error.in_words();
    match error {
        CaseError::Read { reason, .. } if reason.kind() == std::io::ErrorKind::NotFound => {
            PyFileNotFoundError::new_err(message)
        }
        CaseError::Read { .. } => PyOSError::new_err(message),
        CaseError::Data { path, message: sentence, .. }
            if sentence.to_string().contains("cannot read") && !path.exists() =>
        {
            PyFileNotFoundError::new_err(message)
        }
        CaseError::NotConverged(_) => ConvergenceError::new_err(message),
        CaseError::Physics { error: riffel::Error::NotConverged { .. }, .. } => ConvergenceError::new_err(message),
        _ => PyValueError::new_err(message),
    }
}

/// An error of the physics.
pub(crate) fn of_physics(error: riffel::Error) -> PyErr {
    match error {
        riffel::Error::NotConverged { .. } => ConvergenceError::new_err(error.to_string()),
        _ => PyValueError::new_err(error.to_string()),
    }
}

/// A sentence as `ValueError`.
pub(crate) fn wrong(sentence: impl Into<String>) -> PyErr {
    PyValueError::new_err(sentence.into())
}
