//! Virtual environments of Python with pinned requirements.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::root;
use crate::step::run_unseen;

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
    let make = ["-m", "venv", "--clear"];
    run_unseen(command(python, &make).arg(environment))
        .map_err(|_| format!("{python} has no module venv; install it (Debian: apt install python3-venv)"))?;
    let mut install = command(&own, &["-m", "pip", "install", "--quiet"]);
    // Python compiles a module when it is first imported, which of most packages few are.
    install.args(["--no-compile", "--disable-pip-version-check"]);
    install.args(["--requirement", requirements]);
    run_unseen(&mut install)?;
    fs::write(&installed, wanted).map_err(|error| format!("cannot write {}: {error}", installed.display()))?;
    Ok(own)
}

/// A Python that is new enough.
fn interpreter() -> Result<&'static str, String> {
    let check = format!("import sys; sys.exit(sys.version_info < ({},))", OLDEST.replace('.', ", "));
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

/// An interpreter with its arguments.
pub(crate) fn command(python: impl AsRef<OsStr>, arguments: &[&str]) -> Command {
    let mut command = Command::new(python);
    command
        .args(arguments)
        // Packages of the user stay out of it.
        .env_remove("PYTHONPATH")
        .env("MPLBACKEND", "Agg");
    command
}
