//! Long work that leaves Python free and that Ctrl-C ends.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use riffel::cancel::{run_beside, run_while};

/// How often signals are looked at.
const PATIENCE: Duration = Duration::from_millis(50);

/// The result of long work that is done without the interpreter. A signal raises at once, and the work ends soon after it.
pub(crate) fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    if is_within_work() {
        return Ok(py.detach(work));
    }
    let wanted = CancelToken::default();
    let asked = wanted.clone();
    let stop = || _ = wanted.give_up();
    let done = stoppable(py, move || asked.run(work), stop)?;
    done.ok_or_else(ended)
}

/// Result of work that keeps what it has before it ends: after a signal it is asked to `stop`.
///
/// A thread of rayon and not of its own: work in parallel begins there anyway, and is not handed on once more.
pub(crate) fn stoppable<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
    stop: impl FnOnce(),
) -> PyResult<T> {
    if is_within_work() {
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
            Err(RecvTimeoutError::Timeout) => {
                if let Err(error) = py.check_signals() {
                    stop();
                    return Err(error);
                }
            }
            Err(RecvTimeoutError::Disconnected) => return Err(ended()),
        }
    }
}

/// Long work on memory of the caller, which a signal ends. Until it ends, the interpreter does something else, whose result is
/// returned; an error of that ends the work too.
///
/// `give_up` is called when the work is no longer wanted, for what else it may be waiting for.
pub(crate) fn interruptible_while<M>(
    py: Python<'_>,
    work: impl FnOnce() + Send,
    meanwhile: impl FnOnce() -> PyResult<M>,
    give_up: impl Fn(&PyErr),
) -> PyResult<M> {
    if is_within_work() {
        py.detach(work);
        return meanwhile();
    }
    let wanted = CancelToken::default();
    let asked = wanted.clone();
    let (sender, receiver) = sync_channel(1);
    let work = move || {
        work();
        // Where it is broken off or panics, the channel is closed instead; a panic goes on when this thread has ended its part.
        let _ = sender.send(());
    };
    run_beside(
        move || asked.is_wanted(),
        work,
        || {
            let receiver = Mutex::new(receiver);
            let mut result = meanwhile();
            loop {
                if let Err(error) = &result
                    && wanted.give_up()
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
        },
    )
}

/// Whether a callable of the user asks from within work for more: its thread must not wait for itself.
fn is_within_work() -> bool {
    rayon::current_thread_index().is_some()
}

/// Whether the result of some work is still wanted.
#[derive(Clone)]
struct CancelToken(Arc<AtomicBool>);

impl Default for CancelToken {
    fn default() -> Self {
        Self(Arc::new(AtomicBool::new(true)))
    }
}

impl CancelToken {
    /// Work, for as long as it is wanted.
    fn run<T: Send>(self, work: impl FnOnce() -> T + Send) -> Option<T> {
        run_while(move || self.is_wanted(), work)
    }

    fn is_wanted(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Whether it was wanted until now.
    fn give_up(&self) -> bool {
        self.0.swap(false, Ordering::Relaxed)
    }
}

fn ended() -> PyErr {
    PyRuntimeError::new_err("the threads of Riffel have ended")
}

/// Wait without the interpreter, but not for long.
fn wait<T: Send>(py: Python<'_>, receiver: &Mutex<Receiver<T>>) -> Result<T, RecvTimeoutError> {
    py.detach(|| match receiver.lock() {
        Ok(receiver) => receiver.recv_timeout(PATIENCE),
        Err(_) => Err(RecvTimeoutError::Disconnected),
    })
}
