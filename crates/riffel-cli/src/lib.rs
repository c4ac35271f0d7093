//! The program `riffel`: predicts which rail corrugation grows, how fast, and why.
//!
//! [`run`] is the whole of it. The executable is one caller, the Python package another.

mod arguments;
mod command;
mod error;
mod messages;
mod output;
mod progress;
mod question;
mod results;
mod staging;
mod terminal;
mod threads;

use std::any::TypeId;
use std::ffi::OsString;
use std::path::PathBuf;

use arguments::{Arguments, AskedQuestion, Command, Commands};
use clap::{ArgMatches, CommandFactory, FromArgMatches};
use error::CliError;
use messages::{Reader, Verbosity, complain_of, complain_of_usage};
use riffel_keys::Language;
use riffel_keys::text_file::is_standard_input;

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
    match parse(&words) {
        Ok((arguments, _)) if arguments.ask().is_some() => ask(arguments, program),
        parsed => run_parsed(parsed, &words, Reader::Person, program),
    }
}

/// Answer the question on standard input.
fn ask(arguments: Arguments, program: &[OsString]) -> u8 {
    let translations = arguments.ask().is_some_and(|ask| ask.translations);
    if let Some(process) = arguments.ask().and_then(|ask| ask.page) {
        riffel_keys::seal::seal();
        end_with(process);
    }
    let reader = Reader::Program { translations };
    messages::begin(arguments.verbosity(), arguments.language(), reader);
    match asked(arguments) {
        Ok((parsed, words)) => run_parsed(parsed, &words, reader, program),
        Err(error) => {
            complain_of(error.into());
            BAD_INPUT
        }
    }
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

/// A command line read, with the files that it names as inputs.
type Parsed = Result<(Arguments, Vec<PathBuf>), clap::Error>;

fn parse(words: &[OsString]) -> Parsed {
    let matches = with_numbers_below_zero(Arguments::command()).try_get_matches_from(words)?;
    Arguments::from_arg_matches(&matches).map(|arguments| (arguments, inputs(&matches)))
}

/// The command with every option of a number taking one below zero, which its range then refuses in a sentence.
fn with_numbers_below_zero(command: clap::Command) -> clap::Command {
    let names: Vec<String> = command.get_subcommands().map(|command| command.get_name().to_owned()).collect();
    let command = command.mut_args(|argument| {
        let parser = argument.get_value_parser();
        let is_text = [TypeId::of::<String>(), TypeId::of::<PathBuf>()].iter().any(|text| parser.type_id() == *text);
        let is_number = argument.get_action().takes_values() && !is_text;
        // What may stand alone takes no option behind it for its value.
        let is_alone = (argument.get_num_args()).is_some_and(|range| range.min_values() == 0);
        let is_free = !argument.is_positional() && parser.possible_values().is_none();
        match is_number && is_free && !is_alone {
            true => argument.allow_hyphen_values(true),
            false => argument,
        }
    });
    names.iter().fold(command, |command, name| command.mut_subcommand(name, with_numbers_below_zero))
}

/// The question on standard input, with its command line where it is not yet one that is data.
fn asked(arguments: Arguments) -> Result<(Parsed, Vec<OsString>), CliError> {
    let name = arguments.ask().map(|ask| ask.name.clone()).unwrap_or_default();
    let data = riffel_answers::question::named(&name.join(" "));
    let command = match data {
        None => Some(question::find(&Arguments::command(), &name)?),
        Some(_) => None,
    };
    let keys = riffel_keys::question::read();
    let keys = keys.map_err(|reason| CliError::ReadQuestion { reason })?;
    if let (Some(data), None) = (data, &command) {
        let question = AskedQuestion::of_json(data, keys)?;
        let inputs = question.inputs();
        return Ok((Ok((arguments.asking(question), inputs)), Vec::new()));
    }
    let options = arguments.options_of_all().map(OsString::from);
    let words = [OsString::from("riffel")].into_iter().chain(options);
    let words = match &command {
        Some(command) => words.chain(question::words(command, &name, &keys)?).collect(),
        None => Vec::new(),
    };
    Ok((parse(&words), words))
}

fn run_parsed(parsed: Parsed, words: &[OsString], reader: Reader, program: &[OsString]) -> u8 {
    let (arguments, inputs) = match parsed {
        Ok(parsed) => parsed,
        Err(usage) if usage.use_stderr() => {
            messages::begin(Verbosity::Normal, asked_language(words), reader);
            complain_of_usage(&usage, words.iter().map(OsString::as_os_str));
            return BAD_INPUT;
        }
        Err(help) => {
            return match output::unless_reader_left(help.print()) {
                Ok(()) => 0,
                Err(error) => {
                    complain_of(error.into());
                    BAD_INPUT
                }
            };
        }
    };
    messages::begin(arguments.verbosity(), arguments.language(), reader);
    if inputs.iter().filter(|path| is_standard_input(path)).count() > 1 {
        complain_of(CliError::StandardInput.into());
        return BAD_INPUT;
    }
    staging::set_inputs(inputs);
    // The page ends its own work.
    if !matches!(&arguments.command, Commands::Other(command) if matches!(**command, Command::Serve(_))) {
        staging::clean_up_on_interrupt();
    }
    match execute(arguments.command, program) {
        Ok(status) => status,
        Err(report) => {
            complain_of(report);
            BAD_INPUT
        }
    }
}

/// The language that a command line asks for which is wrong elsewhere.
fn asked_language(words: &[OsString]) -> Language {
    let words = words.iter().map(|word| word.to_string_lossy());
    match words.collect::<Vec<_>>().join(" ").replace('=', " ").contains("--language de") {
        true => Language::German,
        false => Language::English,
    }
}

fn execute(command: Commands, program: &[OsString]) -> miette::Result<u8> {
    let command = match command {
        Commands::Question(asked) => {
            command::question::run(&asked)?;
            return Ok(0);
        }
        Commands::Other(command) => *command,
    };
    match command {
        Command::Init(arguments) => command::init::run(&arguments)?,
        Command::Simulate(arguments) => return command::simulate::run(&arguments),
        Command::Network(arguments) => command::network::run(&arguments)?,
        Command::Figures(arguments) => command::figures::run(&arguments)?,
        Command::Presets(arguments) => command::presets::run(&arguments)?,
        Command::Serve(arguments) => command::serve::run(&arguments, program)?,
        Command::Page(arguments) => command::page::run(&arguments)?,
        Command::Study(arguments) => return command::study::run(&arguments),
        Command::Calibrate(arguments) => return command::calibrate::run(&arguments),
        Command::Decide(arguments) => command::decide::run(&arguments)?,
        Command::Completions(arguments) => command::completions::run(&arguments)?,
        Command::Man(arguments) => command::man::run(&arguments)?,
        Command::Schema(arguments) => command::schema::run(&arguments)?,
        // It has become another command.
        Command::Ask(_) => {}
        Command::Validate(arguments) => return command::validate::run(&arguments),
    }
    Ok(0)
}

/// What names where results go.
const RESULTS: [&str; 3] = ["output", "save_format", "into"];

/// The files that a command line names and that are not where results go: none of them may be replaced.
fn inputs(matches: &ArgMatches) -> Vec<PathBuf> {
    match matches.subcommand() {
        // Its only file is the one that it writes.
        Some(("init", _)) => Vec::new(),
        Some((_, below)) => inputs(below),
        None => matches
            .ids()
            .filter(|id| !RESULTS.contains(&id.as_str()))
            // Groups of arguments have no values of their own.
            .filter_map(|id| matches.try_get_raw(id.as_str()).ok().flatten())
            .flatten()
            .map(PathBuf::from)
            .filter(|path| path.is_file() || is_standard_input(path))
            .collect(),
    }
}
