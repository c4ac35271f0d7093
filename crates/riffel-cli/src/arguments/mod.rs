//! The command line.

mod commands;
mod figures;
mod page;
mod question;

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser};
use riffel_answers::paper::Model;
use riffel_keys::Language;

use crate::messages::{Reader, Verbosity, Voice};

pub(crate) use commands::{Command, Commands};
pub(crate) use figures::{Figures, ModelArgument};
pub(crate) use page::Page;
pub(crate) use question::QuestionCall;

/// Place in the help of the first option that every command has: below its own, above `--help`, which clap puts at 999.
const BELOW_OWN: usize = 900;

/// Predicts rail corrugation: which wavelengths grow on a track under traffic, how fast, and why.
#[derive(Parser)]
#[command(
    name = "riffel",
    version = env!("RIFFEL_VERSION"),
    after_help = "Example: riffel init case.toml && riffel map case.toml\n\n\
        Exit status: 0 done, 1 a validation check failed or a study to merge or analyse is not whole, 2 bad input or a file that \
        cannot be written, 130 stopped by Ctrl-C."
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Commands,

    /// Print results and errors only: no notes, no progress.
    #[arg(short, long, global = true, conflicts_with = "verbose", display_order = BELOW_OWN)]
    quiet: bool,

    /// Print notes in full.
    #[arg(short, long, global = true, display_order = BELOW_OWN + 1)]
    verbose: bool,

    /// Language of reports, findings, notes and errors of a case, en, de or fr; help, data, JSON and most heads are English.
    #[arg(long, global = true, display_order = BELOW_OWN + 2, value_name = "LANGUAGE", default_value = "en", hide_possible_values = true,
          value_parser = languages())]
    language: Language,
}

/// The languages by their codes.
fn languages() -> impl TypedValueParser<Value = Language> {
    let codes = PossibleValuesParser::new(Language::ALL.iter().map(|language| language.code()));
    codes.map(|code| Language::of_code(&code).unwrap_or_default())
}

impl Arguments {
    /// What `riffel ask` was given, if it is that.
    pub(crate) fn ask(&self) -> Option<&Ask> {
        match &self.command {
            Commands::Other(Command::Ask(ask)) => Some(ask),
            _ => None,
        }
    }

    /// How the run speaks to a reader.
    pub(crate) fn voice(&self, reader: Reader) -> Voice {
        let verbosity = match (self.quiet, self.verbose) {
            (true, _) => Verbosity::Quiet,
            (false, true) => Verbosity::Verbose,
            (false, false) => Verbosity::Normal,
        };
        Voice { verbosity, language: self.language, reader }
    }
}

#[derive(Args)]
#[command(after_help = "Example: riffel init --metro && riffel map metro.toml")]
pub(crate) struct Init {
    /// File to write [default: case.toml, or one named after what it holds, as metro.toml].
    #[arg(value_name = "FILE")]
    pub(crate) path: Option<PathBuf>,

    /// Write the case of a metro on a slab with direct fastenings.
    #[arg(long, group = "kind")]
    pub(crate) metro: bool,

    /// Write the case of a passenger train on a ballasted main line.
    #[arg(long, group = "kind")]
    pub(crate) main_line: bool,

    /// Write the case of a tram on a slab with direct fastenings.
    #[arg(long, group = "kind")]
    pub(crate) tram: bool,

    /// Write the case of laden freight wagons on a ballasted line.
    #[arg(long, group = "kind")]
    pub(crate) freight: bool,

    /// Write a traffic file for `riffel forecast`.
    #[arg(long, group = "kind")]
    pub(crate) traffic: bool,

    /// Write the plan of a study, on a case nominal.toml beside it.
    #[arg(long, group = "kind")]
    pub(crate) study: bool,

    /// Replace the file if it is there.
    #[arg(long)]
    pub(crate) force: bool,
}

#[derive(Args)]
#[command(after_help = "Example: riffel schema --traffic > traffic.schema.json")]
pub(crate) struct Schema {
    /// That of the traffic file.
    #[arg(long, conflicts_with = "study")]
    pub(crate) traffic: bool,

    /// That of the plan of a study.
    #[arg(long)]
    pub(crate) study: bool,

    /// That of a question which `riffel ask` answers: a command of the program.
    #[arg(long, value_name = "NAME", num_args = 1..=2, conflicts_with_all = ["traffic", "study"])]
    pub(crate) question: Vec<String>,
}

#[derive(Args)]
#[command(
    after_help = "Example: echo '{\"case\": \"case.toml\", \"wavelength\": \"56 mm\", \"speed\": 30}' | riffel ask point\n\n\
        The keys are the options of the command without dashes, with _ between words; a case, a traffic or a table of \
        columns may stand in place of its file. The answer is that of --json; notes and errors are lines of JSON on \
        standard error."
)]
pub(crate) struct Ask {
    /// The command, such as noise or network worst.
    #[arg(value_name = "NAME", required = true, num_args = 1..=2)]
    pub(crate) name: Vec<String>,

    /// Write each message of the answer or the error as an object of its id and its values, in place of its English.
    #[arg(long)]
    pub(crate) messages: bool,

    /// Answer a page of the process with this number: read no files outside this folder, and end with that process.
    #[arg(long, value_name = "PROCESS", hide = true)]
    pub(crate) page: Option<u32>,
}

#[derive(Args)]
#[command(after_help = "Examples: riffel validate hertz wheelset; riffel validate --field --json")]
pub(crate) struct Validate {
    /// Only the checks with one of these words in their names, which are those of the tests.
    #[arg(value_name = "WORD", conflicts_with = "field")]
    pub(crate) words: Vec<String>,

    /// Predict sites whose corrugation is published, and hold the predictions against what was measured.
    #[arg(long)]
    pub(crate) field: bool,

    /// Print a JSON document of the sites.
    #[arg(long, requires = "field")]
    pub(crate) json: bool,

    /// Samples of the choices of each site, 1 to 100000.
    #[arg(long, value_name = "N", requires = "field", default_value_t = 16,
          value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub(crate) samples: u32,

    /// Seed of the samples.
    #[arg(long, value_name = "S", requires = "field", default_value_t = 1)]
    pub(crate) seed: u64,
}

impl From<ModelArgument> for Model {
    fn from(argument: ModelArgument) -> Self {
        match argument {
            ModelArgument::QuasiStatic => Self::QuasiStatic,
            ModelArgument::SpringDashpot => Self::SpringDashpot,
            ModelArgument::NonSteady => Self::NonSteady,
        }
    }
}

#[derive(Args)]
#[command(after_help = "Example: riffel serve --open")]
pub(crate) struct Serve {
    /// Port to listen on; 0 takes any that is free.
    #[arg(long, value_name = "N", default_value_t = 8311)]
    pub(crate) port: u16,

    /// Show the page in the browser.
    #[arg(long)]
    pub(crate) open: bool,

    /// Address to listen on. Any but 127.0.0.1 lets other machines use this one: there is no password.
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    pub(crate) address: std::net::IpAddr,
}

#[derive(Args)]
#[command(after_help = "Examples:\n  \
        riffel completions bash > ~/.local/share/bash-completion/completions/riffel\n  \
        riffel completions zsh > ~/.zfunc/_riffel\n  \
        riffel completions fish > ~/.config/fish/completions/riffel.fish")]
pub(crate) struct Completions {
    /// The shell.
    #[arg(value_name = "SHELL")]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Args)]
#[command(after_help = "Example: riffel man -o ~/.local/share/man/man1 && man riffel-map")]
pub(crate) struct ManPages {
    /// Folder for the pages of all commands, made if need be [default: the first page, on standard output].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}
