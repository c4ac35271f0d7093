//! A question that is data: its answer, handed out.

use riffel_answers::AnswerError;
use riffel_answers::question::Files;

use crate::arguments::QuestionCall;
use crate::interrupt::INTERRUPTED;
use crate::results::put;
use crate::session::Session;
use crate::terminal::Terminal;

/// There is an answer, but none to go by.
const DOUBTFUL: u8 = 1;

/// Answer a question, and hand the answer out; returns the exit status.
pub(crate) fn run(session: &Session, call: &QuestionCall) -> miette::Result<u8> {
    let own = match call.question.name() {
        "simulate" => super::passages::run(session, call)?,
        "study" => Some(super::study::run(session, call)?),
        "calibrate" => Some(super::calibrate::run(session, call)?),
        _ => None,
    };
    if let Some(status) = own {
        return Ok(status);
    }
    let answer = match call.question.answer(call.keys.clone(), &Terminal(session)) {
        Err(AnswerError::Stopped(message)) => {
            session.voice.complain(message);
            return Ok(INTERRUPTED);
        }
        Err(AnswerError::Unfinished(message)) => {
            session.voice.complain(message);
            return Ok(DOUBTFUL);
        }
        answer => answer?,
    };
    // A text that is the whole answer stands in the document of a question in JSON, and in a file only where one is named.
    let in_document = call.json && call.question.files() == Files::Text;
    let text = answer.own_text().filter(|_| !in_document || call.output.is_some());
    if let Some(mut text) = text {
        text.written = text.written.filter(|_| !in_document);
        put(session, &text)?;
        if text.is_all() {
            return Ok(0);
        }
    }
    call.results_of(answer.folder_name()).answer(session, &*answer)?;
    let doubts = answer.doubts();
    doubts.iter().for_each(|doubt| session.voice.complain(doubt.text(session.voice.language)));
    Ok(if doubts.is_empty() { 0 } else { DOUBTFUL })
}
