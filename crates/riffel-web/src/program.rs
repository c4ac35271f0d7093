//! The program itself, run on a file that came from a page.
//!
//! A measured rail is answered by a process of its own: whatever is in the file, the page goes on; a process
//! can be ended at any moment, and its memory is given back. What it prints is an answer's document, and its error is one,
//! too.

use riffel_keys::{Language, say};
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use axum::http::StatusCode;
use serde::Deserialize;
use serde_json::Value;
use sysinfo::{Pid, ProcessRefreshKind, ProcessesToUpdate, System};

use crate::fault::{Fault, disk};
use crate::queue::{CancelToken, Progress};

/// What ends a run, on a line of standard error.
#[derive(Deserialize)]
struct Line {
    error: ErrorDocument,
}

/// How far a run is, on another.
#[derive(Deserialize)]
struct ProgressLine {
    progress: Progress,
}

/// What ended a run.
#[derive(Deserialize)]
struct ErrorDocument {
    /// The sentence, as data.
    message: Value,
    /// What would be right.
    help: Option<Value>,
}

/// How systems say that a disk is full, Linux and macOS, then Windows.
const NO_ROOM: [&str; 2] = ["(os error 28)", "(os error 112)"];

/// How often is looked whether the result is still wanted.
const LOOK: Duration = Duration::from_millis(10);

/// How often is looked how much memory it takes.
const LOOK_AT_MEMORY: Duration = Duration::from_millis(200);

/// Most memory of one run \[bytes\]. The largest file that is taken, 2 GiB of text, makes some 3 GiB of it.
const MOST_MEMORY: u64 = 6 << 30;

/// The command that runs the program.
#[derive(Clone)]
pub(crate) struct Program {
    /// A program, with its first arguments if it takes any.
    command: Vec<OsString>,
    /// Memory at which a run is ended \[bytes\].
    most_memory: u64,
}

/// The memory of a process, as it is looked at now and then.
struct Memory {
    system: System,
    process: Pid,
    next: Instant,
}

impl Memory {
    fn of(child: &Child) -> Self {
        Self { system: System::new(), process: Pid::from_u32(child.id()), next: Instant::now() }
    }

    /// Whether the process takes more than so many bytes; not before the next look is due.
    fn exceeds(&mut self, most: u64) -> bool {
        let now = Instant::now();
        if now < self.next {
            return false;
        }
        self.next = now + LOOK_AT_MEMORY;
        let own = [self.process];
        self.system.refresh_processes_specifics(
            ProcessesToUpdate::Some(&own),
            false,
            ProcessRefreshKind::nothing().with_memory(),
        );
        let process = self.system.process(self.process);
        process.is_some_and(|process| process.memory() > most)
    }
}

/// Ends a process that is still running when nobody waits for it.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Program {
    pub(crate) fn new(command: Vec<OsString>) -> Self {
        Self { command, most_memory: MOST_MEMORY }
    }

    /// The document that answers a question on the files of a folder.
    pub(crate) fn ask(
        &self,
        folder: &Path,
        name: &str,
        question: &Value,
        cancel: &CancelToken,
    ) -> Result<Value, Fault> {
        let printed = self.answer(folder, name, question, Language::English, cancel)?;
        serde_json::from_str(&printed).map_err(|_| Fault::defect("the program printed something else than a document"))
    }

    /// What the program prints to such a question; a page that it writes is in the language.
    pub(crate) fn answer(
        &self,
        folder: &Path,
        name: &str,
        question: &Value,
        language: Language,
        cancel: &CancelToken,
    ) -> Result<String, Fault> {
        let own = std::process::id().to_string();
        let arguments = ["ask", "--messages", "--page", &own, "--language", language.code()];
        let arguments: Vec<&str> = arguments.into_iter().chain(name.split(' ')).collect();
        self.run(folder, &arguments, question, cancel)
    }

    /// What the program prints when it is run with the arguments in the folder, and a document on standard input.
    fn run(&self, folder: &Path, arguments: &[&str], input: &Value, cancel: &CancelToken) -> Result<String, Fault> {
        let failed = |error: io::Error| Fault::defect(format!("the program cannot be run: {error}"));
        // Files, not pipes: nobody has to read while it runs.
        let place = tempfile::tempdir_in(folder).map_err(disk)?;
        let file = |name| place.path().join(name);
        let (input_file, out, err) = (file("in"), file("out"), file("err"));
        fs::write(&input_file, input.to_string()).map_err(disk)?;
        let (program, first) = self.command.split_first().ok_or_else(|| Fault::defect("the program is not known"))?;
        let child = Command::new(program)
            .args(first)
            .args(arguments)
            .current_dir(folder)
            .stdin(File::open(&input_file).map_err(failed)?)
            .stdout(File::create(&out).map_err(disk)?)
            .stderr(File::create(&err).map_err(disk)?)
            .spawn()
            .map_err(failed)?;
        let mut memory = Memory::of(&child);
        let mut running = Running(child);
        let status = loop {
            if let Some(status) = running.0.try_wait().map_err(failed)? {
                break status;
            }
            if !cancel.is_wanted() {
                return Err(Fault::superseded());
            }
            if memory.exceeds(self.most_memory) {
                return Err(Fault::refused(
                    StatusCode::PAYLOAD_TOO_LARGE,
                    say!(the_file_takes_more_memory_than, memory = self.most_memory >> 20),
                    say!(riffel_roughness_reads_it_without_a),
                ));
            }
            if let Some(progress) = progress_of(&fs::read_to_string(&err).unwrap_or_default()) {
                cancel.tell(progress);
            }
            std::thread::sleep(LOOK);
        };
        // One says that what is printed allows no conclusion, which it says itself.
        if matches!(status.code(), Some(0 | 1)) {
            return fs::read_to_string(&out).map_err(failed);
        }
        let words = fs::read_to_string(&err).unwrap_or_default();
        has_room(folder)?;
        Err(fault_of(&words))
    }
}

/// `Err` where the disk is full: what a run that broke off has said of it may be lost.
fn has_room(folder: &Path) -> Result<(), Fault> {
    static PROBE: [u8; 1 << 16] = [0; 1 << 16];
    let file = tempfile::tempfile_in(folder);
    file.and_then(|mut file| file.write_all(&PROBE)).map_err(disk)
}

/// How far a run has last said to be.
fn progress_of(words: &str) -> Option<Progress> {
    let mut lines = words.lines().rev();
    lines.find_map(|line| Some(serde_json::from_str::<ProgressLine>(line).ok()?.progress))
}

/// The error among what the program has said on standard error, notes left aside.
fn fault_of(words: &str) -> Fault {
    let lines = words.lines().rev();
    let mut lines = lines.filter_map(|line| serde_json::from_str::<Line>(line).ok());
    match lines.next().map(|line| line.error) {
        Some(ErrorDocument { message, help }) => {
            let words = message.to_string();
            match NO_ROOM.iter().any(|full| words.contains(full)) {
                true => disk(words),
                false => Fault::of_process(message, help),
            }
        }
        None => Fault::defect(say!(the_program_broke_off)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line without an end, which `tail` keeps whole.
    #[cfg(unix)]
    #[test]
    fn whoever_takes_too_much_memory_is_ended() {
        let place = tempfile::tempdir().unwrap();
        let program = Program { most_memory: 50 << 20, ..Program::new(vec!["tail".into()]) };
        let fault = program.run(place.path(), &["/dev/zero"], &Value::Null, &CancelToken::default());
        let message = fault.unwrap_err().message();
        assert!(message.contains("more memory than the 50 MiB"), "{message}");
    }

    #[test]
    fn the_error_is_found_among_the_notes() {
        let message = "record.csv, line 1: no table of numbers begins here or below";
        let help = "a profile is a position and a height";
        let error = serde_json::json!({ "error": { "message": message, "help": help } });
        let printed = format!("{{\"remark\": {{}}}}\n{error}\n");
        let fault = serde_json::to_value(fault_of(&printed)).unwrap();
        assert_eq!(fault["message"], message);
        assert_eq!(fault["help"], help);
        assert_eq!(fault_of("note: nothing\n").message(), "the program broke off");
    }

    #[test]
    fn a_full_disk_is_no_defect() {
        let full = std::io::Error::from_raw_os_error(28).to_string();
        let error = serde_json::json!({ "error": { "message": format!("cannot write a.zarr: {full}") } });
        let fault = fault_of(&error.to_string());
        assert_eq!(fault.status(), StatusCode::INSUFFICIENT_STORAGE);
        assert!(fault.help().unwrap().contains("TMPDIR"));
        let place = tempfile::tempdir().unwrap();
        has_room(place.path()).unwrap();
        let gone = has_room(&place.path().join("gone")).unwrap_err();
        assert_eq!(gone.status(), StatusCode::INSUFFICIENT_STORAGE);
    }

    #[test]
    fn the_last_line_of_progress_counts() {
        let line = |done: u64| format!("{{\"progress\": {{\"done\": {done}, \"of\": 9}}}}\n");
        let words = format!("{}{{\"remark\": {{}}}}\n{}{{\"prog", line(3), line(5));
        let last = progress_of(&words).unwrap();
        assert_eq!((last.done, last.of), (5, 9));
        assert!(progress_of("note: nothing\n").is_none());
    }
}
