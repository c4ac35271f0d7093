//! The check: all of it, what takes a minute, or all with what has jobs of its own.

use std::thread::{self, ScopedJoinHandle};

use crate::browser::Thoroughness;
use crate::step::{cargo, linting_cargo, run, run_beside};
use crate::times::{Step, printed};
use crate::{Outcome, bench, browser, budget, compiler, dependencies, python, times};

const FORMAT: [&str; 3] = ["fmt", "--all", "--check"];
/// Lints of all crates, for which none is compiled to its end.
const LINTS: [&str; 7] = ["clippy", "--workspace", "--all-targets", "--quiet", "--", "--deny", "warnings"];
/// All that is run, with the features that the wheel has.
const BUILD: [&str; 8] =
    ["build", "--workspace", "--lib", "--bins", "--tests", "--quiet", "--features", "riffel-python/as-tested"];
const TESTS: [&str; 3] = ["test", "--workspace", "--quiet"];
/// The test binaries that take seconds, besides those of the libraries.
const QUICK: [&str; 15] = [
    "--lib",
    "--test",
    "numerics",
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

/// Formatting, lints, and the tests of seconds but for those that have a reason to take longer.
pub(crate) fn quick() -> Outcome {
    run(&mut cargo(&FORMAT))?;
    run(&mut cargo(&LINTS))?;
    let mut tests = linting_cargo(&TESTS);
    tests.args(QUICK).arg("--");
    for long in times::reasons(&["*.rs"])?.into_keys() {
        tests.args(["--skip", &long]);
    }
    run(&mut tests)
}

/// The whole check.
///
/// Packages are fetched while Rust compiles. The Python package and the page, which wait much, are tested beside the
/// rest; the benchmarks, which use the package, are tried after it. What else there is has jobs of its own: see [`thorough`].
pub(crate) fn all() -> Outcome {
    run(&mut cargo(&FORMAT))?;
    dependencies::check()?;
    thread::scope(|scope| {
        let python = scope.spawn(python::prepare);
        let browser = scope.spawn(browser::prepare);
        run(&mut linting_cargo(&BUILD))?;
        let (python, browser) = (end(python)?, end(browser)?);
        let python = scope.spawn(move || python::test(&python).and_then(|()| bench::test(&python)));
        let browser = scope.spawn(move || browser::test(&browser, Thoroughness::Once));
        run_beside(&mut linting_cargo(&TESTS))?;
        end(python)?;
        end(browser)
    })?;
    budget::hold()
}

/// The whole check and what has jobs of its own: documentation, tests that take minutes, the page in one file and in other colours,
/// sizes and languages.
pub(crate) fn thorough() -> Outcome {
    all()?;
    documentation()?;
    long()?;
    browser::test_alone()
}

/// The documentation of the library, without a warning.
pub(crate) fn documentation() -> Outcome {
    let mut documentation = cargo(&["doc", "--workspace", "--no-deps", "--quiet"]);
    run(documentation.env("RUSTDOCFLAGS", "--deny warnings"))
}

/// The tests that take minutes.
pub(crate) fn long() -> Outcome {
    // Not what writes a table or a capture for a reader.
    run(linting_cargo(&TESTS).args(["--tests", "--", "--ignored", "--skip", "is_captured", "--skip", "detection"]))
}

/// The check, one step after another, with the time of each and of the tests that take longest.
pub(crate) fn timed() -> Outcome {
    let step = |name, run: fn() -> Result<String, String>| Step { name, run: Box::new(run) };
    times::write(vec![
        step("formatting, dependencies", || {
            run(&mut cargo(&FORMAT)).and_then(|()| dependencies::check()).map(|()| String::new())
        }),
        step("compiling, lints", || printed(&mut linting_cargo(&BUILD))),
        step("tests", || {
            let mut tests = linting_cargo(&["test", "--workspace", "--tests", "--no-fail-fast"]);
            // The runner of the tests alone, for which times are no stable option.
            let runner = format!("CARGO_TARGET_{}_RUNNER", compiler::host()?.to_uppercase().replace('-', "_"));
            tests.env(runner, "env RUSTC_BOOTSTRAP=1");
            printed(tests.args(["--", "-Zunstable-options", "--report-time"]))
        }),
        step("tests in documentation", || printed(linting_cargo(&TESTS).arg("--doc"))),
        step("Python package", || python::timed(&python::prepare()?)),
        step("page", || browser::timed(&browser::prepare()?)),
    ])
}

fn end<T>(job: ScopedJoinHandle<'_, Result<T, String>>) -> Result<T, String> {
    job.join().map_err(|_| "a job panicked".to_owned())?
}
