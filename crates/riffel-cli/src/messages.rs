//! What is said on standard error beside the results: messages and notes, as much as was asked for.

use std::ffi::OsStr;
use std::fmt::{self, Display};
use std::io::{self, IsTerminal, Write};

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

/// How a run speaks.
#[derive(Clone, Copy)]
pub(crate) struct Voice {
    pub(crate) verbosity: Verbosity,
    pub(crate) language: Language,
    pub(crate) reader: Reader,
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

impl Voice {
    /// True if nothing but errors is to be said.
    pub(crate) fn is_quiet(self) -> bool {
        self.verbosity == Verbosity::Quiet
    }

    /// A line on standard error, unless `--quiet` was given.
    pub(crate) fn say(self, message: impl Into<Message>) {
        if !self.is_quiet() {
            self.complain(message);
        }
    }

    /// A line on standard error, said also with `--quiet`. Where that is closed or full there is nobody left to tell. Control
    /// characters of a file or a command line are written out.
    pub(crate) fn complain(self, message: impl Into<Message>) {
        let message = message.into();
        if self.is_for_a_program() {
            return write_line(&json!({ "remark": message.document(self.language) }));
        }
        let words = message.text(self.language);
        let _ = writeln!(io::stderr().lock(), "{}", in_a_message(&words));
    }

    /// What ends the run, with the place in the file; in colours on a terminal, so that only its words are written out. As
    /// JSON where another program asks for it.
    pub(crate) fn complain_of(self, report: Report) {
        if self.is_for_a_program() {
            let (message, help) = words_of(&report);
            return self.write_document(&message, help.as_ref());
        }
        let shown = format!("{:?}", Report::new(Shown { report, language: self.language }));
        // A word of the same length, for what follows is set below it.
        let shown = shown.replace("  help: ", &format!("  {}: ", say!(help_in_four_letters).text(self.language)));
        let _ = writeln!(io::stderr().lock(), "{shown}");
    }

    /// What is wrong with the command line. In colours on a terminal, unless the command line has control characters
    /// itself, as they could not be told apart.
    pub(crate) fn complain_of_usage<'a>(self, usage: &clap::Error, mut arguments: impl Iterator<Item = &'a OsStr>) {
        if arguments.all(|argument| is_shown_as_it_is(&argument.to_string_lossy())) {
            let _ = usage.print();
        } else {
            self.complain(usage.render().to_string().trim_end());
        }
    }

    /// True if another program reads what ends the run.
    pub(crate) fn is_for_a_program(self) -> bool {
        matches!(self.reader, Reader::Program { .. })
    }

    /// True if the messages of answers and errors are told as data.
    pub(crate) fn tells_messages_as_data(self) -> bool {
        self.reader == Reader::Program { messages: true }
    }

    /// How far the work is, for a program that reads it; whether one does.
    pub(crate) fn tell_progress(self, done: u64, of: u64) -> bool {
        let is_for_a_program = self.is_for_a_program();
        if is_for_a_program {
            write_line(&json!({ "progress": { "done": done, "of": of } }));
        }
        is_for_a_program
    }

    /// A remark, once it is known to be new, in full with `--verbose`.
    pub(crate) fn note(self, remark: &Message, note: &str) {
        match (self.is_quiet(), self.is_for_a_program()) {
            (true, _) => {}
            (false, true) => write_line(&json!({ "remark": remark.document(self.language) })),
            (false, false) => self.complain(say!(note, remark = note)),
        }
    }

    /// An error as one line of JSON.
    fn write_document(self, message: &Message, help: Option<&Message>) {
        let told = |message: &Message| match self.tells_messages_as_data() {
            true => as_data(|| json!(message)),
            false => json!(in_a_message(&message.to_string())),
        };
        write_line(&json!({ "error": { "message": told(message), "help": help.map(told) } }));
    }
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

fn is_shown_as_it_is(text: &str) -> bool {
    in_a_message(text) == text
}

/// An error whose words hold no control characters but line feeds.
#[derive(Debug)]
struct Shown {
    report: Report,
    language: Language,
}

impl Display for Shown {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (message, _) = words_of(&self.report);
        formatter.write_str(&in_a_message(&message.text(self.language)))
    }
}

impl std::error::Error for Shown {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.report.source()
    }
}

impl Diagnostic for Shown {
    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        let (_, help) = words_of(&self.report);
        let help = help?.text(self.language);
        Some(Box::new(in_a_message(&help).into_owned()))
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        self.report.labels()
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.report.source_code()
    }
}
