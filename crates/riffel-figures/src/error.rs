//! Why a figure or a table could not be made.

use miette::Diagnostic;
use riffel_keys::CaseError;
use riffel_plot::PlotError;
use thiserror::Error;

/// Why a figure or a table could not be made.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum FigureError {
    /// The case of the figure is at fault.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),

    /// A value is outside the range of the physics.
    #[error("{0}")]
    Physics(#[from] riffel::Error),

    /// The figure cannot be drawn.
    #[error("cannot draw the figure: {0}")]
    Plot(#[from] PlotError),

    /// The table cannot be written.
    #[error("cannot write the table of the figure: {0}")]
    Table(String),

    /// The gridded file cannot be written.
    #[error("cannot write the gridded file: {0}")]
    Grid(String),
}
