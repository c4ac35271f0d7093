//! What can be wrong with a study.

use std::io;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use riffel_keys::CaseError;
use thiserror::Error;

/// A study that cannot be made, gone on with or read, and why, in a sentence.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum StudyError {
    /// The plan or its case is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Plan(#[from] CaseError),

    /// A file of results cannot be read.
    #[error("cannot read {path}: {reason}", path = path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// A file of results cannot be written.
    #[error("cannot write to {path}: {reason}", path = path.display())]
    #[diagnostic(help("finished chunks are kept: the same command goes on where it stopped"))]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// The folder holds something else.
    #[error("{folder} is not empty and holds no study", folder = folder.display())]
    #[diagnostic(help("give another folder"))]
    NotAStudy {
        /// The folder.
        folder: PathBuf,
    },

    /// The folder is not there, or holds no study to read.
    #[error("{folder} holds no study: there is no study.json", folder = folder.display())]
    NoStudy {
        /// The folder.
        folder: PathBuf,
    },

    /// The folder holds the results of another plan or case.
    #[error("{folder} holds the results of another plan", folder = folder.display())]
    #[diagnostic(help("its plan.toml and case.toml say of which; give another folder for this one"))]
    OtherPlan {
        /// The folder.
        folder: PathBuf,
    },

    /// The folder was begun by another version, whose numbers may differ.
    #[error(
        "{folder} was begun by riffel {version}, and this is riffel {own}: their numbers may differ",
        folder = folder.display()
    )]
    #[diagnostic(help("finish it with that version, or give another folder"))]
    OtherVersion {
        /// The folder.
        folder: PathBuf,
        /// The version that began it.
        version: String,
        /// This version.
        own: &'static str,
    },

    /// A file of a finished chunk is not what was written.
    #[error("{path} is damaged: chunk {chunk} cannot be believed", path = path.display())]
    #[diagnostic(help("run its study again into the same folder, which computes the chunk anew"))]
    Damaged {
        /// The file.
        path: PathBuf,
        /// The chunk, from zero.
        chunk: u64,
    },

    /// A file that Riffel wrote does not read as such.
    #[error("{path} is not as Riffel writes it: {reason}", path = path.display())]
    Record {
        /// The file.
        path: PathBuf,
        /// What the reader says.
        reason: String,
    },

    /// Two folders disagree on a chunk.
    #[error(
        "{folder} has other numbers for chunk {chunk} than {into}: they were not computed by the same program",
        folder = folder.display(),
        into = into.display()
    )]
    Conflict {
        /// The folder merged.
        folder: PathBuf,
        /// Where it was to go.
        into: PathBuf,
        /// The chunk, from zero.
        chunk: u64,
    },

    /// Another run computes there.
    #[error("another run computes in {folder}", folder = folder.display())]
    #[diagnostic(help("let it come to its end, or give every run its own --shard"))]
    InUse {
        /// The folder.
        folder: PathBuf,
    },

    /// Some chunks are still to be computed.
    #[error(
        "{folder} is not finished: {missing} of {chunks} chunks are missing",
        folder = folder.display()
    )]
    #[diagnostic(help("finish it with riffel study, or merge the folders of its shards first"))]
    Incomplete {
        /// The folder.
        folder: PathBuf,
        /// Chunks to compute.
        missing: u64,
        /// Chunks of the study.
        chunks: u64,
    },

    /// An analysis that the study does not allow.
    #[error("{message}")]
    Analysis {
        /// Why not, and what to do.
        message: String,
    },

    /// An array cannot be read.
    #[error("the array {name} cannot be read: {reason}")]
    Array {
        /// Its name.
        name: String,
        /// Why not.
        reason: &'static str,
    },
}

impl StudyError {
    pub(crate) fn write(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        |reason| Self::Write { path, reason }
    }
}
