//! The results of a command: a document on standard output, or files and words on them.

use std::path::{Path, PathBuf};

use riffel_answers::{self as answers, Answer, OwnText, Told};

use crate::arguments::{CaseArguments, ResultsArguments};
use crate::error::CliError;
use crate::messages::{language, print_remarks};
use crate::output::{as_text, json_of, print, table_of};
use crate::staging::{Existing, Staging, write_file};

/// Where the results of a command go: with `--json` the document is printed, and files are written only to a folder that is
/// named.
pub(crate) struct Results {
    command: &'static str,
    folder: PathBuf,
    /// Whether the document is printed.
    json: bool,
    /// Whether files are written.
    writes: bool,
}

impl Results {
    /// Those of a command on a case, which give the folder its name where none is named.
    pub(crate) fn of(command: &'static str, case: &CaseArguments, to: &ResultsArguments) -> Self {
        Self::named(command, case.stem(), to)
    }

    /// Those of a command on a file with this stem, likewise.
    pub(crate) fn named(command: &'static str, stem: String, to: &ResultsArguments) -> Self {
        Self::in_folder(command, Path::new(&(stem + "-" + command)), to.output.as_deref(), to.json)
    }

    /// Those of a command that has a folder where none is named.
    pub(crate) fn in_folder(command: &'static str, folder: &Path, output: Option<&Path>, json: bool) -> Self {
        Self { command, folder: output.unwrap_or(folder).to_owned(), json, writes: !json || output.is_some() }
    }

    /// Hand out an answer: its files and its document, or what they say in words; then its remarks. With `--json` and a folder both,
    /// and nothing is said.
    pub(crate) fn answer(&self, answer: &dyn Answer) -> Result<(), CliError> {
        let document = || json_of(|| answer.document());
        if self.json {
            print(&document())?;
        }
        if self.writes {
            let mut staging = Staging::new(self.command, &self.folder)?;
            for file in answer.files() {
                staging.write_result(file)?;
            }
            staging.write(answer.document_name(), document())?;
            let files = staging.publish()?.join(" ");
            if !self.json {
                print(&format!("{}{}: {files}\n", readable(answer), self.folder.display()))?;
            }
        }
        print_remarks(answer.remarks());
        Ok(())
    }
}

/// Write a text to its file, or print it.
pub(crate) fn put(text: &OwnText<'_>) -> Result<(), CliError> {
    let Some(path) = text.path else {
        return print(&text.text);
    };
    let existing = match text.existing {
        answers::Existing::Kept => Existing::Keep("remove the file first"),
        answers::Existing::Replaced => Existing::Replace,
        answers::Existing::ReplacedIfKnown(mark) => Existing::known(path, &text.text, mark),
    };
    write_file(path, &text.text, existing)?;
    text.written.iter().try_for_each(|written| print(&(written.text(language()) + "\n")))
}

/// An answer in words.
pub(crate) fn readable(answer: &dyn Answer) -> String {
    let told = answer.told().into_iter().map(|told| match told {
        Told::Line(line) => line.text(language()) + "\n",
        Told::Table(table) => format!("{}\n", table_of(&table)),
        Told::Texts(table) => format!("{}\n", as_text(table_of(&table))),
    });
    told.collect()
}
