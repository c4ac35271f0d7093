//! What went wrong, as the page shows it.

use miette::Diagnostic;
use riffel_keys::CaseError;
use serde::Serialize;

/// An error: a status of HTTP for the browser, a sentence for the reader and, where there is one, the key of the
/// case that is at fault.
#[derive(Debug, Serialize)]
pub struct Fault {
    #[serde(skip)]
    status: u16,
    #[serde(skip)]
    retry_after_s: Option<u32>,
    /// Dotted key of the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    key: Option<String>,
    /// The sentence.
    message: String,
    /// What would be right.
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<String>,
    /// Line of the text that was sent, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    /// What a developer of the page wants to know, and nobody else.
    #[serde(skip_serializing_if = "Option::is_none")]
    detail: Option<Box<str>>,
}

impl Fault {
    /// Status of a question or a case that is larger than is read.
    pub const TOO_LARGE: u16 = 413;
    /// Status of a question that cannot be answered as it stands.
    const UNPROCESSABLE: u16 = 422;
    const DEFECT: u16 = 500;
    const BUSY: u16 = 503;

    /// The status of HTTP.
    pub fn status(&self) -> u16 {
        self.status
    }

    /// The sentence.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What would be right.
    pub fn help(&self) -> Option<&str> {
        self.help.as_deref()
    }

    /// After how many seconds to ask again.
    pub fn retry_after_s(&self) -> Option<u32> {
        self.retry_after_s
    }

    /// A request that is not let in.
    pub fn refused(status: impl Into<u16>, message: String, help: &str) -> Self {
        Self {
            status: status.into(),
            retry_after_s: None,
            key: None,
            message,
            help: (!help.is_empty()).then(|| help.to_owned()),
            line: None,
            detail: None,
        }
    }

    /// A newer question for the same has come.
    pub fn superseded() -> Self {
        Self::busy("a newer request has taken the place of this one")
    }

    /// Too much to do at present.
    pub fn busy(message: &str) -> Self {
        Self {
            retry_after_s: Some(1),
            ..Self::refused(
                Self::BUSY,
                message.to_owned(),
                "the page asks again by itself",
            )
        }
    }

    /// A value of the case beyond what the page computes.
    pub fn of_key(key: &str, message: String, help: &str) -> Self {
        Self {
            key: Some(key.to_owned()),
            ..Self::refused(Self::UNPROCESSABLE, message, help)
        }
    }

    /// A request that cannot be read, or cannot be answered as it stands.
    pub fn bad(message: impl Into<String>) -> Self {
        Self::refused(Self::UNPROCESSABLE, message.into(), "")
    }

    /// A request in another form than that of this program's page.
    pub fn misunderstood(detail: &str) -> Self {
        Self {
            detail: Some(detail.into()),
            ..Self::refused(
                Self::UNPROCESSABLE,
                "the page and the program do not understand each other".to_owned(),
                "reload the page: it may be older than the program",
            )
        }
    }

    /// The same fault of something that the form does not show.
    pub fn without_key(self, what: &str) -> Self {
        Self {
            key: None,
            line: None,
            message: format!("{what}{}", self.message),
            ..self
        }
    }

    /// The same fault in other words.
    pub fn in_words(self, words: impl Fn(&str) -> String) -> Self {
        Self {
            message: words(&self.message),
            help: self.help.as_deref().map(words),
            ..self
        }
    }

    /// A defect of the program.
    pub fn defect(message: &str) -> Self {
        Self::refused(
            Self::DEFECT,
            message.to_owned(),
            "this is a defect of Riffel; the case in the address bar reproduces it",
        )
    }
}

impl From<CaseError> for Fault {
    fn from(error: CaseError) -> Self {
        let help = error.help().map(|help| help.to_string());
        let line = error.labels().and_then(|mut labels| {
            let offset = labels.next()?.offset();
            let source = error.source_code()?;
            let span = source.read_span(&(offset, 0).into(), 0, 0).ok()?;
            Some(span.line() + 1)
        });
        let mut cause = &error;
        if let CaseError::NotConverged(inner) = cause {
            cause = inner;
        }
        let key = match cause {
            CaseError::Invalid { key, .. } => Some(key.clone()),
            _ => None,
        };
        Self {
            status: Self::UNPROCESSABLE,
            retry_after_s: None,
            key,
            message: error.to_string(),
            help,
            line,
            detail: None,
        }
    }
}

impl From<riffel_plot::PlotError> for Fault {
    fn from(error: riffel_plot::PlotError) -> Self {
        Self::bad(format!("the figure cannot be drawn: {error}"))
    }
}

impl From<riffel_answers::AnswerError> for Fault {
    fn from(error: riffel_answers::AnswerError) -> Self {
        match error {
            riffel_answers::AnswerError::Case(error) => error.into(),
            error => Self::bad(error.to_string()),
        }
    }
}
