//! What is slow: the steps of the check one after another, and the tests that take longest.

use std::collections::HashMap;
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

    /// The name without modules, folders and parameters.
    fn own_name(&self) -> &str {
        let whole = self.name.split('[').next().unwrap_or_default();
        whole.rsplit("::").next().unwrap_or_default()
    }
}

/// Run the steps one by one, also after one that fails, and write how long each took, with the tests that took longest.
pub(crate) fn write(steps: Vec<Step>) -> Outcome {
    let mut table = format!(
        "# The check\n\nWritten by `cargo xtask test --times`, one step after another, on {} processors.\n\n\
         | step | wall s | processor s |\n|---|---|---|\n",
        std::thread::available_parallelism().map_or(1, usize::from)
    );
    let (mut tests, mut failed) = (Vec::new(), Vec::new());
    for step in steps {
        println!("# {} ...", step.name);
        let (begin, before) = (Instant::now(), budget::taken().unwrap_or_default());
        let (printed, end) = match (step.run)() {
            Ok(printed) => (printed, ""),
            Err(printed) => {
                println!("{printed}");
                failed.push(step.name);
                (printed, ", which failed")
            }
        };
        let spent = budget::taken().unwrap_or_default() - before;
        let _ = writeln!(table, "| {}{end} | {:.0} | {spent:.0} |", step.name, begin.elapsed().as_secs_f64());
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
    let reasons = reasons(&["*.rs", "*.py"])?;
    let mut without = Vec::new();
    for test in &tests {
        let Test { name, seconds } = test;
        let reason = reasons.get(test.own_name());
        let _ = writeln!(table, "| `{name}` | {seconds:.1} | {} |", reason.map_or("?", String::as_str));
        without.extend(reason.is_none().then_some(&**name));
    }
    fs::write(root().join(TABLE), table).map_err(|error| format!("cannot write {TABLE}: {error}"))?;
    match (&failed[..], &without[..]) {
        ([], []) => Ok(()),
        ([], names) => Err(format!(
            "these tests take more than {LONG} s, in a browser {LONG_IN_BROWSER} s, without a reason (`Long: ...`) above them: {}",
            names.join(", ")
        )),
        (steps, _) => Err(format!("these steps failed: {}", steps.join("; "))),
    }
}

/// Why tests in these files take long, by their names without modules, as the comments above them have it.
pub(crate) fn reasons(files: &[&str]) -> Result<HashMap<String, String>, String> {
    let mark = format!("(//|#) {LONG_BECAUSE}");
    let mut find = Command::new("git");
    let found = printed(find.args(["grep", "-h", "-A", "8", "-E", &mark, "--"]).args(files))?;
    Ok(found.split(LONG_BECAUSE).skip(1).filter_map(reason).collect())
}

/// Name and reason of the test whose reason a text begins with.
fn reason(text: &str) -> Option<(String, String)> {
    let (reason, below) = text.split_once('\n')?;
    let (_, test) = below.split_once("fn ").or_else(|| below.split_once("def "))?;
    let (name, _) = test.split_once('(')?;
    Some((name.to_owned(), reason.to_owned()))
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
    fn reasons_are_those_of_the_tests_below() {
        let rust = "Long: waits.\n    #[cfg(unix)]\n    #[test]\n    fn ends() {\n";
        let python = "Long: waits.\n@pytest.mark.skipif(True)\ndef test_ends(\n    path: Path,\n";
        for (text, name) in [(rust, "ends"), (python, "test_ends")] {
            let text = text.strip_prefix(LONG_BECAUSE).unwrap();
            assert_eq!(reason(text), Some((name.to_owned(), "waits.".to_owned())));
        }
        let long = Test { name: "crates/test_map.py::test_zoom[a::b]".to_owned(), seconds: 1.0 };
        assert_eq!(long.own_name(), "test_zoom");
    }

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
