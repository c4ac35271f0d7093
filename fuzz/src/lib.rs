//! What every fuzz target holds its reader to: bounded time, and errors that a terminal can show.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::Duration;

use cpu_time::ProcessTime;
use miette::Diagnostic;
use riffel_keys::CaseError;
use tempfile::TempDir;

/// Longest time a reader may compute on one input, on all threads together.
const LONGEST: Duration = Duration::from_secs(1);
/// Longest sentence of an error, in bytes: a value of the file is quoted, not repeated whole.
const LONGEST_SENTENCE: usize = 4096;

/// Runs a reader on one input.
///
/// # Panics
/// If it takes more than a second of processor time, or if its error is endless or has control characters in it,
/// which a terminal would obey.
pub fn read<T>(reader: impl FnOnce() -> Result<T, CaseError>) -> Option<T> {
    let start = ProcessTime::now();
    let outcome = reader();
    let elapsed = start.elapsed();
    assert!(elapsed <= LONGEST, "the reader took {elapsed:?}");
    match outcome {
        Ok(value) => Some(value),
        Err(error) => {
            check(&error.to_string());
            if let Some(help) = error.help() {
                check(&help.to_string());
            }
            for label in error.labels().into_iter().flatten() {
                check(label.label().unwrap_or_default());
            }
            None
        }
    }
}

fn check(words: &str) {
    let control = words.chars().find(|c| c.is_control() && *c != '\n');
    assert!(
        control.is_none(),
        "the error has the control character {control:?} in it: {words:?}"
    );
    assert!(
        words.len() <= LONGEST_SENTENCE,
        "the error has {} bytes",
        words.len()
    );
}

static FOLDER: LazyLock<TempDir> = LazyLock::new(|| {
    let memory = Path::new("/dev/shm");
    let folder = if memory.is_dir() {
        TempDir::new_in(memory)
    } else {
        TempDir::new()
    };
    folder.expect("a folder for the inputs")
});

/// A file with these bytes, in memory where the system has such a place. The next file of the name replaces it.
///
/// # Panics
/// If it cannot be written.
pub fn file(name: &str, bytes: &[u8]) -> PathBuf {
    let path = FOLDER.path().join(name);
    fs::write(&path, bytes).expect("the input can be written");
    path
}
