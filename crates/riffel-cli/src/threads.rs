//! On how many threads a long command works.

use crate::error::CliError;

/// Work on so many threads, on one for each processor where none are given.
pub(crate) fn on_threads<T: Send>(threads: Option<u16>, work: impl FnOnce() -> T + Send) -> Result<T, CliError> {
    let Some(threads) = threads else {
        return Ok(work());
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
    let pool = pool.build().map_err(|reason| CliError::Threads { threads, reason: reason.to_string() })?;
    Ok(pool.install(work))
}
