//! What can be wrong with a calibration.

use std::io;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use riffel_keys::CaseError;
use thiserror::Error;

/// A calibration that cannot be made or gone on with, and why, in a sentence.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum CalibrationError {
    /// The plan, its case or its data are wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Plan(#[from] CaseError),

    /// A file of results cannot be written.
    #[error("cannot write to {path}: {reason}", path = path.display())]
    #[diagnostic(help("finished parts of the chains are kept: --restart goes on from there"))]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// A file of results cannot be read.
    #[error("cannot read {path}: {reason}", path = path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },

    /// The folder holds something else.
    #[error("{folder} is not empty and holds no calibration", folder = folder.display())]
    #[diagnostic(help("give another folder"))]
    NoCalibration {
        /// The folder.
        folder: PathBuf,
    },

    /// The folder holds the chains of another plan.
    #[error(
        "{folder} holds the chains of another plan, case or data, or of another version",
        folder = folder.display()
    )]
    #[diagnostic(help(
        "riffel calibrate PLAN --restart puts those of this plan in their place; another folder keeps both"
    ))]
    OtherPlan {
        /// The folder.
        folder: PathBuf,
    },

    /// The draws for ArviZ are those of another plan.
    #[error(
        "the draws in {path} are those of another plan than the chains beside it",
        path = path.display()
    )]
    #[diagnostic(help("riffel calibrate PLAN --restart writes them anew"))]
    OtherDraws {
        /// The tree of arrays.
        path: PathBuf,
    },

    /// Another run draws there.
    #[error("another run draws chains in {folder}", folder = folder.display())]
    #[diagnostic(help("let it come to its end, or give another folder"))]
    InUse {
        /// The folder.
        folder: PathBuf,
    },

    /// The folder holds nothing to decide or forecast by.
    #[error("{folder} holds no calibration", folder = folder.display())]
    #[diagnostic(help("riffel calibrate PLAN -o DIR makes one"))]
    NotThere {
        /// The folder.
        folder: PathBuf,
    },

    /// The chains or the results are not whole.
    #[error("the chains or the results in {folder} are not whole", folder = folder.display())]
    #[diagnostic(help("finish them by riffel calibrate PLAN --restart"))]
    Unfinished {
        /// The folder.
        folder: PathBuf,
    },

    /// Draws that tell nothing of what is asked.
    #[error("{0}")]
    Refused(String),

    /// The case takes no values of the priors.
    #[error("the case takes none of 200 draws of the priors: {reason}")]
    #[diagnostic(help("narrow the priors, or cut them off by min and max"))]
    NoStart {
        /// What it says of the last.
        reason: String,
    },
}

impl CalibrationError {
    pub(crate) fn write(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        |reason| Self::Write { path, reason }
    }
}
