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
    /// A file cannot be read.
    #[error("cannot read the {what} {path}: {reason}", path = path.display())]
    Read {
        /// What the file is, as in "case file".
        what: &'static str,
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

    /// A value with which an iteration does not reach its tolerance; the error of the value.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NotConverged(Box<CaseError>),

    /// The physics refuses what was asked of a case.
    #[error("{input}: {error}")]
    Physics {
        /// What was asked.
        input: String,
        /// Why not.
        error: riffel::Error,
    },

    /// A wavelength and a speed at which the case cannot be computed.
    #[error("{message}")]
    Point {
        /// What is asked for, and the rule.
        message: String,
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
    /// The sentence, then the line of the file where it stands and what would be right, each on a line of its own:
    /// for those who cannot show the file. An override is not quoted, for there it is no part of a command line.
    pub fn in_words(&self) -> String {
        let mut words = match self {
            Self::NotConverged(error) => return error.in_words(),
            Self::Override { message, .. } => message.clone(),
            error => error.to_string(),
        };
        let (source, span) = match self {
            Self::Syntax {
                source_code, span, ..
            } => (Some(source_code), Some(*span)),
            Self::Invalid {
                source_code, span, ..
            } => (Some(source_code), *span),
            _ => (None, None),
        };
        // What was not read from a text has no name.
        if let (Some(source), Some(span)) = (source, span)
            && !source.name().is_empty()
        {
            let text = source.inner();
            let before = &text.as_bytes()[..span.offset().min(text.len())];
            let number = before.iter().filter(|&&byte| byte == b'\n').count();
            let line = text.lines().nth(number).unwrap_or_default();
            words += &format!(
                "\n  {}, line {}: {}",
                source.name(),
                number + 1,
                line.trim()
            );
        }
        if let Some(help) = self.help() {
            words += &format!("\n  {help}");
        }
        words
    }

    /// The sentence without the key that it begins with: for a value that was not written by the user.
    pub fn without_key(&self) -> String {
        let message = match self {
            Self::NotConverged(error) => return error.without_key(),
            Self::Invalid { message, .. } | Self::Override { message, .. } => message,
            error => return error.to_string(),
        };
        let after = message
            .strip_prefix('`')
            .and_then(|rest| rest.split_once("`: "));
        after
            .map_or(message.as_str(), |(_, sentence)| sentence)
            .to_owned()
    }

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
