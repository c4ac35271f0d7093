//! On how many threads long work is done.

use crate::{AnswerError, Result};

/// Work on so many threads, on one for each processor where none are given.
///
/// # Errors
/// [`AnswerError::Threads`] where they cannot be started.
pub fn on_threads<T: Send>(threads: Option<u16>, work: impl FnOnce() -> T + Send) -> Result<T> {
    let Some(threads) = threads else {
        return Ok(work());
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
    let pool = pool.build().map_err(|reason| AnswerError::Threads { threads, reason: reason.to_string() })?;
    Ok(pool.install(work))
}
