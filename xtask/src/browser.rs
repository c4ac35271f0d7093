//! The page: its scripts alone under the node of playwright, then all of it in a real browser, Debian's Chromium, driven by
//! pytest.
//!
//! Preferred is the browser without windows: one that has them, though it shows none, takes five times the processor for
//! each page that is opened.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use crate::step::{run_beside, run_unseen};
use crate::times::printed;
use crate::{Outcome, environment, output, page, root};

/// What the tests need, with exact versions.
const REQUIREMENTS: &str = "crates/riffel-web/tests/requirements.txt";

/// Chromium without windows, its program and package.
const WINDOWLESS: &str = "chromium-headless-shell";

/// Folder of the tests of the scripts.
const UNIT: &str = "./crates/riffel-web/tests/unit";

/// Two browsers, each with a server: a test waits half of its time.
const SIDE_BY_SIDE: [&str; 2] = ["--numprocesses=2", "--dist=worksteal"];

/// Names under which a Chromium with windows is found.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// [`test()`] with the program whose page is tested.
pub(crate) fn test_alone() -> Outcome {
    crate::build_program()?;
    let module = page::build_if_possible()?;
    test(&prepare()?, Thoroughness::All { module })
}

/// What drives the browser, and the browser.
pub(crate) struct Browser {
    python: PathBuf,
    chromium: PathBuf,
}

/// Chromium, and the environment of the tests.
pub(crate) fn prepare() -> Result<Browser, String> {
    Ok(Browser { chromium: chromium()?, python: environment::prepare(&folder().join("venv"), REQUIREMENTS)? })
}

/// How much is looked at.
pub(crate) enum Thoroughness {
    /// Each thing once.
    Once,
    /// Again in other colours, sizes and the other language, and in one file where the module for that is there.
    All { module: Option<PathBuf> },
}

/// Run the tests of the page, those of its scripts first. Screenshots of [`Thoroughness::All`] are kept in
/// `target/browser-tests/screenshots`.
pub(crate) fn test(browser: &Browser, thoroughness: Thoroughness) -> Outcome {
    run_beside(&mut scripts(browser)?)?;
    let mut tests = command(browser);
    match thoroughness {
        Thoroughness::Once => {
            tests.args(["-m", "not thorough"]).args(SIDE_BY_SIDE);
        }
        Thoroughness::All { module } => {
            tests.env("SCREENSHOTS", folder().join("screenshots"));
            tests.envs(module.map(|module| ("RIFFEL_WASM", module)));
        }
    }
    run_beside(&mut tests)
}

/// The tests in a browser, with the times of those that take long.
pub(crate) fn timed(browser: &Browser) -> Result<String, String> {
    let tests = ["-m", "not thorough", "--durations=0", "--durations-min=1"];
    printed(command(browser).args(tests).args(SIDE_BY_SIDE))
}

/// The tests in a browser, as a command of pytest.
fn command(browser: &Browser) -> Command {
    let tests = ["-m", "pytest", "--quiet", "crates/riffel-web/tests"];
    let mut tests = environment::command(&browser.python, &tests);
    tests
        .env("RIFFEL", root().join("target/debug/riffel"))
        .env("CHROMIUM", &browser.chromium)
        .env("PYTHONDONTWRITEBYTECODE", "1");
    tests
}

/// The tests of the scripts, as a command of node: playwright comes with one.
fn scripts(browser: &Browser) -> Result<Command, String> {
    let place = "from playwright._impl._driver import compute_driver_executable as driver; print(driver()[0])";
    let node = output(&browser.python, &["-c", place])?;
    let mut tests = Command::new(String::from_utf8_lossy(&node).trim());
    tests
        .args(["--no-warnings", "--experimental-vm-modules", "--test", "--test-isolation=none", "--test-reporter=dot"])
        .args(["--import", &format!("{UNIT}/page.mjs"), &format!("{UNIT}/*.test.mjs")])
        .env("RIFFEL", root().join("target/debug/riffel"));
    Ok(tests)
}

fn folder() -> PathBuf {
    root().join("target/browser-tests")
}

/// Chromium; installed where it is missing and Debian's package manager may do so.
fn chromium() -> Result<PathBuf, String> {
    if let Some(path) = env::var_os("CHROMIUM") {
        return Ok(PathBuf::from(path));
    }
    on_path(&[WINDOWLESS])
        .or_else(|| install(WINDOWLESS).and_then(|()| on_path(&[WINDOWLESS])))
        .or_else(|| on_path(&NAMES))
        .or_else(|| install(NAMES[0]).and_then(|()| on_path(&NAMES)))
        .ok_or_else(|| {
            "the tests of the page need Chromium: install it (Debian: apt install chromium-headless-shell) or name it by \
             CHROMIUM=/path/to/chromium"
                .to_owned()
        })
}

/// Install a package of Debian, where this user may; `None` if not.
fn install(package: &str) -> Option<()> {
    let install = ["install", "--yes", "--quiet", "--no-install-recommends", package];
    for arguments in [&["update", "--quiet"][..], &install] {
        let mut manager = Command::new("apt-get");
        manager.args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
        run_unseen(&mut manager).ok()?;
    }
    Some(())
}

/// The first of some programs that is on the path.
fn on_path(names: &[&str]) -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    let folders: Vec<PathBuf> = env::split_paths(&path).collect();
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|file| file.is_file())
}
