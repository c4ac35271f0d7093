//! Who asks at the terminal.

use std::path::Path;

use riffel_answers::question::{Asker, Step};
use riffel_keys::{Language, Message};

use crate::messages::{language, print_remarks};
use crate::progress::Progress;
use crate::staging::add_input;

/// The person or program at this terminal.
pub(crate) struct Terminal;

impl Asker for Terminal {
    fn begin(&self, work: Message, steps: usize) -> Step<'_> {
        let progress = Progress::new(work, steps);
        Box::new(move |by| progress.advance(by))
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
