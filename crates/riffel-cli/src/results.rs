//! The results of a command: a document on standard output, or files and words on them.

use std::path::PathBuf;

use riffel_answers::{self as answers, Answer, OwnText, Printed};

use crate::error::CliError;
use crate::messages::Voice;
use crate::output::{as_text, json_of, print, table_of};
use crate::session::Session;
use crate::staging::{Existing, Staging, write_file};

/// Where the results of a command go: with `--json` the document is printed, and files are written only to a folder that is
/// named.
pub(crate) struct Results {
    pub(crate) command: &'static str,
    /// The folder, if files are written.
    pub(crate) folder: Option<PathBuf>,
    /// Whether the document is printed.
    pub(crate) json: bool,
}

impl Results {
    /// Hand out an answer: its files and its document, or what they say in words; then its remarks. With `--json` and a folder both,
    /// and nothing is said.
    pub(crate) fn answer(&self, session: &Session, answer: &dyn Answer) -> Result<(), CliError> {
        let document = || json_of(session.voice, || answer.document());
        if self.json {
            print(&document())?;
        }
        let mut written = String::new();
        if let Some(folder) = self.folder.as_ref().filter(|_| answer.has_files()) {
            let mut staging = Staging::new(session, self.command, folder)?;
            for file in answer.files() {
                staging.write_result(file)?;
            }
            staging.write(answer.document_name(), document())?;
            written = format!("{}: {}\n", folder.display(), staging.publish()?.join(" "));
        }
        if !self.json {
            print(&(in_words(session.voice, answer) + &written))?;
        }
        session.print_remarks(answer.remarks());
        Ok(())
    }
}

/// Write a text to its file, or print it.
pub(crate) fn put(session: &Session, text: &OwnText<'_>) -> Result<(), CliError> {
    let Some(path) = text.path else {
        return print(&text.text);
    };
    let existing = match text.existing {
        answers::Existing::Kept => Existing::Keep("remove the file first"),
        answers::Existing::Replaced => Existing::Replace,
        answers::Existing::ReplacedIfKnown(mark) => Existing::known(path, &text.text, mark),
    };
    write_file(session, path, &text.text, existing)?;
    text.written.iter().try_for_each(|written| print(&(written.text(session.voice.language) + "\n")))
}

/// An answer in words.
pub(crate) fn in_words(voice: Voice, answer: &dyn Answer) -> String {
    let told = answer.printed().into_iter().map(|told| match told {
        Printed::Line(line) => line.text(voice.language) + "\n",
        Printed::Table(table) => format!("{}\n", table_of(voice, &table)),
        Printed::Texts(table) => format!("{}\n", as_text(table_of(voice, &table))),
    });
    told.collect()
}
