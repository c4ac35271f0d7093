//! The module: a question is written into its memory, and the answer is read from there.
//!
//! One call after the other, in a worker that has the module for itself:
//!
//! 1. `room(path, question)` makes room for a path and a question of that many bytes and says where it begins; both
//!    are written there, one after the other.
//! 2. `answer()` answers and returns the status of HTTP that the server would give: 200, or that of a fault.
//! 3. `reply()` says where the answer begins, `reply_length()` how many bytes it has: the bytes that the server would
//!    send. They stay until the next question.
//!
//! Work cannot be broken off from outside; whoever no longer wants it ends the worker.

use std::sync::{Mutex, MutexGuard, PoisonError};

use riffel_answers::page::Fault;

static EXCHANGE: Mutex<Exchange> = Mutex::new(Exchange { path_length: 0, asked: Vec::new(), reply: Vec::new() });

struct Exchange {
    path_length: usize,
    /// The path, then the question in JSON.
    asked: Vec<u8>,
    reply: Vec<u8>,
}

fn exchange() -> MutexGuard<'static, Exchange> {
    // After a panic the module is gone as a whole.
    EXCHANGE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Room for a path and a question of so many bytes.
#[expect(unsafe_code, reason = "a name that the worker calls")]
#[unsafe(no_mangle)]
pub extern "C" fn room(path: usize, question: usize) -> *mut u8 {
    let mut exchange = exchange();
    exchange.path_length = path;
    exchange.asked.clear();
    exchange.asked.resize(path + question, 0);
    exchange.asked.as_mut_ptr()
}

/// Answer what was written, and return the status.
#[expect(unsafe_code, reason = "a name that the worker calls")]
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> u32 {
    let mut exchange = exchange();
    let (path, question) = exchange.asked.split_at(exchange.path_length);
    let (status, reply) = match answer_to(path, question) {
        Ok(reply) => (200, reply),
        Err(fault) => (fault.status().into(), riffel_answers::page::written(&fault).unwrap_or_default()),
    };
    exchange.reply = reply;
    status
}

/// Where the answer begins.
#[expect(unsafe_code, reason = "a name that the worker calls")]
#[unsafe(no_mangle)]
pub extern "C" fn reply() -> *const u8 {
    exchange().reply.as_ptr()
}

/// How many bytes the answer has.
#[expect(unsafe_code, reason = "a name that the worker calls")]
#[unsafe(no_mangle)]
pub extern "C" fn reply_length() -> usize {
    exchange().reply.len()
}

/// Where the text begins that tells the release of the module: whoever packs the module looks for it.
#[expect(unsafe_code, reason = "a name that keeps the text in the module")]
#[unsafe(no_mangle)]
pub extern "C" fn release() -> *const u8 {
    riffel_answers::page::RELEASE.as_ptr()
}

fn answer_to(path: &[u8], question: &[u8]) -> Result<Vec<u8>, Fault> {
    const NOT_FOUND: u16 = 404;
    let asked = std::str::from_utf8(path).ok().and_then(|path| riffel_answers::page::read(path, question));
    let Some(asked) = asked else {
        let message = "this file does not hold that part of the page".to_owned();
        return Err(Fault::refused(NOT_FOUND, message, "the page of `riffel serve` has it"));
    };
    Ok(asked?.answer()?.bytes)
}
