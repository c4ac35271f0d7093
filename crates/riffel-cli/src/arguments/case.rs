//! The case file of a command, with overrides.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use riffel_answers::question::{CaseSource, Source};
use riffel_case::Case;
use riffel_keys::text_file::is_standard_input;

use crate::terminal::Terminal;

/// A case file with overrides.
#[derive(Args)]
pub(crate) struct CaseArguments {
    /// Case file, or - for standard input.
    #[arg(value_name = "CASE")]
    path: PathBuf,

    /// Override a value of the case, as in --set contact.friction=0.3; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl CaseArguments {
    /// The same in a question.
    pub(crate) fn source(&self) -> CaseSource {
        CaseSource::new(Source::File(self.path.clone()), self.overrides.clone())
    }

    /// A case named elsewhere than on its own place of the command line.
    pub(crate) fn of(path: &Path, overrides: &[String]) -> Self {
        Self { path: path.to_owned(), overrides: overrides.to_vec() }
    }

    pub(crate) fn read(&self) -> miette::Result<Case> {
        Ok(Arc::unwrap_or_clone(self.source().read(&Terminal)?))
    }

    /// What results are named after.
    pub(crate) fn stem(&self) -> String {
        stem(&self.path)
    }

    /// The folder given for results, or one named after the case and what it holds.
    pub(crate) fn folder(&self, given: Option<&Path>, what: &str) -> PathBuf {
        given.map_or_else(|| PathBuf::from(format!("{}-{what}", stem(&self.path))), Path::to_owned)
    }
}

/// What results are named after that are made from a file.
pub(crate) fn stem(path: &Path) -> String {
    if is_standard_input(path) {
        return "stdin".to_owned();
    }
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}
