//! `riffel`: predicts which rail corrugation grows, how fast, and why.

mod arguments;
mod bay;
mod command;
mod error;
mod observations;
mod output;
mod staging;

use std::process::ExitCode;

use clap::Parser;

use arguments::{Arguments, Command};

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    // The page ends its own work.
    if !matches!(arguments.command, Command::Serve(_)) {
        staging::clean_up_on_interrupt();
    }
    match run(arguments.command) {
        Ok(code) => code,
        Err(report) => {
            eprintln!("{report:?}");
            ExitCode::from(2)
        }
    }
}

fn run(command: Command) -> miette::Result<ExitCode> {
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
        Command::Serve(arguments) => command::serve::run(&arguments)?,
        Command::Study(arguments) => return command::study::run(&arguments),
        Command::Schema(arguments) => command::schema::run(&arguments),
        Command::Validate => return command::validate::run(),
    }
    Ok(ExitCode::SUCCESS)
}
