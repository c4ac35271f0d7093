//! A fresh folder with the case files, in which commands run.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::Command;

use riffel_answers::question::{AnyQuestion, Nobody};
use serde_json::{Map, Value};
use tempfile::TempDir;

/// The root of the repository.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The program, or what records it.
pub(crate) fn program() -> PathBuf {
    let recorder = std::env::var_os("RIFFEL_RECORDER");
    recorder.map_or_else(|| env!("CARGO_BIN_EXE_riffel").into(), PathBuf::from)
}

/// A temporary folder with `cases/`.
pub(crate) struct Sandbox {
    folder: TempDir,
    /// By which its commands are recorded.
    name: String,
}

/// What a command printed, both streams as a terminal shows them, and its exit status.
pub(crate) struct Outcome {
    pub(crate) text: String,
    pub(crate) status: Option<i32>,
}

impl Outcome {
    /// The text without the line breaks and bars that a terminal puts between its words.
    pub(crate) fn sentence(&self) -> String {
        let words = self.text.split_whitespace().filter(|word| *word != "│");
        words.collect::<Vec<_>>().join(" ")
    }
}

impl Sandbox {
    /// That of the test which runs.
    pub(crate) fn new() -> Self {
        Self::named(std::thread::current().name().unwrap_or("another"))
    }

    pub(crate) fn named(name: &str) -> Self {
        let sandbox = Self { folder: TempDir::new().unwrap(), name: name.to_owned() };
        sandbox.copy("cases");
        sandbox
    }

    /// Copy the files of a folder of the repository to the same place here.
    pub(crate) fn copy(&self, name: &str) {
        let copy = self.path(name);
        fs::create_dir_all(&copy).unwrap();
        for entry in fs::read_dir(root().join(name)).unwrap() {
            let path = entry.unwrap().path();
            fs::copy(&path, copy.join(path.file_name().unwrap())).unwrap();
        }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The program, ready to be given arguments.
    pub(crate) fn command(&self) -> Command {
        let mut command = Command::new(program());
        command.current_dir(self.folder.path()).env("NO_COLOR", "1");
        command.env("RIFFEL_TEST", &self.name);
        command
    }

    /// Run `riffel` with arguments separated by blanks.
    pub(crate) fn riffel(&self, arguments: &str) -> Outcome {
        let words = shlex::split(arguments).unwrap_or_else(|| panic!("no command line: {arguments}"));
        let (mut reader, writer) = std::io::pipe().unwrap();
        let mut child = {
            let mut command = self.command();
            command.args(words).stdout(writer.try_clone().unwrap()).stderr(writer);
            command.spawn().unwrap()
        };
        let mut text = String::new();
        reader.read_to_string(&mut text).unwrap();
        Outcome { text, status: child.wait().unwrap().code() }
    }

    /// The document of a question, answered in this process: its files are those of the sandbox.
    ///
    /// Work that the program has a hand in, and files that it writes beside the document, are those of the program.
    pub(crate) fn json(&self, arguments: &str) -> Value {
        let words = shlex::split(arguments).unwrap();
        let line = std::iter::once("riffel".into()).chain(words.iter().map(Into::into));
        let question = riffel_cli::question_of(line).unwrap_or_else(|error| panic!("{arguments}: {error}"));
        let recorded = std::env::var_os("RIFFEL_RECORDER").is_some();
        match question {
            Some((question, keys)) if !recorded && is_answer_alone(question, &words) => {
                let answer = question.answer(self.placed(keys), &Nobody);
                let document = answer.unwrap_or_else(|error| panic!("{arguments}: {error}")).document();
                let place = format!("{}/", self.folder.path().display());
                serde_json::from_str(&document.replace(&place, "")).unwrap()
            }
            _ => self.json_of_program(arguments),
        }
    }

    /// The keys of a question, of which those that name a file of the sandbox have its path.
    fn placed(&self, keys: Map<String, Value>) -> Map<String, Value> {
        let placed = |value| match value {
            Value::String(name) if self.path(&name).exists() => self.path(&name).to_str().unwrap().into(),
            other => other,
        };
        let each = |value| match value {
            Value::Array(values) => values.into_iter().map(placed).collect(),
            one => placed(one),
        };
        keys.into_iter().map(|(key, value)| (key, each(value))).collect()
    }

    /// What a command that succeeds prints on standard output, as JSON.
    pub(crate) fn json_of_program(&self, arguments: &str) -> Value {
        let output = self.command().args(shlex::split(arguments).unwrap()).output().unwrap();
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{arguments}: {errors}");
        serde_json::from_slice(&output.stdout).unwrap()
    }

    /// Names of all that lies in a folder of the sandbox, sorted, but for the list of what Riffel wrote.
    pub(crate) fn list(&self, name: &str) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(self.path(name))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name != "riffel-manifest.json")
            .collect();
        names.sort();
        names
    }
}

/// Whether the document of a question is all that comes of it.
fn is_answer_alone(question: &dyn AnyQuestion, words: &[String]) -> bool {
    let places = ["-o", "--output", "--save-format", "--into"];
    let writes = words.iter().any(|word| places.contains(&word.split('=').next().unwrap_or_default()));
    !writes && !["simulate", "study", "calibrate", "network"].contains(&question.name().split(' ').next().unwrap())
}

/// A number of a JSON document.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}
