//! A question that is data: its answer, handed out.

use riffel_answers::AnswerError;
use riffel_answers::question::Files;

use crate::arguments::QuestionCall;
use crate::messages::{complain, language};
use crate::results::put;
use crate::staging::INTERRUPTED;
use crate::terminal::Terminal;

/// There is an answer, but none to go by.
const DOUBTFUL: u8 = 1;

/// Answer a question, and hand the answer out; returns the exit status.
pub(crate) fn run(call: &QuestionCall) -> miette::Result<u8> {
    let own = match call.question.name() {
        "simulate" => super::passages::run(call)?,
        "study" => Some(super::study::run(call)?),
        "calibrate" => Some(super::calibrate::run(call)?),
        _ => None,
    };
    if let Some(status) = own {
        return Ok(status);
    }
    let answer = match call.question.answer(call.keys.clone(), &Terminal) {
        Err(AnswerError::Stopped(message)) => {
            complain(message);
            return Ok(INTERRUPTED);
        }
        Err(AnswerError::Unfinished(message)) => {
            complain(message);
            return Ok(DOUBTFUL);
        }
        answer => answer?,
    };
    // A text that is the whole answer stands in the document of a question in JSON, and in a file only where one is named.
    let in_document = call.json && call.question.files() == Files::Text;
    let text = answer.own_text().filter(|_| !in_document || call.output.is_some());
    if let Some(mut text) = text {
        text.written = text.written.filter(|_| !in_document);
        put(&text)?;
        if text.is_all() {
            return Ok(0);
        }
    }
    call.results_of(answer.folder_name()).answer(&*answer)?;
    let doubts = answer.doubts();
    doubts.iter().for_each(|doubt| complain(doubt.text(language())));
    Ok(if doubts.is_empty() { 0 } else { DOUBTFUL })
}
