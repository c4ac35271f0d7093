//! What went wrong, as the page shows it.

use miette::Diagnostic;
use riffel_keys::message::as_data;
use riffel_keys::text_file::in_a_message;
use riffel_keys::{CaseError, Message, say};
use serde::{Serialize, Serializer};
use serde_json::Value;

/// An error: a status of HTTP for the browser, a sentence for the reader and, where there is one, the key of the
/// case that is at fault.
#[derive(Debug)]
pub struct Fault {
    status: u16,
    retry_after_s: Option<u32>,
    /// Dotted key of the case.
    key: Option<Box<str>>,
    message: Box<Sentence>,
    /// What would be right.
    help: Option<Box<Sentence>>,
    /// Line of the text that was sent, from 1.
    line: Option<u32>,
    /// What a developer of the page wants to know, and nobody else.
    detail: Option<Box<str>>,
}

/// A sentence of this process, or one of another as it came.
#[derive(Debug)]
enum Sentence {
    Own(Message),
    OfProcess(Value),
}

impl Sentence {
    /// In English, where it is of this process.
    fn english(&self) -> String {
        match self {
            Self::Own(message) => in_a_message(&message.to_string()).into_owned(),
            Self::OfProcess(Value::String(words)) => words.clone(),
            Self::OfProcess(data) => data.to_string(),
        }
    }
}

impl From<Message> for Box<Sentence> {
    fn from(message: Message) -> Self {
        Self::new(Sentence::Own(message))
    }
}

impl Serialize for Sentence {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Own(message) => as_data(|| message.serialize(serializer)),
            Self::OfProcess(data) => data.serialize(serializer),
        }
    }
}

impl Serialize for Fault {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Document<'a> {
            #[serde(skip_serializing_if = "Option::is_none")]
            key: Option<&'a str>,
            message: &'a Sentence,
            #[serde(skip_serializing_if = "Option::is_none")]
            help: Option<&'a Sentence>,
            #[serde(skip_serializing_if = "Option::is_none")]
            line: Option<u32>,
            #[serde(skip_serializing_if = "Option::is_none")]
            detail: Option<&'a str>,
        }
        Document {
            key: self.key.as_deref(),
            message: &self.message,
            help: self.help.as_deref(),
            line: self.line,
            detail: self.detail.as_deref(),
        }
        .serialize(serializer)
    }
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
    pub fn message(&self) -> String {
        self.message.english()
    }

    /// What would be right.
    pub fn help(&self) -> Option<String> {
        self.help.as_ref().map(|help| help.english())
    }

    /// After how many seconds to ask again.
    pub fn retry_after_s(&self) -> Option<u32> {
        self.retry_after_s
    }

    /// A request that is not let in.
    pub fn refused(status: impl Into<u16>, message: impl Into<Message>, help: impl Into<Message>) -> Self {
        let help = Some(help.into()).filter(|help: &Message| !help.is_empty());
        Self {
            status: status.into(),
            retry_after_s: None,
            key: None,
            message: message.into().into(),
            help: help.map(Into::into),
            line: None,
            detail: None,
        }
    }

    /// A fault that another process told, in its sentences as data.
    pub fn of_process(message: Value, help: Option<Value>) -> Self {
        Self {
            message: Sentence::OfProcess(message).into(),
            help: help.map(|help| Sentence::OfProcess(help).into()),
            ..Self::bad("")
        }
    }

    /// A newer question for the same has come.
    pub fn superseded() -> Self {
        Self::busy(say!(newer_request))
    }

    /// Too much to do at present.
    pub fn busy(message: impl Into<Message>) -> Self {
        Self { retry_after_s: Some(1), ..Self::refused(Self::BUSY, message, say!(page_asks_again)) }
    }

    /// A value of the case beyond what the page computes.
    pub fn of_key(key: &str, message: impl Into<Message>, help: impl Into<Message>) -> Self {
        Self { key: Some(key.into()), ..Self::refused(Self::UNPROCESSABLE, message, help) }
    }

    /// A request that cannot be read, or cannot be answered as it stands.
    pub fn bad(message: impl Into<Message>) -> Self {
        Self::refused(Self::UNPROCESSABLE, message, "")
    }

    /// A request in another form than that of this program's page.
    pub fn misunderstood(detail: &str) -> Self {
        Self {
            detail: Some(detail.into()),
            ..Self::refused(Self::UNPROCESSABLE, say!(page_misunderstood), say!(reload_page))
        }
    }

    /// Fault of something that the form does not show.
    #[must_use]
    pub fn without_key(self, what: &str) -> Self {
        let message = match *self.message {
            Sentence::Own(message) => say!(place_and_fault, place = what, fault = message).into(),
            of_process => of_process.into(),
        };
        Self { key: None, line: None, message, ..self }
    }

    /// A defect of the program.
    pub fn defect(message: impl Into<Message>) -> Self {
        Self::refused(Self::DEFECT, message, say!(defect_of_riffel))
    }
}

impl From<CaseError> for Fault {
    fn from(error: CaseError) -> Self {
        let line = error.labels().and_then(|mut labels| {
            let offset = labels.next()?.offset();
            let source = error.source_code()?;
            let span = source.read_span(&(offset, 0).into(), 0, 0).ok()?;
            u32::try_from(span.line() + 1).ok()
        });
        let mut cause = &error;
        if let CaseError::NotConverged(inner) = cause {
            cause = inner;
        }
        let key = match cause {
            CaseError::Invalid { key, .. } => Some(key.as_str().into()),
            _ => None,
        };
        let help = error.advice().unwrap_or_else(|| "".into());
        Self { key, line, ..Self::refused(Self::UNPROCESSABLE, error.message(), help) }
    }
}

impl From<riffel_plot::PlotError> for Fault {
    fn from(error: riffel_plot::PlotError) -> Self {
        Self::bad(format!("the figure cannot be drawn: {error}"))
    }
}

impl From<crate::AnswerError> for Fault {
    fn from(error: crate::AnswerError) -> Self {
        match error {
            crate::AnswerError::Case(error) => error.into(),
            error => Self::bad(error.message()),
        }
    }
}
