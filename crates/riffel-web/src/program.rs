//! The program itself, run on a file that came from a page.
//!
//! A measured rail is read by a process of its own: whatever is in the file, the page goes on; a process
//! can be ended at any moment, and its memory is given back. Its documents are those of `--json`.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use crate::fault::Fault;
use crate::queue::Wanted;

/// How often is looked whether the result is still wanted.
const LOOK: Duration = Duration::from_millis(10);

/// The command that runs the program, with its first arguments if it takes any.
#[derive(Clone)]
pub(crate) struct Program(pub(crate) Vec<OsString>);

/// Ends a process that is still running when nobody waits for it.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Program {
    /// What the program prints when it is run with the arguments in the folder.
    pub(crate) fn run(
        &self,
        folder: &Path,
        arguments: &[&str],
        wanted: &Wanted,
    ) -> Result<String, Fault> {
        let failed =
            |error: io::Error| Fault::defect(&format!("the program cannot be run: {error}"));
        // Files, not pipes: nobody has to read while it runs.
        let place = tempfile::tempdir_in(folder).map_err(failed)?;
        let (out, err) = (place.path().join("out"), place.path().join("err"));
        let (program, first) = self
            .0
            .split_first()
            .ok_or_else(|| Fault::defect("the program is not known"))?;
        let child = Command::new(program)
            .args(first)
            .args(arguments)
            .current_dir(folder)
            .env("NO_COLOR", "1")
            .env("COLUMNS", "2000")
            .stdin(Stdio::null())
            .stdout(File::create(&out).map_err(failed)?)
            .stderr(File::create(&err).map_err(failed)?)
            .spawn()
            .map_err(failed)?;
        let mut running = Running(child);
        let status = loop {
            if let Some(status) = running.0.try_wait().map_err(failed)? {
                break status;
            }
            if !wanted.still() {
                return Err(Fault::busy(
                    "a newer request has taken the place of this one",
                ));
            }
            std::thread::sleep(LOOK);
        };
        if status.success() {
            return fs::read_to_string(&out).map_err(failed);
        }
        let words = fs::read_to_string(&err).unwrap_or_default();
        Err(fault_of(&words))
    }
}

/// The sentence and the help of an error as the program prints it, frames and breaks left aside.
fn fault_of(words: &str) -> Fault {
    let mut sentence = String::new();
    let mut help = String::new();
    let mut now: Option<&mut String> = None;
    for line in words.lines() {
        let line = line.trim();
        let text = if let Some(rest) = line.strip_prefix('×') {
            now = Some(&mut sentence);
            rest
        } else if let Some(rest) = line.strip_prefix("help:") {
            now = Some(&mut help);
            rest
        } else if line.starts_with(['╭', '╰', '·']) || line.starts_with("note:") {
            now = None;
            continue;
        } else {
            line.trim_start_matches('│')
        };
        if let Some(part) = now.as_deref_mut() {
            part.push(' ');
            part.push_str(text.trim());
        }
    }
    if sentence.is_empty() {
        return Fault::defect("the program broke off");
    }
    Fault::refused(
        axum::http::StatusCode::UNPROCESSABLE_ENTITY,
        sentence.trim().to_owned(),
        help.trim(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentence_and_help_are_taken_from_what_is_printed() {
        let printed = "  × record.csv, line 1: no table of numbers begins here\n  │ or below\n  help: a profile is a position and\n        a height\n";
        let fault = serde_json::to_value(fault_of(printed)).unwrap();
        assert_eq!(
            fault["message"],
            "record.csv, line 1: no table of numbers begins here or below"
        );
        assert_eq!(fault["help"], "a profile is a position and a height");
        let silent = serde_json::to_value(fault_of("")).unwrap();
        assert_eq!(silent["message"], "the program broke off");
    }
}
