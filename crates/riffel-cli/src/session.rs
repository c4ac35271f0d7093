//! A run of the program: how it speaks, what it reads, and what Ctrl-C does to it.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use riffel_keys::Message;

use crate::interrupt::Interrupt;
use crate::messages::{Verbosity, Voice};

/// One run of the program. A process may have more than one, as that of Python has.
pub(crate) struct Session {
    pub(crate) voice: Voice,
    /// What is under way when Ctrl-C is pressed.
    pub(crate) interrupt: Arc<Interrupt>,
    /// The notes so far.
    notes: Mutex<Vec<String>>,
    /// The files that it reads, of which none is replaced.
    inputs: Mutex<Vec<PathBuf>>,
}

impl Session {
    pub(crate) fn new(voice: Voice) -> Self {
        Self { voice, interrupt: Arc::default(), notes: Mutex::default(), inputs: Mutex::default() }
    }

    /// Notes on the validity of the models and on what was read: each once in a run, in full with `--verbose`.
    pub(crate) fn print_remarks<M>(&self, remarks: &[M])
    where
        for<'a> &'a M: Into<Message>,
    {
        let mut notes = self.notes.lock().unwrap_or_else(PoisonError::into_inner);
        for remark in remarks {
            let remark: Message = remark.into();
            let note = match self.voice.verbosity {
                Verbosity::Verbose => remark.text(self.voice.language),
                Verbosity::Normal | Verbosity::Quiet => remark.short(self.voice.language),
            };
            if !notes.contains(&note) {
                self.voice.note(&remark, &note);
                notes.push(note);
            }
        }
    }

    /// One more file that this run reads.
    pub(crate) fn add_input(&self, path: PathBuf) {
        self.inputs.lock().unwrap_or_else(PoisonError::into_inner).push(path);
    }

    /// Whether one of the files that it reads is such.
    pub(crate) fn reads(&self, is_such: impl FnMut(&PathBuf) -> bool) -> bool {
        self.inputs.lock().unwrap_or_else(PoisonError::into_inner).iter().any(is_such)
    }
}
