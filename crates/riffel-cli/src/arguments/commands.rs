//! The commands of the program: its questions, and what no question is.

use clap::error::ErrorKind;
use clap::{ArgMatches, FromArgMatches, Subcommand};
use riffel_answers::{QUESTIONS, question};

use super::question::{QuestionCall, command};
use super::*;

/// All commands, in the order of the help.
const ORDER: &[&str] = &[
    "init",
    "point",
    "map",
    "receptance",
    "wheelset",
    "simulate",
    "contact",
    "profile",
    "curve",
    "roughness",
    "axlebox",
    "network",
    "diagnose",
    "report",
    "forecast",
    "compare",
    "noise",
    "shakedown",
    "stability",
    "study",
    "calibrate",
    "decide",
    "figures",
    "serve",
    "page",
    "presets",
    "ask",
    "schema",
    "completions",
    "man",
    "validate",
];

/// A command with its arguments.
pub(crate) enum Commands {
    /// A question that is data.
    Question(QuestionCall),
    /// Another command.
    Other(Command),
}

impl Subcommand for Commands {
    fn augment_subcommands(program: clap::Command) -> clap::Command {
        let others = Command::augment_subcommands(clap::Command::new("riffel")).subcommand(network());
        let of = |(place, name): (usize, &&str)| {
            let command = question::named(name).map(command).or_else(|| others.find_subcommand(name).cloned())?;
            Some(with_questions_below(command).display_order(place))
        };
        program
            .subcommand_required(true)
            .arg_required_else_help(true)
            .subcommands(ORDER.iter().enumerate().filter_map(of))
    }

    fn augment_subcommands_for_update(program: clap::Command) -> clap::Command {
        Self::augment_subcommands(program)
    }

    fn has_subcommand(name: &str) -> bool {
        ORDER.contains(&name)
    }
}

/// The command that has nothing but questions below it.
fn network() -> clap::Command {
    clap::Command::new("network")
        .about("Many lines and dates: surveys into a store, worst places, growth between dates, a plan of grinding")
        .after_help(
            "Example: riffel axlebox run.csv --case case.toml -o run && riffel network ingest railway run/blocks.csv \
             --line \"Main line\" --date 2026-01-31 && riffel network worst railway",
        )
        .subcommand_required(true)
        .arg_required_else_help(true)
}

/// A command with the questions that stand below it, which are asked in its place.
fn with_questions_below(program: clap::Command) -> clap::Command {
    let prefix = format!("{} ", program.get_name());
    let below = QUESTIONS.iter().filter(|question| question.name().starts_with(&prefix));
    let is_asked = question::named(program.get_name()).is_some();
    program
        .args_conflicts_with_subcommands(is_asked)
        .subcommand_negates_reqs(is_asked)
        .subcommands(below.map(|question| command(*question)))
}

impl FromArgMatches for Commands {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let (name, below) = matches.subcommand().ok_or_else(|| clap::Error::new(ErrorKind::MissingSubcommand))?;
        let (full, own) = match below.subcommand() {
            Some((inner, own)) => (format!("{name} {inner}"), own),
            None => (name.to_owned(), below),
        };
        match question::named(&full) {
            Some(question) => Ok(Self::Question(QuestionCall::of(question, own))),
            None => Command::from_arg_matches(matches).map(Self::Other),
        }
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// A command that is no question.
#[derive(Subcommand)]
pub(crate) enum Command {
    /// Write a commented case file to start from, a traffic file or the plan of a study.
    Init(Init),
    /// Figures 2-8 of Afferrante & Ciavarella (2009), each with its numbers.
    Figures(Figures),
    /// The page: the whole model in a browser on this machine.
    Serve(Serve),
    /// The page as one file, with a case inside: it opens without server and network.
    Page(Page),
    /// Answer a question in JSON on standard input: a command with its options as keys.
    Ask(Ask),
    /// Print the JSON schema of the case file, of the traffic file, of the plan of a study or of a question.
    Schema(Schema),
    /// Print completions of this command line for a shell.
    Completions(Completions),
    /// Print the manual page, or write those of all commands.
    Man(ManPages),
    /// Hold the program against reference numbers and published statements.
    Validate(Validate),
}
