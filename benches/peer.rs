//! The NumPy peer: a process that computes one map for each line it is sent.

use std::error::Error;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// Anything that stops a benchmark.
pub(crate) type Failure = Box<dyn Error>;

/// A running peer.
pub(crate) struct Peer {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    version: String,
}

impl Peer {
    /// Make the virtual environment of the peers, if it is not there, and start the peer.
    pub(crate) fn start(folder: &Path) -> Result<Self, Failure> {
        let environment = folder.join("../target/peers");
        let python = environment.join("bin/python");
        let requirements = folder.join("peers/requirements.txt");
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
            .arg(&requirements))?;
        let mut process = Command::new(&python)
            .arg(folder.join("peers/map_numpy.py"))
            .env("OMP_NUM_THREADS", "1")
            .env("OPENBLAS_NUM_THREADS", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let input = process.stdin.take().ok_or("no input to the peer")?;
        let output = process.stdout.take().ok_or("no output of the peer")?;
        let version = fs::read_to_string(requirements)?
            .lines()
            .find_map(|line| line.strip_prefix("numpy=="))
            .unwrap_or("?")
            .to_owned();
        Ok(Self {
            process,
            input,
            output: BufReader::new(output),
            version,
        })
    }

    /// Version of NumPy.
    pub(crate) fn version(&self) -> &str {
        &self.version
    }

    /// Seconds for one map of side × side points, and the sum of its real parts.
    pub(crate) fn map(&mut self, side: usize) -> Result<(f64, f64), Failure> {
        writeln!(self.input, "{side}")?;
        let mut line = String::new();
        self.output.read_line(&mut line)?;
        let (seconds, sum) = line
            .trim()
            .split_once(' ')
            .ok_or("the peer gave no answer")?;
        Ok((seconds.parse()?, sum.parse()?))
    }
}

impl Drop for Peer {
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
