//! The Python package: a virtual environment, the wheel in it, its tests and types.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{Outcome, root};

/// Oldest Python for which the pinned requirements of the tests are made; the package itself asks for 3.10.
const OLDEST: &str = "3.11";

/// What the tests need, with exact versions.
const REQUIREMENTS: &str = "crates/riffel-python/requirements.txt";

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
    prepare(&environment)?;
    let python = python_of(&environment);
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

/// A virtual environment with the requirements, as they are now.
fn prepare(environment: &Path) -> Outcome {
    let wanted = fs::read_to_string(root().join(REQUIREMENTS))
        .map_err(|error| format!("cannot read {REQUIREMENTS}: {error}"))?;
    let installed = environment.join("requirements.installed");
    if fs::read_to_string(&installed).is_ok_and(|present| present == wanted) {
        return Ok(());
    }
    let python = interpreter()?;
    let folder = environment.to_string_lossy();
    run(python, &["-m", "venv", "--clear", &folder]).map_err(|_| {
        format!("{python} has no module venv; install it (Debian: apt install python3-venv)")
    })?;
    let own = python_of(environment);
    let pip = [
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ];
    run(
        &own.to_string_lossy(),
        &[&pip[..], &["--requirement", REQUIREMENTS]].concat(),
    )?;
    fs::write(&installed, wanted)
        .map_err(|error| format!("cannot write {}: {error}", installed.display()))
}

/// A Python that is new enough.
fn interpreter() -> Result<&'static str, String> {
    let check = format!(
        "import sys; sys.exit(sys.version_info < ({},))",
        OLDEST.replace('.', ", ")
    );
    let new_enough = |name: &&&str| {
        let outcome = Command::new(name).args(["-c", &check]).output();
        outcome.is_ok_and(|outcome| outcome.status.success())
    };
    let names = ["python3", "python"];
    names.iter().find(new_enough).copied().ok_or_else(|| {
        format!(
            "the tests of the Python package need Python {OLDEST} or newer with venv, and there is no such python3 on \
             the path"
        )
    })
}

/// The interpreter of a virtual environment.
fn python_of(environment: &Path) -> PathBuf {
    environment.join(match cfg!(windows) {
        true => "Scripts/python.exe",
        false => "bin/python",
    })
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

fn run(program: &str, arguments: &[&str]) -> Outcome {
    let line = format!("{program} {}", arguments.join(" "));
    println!("# {line}");
    let status = Command::new(program)
        .args(arguments)
        .current_dir(root())
        // Packages of the user stay out of it.
        .env_remove("PYTHONPATH")
        .env("MPLBACKEND", "Agg")
        .status()
        .map_err(|error| format!("cannot run {line}: {error}"))?;
    match status.success() {
        true => Ok(()),
        false => Err(format!("{line} failed")),
    }
}
