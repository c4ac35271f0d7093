//! What can be wrong with a case file.

use std::fmt::{self, Display};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode, SourceSpan};
use thiserror::Error;

use crate::printable::in_a_message;
use crate::quantity::named;
use crate::{Language, Message, Value, physics_in_words, say};

/// A case that cannot be used, and why, in a sentence that names the key.
///
/// Its sentence, its help and its label are shown without control characters other than line feeds, whatever a file or
/// a command line holds: a terminal would obey them.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CaseError {
    /// A file cannot be read.
    Read {
        /// What the file is, as in "case file".
        what: &'static str,
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// The text is not TOML.
    Syntax {
        /// What the reader says.
        message: String,
        /// The case file.
        source_code: Arc<NamedSource<String>>,
        /// Where.
        span: SourceSpan,
    },

    /// A key is missing, unknown or has a value that is not allowed.
    Invalid {
        /// The key, dotted.
        key: String,
        /// Key, value and rule.
        message: Message,
        /// What would be right.
        help: Option<Message>,
        /// The case file.
        source_code: Arc<NamedSource<String>>,
        /// Where, if the file says anything there.
        span: Option<SourceSpan>,
    },

    /// A value with which an iteration does not reach its tolerance; the error of the value.
    NotConverged(Box<CaseError>),

    /// The physics refuses what was asked of a case.
    Physics {
        /// What was asked.
        input: String,
        /// Why not.
        error: riffel::Error,
    },

    /// A wavelength and a speed at which the case cannot be computed.
    Point {
        /// What is asked for, and the rule.
        message: Message,
    },

    /// An override is malformed or sets a value that is not allowed.
    Override {
        /// The override as given.
        assignment: String,
        /// Key, value and rule.
        message: Message,
    },

    /// A value that a program gave a key is not allowed.
    Changed {
        /// The key that was given the value, dotted.
        key: String,
        /// Key, value and rule.
        message: Message,
    },

    /// A file of data that cannot be used.
    Data {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: Option<usize>,
        /// What is wrong.
        message: Message,
        /// What would be right.
        help: Option<Message>,
    },

    /// No preset has this name.
    UnknownPreset {
        /// The name asked for.
        name: String,
        /// The name most like it.
        nearest: String,
    },
}

impl Display for CaseError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.sentence(Language::English))
    }
}

impl Diagnostic for CaseError {
    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        let help = self.advice()?.text(Language::English);
        Some(Box::new(in_a_message(&help).into_owned()))
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let (label, span) = match self {
            Self::Syntax { span, .. } => ("here", *span),
            Self::Invalid { key, span, .. } => (&**key, (*span)?),
            Self::NotConverged(error) => return error.labels(),
            _ => return None,
        };
        let label = in_a_message(label).into_owned();
        let label = LabeledSpan::new_with_span(Some(label), span);
        Some(Box::new(std::iter::once(label)))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        match self {
            Self::Syntax { source_code, .. } | Self::Invalid { source_code, .. } => Some(source_code),
            Self::NotConverged(error) => error.source_code(),
            _ => None,
        }
    }
}

/// A path without the folder that is meant anyway: `millions.csv` for `./millions.csv`.
fn shown(path: &Path) -> std::path::Display<'_> {
    path.strip_prefix(".").unwrap_or(path).display()
}

impl CaseError {
    /// What is wrong.
    pub fn message(&self) -> Message {
        match self {
            Self::Read { what, path, reason } => {
                say!(file_cannot_be_read, what = named(what), path = path.display(), reason = reason.to_string())
            }
            Self::Syntax { message, .. } => say!(not_valid_toml, message),
            Self::Invalid { message, .. } | Self::Point { message } | Self::Changed { message, .. } => message.clone(),
            Self::NotConverged(error) => error.message(),
            Self::Physics { input, error } => {
                say!(place_and_fault, place = input, fault = physics_in_words(error))
            }
            Self::Override { assignment, message } => {
                say!(place_and_fault, place = format!("--set {assignment}"), fault = message.clone())
            }
            Self::Data { path, line: None, message, .. } => {
                say!(place_and_fault, place = shown(path), fault = message.clone())
            }
            Self::Data { path, line: Some(line), message, .. } => {
                say!(line_and_fault, path = shown(path), line = *line, fault = message.clone())
            }
            Self::UnknownPreset { name, nearest } => {
                say!(no_such_preset, name, nearest)
            }
        }
    }

    /// What would be right.
    pub fn advice(&self) -> Option<Message> {
        match self {
            Self::Invalid { help, .. } | Self::Data { help, .. } => help.clone(),
            Self::UnknownPreset { .. } => Some(say!(presets_are_listed)),
            Self::NotConverged(error) => error.advice(),
            _ => None,
        }
    }

    /// What is wrong, in words that no terminal obeys.
    pub fn sentence(&self, language: Language) -> String {
        in_a_message(&self.message().text(language)).into_owned()
    }

    /// The sentence, then the line of the file where it stands and what would be right, each on a line of its own:
    /// for those who cannot show the file. An override is not quoted, for there it is no part of a command line.
    pub fn in_words(&self) -> String {
        let mut words = match self {
            Self::NotConverged(error) => return error.in_words(),
            Self::Override { message, .. } => message.to_string(),
            error => error.to_string(),
        };
        let (source, span) = match self {
            Self::Syntax { source_code, span, .. } => (Some(source_code), Some(*span)),
            Self::Invalid { source_code, span, .. } => (Some(source_code), *span),
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
            words += &format!("\n  {}, line {}: {}", source.name(), number + 1, line.trim());
        }
        if let Some(help) = self.help() {
            words += &format!("\n  {help}");
        }
        in_a_message(&words).into_owned()
    }

    /// What is wrong without the key that it begins with: for a value that was not written by the user.
    pub fn without_key(&self) -> Message {
        let message = match self {
            Self::NotConverged(error) => return error.without_key(),
            Self::Invalid { message, .. } | Self::Override { message, .. } => message,
            error => return error.message(),
        };
        let rule = message.values().iter().find(|(name, _)| *name == "rule");
        match (message.id(), rule) {
            ("key-and-rule", Some((_, Value::Message(rule)))) => (**rule).clone(),
            _ => message.clone(),
        }
    }

    /// A file of data that cannot be used as a whole, and why not.
    pub fn data(path: impl Into<PathBuf>, message: impl Into<Message>) -> Self {
        Self::Data { path: path.into(), line: None, message: message.into(), help: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// One of each kind, all of whose words are `words`.
    fn all(words: &str) -> Vec<CaseError> {
        let text = || words.to_owned();
        let source_code = || Arc::new(NamedSource::new("case.toml", text()));
        let span = SourceSpan::from(0..0);
        let invalid = || CaseError::Invalid {
            key: text(),
            message: text().into(),
            help: Some(text().into()),
            source_code: source_code(),
            span: Some(span),
        };
        vec![
            CaseError::Read { what: "case file", path: words.into(), reason: io::Error::other(text()) },
            CaseError::Syntax { message: text(), source_code: source_code(), span },
            invalid(),
            CaseError::NotConverged(Box::new(invalid())),
            CaseError::Physics { input: text(), error: riffel::Error::GridTooSmall { length: 1.0, width: 1.0 } },
            CaseError::Point { message: text().into() },
            CaseError::Override { assignment: text(), message: text().into() },
            CaseError::Data { path: words.into(), line: Some(3), message: text().into(), help: Some(text().into()) },
            CaseError::UnknownPreset { name: text(), nearest: text() },
        ]
    }

    fn shown(error: &CaseError) -> Vec<String> {
        let labels = error.labels().into_iter().flatten();
        let labels = labels.filter_map(|label| label.label().map(str::to_owned));
        [error.to_string(), error.in_words(), in_a_message(&error.without_key().to_string()).into_owned()]
            .into_iter()
            .chain(error.help().map(|help| help.to_string()))
            .chain(labels)
            .collect()
    }

    proptest! {
        #[test]
        fn no_error_commands_a_terminal(words in "[a\n\t\r\u{0}\u{1b}\u{7f}\u{9b}\u{202e}µ]{0,12}") {
            for error in all(&words) {
                for text in shown(&error) {
                    let command = |c: char| c == '\u{202e}' || (c.is_control() && c != '\n');
                    prop_assert!(!text.contains(command), "{error:?}: {text:?}");
                }
            }
        }
    }

    #[test]
    fn what_can_be_seen_is_said_as_it_was_written() {
        for error in all("b `µ` \\n") {
            let label = matches!(error, CaseError::Syntax { .. });
            for text in shown(&error) {
                let said = text.contains("b `µ` \\n") || (label && text == "here");
                let fixed = ["riffel presets lists them all"];
                assert!(said || fixed.contains(&&*text), "{text:?}");
            }
        }
    }
}
