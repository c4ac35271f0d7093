//! Strips along a line, a row for each of several dates: the data of the figure.

use crate::color::Rgb;

/// A stretch of a line with a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Where it begins, in the unit of the axis.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Its value; one that is not finite is not drawn.
    pub value: f64,
}

/// One row of strips.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StripRow {
    /// Name at its left.
    pub label: String,
    /// Its strips; what none covers stays white.
    pub strips: Vec<Strip>,
}

/// A class of values: those from the end of the class before it up to its own end.
#[derive(Debug, Clone, PartialEq)]
pub struct StripClass {
    /// Name in the legend.
    pub label: String,
    /// Largest value; infinite for the last class.
    pub to: f64,
    /// Colour.
    pub color: Rgb,
}

/// A frame with rows of strips over one line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StripPanel {
    /// Words above the panel.
    pub subtitle: String,
    /// Quantity and unit along the line.
    pub x_label: String,
    /// Rows from top to bottom.
    pub rows: Vec<StripRow>,
}

/// Panels of strips, one below the other, with one legend of classes.
///
/// Strips narrower than a pixel share it, and the largest value of a pixel is drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StripFigure {
    /// Title above the figure.
    pub title: String,
    /// Words below the figure.
    pub caption: String,
    /// Classes in the order of their ends.
    pub classes: Vec<StripClass>,
    /// The panels.
    pub panels: Vec<StripPanel>,
}
