//! What is said on standard error beside the results: messages and notes, as much as was asked for.

use std::borrow::Cow;
use std::ffi::OsStr;
use std::fmt::{self, Display};
use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use miette::{Diagnostic, LabeledSpan, MietteHandlerOpts, Report, SourceCode};
use riffel_keys::text_file::in_a_message;
use riffel_keys::{Language, Message};
use riffel_words::in_german;
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
    Program,
}

/// True if this run speaks to a program.
static TO_A_PROGRAM: AtomicBool = AtomicBool::new(false);

/// Begin a run that says as much, in a language, to somebody.
pub(crate) fn begin(verbosity: Verbosity, language: Language, reader: Reader) {
    VERBOSITY.store(verbosity as u8, Ordering::Relaxed);
    TO_A_PROGRAM.store(reader == Reader::Program, Ordering::Relaxed);
    GERMAN.store(language == Language::German, Ordering::Relaxed);
    printed().clear();
}

/// Where errors go to a file or a pipe, lay them out for 80 columns: else the width would be that of whatever terminal
/// the other stream is on.
pub(crate) fn lay_out_errors() {
    const COLUMNS: usize = 80;
    if !io::stderr().is_terminal() {
        // Fails where it has been done: a Python process may run the program more than once.
        let _ = miette::set_hook(Box::new(|_| {
            Box::new(MietteHandlerOpts::new().width(COLUMNS).build())
        }));
    }
}

/// The language of this run.
pub(crate) fn language() -> Language {
    match GERMAN.load(Ordering::Relaxed) {
        true => Language::German,
        false => Language::English,
    }
}

/// Words in the language of this run; in English what the catalogue does not have.
pub(crate) fn in_language(words: &str) -> Cow<'_, str> {
    match language() {
        Language::English => Cow::Borrowed(words),
        Language::German => in_german(words).map_or(Cow::Borrowed(words), Cow::Owned),
    }
}

/// True if nothing but errors is to be said.
pub(crate) fn is_quiet() -> bool {
    VERBOSITY.load(Ordering::Relaxed) == Verbosity::Quiet as u8
}

/// A line on standard error in the language of the run, said also with `--quiet`. Where that is closed or full there is
/// nobody left to tell. Control characters of a file or a command line are written out.
pub(crate) fn complain(message: impl Display) {
    complain_as_written(&in_language(&message.to_string()));
}

fn complain_as_written(message: &str) {
    if is_for_a_program() {
        return write_line(&json!({ "remark": Message::verbatim(message).document(language()) }));
    }
    let _ = writeln!(io::stderr().lock(), "{}", in_a_message(message));
}

/// What ends the run, with the place in the file; in colours on a terminal, so that only its words are written out. As
/// JSON where another program asks for it.
pub(crate) fn complain_of(report: Report) {
    if is_for_a_program() {
        let help = report.help().map(|help| help.to_string());
        return write_document(&report.to_string(), help.as_deref());
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

/// How far the work is, for a program that reads it; whether one does.
pub(crate) fn tell_progress(done: u64, of: u64) -> bool {
    let is_for_a_program = is_for_a_program();
    if is_for_a_program {
        write_line(&json!({ "progress": { "done": done, "of": of } }));
    }
    is_for_a_program
}

/// An error as one line of JSON.
fn write_document(message: &str, help: Option<&str>) {
    let help = help.map(in_a_message);
    let error = json!({ "message": in_a_message(message), "help": help });
    write_line(&json!({ "error": error }));
}

/// A document on a line of standard error.
fn write_line(document: &Value) {
    let _ = writeln!(io::stderr().lock(), "{document}");
}

/// What is wrong with the command line. In colours on a terminal, unless the command line has control characters
/// itself, as they could not be told apart. As JSON where another program asks for it: the first paragraph is the
/// message.
pub(crate) fn complain_of_usage<'a>(
    usage: &clap::Error,
    mut arguments: impl Iterator<Item = &'a OsStr>,
) {
    if is_for_a_program() {
        let words = usage.render().to_string();
        let words = words.trim_end();
        let words = words.strip_prefix("error: ").unwrap_or(words);
        let (message, help) = match words.split_once("\n\n") {
            Some((message, help)) => (message, Some(help.trim_start())),
            None => (words, None),
        };
        return write_document(message, help);
    }
    let shown = arguments.all(|argument| is_shown_as_it_is(&argument.to_string_lossy()));
    if language() == Language::German {
        complain_as_written(&usage_in_german(&usage.render().to_string()));
    } else if shown {
        let _ = usage.print();
    } else {
        complain_as_written(usage.render().to_string().trim_end());
    }
}

/// What the reader of the command line says, line by line.
fn usage_in_german(usage: &str) -> String {
    const HEADS: [(&str, &str); 3] = [
        ("error: ", "Fehler: "),
        ("  tip: ", "  Tipp: "),
        ("Usage: ", "Aufruf: "),
    ];
    let lines = usage.trim_end().lines().map(|line| {
        let head = HEADS.iter().find(|(english, _)| line.starts_with(english));
        let (english, german) = head.unwrap_or(&("", ""));
        format!("{german}{}", in_language(&line[english.len()..]))
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn is_shown_as_it_is(text: &str) -> bool {
    in_a_message(text) == text
}

/// An error whose words hold no control characters but line feeds.
#[derive(Debug)]
struct Shown(Report);

impl Display for Shown {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = self.0.to_string();
        formatter.write_str(&in_a_message(&in_language(&words)))
    }
}

impl std::error::Error for Shown {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.0.source()
    }
}

impl Diagnostic for Shown {
    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        let help = self.0.help()?.to_string();
        let help = in_language(&help);
        Some(Box::new(in_a_message(&help).into_owned()))
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        // All others are keys.
        const HERE: &str = "here";
        let labels = self.0.labels()?;
        Some(Box::new(labels.map(|label| {
            let words = label.label().map(|words| match words {
                HERE => in_language(HERE).into_owned(),
                key => key.to_owned(),
            });
            LabeledSpan::new_with_span(words, *label.inner())
        })))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.0.source_code()
    }
}

/// A line on standard error, unless `--quiet` was given.
pub(crate) fn say(message: impl Display) {
    if !is_quiet() {
        complain(message);
    }
}

/// What the reader of the results should know, in a line and in full.
pub(crate) trait Note {
    fn in_a_line(&self) -> Cow<'_, str>;
    fn in_full(&self) -> Cow<'_, str>;
    /// For a program.
    fn document(&self) -> Value;
}

impl Note for Message {
    fn in_a_line(&self) -> Cow<'_, str> {
        match self.id() {
            "verbatim" => self.in_full(),
            _ => self.short(language()).into(),
        }
    }

    fn in_full(&self) -> Cow<'_, str> {
        let words = self.text(language());
        match self.id() {
            "verbatim" => in_language(&words).into_owned().into(),
            _ => words.into(),
        }
    }

    fn document(&self) -> Value {
        self.document(language())
    }
}

impl Note for String {
    fn in_a_line(&self) -> Cow<'_, str> {
        in_language(self)
    }

    fn in_full(&self) -> Cow<'_, str> {
        in_language(self)
    }

    fn document(&self) -> Value {
        Message::verbatim(self).document(language())
    }
}

/// Notes on the validity of the models and on what was read: each once in a run, in full with `--verbose`.
pub(crate) fn print_remarks(remarks: &[impl Note]) {
    let is_verbose = VERBOSITY.load(Ordering::Relaxed) == Verbosity::Verbose as u8;
    let mut printed = printed();
    for remark in remarks {
        let note = match is_verbose {
            true => remark.in_full(),
            false => remark.in_a_line(),
        };
        if !printed.iter().any(|earlier| *earlier == note) {
            let word = match language() {
                Language::English => "note",
                Language::German => "Hinweis",
            };
            match (is_quiet(), is_for_a_program()) {
                (true, _) => {}
                (false, true) => write_line(&json!({ "remark": remark.document() })),
                (false, false) => complain_as_written(&format!("{word}: {note}")),
            }
            printed.push(note.into_owned());
        }
    }
}
