//! What can be wrong with the data of a figure, and with drawing it.

use thiserror::Error;

/// Why a figure could not be drawn.
///
/// Missing values are not errors: a cell that is not finite is drawn as "not computed", a sample
/// that is not finite breaks its line. Only data that contradict themselves are refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PlotError {
    /// The figure has no panel.
    #[error("the figure has no panel: give it at least one")]
    NoPanel,

    /// The number of values does not equal the number of speeds times the number of wavelengths.
    #[error(
        "panel {panel}: {what} holds {found} numbers, but {rows} speeds × {columns} wavelengths need {}",
        rows * columns
    )]
    GridShape {
        /// Index of the panel, from 0.
        panel: usize,
        /// Name of the field of the panel.
        what: &'static str,
        /// Number of values found.
        found: usize,
        /// Number of speeds.
        rows: usize,
        /// Number of wavelengths.
        columns: usize,
    },

    /// A map needs at least two grid points along each axis.
    #[error("panel {panel}: {axis} has {found} grid points; a map needs at least 2")]
    TooFewGridPoints {
        /// Index of the panel, from 0.
        panel: usize,
        /// Name of the axis.
        axis: &'static str,
        /// Number of grid points found.
        found: usize,
    },

    /// The grid points of a map axis are positive, finite and strictly increasing.
    #[error(
        "panel {panel}: {axis}[{index}] = {value} is out of order; grid points must be positive, finite and increasing"
    )]
    GridOrder {
        /// Index of the panel, from 0.
        panel: usize,
        /// Name of the axis.
        axis: &'static str,
        /// Index of the offending grid point.
        index: usize,
        /// The offending grid point, SI unit of the axis.
        value: f64,
    },

    /// The two coordinates of a line have different numbers of samples.
    #[error("panel {panel}: series \"{label}\" has {x_count} x values and {y_count} y values; they must be as many")]
    SeriesLength {
        /// Index of the panel, from 0.
        panel: usize,
        /// Label of the series.
        label: String,
        /// Number of abscissae.
        x_count: usize,
        /// Number of ordinates.
        y_count: usize,
    },

    /// A given axis range is empty, not finite, or not positive on a logarithmic axis.
    #[error("panel {panel}: the {axis} range {low} … {high} cannot be drawn on a {scale} axis")]
    AxisRange {
        /// Index of the panel, from 0.
        panel: usize,
        /// `"x"` or `"y"`.
        axis: &'static str,
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
        /// `"linear"` or `"logarithmic"`.
        scale: &'static str,
    },

    /// A picture of this size cannot be rendered.
    #[error("a picture of {width} × {height} pixels cannot be rendered; each side must be 1 to {limit}")]
    PictureSize {
        /// Width in pixels.
        width: f64,
        /// Height in pixels.
        height: f64,
        /// Longest side allowed, pixels.
        limit: u32,
    },

    /// A drawing library failed; this is a defect of Riffel, not of the data.
    #[error("the drawing library failed: {reason}")]
    Drawing {
        /// What the library says.
        reason: String,
    },
}
