//! The program `riffel`: predicts which rail corrugation grows, how fast, and why.
//!
//! [`run`] is the whole of it. The executable is one caller, the Python package another.

mod arguments;
mod bay;
mod command;
mod error;
mod observations;
mod output;
mod staging;

use std::ffi::OsString;

use clap::Parser;

use arguments::{Arguments, Command};

/// Exit status after an error of the user.
const BAD_INPUT: u8 = 2;

/// Run the program and return its exit status: 0 done, 1 a check failed or a study is not whole, 2 bad input, 130
/// stopped by Ctrl-C, which ends the process.
///
/// `arguments` begin with the name of the program, as those of a process do. `program` is a command that runs it once
/// more, for work that `riffel serve` does in processes of their own.
pub fn run(arguments: impl IntoIterator<Item = OsString>, program: &[OsString]) -> u8 {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(usage) => {
            // Help that nobody reads is no failure.
            let _ = usage.print();
            return u8::from(usage.use_stderr()) * BAD_INPUT;
        }
    };
    // The page ends its own work.
    if !matches!(arguments.command, Command::Serve(_)) {
        staging::clean_up_on_interrupt();
    }
    match execute(arguments.command, program) {
        Ok(status) => status,
        Err(report) => {
            eprintln!("{report:?}");
            BAD_INPUT
        }
    }
}

fn execute(command: Command, program: &[OsString]) -> miette::Result<u8> {
    match command {
        Command::Init(arguments) => command::init::run(&arguments)?,
        Command::Point(arguments) => command::point::run(&arguments)?,
        Command::Map(arguments) => command::map::run(&arguments)?,
        Command::Receptance(arguments) => command::receptance::run(&arguments)?,
        Command::Contact(arguments) => command::contact::run(&arguments)?,
        Command::Diagnose(arguments) => command::diagnose::run(&arguments)?,
        Command::Report(arguments) => command::report::run(&arguments)?,
        Command::Figures(arguments) => command::figures::run(&arguments)?,
        Command::Presets(arguments) => command::presets::run(&arguments)?,
        Command::Roughness(arguments) => command::roughness::run(&arguments)?,
        Command::Forecast(arguments) => command::forecast::run(&arguments)?,
        Command::Compare(arguments) => command::compare::run(&arguments)?,
        Command::Serve(arguments) => command::serve::run(&arguments, program)?,
        Command::Study(arguments) => return command::study::run(&arguments),
        Command::Schema(arguments) => command::schema::run(&arguments),
        Command::Validate => return command::validate::run(),
    }
    Ok(0)
}
