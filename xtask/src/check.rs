//! The check: all of it, or what takes a minute.

use std::thread::{self, ScopedJoinHandle};

use crate::browser::Thoroughness;
use crate::step::{cargo, run, run_beside};
use crate::{Outcome, browser, dependencies, python};

const FORMAT: [&str; 3] = ["fmt", "--all", "--check"];
const LINTS: [&str; 7] = ["clippy", "--workspace", "--all-targets", "--quiet", "--", "--deny", "warnings"];
const TESTS: [&str; 3] = ["test", "--workspace", "--quiet"];
/// The test binaries that take seconds, besides those of the libraries.
const QUICK: [&str; 13] = [
    "--lib",
    "--test",
    "physics",
    "--test",
    "case",
    "--test",
    "study",
    "--test",
    "calibration",
    "--test",
    "answers",
    "--bin",
    "xtask",
];

/// Formatting, lints, and the tests that take seconds.
pub(crate) fn quick() -> Outcome {
    run(&mut cargo(&FORMAT))?;
    run(&mut cargo(&LINTS))?;
    run(cargo(&TESTS).args(QUICK))
}

/// Everything there is.
///
/// Packages are fetched while Rust compiles. The Python package and the page, which wait much, are tested beside the
/// rest. The page in one file, whose module takes eight minutes of a processor to build, and what has been seen in other colours,
/// another size or the other language are left to `cargo xtask browser`.
pub(crate) fn all() -> Outcome {
    run(&mut cargo(&FORMAT))?;
    dependencies::check()?;
    thread::scope(|scope| {
        let python = scope.spawn(python::prepare);
        let browser = scope.spawn(browser::prepare);
        run(&mut cargo(&LINTS))?;
        run(cargo(&TESTS).arg("--no-run"))?;
        let (python, browser) = (end(python)?, end(browser)?);
        let python = scope.spawn(move || python::test(&python));
        let browser = scope.spawn(move || browser::test(&browser, Thoroughness::Once));
        run_beside(&mut cargo(&TESTS))?;
        let mut documentation = cargo(&["doc", "--workspace", "--no-deps", "--quiet"]);
        run_beside(documentation.env("RUSTDOCFLAGS", "--deny warnings"))?;
        end(python)?;
        end(browser)
    })
}

fn end<T>(job: ScopedJoinHandle<'_, Result<T, String>>) -> Result<T, String> {
    job.join().map_err(|_| "a job panicked".to_owned())?
}
