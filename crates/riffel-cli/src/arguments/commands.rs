//! The commands of the program: its questions, and what no question is.

use clap::error::ErrorKind;
use clap::{ArgMatches, FromArgMatches, Subcommand};
use riffel_answers::{QUESTIONS, question};

use super::question::{AskedQuestion, command};
use super::*;

/// All commands, in the order of the help.
const ORDER: [&str; 31] = [
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
    Question(AskedQuestion),
    /// Another command.
    Other(Box<Command>),
}

impl Subcommand for Commands {
    fn augment_subcommands(program: clap::Command) -> clap::Command {
        let others = Command::augment_subcommands(clap::Command::new("riffel"));
        let of = |(place, name): (usize, &&str)| {
            let command = match question::named(name) {
                Some(question) => command(question),
                None => with_questions_below(others.find_subcommand(name)?.clone()),
            };
            Some(command.display_order(place))
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

/// A command with the questions that stand below it, before its other commands.
fn with_questions_below(program: clap::Command) -> clap::Command {
    let prefix = format!("{} ", program.get_name());
    let below = QUESTIONS.iter().filter(|question| question.name().starts_with(&prefix));
    let below = below.enumerate().map(|(place, question)| command(*question).display_order(place));
    below.fold(program.mut_subcommands(|other| other.display_order(QUESTIONS.len())), clap::Command::subcommand)
}

impl FromArgMatches for Commands {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let (name, below) = matches.subcommand().ok_or_else(|| clap::Error::new(ErrorKind::MissingSubcommand))?;
        let (full, own) = match below.subcommand() {
            Some((inner, own)) => (format!("{name} {inner}"), own),
            None => (name.to_owned(), below),
        };
        match question::named(&full) {
            Some(question) => Ok(Self::Question(AskedQuestion::of(question, own))),
            None => Command::from_arg_matches(matches).map(|command| Self::Other(Box::new(command))),
        }
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// A command that is no question, or not yet one that is data.
#[derive(Subcommand)]
pub(crate) enum Command {
    /// Write a commented case file to start from, a traffic file or the plan of a study.
    Init(Init),
    /// A wheel along a rail in time: large amplitudes, loss of contact.
    Simulate(Simulate),
    /// Many lines and dates: surveys into a store, worst places, growth between dates, a plan of grinding.
    Network(Network),
    /// Many cases of one kind: grids, samples of distributions, what matters and how sure it is.
    Study(Study),
    /// What measurements say of the uncertain values of a case.
    Calibrate(Calibrate),
    /// Which action pays, over the posterior of a calibration, and what to measure first.
    Decide(Decide),
    /// Figures 2-8 of Afferrante & Ciavarella (2009), each with its numbers.
    Figures(Figures),
    /// The page: the whole model in a browser on this machine.
    Serve(Serve),
    /// The page as one file, with a case inside: it opens without server and network.
    Page(Page),
    /// List the presets, or show one with the sources of its values.
    Presets(Presets),
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
