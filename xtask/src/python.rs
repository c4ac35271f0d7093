//! The Python package: a virtual environment, the wheel in it, its tests and types.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::step::run_beside;
use crate::times::printed;
use crate::{Outcome, compiler, environment, root};

/// What the tests need, with exact versions.
pub(crate) const REQUIREMENTS: &str = "crates/riffel-python/requirements.txt";

/// [`test()`] with the program that it is held against.
pub(crate) fn test_alone() -> Outcome {
    crate::build_program()?;
    test(&prepare()?)
}

/// The interpreter of `target/python`, which is made once, and anew when the requirements change.
pub(crate) fn prepare() -> Result<PathBuf, String> {
    environment::prepare(&folder(), REQUIREMENTS)
}

/// Build the wheel, install it under `target/python` and test it there against the program.
///
/// The wheel is of the dev profile and has the features of the tests: its numbers are those of the program of the
/// same profile, and its dependencies are theirs.
pub(crate) fn test(python: &Path) -> Outcome {
    install(python)?;
    run_beside(&mut tests(python))?;
    run_beside(&mut environment::command(python, &["-m", "mypy"]))
}

/// Install the package and run its tests, with the times of those that take long.
pub(crate) fn timed(python: &Path) -> Result<String, String> {
    install(python)?;
    printed(tests(python).args(["--durations=0", "--durations-min=1"]))
}

/// The tests of the installed package.
fn tests(python: &Path) -> Command {
    environment::command(python, &["-m", "pytest", "--quiet"])
}

/// Build the wheel and install it under `target/python`.
fn install(python: &Path) -> Outcome {
    let wheels = folder().join("wheels");
    // One wheel, whichever version was built before.
    let _ = fs::remove_dir_all(&wheels);
    let mut build = Command::new(python);
    build.args(["-m", "maturin", "build", "--quiet", "--profile", "dev"]);
    build.args(["--features", "as-tested", "--interpreter"]);
    run_beside(compiler::linting(build.arg(python).arg("--out").arg(&wheels)))?;
    let mut install = environment::command(python, &["-m", "pip", "install", "--quiet"]);
    install.args(["--no-index", "--no-deps", "--force-reinstall"]);
    run_beside(install.arg(wheel(&wheels)?))
}

fn folder() -> PathBuf {
    root().join("target/python")
}

/// The wheel that was built.
fn wheel(folder: &Path) -> Result<PathBuf, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|path| path.extension().is_some_and(|extension| extension == "whl"))
        .ok_or_else(|| format!("maturin left no wheel in {}", folder.display()))
}
