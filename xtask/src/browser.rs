//! The page in a real browser: Debian's Chromium, driven by pytest.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::{Outcome, root};

/// What the tests need, with exact versions.
const REQUIREMENTS: &str = "crates/riffel-web/tests/requirements.txt";

/// Names under which Chromium is found.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// [`test()`] with the program whose page is tested.
pub(crate) fn test_alone() -> Outcome {
    crate::cargo(&["build", "--quiet"])?;
    test()
}

/// Run the tests of the page; screenshots are kept in `target/browser-tests/screenshots`.
pub(crate) fn test() -> Outcome {
    let chromium = chromium()?;
    let environment = root().join("target/browser-tests");
    let python = prepare(&environment)?;
    println!(
        "# pytest crates/riffel-web/tests, in {}",
        chromium.display()
    );
    let status = Command::new(python)
        .args(["-m", "pytest", "--quiet"])
        .arg(root().join("crates/riffel-web/tests"))
        .env("RIFFEL", root().join("target/debug/riffel"))
        .env("CHROMIUM", chromium)
        .env("SCREENSHOTS", environment.join("screenshots"))
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .status();
    done(status, "the tests of the page")
}

fn done(status: std::io::Result<std::process::ExitStatus>, what: &str) -> Outcome {
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("{what} failed")),
        Err(error) => Err(format!("{what} cannot be run: {error}")),
    }
}

/// Chromium; installed where it is missing and Debian's package manager may do so.
fn chromium() -> Result<PathBuf, String> {
    let found = || env::var_os("CHROMIUM").map(PathBuf::from).or_else(on_path);
    if let Some(path) = found() {
        return Ok(path);
    }
    println!("# apt-get install chromium");
    for arguments in [
        &["update", "--quiet"][..],
        &[
            "install",
            "--yes",
            "--quiet",
            "--no-install-recommends",
            "chromium",
        ],
    ] {
        let status = Command::new("apt-get")
            .args(arguments)
            .env("DEBIAN_FRONTEND", "noninteractive")
            .stdout(Stdio::null())
            .status();
        if done(status, "apt-get").is_err() {
            break;
        }
    }
    found().ok_or_else(|| {
        "the tests of the page need Chromium: install it (Debian: apt install chromium) or name it by \
         CHROMIUM=/path/to/chromium"
            .to_owned()
    })
}

fn on_path() -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    let folders: Vec<PathBuf> = env::split_paths(&path).collect();
    NAMES
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)))
        .find(|file| file.is_file())
}

/// Python of a virtual environment with the requirements as they are now.
fn prepare(environment: &Path) -> Result<PathBuf, String> {
    let folder = environment.join("venv");
    let python = folder.join(if cfg!(windows) {
        "Scripts/python.exe"
    } else {
        "bin/python"
    });
    let wanted = fs::read_to_string(root().join(REQUIREMENTS))
        .map_err(|error| format!("cannot read {REQUIREMENTS}: {error}"))?;
    let installed = environment.join("requirements.installed");
    if fs::read_to_string(&installed).is_ok_and(|present| present == wanted) {
        return Ok(python);
    }
    let venv = Command::new("python3")
        .args(["-m", "venv", "--clear"])
        .arg(&folder)
        .status();
    done(
        venv,
        "the tests of the page need Python 3 with venv (Debian: apt install python3-venv); python3 -m venv",
    )?;
    let pip = Command::new(&python)
        .args([
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
            "--requirement",
        ])
        .arg(root().join(REQUIREMENTS))
        .status();
    done(pip, "pip install")?;
    fs::write(&installed, wanted)
        .map_err(|error| format!("cannot write {}: {error}", installed.display()))?;
    Ok(python)
}
