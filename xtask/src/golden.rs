//! Golden capture: every command line of the program's tests and of the book, with all that it wrote.
//!
//! The tests run `cargo xtask` in the place of the program, which runs the program and keeps what it printed. Two captures, one before
//! a change and one after it, are compared by `diff --recursive`.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::SystemTime;

use crate::step::{linting_cargo, run};
use crate::{Outcome, build_program, root};

/// Where records go; set for a program under test.
const RECORDS: &str = "RIFFEL_RECORDS";
/// What the tests run in the place of the program.
const RECORDER: &str = "RIFFEL_RECORDER";
/// The test that runs the program.
const TEST: &str = "RIFFEL_TEST";

/// Texts that are kept as they are, of other files a checksum.
const TEXTS: [&str; 8] = ["csv", "html", "json", "md", "svg", "toml", "txt", "xml"];
/// Largest of them \[bytes\]: pages hold a library.
const LARGEST: usize = 200_000;

/// Run the tests of the program and keep what it printed and wrote in a new folder. Tests that end the program from outside may fail:
/// they end the recorder.
pub(crate) fn capture(records: &Path) -> Outcome {
    let failed = |error: io::Error| format!("{}: {error}", records.display());
    fs::create_dir(records).map_err(failed)?;
    let records = records.canonicalize().map_err(failed)?;
    let recorder = std::env::current_exe().map_err(failed)?;
    build_program()?;
    let tests = ["test", "--quiet", "--package", "riffel-cli", "--test", "program"];
    let mut tests = linting_cargo(&tests);
    run(tests.env(RECORDS, records).env(RECORDER, recorder))
}

/// Run the program in whose place this runs, and record it; `None` where this is a developer's command.
pub(crate) fn record() -> Option<ExitCode> {
    let records = PathBuf::from(std::env::var_os(RECORDS)?);
    let test = std::env::var(TEST).ok()?;
    let run = Run::new();
    if run.arguments.first().is_some_and(|name| name == "serve") {
        // It is ended from outside, and prints nothing but its address.
        return Some(in_its_place(&run.program));
    }
    let (status, printed) = run.output().unwrap_or_else(|error| panic!("{}: {error}", run.program.display()));
    let text = run.text(status, &printed);
    keep(&records.join(test.replace("::", "-")), &text).expect("a place for the record");
    Some(ExitCode::from(u8::try_from(status.unwrap_or(255)).unwrap_or(255)))
}

/// Go on as the program.
#[cfg(unix)]
fn in_its_place(program: &Path) -> ExitCode {
    use std::os::unix::process::CommandExt;
    let error = Command::new(program).args(std::env::args_os().skip(1)).env_remove(RECORDS).exec();
    panic!("{}: {error}", program.display())
}

/// Elsewhere a server is left out: its end would leave it running.
#[cfg(not(unix))]
fn in_its_place(_: &Path) -> ExitCode {
    ExitCode::FAILURE
}

/// Write a record under the next number of its test.
fn keep(folder: &Path, text: &str) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    for number in 1.. {
        match fs::File::create_new(folder.join(format!("{number:03}.txt"))) {
            Ok(mut file) => return file.write_all(text.as_bytes()),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    unreachable!("numbers do not end")
}

/// A run of the program in a folder.
struct Run {
    program: PathBuf,
    arguments: Vec<String>,
    folder: PathBuf,
    before: BTreeMap<PathBuf, (u64, SystemTime)>,
}

impl Run {
    fn new() -> Self {
        let folder = std::env::current_dir().expect("a folder to run in");
        Self {
            program: root().join("target/debug/riffel"),
            arguments: std::env::args().skip(1).collect(),
            before: files(&folder),
            folder,
        }
    }

    /// The status, and what came on standard output and standard error, which go on to where this process has them.
    fn output(&self) -> io::Result<(Option<i32>, [String; 2])> {
        let mut child = Command::new(&self.program)
            .args(std::env::args_os().skip(1))
            .env_remove(RECORDS)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()?;
        let (out, err) = (child.stdout.take(), child.stderr.take());
        let printed = std::thread::scope(|scope| {
            let out = scope.spawn(|| passed_on(out, io::stdout()));
            [passed_on(err, io::stderr()), out.join().unwrap_or_default()]
        });
        let [err, out] = printed;
        Ok((child.wait()?.code(), [out, err]))
    }

    fn text(&self, status: Option<i32>, [out, err]: &[String; 2]) -> String {
        let mut text = format!("$ riffel {}\nstatus {status:?}\n", self.arguments.join(" "));
        let err: Vec<&str> = err.lines().filter(|line| !is_progress(line)).collect();
        for (name, printed) in [("output", out), ("errors", &err.join("\n"))] {
            text.push_str(&format!("--- {name}\n{printed}\n"));
        }
        for (path, state) in files(&self.folder) {
            if self.before.get(&path) == Some(&state) {
                continue;
            }
            let bytes = fs::read(self.folder.join(&path)).unwrap_or_default();
            let is_text =
                bytes.len() <= LARGEST && path.extension().is_some_and(|kind| TEXTS.iter().any(|text| kind == *text));
            let content = match is_text {
                true => String::from_utf8_lossy(&bytes).into_owned(),
                false => checksum(&bytes),
            };
            text.push_str(&format!("--- {}\n{content}\n", path.display()));
        }
        text.replace(&*self.folder.to_string_lossy(), "SANDBOX")
    }
}

/// Whether a line says how far the work is, which another run says at other moments.
fn is_progress(line: &str) -> bool {
    line.ends_with(" left") || line.ends_with(": 0 %") || line.starts_with("{\"progress\"")
}

/// All that a stream holds, which another is given as it comes.
fn passed_on(from: Option<impl Read>, mut to: impl Write) -> String {
    let (mut all, mut part) = (Vec::new(), [0; 4096]);
    let Some(mut from) = from else {
        return String::new();
    };
    while let Ok(length @ 1..) = from.read(&mut part) {
        all.extend(&part[..length]);
        // Whoever no longer listens is no failure of the program.
        let _ = to.write_all(&part[..length]).and_then(|()| to.flush());
    }
    String::from_utf8_lossy(&all).into_owned()
}

/// The files in a folder, with their sizes and when they were written.
fn files(folder: &Path) -> BTreeMap<PathBuf, (u64, SystemTime)> {
    let mut found = BTreeMap::new();
    let mut open = vec![folder.to_owned()];
    while let Some(place) = open.pop() {
        for entry in fs::read_dir(place).into_iter().flatten().flatten() {
            let Ok(state) = entry.metadata() else {
                continue;
            };
            if state.is_dir() {
                open.push(entry.path());
            } else if let Ok(name) = entry.path().strip_prefix(folder) {
                found.insert(name.to_owned(), (state.len(), state.modified().unwrap_or(SystemTime::UNIX_EPOCH)));
            }
        }
    }
    found
}

/// Size and checksum (Fowler, Noll, Vo) of a file that is no text.
fn checksum(bytes: &[u8]) -> String {
    let sum = bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3));
    format!("{} bytes {sum:016x}", bytes.len())
}
