//! The program `riffel`: predicts which rail corrugation grows, how fast, and why.
//!
//! [`run`] is the whole of it. The executable is one caller, the Python package another.

mod arguments;
mod command;
mod error;
mod interrupt;
mod messages;
mod output;
mod progress;
mod results;
mod scratch;
mod session;
mod staging;
mod terminal;

use std::ffi::OsString;

use arguments::{Arguments, Ask, Command, Commands, QuestionCall};
use clap::Parser;
use error::CliError;
use messages::{Reader, Verbosity, Voice};
use miette::Report;
use riffel_answers::question::{self, AnyQuestion};
use riffel_keys::Language;
use riffel_keys::text_file::is_standard_input;
use serde_json::{Map, Value};
use session::Session;

/// A question and its keys.
pub type KeyedQuestion = (&'static dyn AnyQuestion, Map<String, Value>);

/// Exit status after an error of the user.
const BAD_INPUT: u8 = 2;

/// Run the program and return its exit status: 0 done, 1 a check failed or a study is not whole, 2 bad input, 130
/// stopped by Ctrl-C, which ends the process.
///
/// `arguments` begin with the name of the program, as those of a process do. `program` is a command that runs it once
/// more, for work that `riffel serve` does in processes of their own.
pub fn run(arguments: impl IntoIterator<Item = OsString>, program: &[OsString]) -> u8 {
    messages::lay_out_errors();
    let words: Vec<OsString> = arguments.into_iter().collect();
    match Arguments::try_parse_from(&words) {
        Ok(arguments) => match arguments.ask() {
            Some(ask) => answer(ask, &arguments, program),
            None => {
                let session = Session::new(arguments.voice(Reader::Person));
                status(session.voice, execute(&session, arguments.command, program))
            }
        },
        Err(usage) if usage.use_stderr() => {
            let language = asked_language(&words);
            let voice = Voice { verbosity: Verbosity::Normal, language, reader: Reader::Person };
            voice.complain_of_usage(&usage, words.iter().map(OsString::as_os_str));
            BAD_INPUT
        }
        Err(help) => {
            let printed = output::unless_reader_left(help.print());
            let voice = Voice { verbosity: Verbosity::Normal, language: Language::default(), reader: Reader::Person };
            status(voice, printed.map(|()| 0).map_err(Report::from))
        }
    }
}

/// The question that a command line asks, with its keys as they were given; `None` where the command is no question.
///
/// # Errors
/// What is wrong with the command line.
pub fn question_of(arguments: impl IntoIterator<Item = OsString>) -> Result<Option<KeyedQuestion>, clap::Error> {
    Ok(match Arguments::try_parse_from(arguments)?.command {
        Commands::Question(call) => Some((call.question, call.keys)),
        Commands::Other(_) => None,
    })
}

/// The exit status of an outcome, of which an error is told.
fn status(voice: Voice, outcome: miette::Result<u8>) -> u8 {
    outcome.unwrap_or_else(|report| {
        voice.complain_of(report);
        BAD_INPUT
    })
}

/// Answer the question on standard input.
fn answer(ask: &Ask, arguments: &Arguments, program: &[OsString]) -> u8 {
    if let Some(process) = ask.page {
        riffel_keys::seal::seal();
        end_with(process);
    }
    let reader = Reader::Program { messages: ask.messages };
    let session = Session::new(arguments.voice(reader));
    let question = || {
        let question = question::known(&ask.name.join(" "))?;
        let keys = riffel_keys::question::read().map_err(|reason| CliError::ReadQuestion { reason })?;
        Ok(QuestionCall::of_json(question, keys)?)
    };
    status(session.voice, question().and_then(|call| execute(&session, Commands::Question(call), program)))
}

/// End this process soon after its parent has ended, whose number it was told: nobody waits for an answer any more.
#[cfg(unix)]
fn end_with(parent: u32) {
    std::thread::spawn(move || {
        while std::os::unix::process::parent_id() == parent {
            std::thread::sleep(std::time::Duration::from_millis(200));
        }
        std::process::exit(i32::from(BAD_INPUT));
    });
}

/// Windows does not tell who the parent is.
#[cfg(not(unix))]
fn end_with(_: u32) {}

/// The language that a command line asks for which is wrong elsewhere.
fn asked_language(words: &[OsString]) -> Language {
    let words = words.iter().map(|word| word.to_string_lossy());
    let line = words.collect::<Vec<_>>().join(" ").replace('=', " ");
    let asked = |language: &&Language| line.contains(&format!("--language {}", language.code()));
    Language::ALL.iter().find(asked).copied().unwrap_or_default()
}

fn execute(session: &Session, command: Commands, program: &[OsString]) -> miette::Result<u8> {
    let inputs = match &command {
        Commands::Question(call) => call.inputs(),
        Commands::Other(Command::Page(page)) => page.case.iter().cloned().collect(),
        Commands::Other(_) => Vec::new(),
    };
    if inputs.iter().filter(|path| is_standard_input(path)).count() > 1 {
        Err(CliError::StandardInput)?;
    }
    inputs.into_iter().for_each(|path| session.add_input(path));
    // The page ends its own work.
    if !matches!(command, Commands::Other(Command::Serve(_))) {
        session.interrupt.handle();
    }
    let command = match command {
        Commands::Question(call) => return command::question::run(session, &call),
        Commands::Other(command) => command,
    };
    match command {
        Command::Init(arguments) => command::init::run(session, &arguments)?,
        Command::Figures(arguments) => command::figures::run(session, &arguments)?,
        Command::Serve(arguments) => command::serve::run(session, &arguments, program)?,
        Command::Page(arguments) => command::page::run(session, &arguments)?,
        Command::Completions(arguments) => command::completions::run(&arguments)?,
        Command::Man(arguments) => command::man::run(session, &arguments)?,
        Command::Schema(arguments) => command::schema::run(session, &arguments)?,
        // It has become another command.
        Command::Ask(_) => {}
        Command::Validate(arguments) => return command::validate::run(session, &arguments),
    }
    Ok(0)
}
