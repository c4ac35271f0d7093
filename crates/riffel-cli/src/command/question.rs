//! A question that is data: its answer, handed out.

use std::path::Path;

use riffel_answers::question::{Asker, Step};
use riffel_keys::Message;

use crate::arguments::AskedQuestion;
use crate::messages::print_remarks;
use crate::output::print;
use crate::progress::Progress;
use crate::results::{Results, readable};
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

    fn reads(&self, path: &Path) {
        add_input(path.to_owned());
    }
}

/// Answer a question, and hand the answer out.
pub(crate) fn run(asked: &AskedQuestion) -> miette::Result<()> {
    let answer = asked.question.answer(asked.keys.clone(), &Terminal)?;
    if !asked.question.writes_files() && !asked.results.json {
        print(&readable(&*answer))?;
        print_remarks(answer.remarks());
        return Ok(());
    }
    let name = answer.folder_name().unwrap_or(asked.question.name());
    Ok(Results::named(name, asked.stem(), &asked.results).answer(&*answer)?)
}
