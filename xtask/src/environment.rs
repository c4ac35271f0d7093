//! Virtual environments of Python with pinned requirements.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{Outcome, root};

/// Oldest Python for which the pinned requirements of the tests are made; the package asks for 3.10.
const OLDEST: &str = "3.11";

/// The interpreter of a virtual environment with the requirements of a file as they are now. It is made once,
/// and anew when they change.
pub(crate) fn prepare(environment: &Path, requirements: &str) -> Result<PathBuf, String> {
    let wanted = fs::read_to_string(root().join(requirements))
        .map_err(|error| format!("cannot read {requirements}: {error}"))?;
    let installed = environment.join("requirements.installed");
    let own = python_of(environment);
    if fs::read_to_string(&installed).is_ok_and(|present| present == wanted) {
        return Ok(own);
    }
    let python = interpreter()?;
    let folder = environment.to_string_lossy();
    run(python, &["-m", "venv", "--clear", &folder]).map_err(|_| {
        format!("{python} has no module venv; install it (Debian: apt install python3-venv)")
    })?;
    let pip = [
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ];
    run(
        &own.to_string_lossy(),
        &[&pip[..], &["--requirement", requirements]].concat(),
    )?;
    fs::write(&installed, wanted)
        .map_err(|error| format!("cannot write {}: {error}", installed.display()))?;
    Ok(own)
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
            "the tests need Python {OLDEST} or newer with venv, and there is no such python3 on \
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

/// Run a program of the environment in the root of the workspace.
pub(crate) fn run(program: &str, arguments: &[&str]) -> Outcome {
    run_with(program, arguments, &[])
}

/// [`run`] with variables of the environment.
pub(crate) fn run_with(program: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Outcome {
    let line = format!("{program} {}", arguments.join(" "));
    println!("# {line}");
    let status = Command::new(program)
        .args(arguments)
        .current_dir(root())
        // Packages of the user stay out of it.
        .env_remove("PYTHONPATH")
        .env("MPLBACKEND", "Agg")
        .envs(variables.iter().copied())
        .status()
        .map_err(|error| format!("cannot run {line}: {error}"))?;
    match status.success() {
        true => Ok(()),
        false => Err(format!("{line} failed")),
    }
}
