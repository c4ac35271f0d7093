//! What is said on standard error beside the results: messages and notes, as much as was asked for.

use std::ffi::OsStr;
use std::fmt::{self, Display};
use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use miette::{Diagnostic, LabeledSpan, MietteHandlerOpts, Report, SourceCode};
use riffel_answers::AnswerError;
use riffel_keys::message::as_data;
use riffel_keys::text_file::in_a_message;
use riffel_keys::{CaseError, Language, Message, say};
use serde_json::{Value, json};

/// How much is said.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verbosity {
    /// Errors only.
    Quiet,
    /// Notes in one line each.
    Normal,
    /// Notes in full.
    Verbose,
}

/// Of this run.
static VERBOSITY: AtomicU8 = AtomicU8::new(Verbosity::Normal as u8);

/// The notes of this run so far.
static PRINTED: Mutex<Vec<String>> = Mutex::new(Vec::new());

fn printed() -> MutexGuard<'static, Vec<String>> {
    PRINTED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The language of this run, by its place among all.
static LANGUAGE: AtomicUsize = AtomicUsize::new(Language::English as usize);

/// Who reads what a run says beside its results.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reader {
    /// A person, in words.
    Person,
    /// Another program, in lines of JSON.
    Program {
        /// With the messages of answers and errors as data.
        messages: bool,
    },
}

/// True if this run speaks to a program.
static TO_A_PROGRAM: AtomicBool = AtomicBool::new(false);

/// True if the messages of answers and errors are told as data.
static MESSAGES_AS_DATA: AtomicBool = AtomicBool::new(false);

/// Begin a run that says as much, in a language, to somebody.
pub(crate) fn begin(verbosity: Verbosity, language: Language, reader: Reader) {
    VERBOSITY.store(verbosity as u8, Ordering::Relaxed);
    let (to_a_program, as_data) = match reader {
        Reader::Person => (false, false),
        Reader::Program { messages } => (true, messages),
    };
    TO_A_PROGRAM.store(to_a_program, Ordering::Relaxed);
    MESSAGES_AS_DATA.store(as_data, Ordering::Relaxed);
    LANGUAGE.store(language as usize, Ordering::Relaxed);
    printed().clear();
}

/// Where errors go to a file or a pipe, lay them out for 80 columns: else the width would be that of whatever terminal
/// the other stream is on.
pub(crate) fn lay_out_errors() {
    const COLUMNS: usize = 80;
    if !io::stderr().is_terminal() {
        // Fails where it has been done: a Python process may run the program more than once.
        let _ = miette::set_hook(Box::new(|_| Box::new(MietteHandlerOpts::new().width(COLUMNS).build())));
    }
}

/// The language of this run.
pub(crate) fn language() -> Language {
    Language::ALL.get(LANGUAGE.load(Ordering::Relaxed)).copied().unwrap_or_default()
}

/// True if nothing but errors is to be said.
pub(crate) fn is_quiet() -> bool {
    VERBOSITY.load(Ordering::Relaxed) == Verbosity::Quiet as u8
}

/// A line on standard error, said also with `--quiet`. Where that is closed or full there is nobody left to tell. Control
/// characters of a file or a command line are written out.
pub(crate) fn complain(message: impl Into<Message>) {
    let message = message.into();
    if is_for_a_program() {
        return write_line(&json!({ "remark": message.document(language()) }));
    }
    let words = message.text(language());
    let _ = writeln!(io::stderr().lock(), "{}", in_a_message(&words));
}

/// What ends the run, with the place in the file; in colours on a terminal, so that only its words are written out. As
/// JSON where another program asks for it.
pub(crate) fn complain_of(report: Report) {
    if is_for_a_program() {
        let (message, help) = words_of(&report);
        return write_document(&message, help.as_ref());
    }
    let shown = format!("{:?}", Report::new(Shown(report)));
    // A word of the same length, for what follows is set below it.
    let shown = shown.replace("  help: ", &format!("  {}: ", say!(help_in_four_letters).text(language())));
    let _ = writeln!(io::stderr().lock(), "{shown}");
}

/// True if another program reads what ends the run.
pub(crate) fn is_for_a_program() -> bool {
    TO_A_PROGRAM.load(Ordering::Relaxed)
}

/// True if the messages of answers and errors are told as data.
pub(crate) fn tells_messages_as_data() -> bool {
    MESSAGES_AS_DATA.load(Ordering::Relaxed)
}

/// How far the work is, for a program that reads it; whether one does.
pub(crate) fn tell_progress(done: u64, of: u64) -> bool {
    let is_for_a_program = is_for_a_program();
    if is_for_a_program {
        write_line(&json!({ "progress": { "done": done, "of": of } }));
    }
    is_for_a_program
}

/// An error as one line of JSON.
fn write_document(message: &Message, help: Option<&Message>) {
    let told = |message: &Message| match tells_messages_as_data() {
        true => as_data(|| json!(message)),
        false => json!(in_a_message(&message.to_string())),
    };
    write_line(&json!({ "error": { "message": told(message), "help": help.map(told) } }));
}

/// What ends a run and what would be right: errors of a case and of the physics have every language, others are English.
fn words_of(report: &Report) -> (Message, Option<Message>) {
    let answer = report.downcast_ref::<AnswerError>();
    let case = report.downcast_ref::<CaseError>().or(match answer {
        Some(AnswerError::Case(error)) => Some(error),
        _ => None,
    });
    if let Some(error) = case {
        return (error.message(), error.advice());
    }
    let message = answer.map_or_else(|| report.to_string().into(), AnswerError::message);
    (message, report.help().map(|help| help.to_string().into()))
}

/// A document on a line of standard error.
fn write_line(document: &Value) {
    let _ = writeln!(io::stderr().lock(), "{document}");
}

/// What is wrong with the command line. In colours on a terminal, unless the command line has control characters
/// itself, as they could not be told apart.
pub(crate) fn complain_of_usage<'a>(usage: &clap::Error, mut arguments: impl Iterator<Item = &'a OsStr>) {
    if arguments.all(|argument| is_shown_as_it_is(&argument.to_string_lossy())) {
        let _ = usage.print();
    } else {
        complain(usage.render().to_string().trim_end());
    }
}

fn is_shown_as_it_is(text: &str) -> bool {
    in_a_message(text) == text
}

/// An error whose words hold no control characters but line feeds.
#[derive(Debug)]
struct Shown(Report);

impl Display for Shown {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (message, _) = words_of(&self.0);
        formatter.write_str(&in_a_message(&message.text(language())))
    }
}

impl std::error::Error for Shown {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.0.source()
    }
}

impl Diagnostic for Shown {
    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        let (_, help) = words_of(&self.0);
        let help = help?.text(language());
        Some(Box::new(in_a_message(&help).into_owned()))
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        self.0.labels()
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.0.source_code()
    }
}

/// A line on standard error, unless `--quiet` was given.
pub(crate) fn say(message: impl Into<Message>) {
    if !is_quiet() {
        complain(message);
    }
}

/// Notes on the validity of the models and on what was read: each once in a run, in full with `--verbose`.
pub(crate) fn print_remarks<M>(remarks: &[M])
where
    for<'a> &'a M: Into<Message>,
{
    let is_verbose = VERBOSITY.load(Ordering::Relaxed) == Verbosity::Verbose as u8;
    let mut printed = printed();
    for remark in remarks {
        let remark: Message = remark.into();
        let note = match is_verbose {
            true => remark.text(language()),
            false => remark.short(language()),
        };
        if !printed.contains(&note) {
            match (is_quiet(), is_for_a_program()) {
                (true, _) => {}
                (false, true) => write_line(&json!({ "remark": remark.document(language()) })),
                (false, false) => complain(say!(note, remark = &note)),
            }
            printed.push(note);
        }
    }
}
