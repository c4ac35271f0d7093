//! Why there is no answer.

use std::path::PathBuf;

use miette::Diagnostic;
use riffel_calibrate::CalibrationError;
use riffel_curving::profile::ProfileError;
use riffel_keys::{CaseError, Message, say};
use riffel_plot::PlotError;
use riffel_study::StudyError;
use thiserror::Error;

use crate::QUESTIONS;

/// An answer or a part of it, or why there is none.
pub type Result<T, E = AnswerError> = std::result::Result<T, E>;

/// Why there is no answer, or no figure or table of it.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum AnswerError {
    /// A file is at fault.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),

    /// A key of the case that an option has set cannot have this value.
    #[error("{option}: {message}")]
    Option {
        /// The option.
        option: &'static str,
        /// What is wrong.
        message: Message,
    },

    /// A calibration is not there, or not finished.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Calibration(Box<CalibrationError>),

    /// A store of surveys cannot be made, read or added to.
    #[error(transparent)]
    #[diagnostic(transparent)]
    #[cfg(not(target_family = "wasm"))]
    Network(Box<riffel_network::NetworkError>),

    /// A value is outside the range of the physics.
    #[error("{0}")]
    Physics(#[from] riffel::Error),

    /// Wheels and rails that do not touch.
    #[error("{0}")]
    Profile(ProfileError),

    /// What was asked is out of the question; the name is that of the argument of the program.
    #[error("{argument} is {value}, but must be {rule}")]
    Argument {
        /// The argument.
        argument: &'static str,
        /// Its value.
        value: String,
        /// What it must be.
        rule: String,
    },

    /// A value of an argument that cannot be taken as it is written.
    #[error("{argument}{message}")]
    Range {
        /// The argument.
        argument: &'static str,
        /// After the name of the argument, with what separates it.
        message: String,
    },

    /// A key of a question is unknown, missing or of the wrong kind.
    #[error("{message}")]
    #[diagnostic(help("{}", keys_are_told_by(question)))]
    Question {
        /// The name of the question.
        question: &'static str,
        /// The sentence.
        message: String,
    },

    /// A line of a table of observations is wrong.
    #[error("{path}, line {line}: {message}", path = path.display())]
    Observation {
        /// The file.
        path: PathBuf,
        /// The line.
        line: usize,
        /// What is wrong.
        message: String,
    },

    /// A model of the field was named that cannot be read from the case.
    #[error("{model} is not on this case: {reason}")]
    NotOnCase {
        /// The name of the model.
        model: &'static str,
        /// What it needs, or what is wrong under it.
        reason: String,
    },

    /// A forecast was asked for without a spectrum to begin with.
    #[error("a forecast needs a spectrum: one that was measured, or that of a rail that will be ground")]
    NoSpectrum,

    /// No rail has a band in the window of wavelengths of the case.
    #[error("the spectrum has no band in map.wavelength of the case: {0}")]
    OutsideWindow(riffel::Error),

    /// Months were asked of traffic that does not say how much of it there is.
    #[error("months need traffic with passages_per_day or mgt_per_year under [line]")]
    NoPassagesPerDay,

    /// Growth over the bay was asked of a track without one.
    #[error("--bay needs discrete supports, but track.model = \"{model}\" is the same everywhere along the rail")]
    #[diagnostic(help("choose track.model = \"one-layer-periodic\" or \"two-layer-periodic\""))]
    NoBay {
        /// The model of the track.
        model: &'static str,
    },

    /// The wheels of a curve were asked of a case that has none.
    #[error("the wheels of a curve need contact.from, which says of which vehicle they are")]
    #[diagnostic(help(
        "give [curve], [bogie], [profiles] and contact.from = {{ wheelset = 1, rail = \"low\" }}, as cases/metro-curve.toml does"
    ))]
    NoCurve,

    /// A study cannot be read, made or gone on with.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Study(Box<StudyError>),

    /// The threads that were asked for cannot be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// How many.
        threads: u16,
        /// Why not.
        reason: String,
    },

    /// What keeps its work in a folder was asked of whom has none.
    #[error("{question} keeps its work in a folder: run `riffel {question}`")]
    InFolder {
        /// The name of the question.
        question: &'static str,
    },

    /// Work ended early, as it was asked to.
    #[error("{0}")]
    Stopped(Message),

    /// What is asked about is not whole yet.
    #[error("{0}")]
    Unfinished(Message),

    /// The figure cannot be drawn.
    #[error("cannot draw the figure: {0}")]
    Plot(#[from] PlotError),

    /// The gridded file cannot be written.
    #[error("cannot write the gridded file: {0}")]
    Grid(String),
}

/// What says which keys a question takes: those of the page are no commands.
fn keys_are_told_by(question: &str) -> String {
    match QUESTIONS.iter().any(|known| known.name() == question) {
        true => {
            format!("`riffel {question} --help` says what each takes, `riffel schema --question {question}` as JSON")
        }
        false => format!("`riffel schema --question {question}` says as JSON what each takes"),
    }
}

impl From<CalibrationError> for AnswerError {
    fn from(error: CalibrationError) -> Self {
        Self::Calibration(Box::new(error))
    }
}

impl From<StudyError> for AnswerError {
    fn from(error: StudyError) -> Self {
        Self::Study(Box::new(error))
    }
}

#[cfg(not(target_family = "wasm"))]
impl From<riffel_network::NetworkError> for AnswerError {
    fn from(error: riffel_network::NetworkError) -> Self {
        Self::Network(Box::new(error))
    }
}

impl AnswerError {
    /// That an argument of the program has a value out of the question, and what it must be.
    pub(crate) fn argument(argument: &'static str, value: impl ToString, rule: impl Into<String>) -> Self {
        Self::Argument { argument, value: value.to_string(), rule: rule.into() }
    }

    /// What is wrong; what no case is at fault for is English.
    pub fn message(&self) -> Message {
        match self {
            Self::Case(error) => error.message(),
            Self::Physics(error) => error.into(),
            Self::Profile(error) => error.into(),
            Self::Stopped(message) | Self::Unfinished(message) => message.clone(),
            Self::Option { option, message } => say!(place_and_fault, place = *option, fault = message),
            other => Message::verbatim(other.to_string()),
        }
    }
}
