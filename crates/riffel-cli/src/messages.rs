//! What is said on standard error beside the results: messages and notes, as much as was asked for.

use std::ffi::OsStr;
use std::fmt::{self, Display};
use std::io::{self, IsTerminal, Write};
use std::iter;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use miette::{Diagnostic, LabeledSpan, MietteHandlerOpts, Report, SourceCode};
use riffel_answers::AnswerError;
use riffel_keys::message::translations;
use riffel_keys::text_file::in_a_message;
use riffel_keys::{CaseError, Language, Message};
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

/// True if this run speaks German.
static GERMAN: AtomicBool = AtomicBool::new(false);

/// Who reads what a run says beside its results.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reader {
    /// A person, in words.
    Person,
    /// Another program, in lines of JSON.
    Program {
        /// With the German of answers and errors beside them.
        translations: bool,
    },
}

/// True if this run speaks to a program.
static TO_A_PROGRAM: AtomicBool = AtomicBool::new(false);

/// True if the German of answers and errors stands beside them.
static WITH_TRANSLATIONS: AtomicBool = AtomicBool::new(false);

/// Begin a run that says as much, in a language, to somebody.
pub(crate) fn begin(verbosity: Verbosity, language: Language, reader: Reader) {
    VERBOSITY.store(verbosity as u8, Ordering::Relaxed);
    let (to_a_program, with_translations) = match reader {
        Reader::Person => (false, false),
        Reader::Program { translations } => (true, translations),
    };
    TO_A_PROGRAM.store(to_a_program, Ordering::Relaxed);
    WITH_TRANSLATIONS.store(with_translations, Ordering::Relaxed);
    GERMAN.store(language == Language::German, Ordering::Relaxed);
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
    match GERMAN.load(Ordering::Relaxed) {
        true => Language::German,
        false => Language::English,
    }
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
    let shown = match language() {
        Language::English => shown,
        // A word of the same length, for what follows is set below it.
        Language::German => shown.replace("  help: ", "  Tipp: "),
    };
    let _ = writeln!(io::stderr().lock(), "{shown}");
}

/// True if another program reads what ends the run.
pub(crate) fn is_for_a_program() -> bool {
    TO_A_PROGRAM.load(Ordering::Relaxed)
}

/// True if the German of answers and errors stands beside them.
pub(crate) fn has_translations() -> bool {
    WITH_TRANSLATIONS.load(Ordering::Relaxed)
}

/// How far the work is, for a program that reads it; whether one does.
pub(crate) fn tell_progress(done: u64, of: u64) -> bool {
    let is_for_a_program = is_for_a_program();
    if is_for_a_program {
        write_line(&json!({ "progress": { "done": done, "of": of } }));
    }
    is_for_a_program
}

/// An error as one line of JSON, with the German of its sentences and their pieces, by their English, if that is wanted.
fn write_document(message: &Message, help: Option<&Message>) {
    let english = |message: &Message| in_a_message(&message.to_string()).into_owned();
    let mut error = json!({ "message": english(message), "help": help.map(english) });
    if has_translations() {
        let known = translations(iter::once(message).chain(help));
        error["german"] = json!(known.german);
        if !known.message_pieces.is_empty() {
            error["message_pieces"] = json!(known.message_pieces);
        }
    }
    write_line(&json!({ "error": error }));
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
    let word = match language() {
        Language::English => "note",
        Language::German => "Hinweis",
    };
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
                (false, false) => complain(format!("{word}: {note}")),
            }
            printed.push(note);
        }
    }
}
