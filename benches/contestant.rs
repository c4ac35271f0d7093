//! Contestants: processes that do one task for each line they are sent and answer with the seconds it
//! took and a sum of its result.

use std::error::Error;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::{fs, iter};

const NUMPY_REQUIREMENTS: &str = "peers/requirements.txt";
const RIFFEL_REQUIREMENTS: &str = "peers/requirements-riffel.txt";
const ROLLAND_REQUIREMENTS: &str = "peers/requirements-rolland.txt";

/// Anything that stops a benchmark.
pub(crate) type Failure = Box<dyn Error>;

/// A running contestant.
pub(crate) struct Contestant {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Contestant {
    /// A script of the peers in NumPy.
    pub(crate) fn numpy(folder: &Path, script: &str) -> Result<Self, Failure> {
        let python = environment(folder, "peers", || Ok("python3".into()))?;
        install(&python, &folder.join(NUMPY_REQUIREMENTS))?;
        Self::python(&python, &folder.join("peers").join(script))
    }

    /// rolland, apart from the other peers: it wants a Python of its own and holds NumPy back. The error
    /// says in few words what is missing.
    pub(crate) fn rolland(folder: &Path) -> Result<Self, Failure> {
        let python = environment(folder, "peers-rolland", recent_python)?;
        install(&python, &folder.join(ROLLAND_REQUIREMENTS)).map_err(|_| "pip failed")?;
        let mut rolland = Self::python(&python, &folder.join("peers/receptance_rolland.py"))?;
        rolland.once("rolland", 1).map_err(|_| "it does not run")?;
        Ok(rolland)
    }

    /// A script that uses the Python package of Riffel, built from these sources as users build it, on a
    /// number of threads.
    pub(crate) fn riffel_of_python(folder: &Path, script: &str, threads: usize) -> Result<Self, Failure> {
        let python = environment(folder, "peers-riffel", || Ok("python3".into()))?;
        install(&python, &folder.join(RIFFEL_REQUIREMENTS))?;
        run(Command::new(&python)
            .args(["-m", "pip", "install", "--quiet", "--no-build-isolation"])
            .args(["--no-deps", "--disable-pip-version-check"])
            .arg(folder.join("..").canonicalize()?)
            // The scripts beside the interpreter, for maturin.
            .env("PATH", scripts_first(&python)?))?;
        Self::start(
            Command::new(python).arg(folder.join("peers").join(script)).env("RAYON_NUM_THREADS", threads.to_string()),
        )
    }

    /// A Python script on one thread.
    fn python(python: &Path, script: &Path) -> Result<Self, Failure> {
        Self::start(Command::new(python).arg(script).env("OMP_NUM_THREADS", "1").env("OPENBLAS_NUM_THREADS", "1"))
    }

    /// Riffel on a number of threads: this program again.
    pub(crate) fn riffel(threads: usize) -> Result<Self, Failure> {
        Self::start(
            Command::new(std::env::current_exe()?).arg(crate::CONTESTANT).env("RAYON_NUM_THREADS", threads.to_string()),
        )
    }

    fn start(command: &mut Command) -> Result<Self, Failure> {
        let mut process = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let input = process.stdin.take().ok_or("no input to the contestant")?;
        let output = process.stdout.take().ok_or("no output of the contestant")?;
        Ok(Self { process, input, output: BufReader::new(output) })
    }

    /// Seconds for one task on an axis of so many points, and the sum of its result. The task is done
    /// twice and the second counts: the turn of another contestant has emptied the caches.
    pub(crate) fn time(&mut self, task: &str, points: usize) -> Result<(f64, f64), Failure> {
        self.once(task, points)?;
        self.once(task, points)
    }

    /// Seconds for one task, done once.
    pub(crate) fn once(&mut self, task: &str, points: usize) -> Result<(f64, f64), Failure> {
        writeln!(self.input, "{task} {points}")?;
        let mut line = String::new();
        self.output.read_line(&mut line)?;
        let (seconds, sum) = line.trim().split_once(' ').ok_or("a contestant gave no answer")?;
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
    if status.success() { Ok(()) } else { Err(format!("{command:?} failed").into()) }
}

/// The Python of a virtual environment, which is made with another Python if it is not there.
fn environment(
    folder: &Path,
    name: &str,
    maker: impl FnOnce() -> Result<PathBuf, Failure>,
) -> Result<PathBuf, Failure> {
    let environment = folder.join("../target").join(name);
    let python = environment.join("bin/python");
    if !python.exists() {
        run(Command::new(maker()?).args(["-m", "venv"]).arg(&environment))?;
    }
    Ok(python)
}

/// The search path with the folder of an interpreter before all else.
fn scripts_first(python: &Path) -> Result<std::ffi::OsString, Failure> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folder = python.parent().map(Path::to_owned);
    Ok(std::env::join_paths(folder.into_iter().chain(std::env::split_paths(&path)))?)
}

fn install(python: &Path, requirements: &Path) -> Result<(), Failure> {
    run(Command::new(python)
        .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"])
        .arg(requirements))
}

/// A Python of version 3.12 or later, from the search path or from pyenv.
fn recent_python() -> Result<PathBuf, Failure> {
    let named = ["python3.13", "python3.12", "python3.14", "python3"].map(PathBuf::from);
    let python = named.into_iter().chain(iter::once_with(pyenv_pythons).flatten()).find(|python| is_recent(python));
    Ok(python.ok_or("no Python 3.12 or later")?)
}

fn is_recent(python: &Path) -> bool {
    let question = "import sys; print(sys.version_info >= (3, 12))";
    answer(Command::new(python).args(["-c", question])).is_some_and(|answer| answer == "True")
}

/// The Pythons of pyenv, the latest first; none without pyenv.
fn pyenv_pythons() -> Vec<PathBuf> {
    let versions = answer(Command::new("pyenv").args(["versions", "--bare"])).unwrap_or_default();
    let prefixes = versions.lines().rev().filter_map(|version| answer(Command::new("pyenv").args(["prefix", version])));
    prefixes.map(|prefix| Path::new(&prefix).join("bin/python")).collect()
}

/// What a command prints; nothing if it fails or is not there.
fn answer(command: &mut Command) -> Option<String> {
    let output = command.output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

/// Version of a package that the peers require.
fn required_version(requirements: &Path, package: &str) -> Result<String, Failure> {
    let text = fs::read_to_string(requirements)?;
    let version = text.lines().find_map(|line| {
        let (name, version) = line.split_once("==")?;
        (name == package).then_some(version)
    });
    Ok(version.ok_or(format!("no version of {package} is required"))?.to_owned())
}

/// Version of NumPy.
pub(crate) fn numpy_version(folder: &Path) -> Result<String, Failure> {
    required_version(&folder.join(NUMPY_REQUIREMENTS), "numpy")
}

/// Version of SciPy.
pub(crate) fn scipy_version(folder: &Path) -> Result<String, Failure> {
    required_version(&folder.join(NUMPY_REQUIREMENTS), "scipy")
}

/// Version of rolland.
pub(crate) fn rolland_version(folder: &Path) -> Result<String, Failure> {
    required_version(&folder.join(ROLLAND_REQUIREMENTS), "rolland")
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
