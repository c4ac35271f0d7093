//! The results of a command: a document on standard output, or files and words on them.

use std::path::Path;

use crate::arguments::CaseArguments;
use crate::error::CliError;
use crate::output::print;
use crate::staging::Staging;

/// Where the results of a command on a case go: with `--json` the document is printed, and files are written only to a
/// folder that is named.
pub(crate) struct Results<'a> {
    /// The command, which gives the folder its name where none is named.
    pub(crate) command: &'static str,
    pub(crate) case: &'a CaseArguments,
    /// `--output`.
    pub(crate) output: Option<&'a Path>,
    /// `--json`.
    pub(crate) json: bool,
}

impl Results<'_> {
    /// Hand out the document, or files and what is said of them on a terminal; with `--json` and a folder both, and nothing
    /// is said.
    pub(crate) fn hand_out(
        &self,
        document: impl FnOnce() -> String,
        write: impl FnOnce(&mut Staging) -> Result<(), CliError>,
        readable: impl FnOnce() -> String,
    ) -> Result<(), CliError> {
        if self.json {
            print(&document())?;
            if self.output.is_none() {
                return Ok(());
            }
        }
        let folder = self.case.folder(self.output, self.command);
        let mut staging = Staging::new(self.command, &folder)?;
        write(&mut staging)?;
        let files = staging.publish()?.join(" ");
        if self.json {
            return Ok(());
        }
        print(&format!("{}{}: {files}\n", readable(), folder.display()))
    }
}
