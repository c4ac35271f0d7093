//! Long work that leaves Python free and that Ctrl-C ends.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
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
    if rayon::current_thread_index().is_some() {
        // A callable of the user that asks another case: its thread must not wait for itself.
        return Ok(py.detach(work));
    }
    let (sender, receiver) = sync_channel(1);
    rayon::spawn(move || {
        // Nobody listens after a signal. A panic goes on where the result is waited for.
        let _ = sender.send(catch_unwind(AssertUnwindSafe(work)));
    });
    let receiver = Mutex::new(receiver);
    loop {
        match wait(py, &receiver) {
            Ok(Ok(result)) => return Ok(result),
            Ok(Err(panic)) => resume_unwind(panic),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the threads of Riffel have ended"));
            }
        }
    }
}

/// The same for work on memory of the caller, which asks whether it is still wanted and ends soon after a signal.
/// Until it ends, the interpreter does something else, whose result is returned; an error of that ends the work too.
///
/// `give_up` is called when the work is no longer wanted, for what else it may be waiting for.
pub(crate) fn interruptible_while<M>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) + Send,
    meanwhile: impl FnOnce() -> PyResult<M>,
    give_up: impl Fn(&PyErr),
) -> PyResult<M> {
    let wanted = AtomicBool::new(true);
    if rayon::current_thread_index().is_some() {
        py.detach(|| work(&wanted));
        return meanwhile();
    }
    let (sender, receiver) = sync_channel(1);
    rayon::in_place_scope(|scope| {
        let wanted = &wanted;
        scope.spawn(move |_| {
            work(wanted);
            // A panic closes the channel instead, and goes on at the end of the scope.
            let _ = sender.send(());
        });
        let receiver = Mutex::new(receiver);
        let mut result = meanwhile();
        loop {
            if let Err(error) = &result
                && wanted.swap(false, Ordering::Relaxed)
            {
                give_up(error);
            }
            match wait(py, &receiver) {
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(error) = py.check_signals() {
                        result = Err(error);
                    }
                }
                Ok(()) | Err(RecvTimeoutError::Disconnected) => return result,
            }
        }
    })
}

/// Wait without the interpreter, but not for long.
fn wait<T: Send>(py: Python<'_>, receiver: &Mutex<Receiver<T>>) -> Result<T, RecvTimeoutError> {
    py.detach(|| match receiver.lock() {
        Ok(receiver) => receiver.recv_timeout(PATIENCE),
        Err(_) => Err(RecvTimeoutError::Disconnected),
    })
}
