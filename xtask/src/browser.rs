//! The page in a real browser: Debian's Chromium, driven by pytest.

use std::env;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::{Outcome, environment, root};

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
    let folder = root().join("target/browser-tests");
    let python = environment::prepare(&folder.join("venv"), REQUIREMENTS)?;
    println!(
        "# pytest crates/riffel-web/tests, in {}",
        chromium.display()
    );
    let status = Command::new(python)
        .args(["-m", "pytest", "--quiet"])
        .arg(root().join("crates/riffel-web/tests"))
        .env("RIFFEL", root().join("target/debug/riffel"))
        .env("CHROMIUM", chromium)
        .env("SCREENSHOTS", folder.join("screenshots"))
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
