//! Contestants: processes that do one task for each line they are sent and answer with the seconds it
//! took and the sum of the real parts of its result.

use std::error::Error;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// Anything that stops a benchmark.
pub(crate) type Failure = Box<dyn Error>;

/// A running contestant.
pub(crate) struct Contestant {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Contestant {
    /// NumPy on one thread, in a virtual environment of the peers that is made if it is not there.
    pub(crate) fn numpy(folder: &Path) -> Result<Self, Failure> {
        let environment = folder.join("../target/peers");
        let python = environment.join("bin/python");
        if !python.exists() {
            run(Command::new("python3")
                .args(["-m", "venv"])
                .arg(&environment))?;
        }
        run(Command::new(&python)
            .args([
                "-m",
                "pip",
                "install",
                "--quiet",
                "--disable-pip-version-check",
                "-r",
            ])
            .arg(requirements(folder)))?;
        Self::start(
            Command::new(&python)
                .arg(folder.join("peers/map_numpy.py"))
                .env("OMP_NUM_THREADS", "1")
                .env("OPENBLAS_NUM_THREADS", "1"),
        )
    }

    /// Riffel on a number of threads: this program again.
    pub(crate) fn riffel(threads: usize) -> Result<Self, Failure> {
        Self::start(
            Command::new(std::env::current_exe()?)
                .arg(crate::CONTESTANT)
                .env("RAYON_NUM_THREADS", threads.to_string()),
        )
    }

    fn start(command: &mut Command) -> Result<Self, Failure> {
        let mut process = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let input = process.stdin.take().ok_or("no input to the contestant")?;
        let output = process.stdout.take().ok_or("no output of the contestant")?;
        Ok(Self {
            process,
            input,
            output: BufReader::new(output),
        })
    }

    /// Seconds for one task on a map of side × side points, and the sum of the real parts. The task is
    /// done twice and the second counts: the turn of another contestant has emptied the caches.
    pub(crate) fn time(&mut self, task: &str, side: usize) -> Result<(f64, f64), Failure> {
        self.once(task, side)?;
        self.once(task, side)
    }

    fn once(&mut self, task: &str, side: usize) -> Result<(f64, f64), Failure> {
        writeln!(self.input, "{task} {side}")?;
        let mut line = String::new();
        self.output.read_line(&mut line)?;
        let (seconds, sum) = line
            .trim()
            .split_once(' ')
            .ok_or("a contestant gave no answer")?;
        Ok((seconds.parse()?, sum.parse()?))
    }
}

impl Drop for Contestant {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

fn run(command: &mut Command) -> Result<(), Failure> {
    let status = command.status()?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{command:?} failed").into())
    }
}

fn requirements(folder: &Path) -> PathBuf {
    folder.join("peers/requirements.txt")
}

/// Version of NumPy.
pub(crate) fn numpy_version(folder: &Path) -> Result<String, Failure> {
    let text = fs::read_to_string(requirements(folder))?;
    let version = text.lines().find_map(|line| line.strip_prefix("numpy=="));
    Ok(version.ok_or("no version of NumPy is required")?.to_owned())
}

/// Processor and system, as far as the system tells.
pub(crate) fn machine() -> String {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let model = fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            Some(line.split_once(':')?.1.trim().to_owned())
        })
        .unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    format!("{model}, {processors} processors, {}", std::env::consts::OS)
}
