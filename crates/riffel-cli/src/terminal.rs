//! Who asks at the terminal.

use std::path::Path;
use std::sync::Arc;

use riffel_answers::question::{Client, Step};
use riffel_keys::{Language, Message};
use riffel_study::Stop;

use crate::progress::Progress;
use crate::session::Session;

/// The person or program at this terminal.
pub(crate) struct Terminal<'a>(pub(crate) &'a Session);

impl Client for Terminal<'_> {
    fn begin(&self, work: Message, steps: usize) -> Step<'_> {
        let progress = Progress::new(self.0.voice, work, steps);
        Box::new(move |by| progress.advance(by))
    }

    fn count(&self, work: Message, total: u64) -> Step<'_> {
        let progress = Progress::counting(self.0.voice, work, total);
        Box::new(move |by| progress.advance(by))
    }

    fn say(&self, what: Message) {
        self.0.voice.say(what);
    }

    fn stop(&self) -> Arc<Stop> {
        self.0.interrupt.asks_work()
    }

    fn remark(&self, remarks: &[Message]) {
        self.0.print_remarks(remarks);
    }

    fn language(&self) -> Language {
        self.0.voice.language
    }

    fn reads(&self, path: &Path) {
        self.0.add_input(path.to_owned());
    }
}
