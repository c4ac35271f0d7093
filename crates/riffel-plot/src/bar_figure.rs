//! Horizontal bars, a row for each of several things: the data of the figure.

use crate::color::Rgb;

/// How the bars of a row stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BarArrangement {
    /// One below the other: several measures of the same thing.
    #[default]
    SideBySide,
    /// On one line, as a tornado has them: what happens one way and the other.
    OnOneLine,
}

/// A bar from the base line of its panel to a value.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bar {
    /// Where it ends; a value that is not finite has no bar.
    pub value: f64,
    /// Interval of confidence, drawn as a whisker.
    pub interval: Option<(f64, f64)>,
    /// Words at its end.
    pub note: String,
}

/// Bars of one kind, one for each row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BarSeries {
    /// Name in the legend.
    pub label: String,
    /// Its bars, as many as there are rows.
    pub bars: Vec<Bar>,
    /// Colour; None takes the next one of [`OKABE_ITO`](crate::OKABE_ITO).
    pub color: Option<Rgb>,
}

/// A frame with rows of bars.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BarPanel {
    /// Words above the panel.
    pub subtitle: String,
    /// Quantity and unit of the bars.
    pub x_label: String,
    /// Range of the bars; None shows all of them.
    pub x_range: Option<(f64, f64)>,
    /// Where bars begin.
    pub base: f64,
    /// Names of the rows from top to bottom.
    pub rows: Vec<String>,
    /// The bars.
    pub series: Vec<BarSeries>,
    /// How the bars of a row stand.
    pub arrangement: BarArrangement,
}

/// One or more panels of bars, one below the other.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BarFigure {
    /// Title above the figure.
    pub title: String,
    /// Words below the figure.
    pub caption: String,
    /// The panels.
    pub panels: Vec<BarPanel>,
}
