//! What went wrong, as the page shows it.

use miette::Diagnostic;
use riffel_keys::message::{Translations, translations};
use riffel_keys::text_file::in_a_message;
use riffel_keys::{CaseError, Message, say};
use serde::{Serialize, Serializer};

/// An error: a status of HTTP for the browser, a sentence for the reader and, where there is one, the key of the
/// case that is at fault.
#[derive(Debug)]
pub struct Fault {
    status: u16,
    retry_after_s: Option<u32>,
    /// Dotted key of the case.
    key: Option<Box<str>>,
    /// The sentence.
    message: Message,
    /// What would be right, or nothing.
    help: Box<Message>,
    /// Line of the text that was sent, from 1.
    line: Option<u32>,
    /// The German of both and their pieces, where another process said them.
    known: Option<Box<Translations>>,
    /// What a developer of the page wants to know, and nobody else.
    detail: Option<Box<str>>,
}

/// A message as it is shown.
fn shown(message: &Message) -> String {
    in_a_message(&message.to_string()).into_owned()
}

impl Serialize for Fault {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Document<'a> {
            #[serde(skip_serializing_if = "Option::is_none")]
            key: Option<&'a str>,
            message: String,
            #[serde(skip_serializing_if = "Option::is_none")]
            help: Option<String>,
            #[serde(skip_serializing_if = "Option::is_none")]
            line: Option<u32>,
            #[serde(flatten)]
            known: Translations,
            #[serde(skip_serializing_if = "Option::is_none")]
            detail: Option<&'a str>,
        }
        let own = || translations([&self.message, &*self.help]);
        Document {
            key: self.key.as_deref(),
            message: self.message(),
            help: self.help(),
            line: self.line,
            known: self.known.as_deref().cloned().unwrap_or_else(own),
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
        shown(&self.message)
    }

    /// What would be right.
    pub fn help(&self) -> Option<String> {
        (!self.help.is_empty()).then(|| shown(&self.help))
    }

    /// After how many seconds to ask again.
    pub fn retry_after_s(&self) -> Option<u32> {
        self.retry_after_s
    }

    /// A request that is not let in.
    pub fn refused(status: impl Into<u16>, message: impl Into<Message>, help: impl Into<Message>) -> Self {
        Self {
            status: status.into(),
            retry_after_s: None,
            key: None,
            message: message.into(),
            help: Box::new(help.into()),
            line: None,
            known: None,
            detail: None,
        }
    }

    /// The same fault with what is known of its sentences.
    #[must_use]
    pub fn with_translations(self, known: Translations) -> Self {
        Self { known: Some(known.into()), ..self }
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

    /// The same fault of something that the form does not show.
    #[must_use]
    pub fn without_key(self, what: &str) -> Self {
        Self { key: None, line: None, message: say!(place_and_fault, place = what, fault = self.message), ..self }
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

impl From<riffel_answers::AnswerError> for Fault {
    fn from(error: riffel_answers::AnswerError) -> Self {
        match error {
            riffel_answers::AnswerError::Case(error) => error.into(),
            error => Self::bad(error.message()),
        }
    }
}
