//! Curves as pages.

use serde_json::{Value, json};

use super::html::{self, PagePanel, PageStage, coordinates, words};
use crate::drawing::axis::degree_step;
use crate::drawing::line::series_color;
use crate::drawing::marker::Marker;
use crate::error::PlotError;
use crate::line_figure::{Area, Arrangement, LineFigure, LinePanel, LineStyle, Mark, Series};
use crate::scale::Scale;

impl LineFigure {
    /// The figure as a page of HTML that shows the numbers under the pointer. It carries everything
    /// it needs and loads nothing. Identical data give identical text.
    ///
    /// # Errors
    /// Errors of [`picture`](LineFigure::picture).
    pub fn html(&self) -> Result<String, PlotError> {
        html_of_stages(&[("", self)])
    }
}

/// Figures with their names as one page with a slider, which begins at the last; title, caption and arrangement are its. Axes should
/// have their ranges given, so that they stay.
///
/// # Errors
/// [`PlotError::NoPanel`] without a figure, otherwise as [`picture`](LineFigure::picture).
pub fn html_of_stages(stages: &[(&str, &LineFigure)]) -> Result<String, PlotError> {
    let (_, last) = stages.last().ok_or(PlotError::NoPanel)?;
    let stages: Result<Vec<PageStage>, PlotError> = stages
        .iter()
        .map(|(name, figure)| {
            figure.check()?;
            Ok(PageStage { name: (*name).to_owned(), panels: figure.panels.iter().map(page_panel).collect() })
        })
        .collect();
    Ok(html::page(&last.title, &last.caption, last.arrangement != Arrangement::SideBySide, &stages?))
}

fn page_panel(panel: &LinePanel) -> PagePanel {
    let curves = panel.series.iter().enumerate();
    let curves = curves.map(|(index, series)| trace(panel, series, index));
    let data = panel.areas.iter().flat_map(edges).chain(curves).collect();
    let x = axis(&panel.x_label, panel.x_scale, panel.drawn_x_range());
    let (low, high) = panel.drawn_y_range();
    let mut y = axis(&panel.y_label, panel.y_scale, (low, high));
    if panel.y_is_angle() && panel.y_scale == Scale::Linear {
        y["dtick"] = json!(degree_step(high - low, 8));
    }
    let mut layout = html::layout(&panel.subtitle, x, y);
    layout["shapes"] = panel.marks.iter().map(upright).collect();
    layout["annotations"] = panel.marks.iter().map(|mark| name(mark, panel.x_scale)).collect();
    PagePanel { data, layout, hover: Value::Null }
}

/// The two edges of an area, filled between.
fn edges(area: &Area) -> [Value; 2] {
    let edge = |y: &[f64], fill: Value, named: bool| {
        json!({
            "type": "scatter", "mode": "lines", "name": words(&area.label), "showlegend": named,
            "x": coordinates(area.x.iter().copied()), "y": coordinates(y.iter().copied()),
            "line": { "width": 0, "color": area.color.hex() }, "fill": fill,
            "fillcolor": area.color.hex(), "hovertemplate": "%{x:.5g}, %{y:.5g}",
        })
    };
    let labelled = !area.label.is_empty();
    [edge(&area.low, Value::Null, false), edge(&area.high, json!("tonexty"), labelled)]
}

/// The line of a mark.
fn upright(mark: &Mark) -> Value {
    json!({ "type": "line", "layer": "below", "xref": "x", "yref": "paper", "x0": mark.x, "x1": mark.x,
        "y0": 0, "y1": 1, "line": { "width": 1, "dash": "dot", "color": "#555555" } })
}

/// The name of a mark; plotly places words on a logarithmic axis by the logarithm.
fn name(mark: &Mark, scale: Scale) -> Value {
    let x = match scale {
        Scale::Linear => mark.x,
        Scale::Log => mark.x.log10(),
    };
    json!({ "text": words(&mark.label), "showarrow": false, "textangle": -90, "xref": "x", "yref": "paper",
        "x": x, "y": 0.01, "xanchor": "right", "yanchor": "bottom", "font": { "size": 11 } })
}

fn axis(title: &str, scale: Scale, (low, high): (f64, f64)) -> Value {
    let mut axis = html::axis(title);
    axis["exponentformat"] = json!("power");
    match scale {
        Scale::Linear => axis["range"] = coordinates([low, high]),
        Scale::Log => {
            axis["type"] = json!("log");
            axis["range"] = coordinates([low.log10(), high.log10()]);
            axis["minor"] = json!({ "ticks": "inside", "showgrid": true, "gridcolor": "#f2f2f2" });
            if high / low > 30.0 {
                axis["dtick"] = json!(1);
            }
        }
    }
    axis
}

fn trace(panel: &LinePanel, series: &Series, index: usize) -> Value {
    let color = series_color(series, index).hex();
    // What cannot be drawn becomes null, which breaks the line.
    let drawn = |value: f64, x: f64, y: f64| if panel.admits(x, y) { value } else { f64::NAN };
    let digits = LinePanel::digits(panel.drawn_x_range(), panel.x_scale);
    let pairs = || series.x.iter().copied().zip(series.y.iter().copied());
    let mut trace = json!({
        "type": "scatter", "name": words(&series.label), "showlegend": !series.label.is_empty() && panel.shows(series),
        "x": coordinates(pairs().map(|(x, y)| drawn(x, x, y))), "y": coordinates(pairs().map(|(x, y)| drawn(y, x, y))),
        "hovertemplate": format!("%{{x:.{digits}~g}}, %{{y:.5g}}"), "connectgaps": false,
    });
    let dash = match series.style {
        LineStyle::Solid => "solid",
        LineStyle::Dashed => "dash",
        LineStyle::Dotted => "dot",
        LineStyle::Markers => {
            trace["mode"] = json!("markers");
            trace["marker"] = json!({ "symbol": Marker::open(index).plotly_symbol(), "size": 8, "color": color,
                "line": { "width": 1.6 } });
            return trace;
        }
    };
    trace["mode"] = json!("lines");
    trace["line"] = json!({ "color": color, "width": 2, "dash": dash });
    trace
}
