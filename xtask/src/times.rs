//! What is slow: the steps of the check one after another, and the tests that take longest.

use std::fmt::Write;
use std::fs;
use std::process::Command;
use std::time::Instant;

use crate::{Outcome, budget, root};

/// The table.
const TABLE: &str = "benches/check.md";
/// Time of a test above which its reason stands beside it \[s\].
const LONG: f64 = 2.0;
/// Time of a test in a browser, which waits for the page, above which it does \[s\].
const LONG_IN_BROWSER: f64 = 10.0;
/// What the reason begins with.
const LONG_BECAUSE: &str = "Long: ";

/// A step of the check.
pub(crate) struct Step {
    pub(crate) name: &'static str,
    pub(crate) run: Box<dyn FnOnce() -> Result<String, String>>,
}

/// A test and its time \[s\].
struct Test {
    name: String,
    seconds: f64,
}

impl Test {
    fn is_long(&self) -> bool {
        // Their names begin with their file, those of the Python package with its folder.
        let limit = if self.name.starts_with("test_") { LONG_IN_BROWSER } else { LONG };
        self.seconds > limit
    }
}

/// Run the steps one by one and write how long each took, with the tests that took longest.
pub(crate) fn write(steps: Vec<Step>) -> Outcome {
    let mut table = format!(
        "# The check\n\nWritten by `cargo xtask test --times`, one step after another, on {} processors.\n\n\
         | step | wall s | processor s |\n|---|---|---|\n",
        std::thread::available_parallelism().map_or(1, usize::from)
    );
    let mut tests = Vec::new();
    for step in steps {
        println!("# {} ...", step.name);
        let (begin, before) = (Instant::now(), budget::taken().unwrap_or_default());
        let printed = (step.run)()?;
        let spent = budget::taken().unwrap_or_default() - before;
        let _ = writeln!(table, "| {} | {:.0} | {spent:.0} |", step.name, begin.elapsed().as_secs_f64());
        tests.extend(printed.lines().filter_map(timed));
    }
    let (count, sum) = (tests.len(), tests.iter().map(|test| test.seconds).sum::<f64>());
    tests.retain(Test::is_long);
    tests.sort_by(|one, other| other.seconds.total_cmp(&one.seconds));
    let _ = writeln!(
        table,
        "\nThe {count} tests whose time is told take {sum:.0} s by themselves. Above {LONG} s, in a browser {LONG_IN_BROWSER} s, are:\n"
    );
    table.push_str("| test | s | why |\n|---|---|---|\n");
    let mut without = Vec::new();
    for Test { name, seconds } in &tests {
        let reason = reason(name);
        let _ = writeln!(table, "| `{name}` | {seconds:.1} | {} |", reason.as_deref().unwrap_or("?"));
        without.extend(reason.is_none().then_some(&**name));
    }
    fs::write(root().join(TABLE), table).map_err(|error| format!("cannot write {TABLE}: {error}"))?;
    match &without[..] {
        [] => Ok(()),
        names => Err(format!(
            "these tests take more than {LONG} s, in a browser {LONG_IN_BROWSER} s, without a reason (`Long: ...`) above them: {}",
            names.join(", ")
        )),
    }
}

/// Why a test takes long, as the comment above it has it.
fn reason(test: &str) -> Option<String> {
    let name = test.rsplit("::").next()?.split('[').next()?;
    let begin = format!("(fn|def) {name}\\(");
    let mut find = Command::new("git");
    let above = printed(find.args(["grep", "-h", "-B", "8", "-E", &begin, "--", "*.rs", "*.py"])).ok()?;
    let (_, reason) = above.rsplit_once(LONG_BECAUSE)?;
    reason.lines().next().map(str::to_owned)
}

/// The tests in Rust above which such a reason stands.
pub(crate) fn long() -> Result<Vec<String>, String> {
    let comment = format!("// {LONG_BECAUSE}");
    let found = printed(Command::new("git").args(["grep", "-h", "-A", "8", &comment, "--", "*.rs"]))?;
    let reasons = found.split(&comment).skip(1);
    Ok(reasons.filter_map(|text| Some(text.split_once("fn ")?.1.split_once('(')?.0.to_owned())).collect())
}

/// Run a command and return what it printed on both streams.
pub(crate) fn printed(command: &mut Command) -> Result<String, String> {
    let output = command.current_dir(root()).output().map_err(|error| error.to_string())?;
    let [out, err] = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text));
    match output.status.success() {
        true => Ok(format!("{out}{err}")),
        false => Err(format!("{out}{err}")),
    }
}

/// The test of a line of libtest or pytest, with its time.
fn timed(line: &str) -> Option<Test> {
    let (name, seconds) = match line.strip_prefix("test ") {
        Some(line) => {
            let (name, rest) = line.split_once(" ... ok <")?;
            (name, rest.strip_suffix("s>")?)
        }
        None => {
            let (seconds, rest) = line.trim_start().split_once("s call ")?;
            (rest.trim(), seconds)
        }
    };
    Some(Test { name: name.to_owned(), seconds: seconds.parse().ok()? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_those_of_both_runners() {
        for (line, told) in [
            ("test track::modes ... ok <1.234s>", Some(("track::modes", 1.234))),
            ("12.50s call     tests/test_map.py::test_zoom", Some(("tests/test_map.py::test_zoom", 12.5))),
            ("0.50s setup    tests/test_map.py::test_zoom", None),
            ("test track::modes ... FAILED <1.234s>", None),
            ("running 3 tests", None),
        ] {
            let test = timed(line);
            assert_eq!(test.as_ref().map(|test| (&*test.name, test.seconds)), told, "{line}");
        }
    }
}
