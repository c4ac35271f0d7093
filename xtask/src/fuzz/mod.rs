//! Fuzzing: the readers of foreign bytes with mutations guided by coverage, the built program with blind ones.

mod corpus;
mod mutation;
mod program;
mod readers;

use clap::{Args, ValueEnum};

use crate::Outcome;

/// What is fuzzed, and for how long.
#[derive(Args)]
pub(crate) struct Fuzz {
    /// Seconds for each target.
    #[arg(long, default_value_t = 60)]
    seconds: u64,
    /// One target, by its name; all without.
    #[arg(long)]
    target: Option<Target>,
    /// Number that the mutations begin with.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// A reader of `fuzz/targets`, or the whole program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Target {
    /// Case files.
    Case,
    /// Profiles and tables of levels.
    Roughness,
    /// Measured receptances: tables and universal files.
    Receptance,
    /// Traffic files.
    Traffic,
    /// Plans of studies.
    Plan,
    /// The built program, with files and arguments.
    Program,
}

impl Target {
    fn name(self) -> &'static str {
        match self {
            Target::Case => "case",
            Target::Roughness => "roughness",
            Target::Receptance => "receptance",
            Target::Traffic => "traffic",
            Target::Plan => "plan",
            Target::Program => "program",
        }
    }
}

/// Fuzz the targets one after the other; a finding ends the run with an error that says where its input lies.
pub(crate) fn run(arguments: &Fuzz) -> Outcome {
    let chosen = |target: &Target| arguments.target.is_none_or(|only| only == *target);
    let targets: Vec<Target> = Target::value_variants()
        .iter()
        .copied()
        .filter(chosen)
        .collect();
    let readers: Vec<Target> = targets
        .iter()
        .copied()
        .filter(|&target| target != Target::Program)
        .collect();
    if !readers.is_empty() {
        readers::build(&readers)?;
    }
    for target in readers {
        readers::run(target, arguments.seconds, arguments.seed)?;
    }
    if targets.contains(&Target::Program) {
        program::run(arguments.seconds, arguments.seed)?;
    }
    Ok(())
}
