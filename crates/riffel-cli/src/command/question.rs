//! A question that is data: its answer, handed out.

use crate::arguments::AskedQuestion;
use crate::messages::print_remarks;
use crate::output::print;
use crate::results::{Results, put, readable};
use crate::terminal::Terminal;

/// Answer a question, and hand the answer out.
pub(crate) fn run(asked: &AskedQuestion) -> miette::Result<()> {
    let answer = asked.question.answer(asked.keys.clone(), &Terminal)?;
    if let Some(text) = answer.own_text() {
        put(&text)?;
        if text.is_all() {
            return Ok(());
        }
    }
    if !asked.question.writes_files() && !asked.results.json {
        print(&readable(&*answer))?;
        print_remarks(answer.remarks());
        return Ok(());
    }
    let name = answer.folder_name().unwrap_or(asked.question.name());
    Ok(Results::named(name, asked.stem(), &asked.results).answer(&*answer)?)
}
