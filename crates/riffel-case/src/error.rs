//! What can be wrong with a case file.

use std::io;
use std::path::PathBuf;
use std::sync::Arc;

use miette::{Diagnostic, NamedSource, SourceSpan};
use thiserror::Error;

/// A case that cannot be used, and why, in a sentence that names the key.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum CaseError {
    /// The file cannot be read.
    #[error("cannot read the case file {path}: {reason}", path = path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// The text is not TOML.
    #[error("not valid TOML: {message}")]
    Syntax {
        /// What the reader says.
        message: String,
        /// The case file.
        #[source_code]
        source_code: Arc<NamedSource<String>>,
        /// Where.
        #[label("here")]
        span: SourceSpan,
    },

    /// A key is missing, unknown or has a value that is not allowed.
    #[error("{message}")]
    Invalid {
        /// The key, dotted.
        key: String,
        /// Key, value and rule.
        message: String,
        /// What would be right.
        #[help]
        help: Option<String>,
        /// The case file.
        #[source_code]
        source_code: Arc<NamedSource<String>>,
        /// Where, if the file says anything there.
        #[label("{key}")]
        span: Option<SourceSpan>,
    },

    /// An override is malformed or sets a value that is not allowed.
    #[error("--set {assignment}: {message}")]
    Override {
        /// The override as given.
        assignment: String,
        /// Key, value and rule.
        message: String,
    },

    /// A file of data that cannot be used.
    #[error(
        "{path}{place}: {message}",
        path = path.display(),
        place = line.map(|line| format!(", line {line}")).unwrap_or_default()
    )]
    Data {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: Option<usize>,
        /// What is wrong.
        message: String,
        /// What would be right.
        #[help]
        help: Option<String>,
    },

    /// No preset has this name.
    #[error("no preset is called \"{name}\"; the nearest is \"{nearest}\"")]
    #[diagnostic(help("riffel presets lists them all"))]
    UnknownPreset {
        /// The name asked for.
        name: String,
        /// The name most like it.
        nearest: String,
    },
}

impl CaseError {
    /// A file of data that cannot be used as a whole, and why not.
    pub fn data(path: impl Into<PathBuf>, message: impl Into<String>) -> Self {
        Self::Data {
            path: path.into(),
            line: None,
            message: message.into(),
            help: None,
        }
    }
}
