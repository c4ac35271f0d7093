//! Developer commands: `cargo xtask help` names them.

mod browser;
mod dependencies;
mod environment;
mod fuzz;
mod python;
mod release;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::{Parser, Subcommand};

/// Developer commands of Riffel.
#[derive(Parser)]
#[command(name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    command: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Everything there is: formatting, lints, tests, documentation, the Python package, the page in a
    /// browser.
    Test,
    /// The page alone, in a real browser: Debian's Chromium, driven by pytest.
    Browser,
    /// The Python package alone: wheel, tests, types.
    Python,
    /// Write the generated files of the book. A test of the program says whether they are current.
    Generate,
    /// Dependencies alone: licences, versions and sources against `deny.toml`.
    Dependencies,
    /// What a release consists of, for this system: archive of the program, wheel, source distribution.
    Release,
    /// Benchmarks beside their peers; needs Python 3 with venv, and network for the first run.
    Bench,
    /// Mutated files for the readers of foreign bytes and for the built program, as `fuzz/README.md` tells.
    Fuzz(fuzz::Fuzz),
}

/// A failure as a sentence.
type Outcome = Result<(), String>;

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Task::Test => test(),
        Task::Browser => browser::test_alone(),
        Task::Python => python::test_alone(),
        Task::Generate => generate(),
        Task::Dependencies => dependencies::check(),
        Task::Release => release::build(),
        Task::Fuzz(arguments) => fuzz::run(&arguments),
        Task::Bench => cargo(&["run", "--release", "--package", "riffel-bench"]),
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
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn test() -> Outcome {
    cargo(&["fmt", "--all", "--check"])?;
    dependencies::check()?;
    cargo(&[
        "clippy",
        "--workspace",
        "--all-targets",
        "--quiet",
        "--",
        "--deny",
        "warnings",
    ])?;
    cargo(&["test", "--workspace", "--quiet"])?;
    cargo_with(
        &["doc", "--workspace", "--no-deps", "--quiet"],
        &[("RUSTDOCFLAGS", "--deny warnings")],
    )?;
    python::test()?;
    browser::test()
}

/// Write the book with the program as it is now.
fn generate() -> Outcome {
    cargo(&["build", "--quiet"])?;
    let program = root().join("target/debug/riffel");
    let program = program.to_string_lossy();
    cargo(&["run", "--quiet", "--package", "riffel-book", "--", &program])
}

fn cargo(arguments: &[&str]) -> Outcome {
    cargo_with(arguments, &[])
}

pub(crate) fn cargo_with(arguments: &[&str], environment: &[(&str, &str)]) -> Outcome {
    let line = format!("cargo {}", arguments.join(" "));
    println!("# {line}");
    let status = Command::new(env!("CARGO"))
        .args(arguments)
        .envs(environment.iter().copied())
        .current_dir(root())
        .status()
        .map_err(|error| format!("cannot run {line}: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{line} failed"))
    }
}

/// What a program prints.
pub(crate) fn output(program: &Path, arguments: &[&str]) -> Result<Vec<u8>, String> {
    let line = format!("{} {}", program.display(), arguments.join(" "));
    let output = Command::new(program)
        .args(arguments)
        .current_dir(root())
        .output();
    let output = output.map_err(|error| format!("cannot run {line}: {error}"))?;
    match output.status.success() {
        true => Ok(output.stdout),
        false => Err(format!(
            "{line} failed: {}",
            String::from_utf8_lossy(&output.stderr)
        )),
    }
}
