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

    #[error("only one file can be -, standard input")]
    StandardInput,

    #[error("the question on standard input cannot be read: {reason}")]
    #[diagnostic(help("it is a JSON object; `riffel schema --question NAME` tells its keys"))]
    ReadQuestion { reason: io::Error },

    #[error("{message}")]
    #[diagnostic(help("`riffel schema --question NAME` tells the keys of a question"))]
    Question { message: String },

    #[error("cannot write to standard output: {reason}")]
    StandardOutput { reason: io::Error },

    #[error("{path} is {what}; only a regular file is replaced by another", path = path.display())]
    NotAFile { path: PathBuf, what: &'static str },

    #[error("{path} is {what}, not a folder for results", path = path.display())]
    NotAFolder { path: PathBuf, what: &'static str },

    #[error("{path} is read by this command, and an input is never replaced", path = path.display())]
    #[diagnostic(help("give another name with --output"))]
    IsAnInput { path: PathBuf },

    #[error("{path} is there already and was not written by Riffel", path = path.display())]
    #[diagnostic(help(
        "give another folder with --output, or move the file away; riffel-manifest.json lists what Riffel wrote"
    ))]
    Foreign { path: PathBuf },

    #[error("{path} is no list of files that Riffel wrote: {reason}", path = path.display())]
    #[diagnostic(help("give another folder with --output, or move the file away"))]
    Manifest { path: PathBuf, reason: io::Error },

    #[error("{path} cannot be gone on from: {reason}", path = path.display())]
    #[diagnostic(help("give another folder with --output, or remove the file to begin anew"))]
    State { path: PathBuf, reason: String },

    #[error("{path} is there already", path = path.display())]
    #[diagnostic(help("give another name, or {way_out}"))]
    Exists { path: PathBuf, way_out: &'static str },

    #[error("{argument} is {value}, but must be {rule}")]
    Argument { argument: &'static str, value: String, rule: String },

    #[error("{error}")]
    #[diagnostic(help("choose another port, or --port 0 for any that is free"))]
    Listen { error: riffel_web::ServeError },

    #[error("{error}")]
    Serve { error: riffel_web::ServeError },

    #[error("this program was built without the WebAssembly module that the page in one file needs")]
    #[diagnostic(help(
        "in the sources of Riffel run `cargo xtask page` and build the program anew, or give the module with --module; \
         the programs of a release have it"
    ))]
    NoModule,

    #[error("cannot read the module {path}: {reason}", path = path.display())]
    ReadModule { path: PathBuf, reason: io::Error },

    #[error("{message}")]
    Page {
        message: String,
        #[help]
        help: Option<String>,
    },

    #[error(transparent)]
    #[diagnostic(transparent)]
    Answer(#[from] riffel_answers::AnswerError),

    #[error("cannot draw the figure: {0}")]
    Plot(#[from] riffel_plot::PlotError),
}
