//! The results of a command: a document on standard output, or files and words on them.

use riffel_answers::{Answer, Table};
use riffel_keys::Message;

use std::path::PathBuf;

use crate::arguments::{CaseArguments, ResultsArguments};
use crate::error::CliError;
use crate::messages::{language, print_remarks};
use crate::output::{json_of, print, table_of};
use crate::staging::Staging;

/// Where the results of a command on a case go: with `--json` the document is printed, and files are written only to a
/// folder that is named.
pub(crate) struct Results<'a> {
    /// The command, which gives the folder its name where none is named.
    command: &'static str,
    /// The file that it is about, without its ending, which gives it the rest.
    stem: String,
    to: &'a ResultsArguments,
}

impl<'a> Results<'a> {
    pub(crate) fn of(command: &'static str, case: &CaseArguments, to: &'a ResultsArguments) -> Self {
        Self::named(command, case.stem(), to)
    }

    /// Results that are named after a file with this stem.
    pub(crate) fn named(command: &'static str, stem: String, to: &'a ResultsArguments) -> Self {
        Self { command, stem, to }
    }

    /// Hand out the document, or files and what is said of them on a terminal; with `--json` and a folder both, and nothing
    /// is said.
    pub(crate) fn hand_out(
        &self,
        document: impl FnOnce() -> String,
        write: impl FnOnce(&mut Staging) -> Result<(), CliError>,
        readable: impl FnOnce() -> String,
    ) -> Result<(), CliError> {
        if self.to.json {
            print(&document())?;
            if self.to.output.is_none() {
                return Ok(());
            }
        }
        let named = || PathBuf::from(format!("{}-{}", self.stem, self.command));
        let folder = self.to.output.clone().unwrap_or_else(named);
        let mut staging = Staging::new(self.command, &folder)?;
        write(&mut staging)?;
        let files = staging.publish()?.join(" ");
        if self.to.json {
            return Ok(());
        }
        print(&format!("{}{}: {files}\n", readable(), folder.display()))
    }

    /// Hand out an answer: its figure, a file for each table and its document, or what they say in words; then its remarks.
    pub(crate) fn answer(&self, answer: &dyn Answer) -> Result<(), CliError> {
        self.hand_out(
            || json_of(|| answer.document()),
            |staging| {
                for file in answer.files() {
                    staging.write_result(file)?;
                }
                staging.write(answer.document_name(), json_of(|| answer.document()))
            },
            || readable(answer),
        )?;
        print_remarks(answer.remarks());
        Ok(())
    }
}

/// An answer in words.
pub(crate) fn readable(answer: &dyn Answer) -> String {
    let lines = |messages: Vec<Message>| -> String {
        let lines = messages.iter().map(|line| line.text(language()) + "\n");
        lines.collect()
    };
    let shown = answer.tables().into_iter().filter(Table::is_shown);
    let tables = shown.map(|table| {
        let [above, below] = [answer.above(table.name), answer.below(table.name)].map(lines);
        format!("{above}{}\n{below}", table_of(&table))
    });
    let tables = tables.collect::<String>();
    lines(answer.introduction()) + &tables + &lines(answer.sentences())
}
