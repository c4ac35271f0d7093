//! Developer commands: `cargo xtask test`, `cargo xtask generate`, `cargo xtask bench`.

mod browser;
mod decay_rate;
mod environment;
mod generate;
mod marked;
mod place_of_wear;
mod presets;
mod python;

use std::path::PathBuf;
use std::process::{Command, ExitCode};

use clap::{Parser, Subcommand};
use riffel_plot::{DEFAULT_PNG_SCALE, LineFigure, png};

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
    /// browser, generated files.
    Test,
    /// The page alone, in a real browser: Debian's Chromium, driven by pytest.
    Browser,
    /// The Python package alone: wheel, tests, types.
    Python,
    /// Write the generated files of the book, or check that they are current.
    Generate {
        /// Change nothing; fail if a file is not current.
        #[arg(long)]
        check: bool,
    },
    /// Benchmarks beside their peers; needs Python 3 with venv, and network for the first run.
    Bench,
}

/// A failure as a sentence.
type Outcome = Result<(), String>;

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Task::Test => test(),
        Task::Browser => browser::test_alone(),
        Task::Python => python::test_alone(),
        Task::Generate { check } => generate::run(check),
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

/// Draw a picture of the book.
fn draw(path: &str, figure: &LineFigure) -> Outcome {
    let picture = figure.svg().and_then(|svg| png(&svg, DEFAULT_PNG_SCALE));
    let picture = picture.map_err(|error| format!("cannot draw {path}: {error}"))?;
    std::fs::write(root().join(path), picture)
        .map_err(|error| format!("cannot write {path}: {error}"))
}

fn test() -> Outcome {
    cargo(&["fmt", "--all", "--check"])?;
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
    browser::test()?;
    generate::run(true)
}

fn cargo(arguments: &[&str]) -> Outcome {
    cargo_with(arguments, &[])
}

fn cargo_with(arguments: &[&str], environment: &[(&str, &str)]) -> Outcome {
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
