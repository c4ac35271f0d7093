//! What is said on standard error beside the results: messages and notes, as much as was asked for.

use std::fmt::Display;
use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use miette::MietteHandlerOpts;
use riffel_case::{Language, Remark};

/// How much is said.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verbosity {
    /// Errors only.
    Quiet,
    /// Notes in one line each.
    Normal,
    /// Notes in full.
    Verbose,
}

/// Of this run.
static VERBOSITY: AtomicU8 = AtomicU8::new(Verbosity::Normal as u8);

/// The notes of this run so far.
static PRINTED: Mutex<Vec<String>> = Mutex::new(Vec::new());

fn printed() -> MutexGuard<'static, Vec<String>> {
    PRINTED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Begin a run that says as much.
pub(crate) fn begin(verbosity: Verbosity) {
    VERBOSITY.store(verbosity as u8, Ordering::Relaxed);
    printed().clear();
}

/// Where errors go to a file or a pipe, lay them out for 80 columns: else the width would be that of whatever terminal
/// the other stream is on.
pub(crate) fn lay_out_errors() {
    const COLUMNS: usize = 80;
    if !io::stderr().is_terminal() {
        // Fails where it has been done: a Python process may run the program more than once.
        let _ = miette::set_hook(Box::new(|_| {
            Box::new(MietteHandlerOpts::new().width(COLUMNS).build())
        }));
    }
}

/// True if nothing but errors is to be said.
pub(crate) fn is_quiet() -> bool {
    VERBOSITY.load(Ordering::Relaxed) == Verbosity::Quiet as u8
}

/// A line on standard error, said also with `--quiet`. Where that is closed or full there is nobody left to tell.
pub(crate) fn complain(message: impl Display) {
    let _ = writeln!(io::stderr().lock(), "{message}");
}

/// A line on standard error, unless `--quiet` was given.
pub(crate) fn say(message: impl Display) {
    if !is_quiet() {
        complain(message);
    }
}

/// What the reader of the results should know, in a line and in full.
pub(crate) trait Note {
    fn in_a_line(&self) -> &str;
    fn in_full(&self) -> &str;
}

impl Note for Remark {
    fn in_a_line(&self) -> &str {
        self.short()
    }

    fn in_full(&self) -> &str {
        self.in_language(Language::English)
    }
}

impl Note for String {
    fn in_a_line(&self) -> &str {
        self
    }

    fn in_full(&self) -> &str {
        self
    }
}

/// Notes on the validity of the models and on what was read: each once in a run, in full with `--verbose`.
pub(crate) fn print_remarks(remarks: &[impl Note]) {
    let is_verbose = VERBOSITY.load(Ordering::Relaxed) == Verbosity::Verbose as u8;
    let mut printed = printed();
    for remark in remarks {
        let note = match is_verbose {
            true => remark.in_full(),
            false => remark.in_a_line(),
        };
        if !printed.iter().any(|earlier| earlier == note) {
            say(format_args!("note: {note}"));
            printed.push(note.to_owned());
        }
    }
}
