//! Curves over a common abscissa: the data of the figure.

use crate::color::Rgb;
use crate::error::PlotError;
use crate::scale::Scale;

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineStyle {
    /// An unbroken line.
    #[default]
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Open marks at the samples, without a line.
    Markers,
}

/// How the panels of a figure stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Arrangement {
    /// Two in a row.
    #[default]
    SideBySide,
    /// One below the other.
    Stacked,
    /// One below the other, wide and low: profiles along a rail.
    Strips,
}

/// A curve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Name in the legend; without a name the series has no entry there.
    pub label: String,
    /// Abscissae, in the unit the axis names.
    pub x: Vec<f64>,
    /// Ordinates, as many as abscissae. A sample that is not finite, or not positive on a
    /// logarithmic axis, breaks the line.
    pub y: Vec<f64>,
    /// How the series is drawn.
    pub style: LineStyle,
    /// Colour; None takes the next one of [`OKABE_ITO`](crate::OKABE_ITO).
    pub color: Option<Rgb>,
}

/// The area between two curves, such as a band that holds half of all samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// Name in the legend; without a name the area has no entry there.
    pub label: String,
    /// Abscissae, in the unit the axis names.
    pub x: Vec<f64>,
    /// Ordinates of the lower curve, as many as abscissae.
    pub low: Vec<f64>,
    /// Ordinates of the upper curve, as many.
    pub high: Vec<f64>,
    /// Colour; light, since curves and areas lie on it.
    pub color: Rgb,
}

/// A place on the abscissa with a name, such as a resonance.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Abscissa, in the unit the axis names.
    pub x: f64,
    /// Its name.
    pub label: String,
}

/// A pair of axes with curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LinePanel {
    /// Words above the panel.
    pub subtitle: String,
    /// Quantity and unit of the abscissa, such as "speed V \[m/s\]".
    pub x_label: String,
    /// Quantity and unit of the ordinate.
    pub y_label: String,
    /// Spacing of the abscissa.
    pub x_scale: Scale,
    /// Spacing of the ordinate.
    pub y_scale: Scale,
    /// Range of the abscissa; None shows all samples.
    pub x_range: Option<(f64, f64)>,
    /// Range of the ordinate; None shows all samples within the range of the abscissa.
    pub y_range: Option<(f64, f64)>,
    /// The curves, later ones on top.
    pub series: Vec<Series>,
    /// Named places, drawn as upright lines below the curves.
    pub marks: Vec<Mark>,
    /// Areas below the curves, later ones on top.
    pub areas: Vec<Area>,
}

/// One or more panels of curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LineFigure {
    /// Title above the figure.
    pub title: String,
    /// Words below the figure: the parameters and the sign convention.
    pub caption: String,
    /// The panels.
    pub panels: Vec<LinePanel>,
    /// How the panels stand.
    pub arrangement: Arrangement,
}

impl Series {
    /// An unbroken curve of some abscissae and as many ordinates, in the next colour.
    pub fn new(label: impl Into<String>, x: Vec<f64>, y: Vec<f64>) -> Self {
        Self { label: label.into(), x, y, ..Self::default() }
    }

    /// Curve in a style.
    pub fn styled(self, style: LineStyle) -> Self {
        Self { style, ..self }
    }

    /// Curve in a colour.
    pub fn colored(self, color: Rgb) -> Self {
        Self { color: Some(color), ..self }
    }
}

impl LineFigure {
    /// Panels side by side below a title and above a caption.
    pub fn new(
        title: impl Into<String>,
        caption: impl Into<String>,
        panels: impl IntoIterator<Item = LinePanel>,
    ) -> Self {
        Self {
            title: title.into(),
            caption: caption.into(),
            panels: panels.into_iter().collect(),
            arrangement: Arrangement::SideBySide,
        }
    }

    /// Figure with its panels arranged otherwise.
    pub fn arranged(self, arrangement: Arrangement) -> Self {
        Self { arrangement, ..self }
    }

    pub(crate) fn check(&self) -> Result<(), PlotError> {
        if self.panels.is_empty() {
            return Err(PlotError::NoPanel);
        }
        self.panels.iter().enumerate().try_for_each(|(index, panel)| panel.check(index))
    }
}

impl LinePanel {
    /// Curves on linear axes, each named with its unit.
    pub fn new(
        x_label: impl Into<String>,
        y_label: impl Into<String>,
        series: impl IntoIterator<Item = Series>,
    ) -> Self {
        Self {
            x_label: x_label.into(),
            y_label: y_label.into(),
            series: series.into_iter().collect(),
            ..Self::default()
        }
    }

    /// Panel with a line of words above it.
    pub fn titled(self, subtitle: impl Into<String>) -> Self {
        Self { subtitle: subtitle.into(), ..self }
    }

    /// Panel with a spacing for each axis.
    pub fn scaled(self, x_scale: Scale, y_scale: Scale) -> Self {
        Self { x_scale, y_scale, ..self }
    }

    fn check(&self, panel: usize) -> Result<(), PlotError> {
        for series in &self.series {
            let (x_count, y_count) = (series.x.len(), series.y.len());
            if x_count != y_count {
                return Err(PlotError::SeriesLength { panel, label: series.label.clone(), x_count, y_count });
            }
        }
        for area in &self.areas {
            let (x_count, y_count) = (area.x.len(), area.low.len().min(area.high.len()));
            if x_count != y_count || area.low.len() != area.high.len() {
                return Err(PlotError::SeriesLength { panel, label: area.label.clone(), x_count, y_count });
            }
        }
        for (axis, scale, range) in [("x", self.x_scale, self.x_range), ("y", self.y_scale, self.y_range)] {
            if let Some((low, high)) = range
                && !(scale.admits(low) && scale.admits(high) && low < high)
            {
                return Err(PlotError::AxisRange { panel, axis, low, high, scale: scale.name() });
            }
        }
        Ok(())
    }

    /// Range of the abscissa: as given, or that of the samples.
    pub(crate) fn drawn_x_range(&self) -> (f64, f64) {
        self.x_range.unwrap_or_else(|| self.x_scale.range_of(self.samples().map(|sample| sample.0)))
    }

    /// Range of the ordinate: as given, or that of the samples in sight with a little air.
    pub(crate) fn drawn_y_range(&self) -> (f64, f64) {
        let (low, high) = self.drawn_x_range();
        let seen = self.samples().filter(|sample| low <= sample.0 && sample.0 <= high).map(|sample| sample.1);
        self.y_range.unwrap_or_else(|| self.y_scale.with_air(self.y_scale.range_of(seen)))
    }

    /// Whether the ordinate is an angle in degrees.
    pub(crate) fn y_is_angle(&self) -> bool {
        self.y_label.contains('°')
    }

    /// Samples that can be drawn.
    fn samples(&self) -> impl Iterator<Item = (f64, f64)> {
        let curve = |x: &'_ [f64], y: &'_ [f64]| x.iter().copied().zip(y.iter().copied()).collect::<Vec<_>>();
        self.series
            .iter()
            .map(move |series| curve(&series.x, &series.y))
            .chain(self.areas.iter().flat_map(move |area| [curve(&area.x, &area.low), curve(&area.x, &area.high)]))
            .flatten()
            .filter(|&(x, y)| self.admits(x, y))
    }

    /// Whether a series has anything to show: without, it has no place in a legend.
    pub(crate) fn shows(&self, series: &Series) -> bool {
        let mut samples = series.x.iter().zip(&series.y);
        samples.any(|(&x, &y)| self.admits(x, y))
    }

    /// Digits that tell the samples of an axis apart, for words under the pointer: five of its range.
    pub(crate) fn digits((low, high): (f64, f64), scale: Scale) -> usize {
        let ratio = match scale {
            Scale::Linear => low.abs().max(high.abs()) / (high - low),
            Scale::Log => 1.0,
        };
        5 + ratio.log10().clamp(0.0, 10.0).floor() as usize
    }

    /// Whether a sample can be drawn.
    pub(crate) fn admits(&self, x: f64, y: f64) -> bool {
        self.x_scale.admits(x) && self.y_scale.admits(y)
    }
}
