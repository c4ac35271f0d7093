//! What can go wrong besides the case file.

use std::io;
use std::path::PathBuf;

use miette::Diagnostic;
use thiserror::Error;

/// Bad input on the command line or a file that cannot be read or written.
#[derive(Debug, Error, Diagnostic)]
pub(crate) enum CliError {
    #[error("cannot write to {path}: {reason}", path = path.display())]
    Write { path: PathBuf, reason: io::Error },

    #[error("{path} is there already", path = path.display())]
    #[diagnostic(help("give another name, or --force to replace it"))]
    Exists { path: PathBuf },

    #[error("{argument} is {value}, but must be {rule}")]
    Argument {
        argument: &'static str,
        value: String,
        rule: String,
    },

    #[error(
        "--bay needs discrete supports, but track.model = \"{model}\" is the same everywhere along the rail"
    )]
    #[diagnostic(help("choose track.model = \"one-layer-periodic\" or \"two-layer-periodic\""))]
    NoBay { model: &'static str },

    #[error("--wavelength: {message}")]
    Wavelength { message: String },

    #[error("--position: {message}")]
    Position { message: String },

    #[error("{input}: {error}")]
    Physics { input: String, error: riffel::Error },

    #[error("cannot read the observations {path}: {reason}", path = path.display())]
    ReadObservations { path: PathBuf, reason: csv::Error },

    #[error("{path}, line {line}: {message}", path = path.display())]
    Observation {
        path: PathBuf,
        line: u64,
        message: String,
    },

    #[error("{error}")]
    #[diagnostic(help("choose another port, or --port 0 for any that is free"))]
    Listen { error: riffel_web::ServeError },

    #[error("{error}")]
    Serve { error: riffel_web::ServeError },

    #[error(transparent)]
    #[diagnostic(transparent)]
    Figure(#[from] riffel_figures::FigureError),

    #[error("cannot draw the figure: {0}")]
    Plot(#[from] riffel_plot::PlotError),
}
