//! Who asks at the terminal.

use std::path::Path;
use std::sync::Arc;

use riffel_answers::question::{Client, Step};
use riffel_keys::{Language, Message};
use riffel_study::Stop;

use crate::messages::{language, print_remarks, say};
use crate::progress::Progress;
use crate::staging::{add_input, stop_on_interrupt};

/// The person or program at this terminal.
pub(crate) struct Terminal;

impl Client for Terminal {
    fn begin(&self, work: Message, steps: usize) -> Step<'_> {
        let progress = Progress::new(work, steps);
        Box::new(move |by| progress.advance(by))
    }

    fn count(&self, work: Message, total: u64) -> Step<'_> {
        let progress = Progress::counting(work, total);
        Box::new(move |by| progress.advance(by))
    }

    fn say(&self, what: Message) {
        say(what);
    }

    fn stop(&self) -> Arc<Stop> {
        stop_on_interrupt()
    }

    fn remark(&self, remarks: &[Message]) {
        print_remarks(remarks);
    }

    fn language(&self) -> Language {
        language()
    }

    fn reads(&self, path: &Path) {
        add_input(path.to_owned());
    }
}
