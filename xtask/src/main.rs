//! Developer commands: `cargo xtask help` names them.

mod bench;
mod browser;
mod budget;
mod check;
mod compiler;
mod dependencies;
mod environment;
mod golden;
mod page;
mod python;
mod release;
mod step;
mod times;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::{Parser, Subcommand};

use crate::step::{linting_cargo, run};

/// Developer commands of Riffel.
#[derive(Parser)]
#[command(name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    command: Task,
}

#[derive(Subcommand)]
enum Task {
    /// The whole check: formatting, lints, tests, the Python package, the page in a browser.
    Test {
        /// Only what takes a minute: formatting, lints, the tests of the libraries but for those with a reason to take
        /// long. Left out are the program and its files, pictures, the page under load, examples in documentation, Python
        /// and the browser.
        #[arg(long, conflicts_with_all = ["thorough", "times"])]
        quick: bool,
        /// What has jobs of its own too: documentation, tests that take minutes, the page in one file and in other colours, sizes and
        /// languages.
        #[arg(long, conflicts_with = "times")]
        thorough: bool,
        /// One step after another, and write to `benches/check.md` what each takes and which tests take longest.
        #[arg(long)]
        times: bool,
    },
    /// The documentation of the library alone.
    Documentation,
    /// The tests that take minutes alone.
    Long,
    /// The page alone, in a real browser: Debian's Chromium, driven by pytest. All there is, also in other colours, sizes and
    /// languages and in one file.
    Browser,
    /// The answers of the page as a WebAssembly module: a program that is built after it holds them, for `riffel page`.
    Page,
    /// The Python package alone: wheel, tests, types.
    Python,
    /// Write the generated files of the book. A test of the program says whether they are current.
    Generate,
    /// All that the program prints and writes in its tests and the book, in a new folder: two of them, from before and after a change,
    /// are compared by `diff --recursive`.
    Golden {
        /// The folder.
        records: PathBuf,
    },
    /// Dependencies alone: licences, versions and sources against `deny.toml`.
    Dependencies,
    /// What a release consists of, for this system: archive of the program, wheel, source distribution.
    Release,
    /// Benchmarks beside their peers; needs Python 3 with venv, and network for the first run.
    Bench {
        /// Only the time of a release build into an empty folder.
        #[arg(long)]
        build: bool,
    },
}

/// A failure as a sentence.
type Outcome = Result<(), String>;

fn main() -> ExitCode {
    if let Some(recorded) = golden::record() {
        return recorded;
    }
    let outcome = match Arguments::parse().command {
        Task::Test { quick: true, .. } => check::quick(),
        Task::Test { thorough: true, .. } => check::thorough(),
        Task::Test { times: true, .. } => check::timed(),
        Task::Test { .. } => check::all(),
        Task::Documentation => check::documentation(),
        Task::Long => check::long(),
        Task::Browser => browser::test_alone(),
        Task::Page => page::install(),
        Task::Python => python::test_alone(),
        Task::Generate => generate(),
        Task::Golden { records } => golden::capture(&records),
        Task::Dependencies => dependencies::check(),
        Task::Release => release::build(),
        Task::Bench { build } => bench::write(build),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("cargo xtask: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The root of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Build the program as the tests have it, all of its dependencies too.
fn build_program() -> Outcome {
    let packages = ["--package", "riffel-cli", "--package", "riffel-python"];
    let features = ["--features", "riffel-python/as-tested"];
    run(linting_cargo(&["build", "--quiet"]).args(packages).args(features))
}

/// Write the book with the program as it is now.
fn generate() -> Outcome {
    build_program()?;
    let program = root().join("target/debug/riffel");
    let program = program.to_string_lossy();
    run(&mut linting_cargo(&["run", "--quiet", "--package", "riffel-book", "--", &program]))
}

/// What a program prints.
pub(crate) fn output(program: &Path, arguments: &[&str]) -> Result<Vec<u8>, String> {
    let line = format!("{} {}", program.display(), arguments.join(" "));
    let output = Command::new(program).args(arguments).current_dir(root()).output();
    let output = output.map_err(|error| format!("cannot run {line}: {error}"))?;
    match output.status.success() {
        true => Ok(output.stdout),
        false => Err(format!("{line} failed: {}", String::from_utf8_lossy(&output.stderr))),
    }
}

#[cfg(test)]
mod doc_lines;
