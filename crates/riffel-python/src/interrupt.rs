//! Long work that leaves Python free and that Ctrl-C ends.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// How often signals are looked at.
const PATIENCE: Duration = Duration::from_millis(50);

/// The result of work that is done without the interpreter, on the threads of rayon, so that a signal raises at once.
/// Work that is given up runs to its end unheard.
///
/// A thread of rayon and not of its own: work in parallel begins there anyway, and is not handed on once more.
pub(crate) fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    Ok(interruptible_meanwhile(py, work, || Ok(()))?.0)
}

/// The same, with something for the interpreter to do until the result is there; if that raises, as on a signal, the
/// work is given up.
pub(crate) fn interruptible_meanwhile<T: Send + 'static, M>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
    meanwhile: impl FnOnce() -> PyResult<M>,
) -> PyResult<(T, M)> {
    if rayon::current_thread_index().is_some() {
        // A callable of the user that asks another case: its thread must not wait for itself.
        return Ok((py.detach(work), meanwhile()?));
    }
    let (sender, receiver) = sync_channel(1);
    let receiver = Mutex::new(receiver);
    rayon::spawn(move || {
        // Nobody listens after a signal. A panic goes on where the result is waited for.
        let _ = sender.send(catch_unwind(AssertUnwindSafe(work)));
    });
    let meanwhile = meanwhile()?;
    loop {
        let received = py.detach(|| match receiver.lock() {
            Ok(receiver) => receiver.recv_timeout(PATIENCE),
            Err(_) => Err(RecvTimeoutError::Disconnected),
        });
        match received {
            Ok(Ok(result)) => return Ok((result, meanwhile)),
            Ok(Err(panic)) => resume_unwind(panic),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the threads of Riffel have ended"));
            }
        }
    }
}
