//! Ctrl-C: nothing half-written remains, and long work ends by itself.

use std::fs;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError, Weak};

use riffel_study::Stop;

use crate::scratch::Scratch;

/// Exit status of a program that Ctrl-C stopped.
pub(crate) const INTERRUPTED: u8 = 130;

/// Whom the handler serves: a signal comes to a process, whichever run is under way in it.
static UNDER_WAY: Mutex<Weak<Interrupt>> = Mutex::new(Weak::new());

/// What Ctrl-C has to end in a run.
#[derive(Default)]
pub(crate) struct Interrupt {
    /// The temporary folder in use.
    active: Mutex<Option<Active>>,
    /// Work which ends by itself when it is asked to.
    work: OnceLock<Arc<Stop>>,
}

/// A temporary folder that is removed.
pub(crate) struct Active {
    pub(crate) scratch: Scratch,
    /// The folder of results, if it was made for this run.
    pub(crate) made: Option<PathBuf>,
}

impl Active {
    pub(crate) fn discard(self) {
        self.scratch.close();
        if let Some(made) = self.made {
            // Fails, as it should, where something has been put there meanwhile.
            let _ = fs::remove_dir(made);
        }
    }
}

impl Interrupt {
    /// The temporary folder in use, which the handler waits for: it never cuts into the renaming of finished files.
    pub(crate) fn active(&self) -> MutexGuard<'_, Option<Active>> {
        // The data is a path: nothing about it is broken by a panic elsewhere.
        self.active.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Let Ctrl-C ask the work to stop, instead of ending the program; the second one ends it.
    pub(crate) fn asks_work(&self) -> Arc<Stop> {
        self.work.get_or_init(Arc::default).clone()
    }

    /// On Ctrl-C or a request to end, remove what is half-written and leave with status 130.
    pub(crate) fn handle(self: &Arc<Self>) {
        *under_way() = Arc::downgrade(self);
        // Fails only where an earlier run of the process has set it.
        let _ = ctrlc::set_handler(|| {
            let interrupt = under_way().upgrade();
            match interrupt {
                Some(interrupt) => interrupt.end(),
                None => std::process::exit(INTERRUPTED.into()),
            }
        });
    }

    /// Ask the work to stop, or else remove what is half-written and end the process.
    fn end(&self) {
        if let Some(stop) = self.work.get().filter(|stop| !stop.is_asked()) {
            return stop.ask();
        }
        let mut guard = self.active();
        if let Some(active) = guard.take() {
            active.discard();
        }
        std::process::exit(INTERRUPTED.into());
    }
}

fn under_way() -> MutexGuard<'static, Weak<Interrupt>> {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}
