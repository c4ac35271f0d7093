//! Questions by their names, as the program answers them.

use std::path::Path;
use std::sync::{Mutex, PoisonError};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use pythonize::{depythonize, pythonize};
use riffel_answers::AnswerError;
use riffel_answers::question::{self, AnyQuestion, Client, Step};
use riffel_keys::Message;
use riffel_keys::question::Held;
use serde_json::{Map, Value};

use crate::axlebox::AxleBoxRun;
use crate::case::Case;
use crate::curving::CurvingCase;
use crate::document::sentences;
use crate::errors::of_answer;
use crate::interrupt::interruptible;
use crate::records::Record;
use crate::traffic::Traffic;

/// Somebody who hears what is unusual about a question after it is answered.
#[derive(Default)]
struct Listener(Mutex<Vec<Message>>);

impl Client for Listener {
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
        } else if let Ok(run) = value.cast::<AxleBoxRun>() {
            self.0.hold("run", run.get().0.clone())
        } else if let Ok(traffic) = value.cast::<Traffic>() {
            self.0.hold(key, traffic.get().0.clone())
        } else if let Ok(list) = value.cast::<PyList>() {
            let items = list.iter().enumerate();
            return items.map(|(place, one)| self.hold(&format!("{key}.{place}"), &one)).collect();
        } else {
            return Ok(depythonize(value)?);
        };
        Ok(path.to_string_lossy().into())
    }
}

/// The keys of a question, which hold what stands in memory, and the cases among it.
pub(crate) struct QuestionArg<'py> {
    keys: Map<String, Value>,
    held: [Held; 2],
    cases: Vec<Bound<'py, Case>>,
}

impl<'py> QuestionArg<'py> {
    pub(crate) fn new(named: &dyn AnyQuestion, question: &Bound<'py, PyDict>) -> PyResult<Self> {
        let (mut keys, mut in_memory) = (Map::new(), InMemory::default());
        for (key, value) in question {
            let key: String = key.extract().map_err(|_| PyTypeError::new_err("keys of a question are strings"))?;
            let value = in_memory.hold(&key, &value)?;
            keys.insert(key, value);
        }
        let InMemory(values, cases) = in_memory;
        let held = [values, question::hold(named, &mut keys)];
        Ok(Self { keys, held, cases })
    }

    /// Long work on the question without the interpreter, and what is unusual about the question.
    pub(crate) fn answer<T: Send + 'static>(
        self,
        py: Python<'py>,
        work: impl FnOnce(Map<String, Value>, &dyn Client) -> Result<T, AnswerError> + Send + 'static,
    ) -> PyResult<(T, Vec<Message>)> {
        let Self { keys, held, cases } = self;
        let answered = interruptible(py, move || {
            let _held = held;
            let client = Listener::default();
            let answer = work(keys, &client)?;
            Ok((answer, client.0.into_inner().unwrap_or_else(PoisonError::into_inner)))
        });
        let answered = cases.iter().try_fold(answered?, |answered, case| case.get().unless_callable_failed(answered));
        answered?.map_err(of_answer)
    }
}

/// Document of an answer, remarks on its question with their ids, and those of the answer.
type AnswerParts<'py> = (Bound<'py, PyAny>, Vec<(&'static str, String)>, Vec<String>);

/// Answer a question in which cases, records and traffic may stand.
#[pyfunction]
pub(crate) fn ask<'py>(py: Python<'py>, name: &str, question: &Bound<'py, PyDict>) -> PyResult<AnswerParts<'py>> {
    let named = question::known(name).map_err(of_answer)?;
    let ((document, own), on_question) = QuestionArg::new(named, question)?.answer(py, |keys, client| {
        let answer = named.answer(keys, client)?;
        let own = sentences(answer.remarks());
        Ok((answer.value(), own))
    })?;
    let on_question = on_question.iter().map(|remark| (remark.id(), remark.to_string()));
    Ok((pythonize(py, &document)?, on_question.collect(), own))
}
