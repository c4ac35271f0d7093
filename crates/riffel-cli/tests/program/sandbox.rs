//! A fresh folder with the case files, in which commands run.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
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
    pub(crate) fn new() -> Self {
        let folder = TempDir::new().unwrap();
        let sandbox = Self { folder };
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
        let test = std::thread::current();
        command.env("RIFFEL_TEST", test.name().unwrap_or("another"));
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

    /// What a command that succeeds prints on standard output, as JSON.
    pub(crate) fn json(&self, arguments: &str) -> Value {
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

/// A number of a JSON document.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}
