//! The page in a real browser: Debian's Chromium, driven by pytest.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use crate::step::{run_beside, run_unseen};
use crate::{Outcome, environment, page, root};

/// What the tests need, with exact versions.
const REQUIREMENTS: &str = "crates/riffel-web/tests/requirements.txt";

/// Names under which Chromium is found.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// [`test()`] with the program whose page is tested.
pub(crate) fn test_alone() -> Outcome {
    crate::build_program()?;
    test(&prepare()?, page::build_if_possible()?)
}

/// What drives the browser, and the browser.
pub(crate) struct Browser {
    python: PathBuf,
    chromium: PathBuf,
}

/// Chromium, and the environment of the tests.
pub(crate) fn prepare() -> Result<Browser, String> {
    Ok(Browser {
        chromium: chromium()?,
        python: environment::prepare(&folder().join("venv"), REQUIREMENTS)?,
    })
}

/// Run the tests of the page, and of the page in one file where its module is there; screenshots are kept in
/// `target/browser-tests/screenshots`.
pub(crate) fn test(browser: &Browser, module: Option<PathBuf>) -> Outcome {
    let tests = ["-m", "pytest", "--quiet", "crates/riffel-web/tests"];
    let mut tests = environment::command(&browser.python, &tests);
    tests
        .env("RIFFEL", root().join("target/debug/riffel"))
        .env("CHROMIUM", &browser.chromium)
        .env("SCREENSHOTS", folder().join("screenshots"))
        .env("PYTHONDONTWRITEBYTECODE", "1");
    if let Some(module) = module {
        tests.env("RIFFEL_WASM", module);
    }
    run_beside(&mut tests)
}

fn folder() -> PathBuf {
    root().join("target/browser-tests")
}

/// Chromium; installed where it is missing and Debian's package manager may do so.
fn chromium() -> Result<PathBuf, String> {
    let found = || env::var_os("CHROMIUM").map(PathBuf::from).or_else(on_path);
    if let Some(path) = found() {
        return Ok(path);
    }
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
        let mut install = Command::new("apt-get");
        install
            .args(arguments)
            .env("DEBIAN_FRONTEND", "noninteractive");
        if run_unseen(&mut install).is_err() {
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
