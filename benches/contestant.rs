//! Contestants: processes that do one task for each line they are sent and answer with the seconds it
//! took and a sum of its result.

use std::error::Error;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::{fmt, fs, iter};

const NUMPY_REQUIREMENTS: &str = "peers/requirements.txt";
const RIFFEL_REQUIREMENTS: &str = "peers/requirements-riffel.txt";
const ROLLAND_REQUIREMENTS: &str = "peers/requirements-rolland.txt";

/// Anything that stops a benchmark.
pub(crate) type Failure = Box<dyn Error>;

/// A peer whose packages are not there: a trial leaves it out.
#[derive(Debug)]
pub(crate) struct Absent(String);

impl fmt::Display for Absent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for Absent {}

/// Where the contestants are, and which Python has their packages.
pub(crate) struct Peers {
    /// Folder of the benchmarks.
    pub(crate) folder: PathBuf,
    /// A Python that has the packages it has; without it one is made for each list of requirements.
    python: Option<PathBuf>,
}

impl Peers {
    pub(crate) fn new(python: Option<PathBuf>) -> Self {
        Self { folder: env!("CARGO_MANIFEST_DIR").into(), python }
    }

    /// A script of the peers in NumPy, with its arguments.
    pub(crate) fn numpy(&self, script: &str, arguments: &[String]) -> Result<Contestant, Failure> {
        let python = self.python("peers", || Ok("python3".into()), NUMPY_REQUIREMENTS)?;
        Contestant::start(self.script(&python, script, 1).args(arguments))
    }

    /// rolland, apart from the other peers: it wants a Python of its own and holds NumPy back.
    pub(crate) fn rolland(&self) -> Result<Contestant, Failure> {
        let python = self.python("peers-rolland", recent_python, ROLLAND_REQUIREMENTS)?;
        let mut rolland = Contestant::start(&mut self.script(&python, "receptance_rolland.py", 1))?;
        rolland.once("rolland", 1).map_err(|_| Absent("it does not run".to_owned()))?;
        Ok(rolland)
    }

    /// A Python that has the package of Riffel, built from these sources as users build it unless it is at hand.
    pub(crate) fn python_with_riffel(&self) -> Result<PathBuf, Failure> {
        let python = self.python("peers-riffel", || Ok("python3".into()), RIFFEL_REQUIREMENTS)?;
        if self.python.is_some() {
            check_packages(&python, &["riffel".to_owned()])?;
            return Ok(python);
        }
        run(Command::new(&python)
            .args(["-m", "pip", "install", "--quiet", "--no-build-isolation"])
            .args(["--no-deps", "--disable-pip-version-check"])
            .arg(self.folder.join("..").canonicalize()?)
            // The scripts beside the interpreter, for maturin.
            .env("PATH", scripts_first(&python)?))?;
        Ok(python)
    }

    /// A script that uses the package of Riffel, on a number of threads.
    pub(crate) fn riffel_of_python(&self, python: &Path, script: &str, threads: usize) -> Result<Contestant, Failure> {
        Contestant::start(&mut self.script(python, script, threads))
    }

    /// Riffel on a number of threads: this program again.
    pub(crate) fn riffel(&self, threads: usize) -> Result<Contestant, Failure> {
        let mut command = Command::new(std::env::current_exe()?);
        command.arg(crate::CONTESTANT).args(crate::is_smoke().then_some(crate::SMOKE));
        Contestant::start(command.env("RAYON_NUM_THREADS", threads.to_string()))
    }

    /// Version of a package that a list requires.
    fn version(&self, requirements: &str, package: &str) -> Result<String, Failure> {
        let mut pinned = required(&self.folder.join(requirements))?.into_iter();
        let found = pinned.find(|(name, _)| name == package);
        Ok(found.ok_or_else(|| format!("no version of {package} is required"))?.1)
    }

    /// Version of NumPy.
    pub(crate) fn numpy_version(&self) -> Result<String, Failure> {
        self.version(NUMPY_REQUIREMENTS, "numpy")
    }

    /// Version of SciPy.
    pub(crate) fn scipy_version(&self) -> Result<String, Failure> {
        self.version(NUMPY_REQUIREMENTS, "scipy")
    }

    /// Version of rolland.
    pub(crate) fn rolland_version(&self) -> Result<String, Failure> {
        self.version(ROLLAND_REQUIREMENTS, "rolland")
    }

    /// A Python with the packages of a list: the one at hand, or one of a virtual environment that is made with another.
    fn python(
        &self,
        environment: &str,
        maker: impl FnOnce() -> Result<PathBuf, Failure>,
        requirements: &str,
    ) -> Result<PathBuf, Failure> {
        let requirements = self.folder.join(requirements);
        if let Some(python) = &self.python {
            let names = required(&requirements)?.into_iter().map(|(name, _)| name);
            check_packages(python, &names.collect::<Vec<_>>())?;
            return Ok(python.clone());
        }
        let environment = self.folder.join("../target").join(environment);
        let python = environment.join("bin/python");
        if !python.exists() {
            run(Command::new(maker()?).args(["-m", "venv"]).arg(&environment))?;
        }
        run(Command::new(&python)
            .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"])
            .arg(requirements))?;
        Ok(python)
    }

    /// A script on a number of threads, of Riffel or of linear algebra.
    fn script(&self, python: &Path, script: &str, threads: usize) -> Command {
        let mut command = Command::new(python);
        command.arg(self.folder.join("peers").join(script));
        for variable in ["RAYON_NUM_THREADS", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"] {
            command.env(variable, threads.to_string());
        }
        command
    }
}

/// A running contestant.
pub(crate) struct Contestant {
    process: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
}

impl Contestant {
    fn start(command: &mut Command) -> Result<Self, Failure> {
        let mut process = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let input = process.stdin.take();
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
        writeln!(self.input.as_ref().ok_or("no input to a contestant")?, "{task} {points}")?;
        let mut line = String::new();
        self.output.read_line(&mut line)?;
        let (seconds, sum) = line.trim().split_once(' ').ok_or("a contestant gave no answer")?;
        Ok((seconds.parse()?, sum.parse()?))
    }
}

/// A contestant ends with its input, and ends what it started.
impl Drop for Contestant {
    fn drop(&mut self) {
        self.input = None;
        let _ = self.process.wait();
    }
}

fn run(command: &mut Command) -> Result<(), Failure> {
    let status = command.status()?;
    if status.success() { Ok(()) } else { Err(format!("{command:?} failed").into()) }
}

/// The search path with the folder of an interpreter before all else.
fn scripts_first(python: &Path) -> Result<std::ffi::OsString, Failure> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folder = python.parent().map(Path::to_owned);
    Ok(std::env::join_paths(folder.into_iter().chain(std::env::split_paths(&path)))?)
}

/// Names and versions of a list of requirements.
fn required(requirements: &Path) -> Result<Vec<(String, String)>, Failure> {
    let text = fs::read_to_string(requirements)?;
    let pinned = text.lines().filter_map(|line| line.split_once("=="));
    Ok(pinned.map(|(name, version)| (name.to_owned(), version.to_owned())).collect())
}

/// Fails with what is missing unless a Python has all packages.
fn check_packages(python: &Path, names: &[String]) -> Result<(), Absent> {
    const QUESTION: &str = "import sys, importlib.metadata as known\nfor name in sys.argv[1:]: known.version(name)";
    match answer(Command::new(python).args(["-c", QUESTION]).args(names)) {
        Some(_) => Ok(()),
        None => Err(Absent(format!("{} lacks one of {}", python.display(), names.join(", ")))),
    }
}

/// A Python of version 3.12 or later, from the search path or from pyenv.
fn recent_python() -> Result<PathBuf, Failure> {
    let named = ["python3.13", "python3.12", "python3.14", "python3"].map(PathBuf::from);
    let python = named.into_iter().chain(iter::once_with(pyenv_pythons).flatten()).find(|python| is_recent(python));
    Ok(python.ok_or_else(|| Absent("no Python 3.12 or later".to_owned()))?)
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
