//! The Python package: a virtual environment, the wheel in it, its tests and types.

use std::fs;
use std::path::Path;

use crate::environment::{self, run};
use crate::{Outcome, root};

/// What the tests need, with exact versions.
pub(crate) const REQUIREMENTS: &str = "crates/riffel-python/requirements.txt";

/// [`test()`] with the program that it is held against.
pub(crate) fn test_alone() -> Outcome {
    crate::cargo(&["build", "--quiet"])?;
    test()
}

/// Build the wheel, install it under `target/python` and test it there against the program.
///
/// The environment is made once, and anew when the requirements change. The wheel is of the dev profile: its
/// numbers are those of the program of the same profile, and its dependencies stay in `target`.
pub(crate) fn test() -> Outcome {
    let environment = root().join("target/python");
    let python = environment::prepare(&environment, REQUIREMENTS)?;
    let python = python.to_string_lossy();
    let wheels = environment.join("wheels");
    // One wheel, whichever version was built before.
    let _ = fs::remove_dir_all(&wheels);
    let out = wheels.to_string_lossy();
    let build = [
        "-m",
        "maturin",
        "build",
        "--quiet",
        "--profile",
        "dev",
        "--interpreter",
        &python,
        "--out",
        &out,
    ];
    run(&python, &build)?;
    let wheel = wheel(&wheels)?;
    let install = ["-m", "pip", "install", "--quiet", "--no-index", "--no-deps"];
    run(
        &python,
        &[&install[..], &["--force-reinstall", &wheel]].concat(),
    )?;
    run(&python, &["-m", "pytest", "--quiet"])?;
    run(&python, &["-m", "mypy"])
}

/// The wheel that was built.
fn wheel(folder: &Path) -> Result<String, String> {
    let entries = fs::read_dir(folder)
        .map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|path| path.extension().is_some_and(|extension| extension == "whl"))
        .map(|path| path.to_string_lossy().into_owned())
        .ok_or_else(|| format!("maturin left no wheel in {}", folder.display()))
}
