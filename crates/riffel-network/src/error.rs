//! What can be wrong with a network.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use riffel_keys::{CaseError, Message};
use thiserror::Error;

/// What is wrong with surveys, by the file of their record.
pub(crate) type Damage = BTreeMap<PathBuf, NetworkError>;

/// A store that cannot be made, read or added to, and why, in a sentence.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum NetworkError {
    /// A file that is read is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Input(#[from] CaseError),

    /// A file of the store cannot be read.
    #[error("cannot read {path}: {reason}", path = path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// A file of the store cannot be written.
    #[error("cannot write to {path}: {reason}", path = path.display())]
    #[diagnostic(help("surveys are there whole or not at all: the same command does it anew"))]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// The folder holds no network.
    #[error("{folder} holds no network: there is no network.json", folder = folder.display())]
    #[diagnostic(help("`riffel network ingest` makes one in a new or empty folder"))]
    NoNetwork {
        /// The folder.
        folder: PathBuf,
    },

    /// The folder holds something else.
    #[error("{folder} is not empty and holds no network", folder = folder.display())]
    #[diagnostic(help("give another folder"))]
    NotANetwork {
        /// The folder.
        folder: PathBuf,
    },

    /// Something stands where the store has a file or folder of its own.
    #[error("{path} is a link, or was not written by riffel, and stays as it is", path = path.display())]
    #[diagnostic(help("move it away, or give another folder"))]
    Foreign {
        /// The file, folder or link.
        path: PathBuf,
    },

    /// Another process adds to the store.
    #[error("another process adds to {folder} at this moment", folder = folder.display())]
    Locked {
        /// The folder.
        folder: PathBuf,
    },

    /// A file of the store is not what was written.
    #[error("{path} is damaged: {reason}", path = path.display())]
    #[diagnostic(help("ingest the survey again, with --replace"))]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },

    /// What the store says of itself is not what was written.
    #[error("{path} is damaged: {reason}", path = path.display())]
    #[diagnostic(help("restore it from a copy: it says what cells and bands the store has"))]
    DamagedStore {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },

    /// Surveys are lost or damaged.
    #[error("surveys that are damaged or lost: {damaged}")]
    #[diagnostic(help("ingest each again, with --replace"))]
    NotWhole {
        /// How many.
        damaged: usize,
    },

    /// The line has another survey of the date.
    #[error("{line} has another survey of {date} already, from {source_name}")]
    #[diagnostic(help("--replace puts this one in its place"))]
    Conflict {
        /// The line.
        line: String,
        /// The date.
        date: String,
        /// The file it came from.
        source_name: String,
    },

    /// A value that is not allowed.
    #[error("{what} is {value}, but must be {rule}")]
    Value {
        /// What it is.
        what: &'static str,
        /// The value.
        value: String,
        /// What is allowed.
        rule: String,
    },

    /// A date that cannot be read.
    #[error("the date {0}")]
    Date(Message),

    /// A limit table that does not fit the store.
    #[error("the limit \"{name}\" {reason}")]
    Limit {
        /// Name of the table.
        name: String,
        /// Why not.
        reason: String,
    },

    /// What was asked cannot be answered by what is there.
    #[error("{0}")]
    Nothing(String),
}

impl NetworkError {
    pub(crate) fn read(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        |reason| Self::Read { path, reason }
    }

    pub(crate) fn write(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        |reason| Self::Write { path, reason }
    }

    /// That a store has nothing of a name.
    pub(crate) fn not_there<'a>(what: &'static str, asked: &str, known: impl Iterator<Item = &'a str>) -> Self {
        let known: BTreeSet<&str> = known.collect();
        let known: Vec<&str> = known.into_iter().collect();
        Self::Value {
            what,
            value: format!("\"{asked}\""),
            rule: match known[..] {
                [] => "one of those in the store, which has no survey".to_owned(),
                _ => format!("one of those in the store: {}", known.join(", ")),
            },
        }
    }
}
