//! Questions by their names, as the program answers them.

use std::path::Path;
use std::sync::{Mutex, PoisonError};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use pythonize::{depythonize, pythonize};
use riffel_answers::AnswerError;
use riffel_answers::question::{self, Asker, Step};
use riffel_keys::Message;
use riffel_keys::question::Held;
use serde_json::{Map, Value};

use crate::case::Case;
use crate::curving::CurvingCase;
use crate::errors::of_answer;
use crate::interrupt::interruptible;
use crate::records::Record;

/// Somebody who hears what is unusual about a question after it is answered.
#[derive(Default)]
struct Listener(Mutex<Vec<Message>>);

impl Asker for Listener {
    fn begin(&self, _: Message, _: usize) -> Step<'_> {
        Box::new(|_| ())
    }

    fn remark(&self, remarks: &[Message]) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(remarks);
    }

    fn reads(&self, _: &Path) {}
}

/// What stands under the keys of a question in memory, and the cases among it.
#[derive(Default)]
struct InMemory<'py>(Held, Vec<Bound<'py, Case>>);

impl<'py> InMemory<'py> {
    /// A value in JSON, with paths in the place of what is in memory.
    fn hold(&mut self, key: &str, value: &Bound<'py, PyAny>) -> PyResult<Value> {
        let path = if let Ok(case) = value.cast::<Case>() {
            self.1.push(case.clone());
            self.0.hold(key, case.get().case.clone())
        } else if let Ok(case) = value.cast::<CurvingCase>() {
            self.0.hold(key, case.get().0.clone())
        } else if let Ok(record) = value.cast::<Record>() {
            let Record { name, file } = record.get();
            self.0.hold(name, file.clone())
        } else if let Ok(list) = value.cast::<PyList>() {
            let items = list.iter().enumerate();
            return items.map(|(place, one)| self.hold(&format!("{key}.{place}"), &one)).collect();
        } else {
            return Ok(depythonize(value)?);
        };
        Ok(path.to_string_lossy().into())
    }
}

/// Document of an answer, remarks on its question with their ids, and those of the answer.
type Told<'py> = (Bound<'py, PyAny>, Vec<(&'static str, String)>, Vec<String>);

/// Answer a question in which cases and records may stand.
#[pyfunction]
pub(crate) fn ask<'py>(py: Python<'py>, name: &str, question: &Bound<'py, PyDict>) -> PyResult<Told<'py>> {
    let named = question::known(name).map_err(of_answer)?;
    let (mut keys, mut in_memory) = (Map::new(), InMemory::default());
    for (key, value) in question {
        let key: String = key.extract().map_err(|_| PyTypeError::new_err("keys of a question are strings"))?;
        let value = in_memory.hold(&key, &value)?;
        keys.insert(key, value);
    }
    let InMemory(values, cases) = in_memory;
    let held = (values, question::hold(named, &mut keys));
    let answered = interruptible(py, move || {
        let _held = held;
        let asker = Listener::default();
        let answer = named.answer(keys, &asker)?;
        let on_question = asker.0.into_inner().unwrap_or_else(PoisonError::into_inner);
        let own = answer.remarks().iter().map(ToString::to_string).collect();
        Ok::<_, AnswerError>((answer.value(), on_question, own))
    });
    let answered = cases.iter().try_fold(answered?, |answered, case| case.get().unless_callable_failed(answered));
    let (document, on_question, own): (Value, Vec<Message>, _) = answered?.map_err(of_answer)?;
    let on_question = on_question.iter().map(|remark| (remark.id(), remark.to_string()));
    Ok((pythonize(py, &document)?, on_question.collect(), own))
}
