//! Maps of growth as pages.

use serde_json::{Value, json};

use super::html::{self, PagePanel, PageStage, coordinates, number, words};
use crate::color::{BEST_FIT, Rgb, growth_color};
use crate::drawing::map::ZERO_CONTOUR;
use crate::drawing::map_marks::{MOST_RIDGE_MARKS, hertz};
use crate::drawing::marker::Marker;
use crate::error::PlotError;
use crate::grid::{Grid, thinned_indices};
use crate::map_figure::{BranchLine, MapFigure, MapPanel, Observation, RidgeMark};
use crate::steps::Steps;

/// Grid points along an axis of a page: more only make it heavy.
const MOST_GRID_POINTS: usize = 250;

impl MapFigure {
    /// The figure as a page of HTML that shows the numbers under the pointer. It carries everything
    /// it needs and loads nothing. Identical data give identical text.
    ///
    /// # Errors
    /// Errors of [`picture`](MapFigure::picture).
    pub fn html(&self) -> Result<String, PlotError> {
        html(self)
    }
}

fn html(figure: &MapFigure) -> Result<String, PlotError> {
    figure.check()?;
    let labels = figure.observation_labels();
    let panels: Vec<PagePanel> = figure.panels.iter().map(|panel| page_panel(panel, &labels)).collect();
    let stage = PageStage { name: String::new(), panels };
    Ok(html::page(&figure.title, &figure.caption, false, &[stage]))
}

fn page_panel(panel: &MapPanel, labels: &[&str]) -> PagePanel {
    let steps = panel.steps();
    let grid = panel.grid().thinned(MOST_GRID_POINTS);
    let mut data = Vec::new();
    data.extend(missing_trace(&grid));
    data.push(map_trace(panel, &grid, steps.as_ref()));
    data.extend(steps.as_ref().map(|_| zero_trace()));
    let rays: Vec<f64> = panel.other_rays().collect();
    for (index, &frequency) in rays.iter().enumerate() {
        let style = json!({ "color": Rgb::AUXILIARY.hex(), "width": 1 });
        data.extend(ray_trace(panel, frequency, "constant frequency V = fλ", style, index == 0));
    }
    if let Some(frequency) = panel.best_fit_frequency_hz {
        let style = json!({ "color": BEST_FIT.hex(), "width": 2.5, "dash": "dash" });
        data.extend(ray_trace(panel, frequency, "constant frequency of the strongest branch", style, true));
    }
    let branches = panel.branches.iter().filter(|branch| branch.points.len() > 1);
    data.extend(branches.enumerate().map(|(index, branch)| branch_trace(branch, index == 0)));
    for (at_edge, name) in [(false, "strongest growth at each speed"), (true, "strongest at the edge of the window")] {
        data.extend(ridge_trace(&panel.ridge, at_edge, name));
    }
    for (index, label) in labels.iter().enumerate() {
        data.extend(observation_trace(&panel.observations, label, Marker::open(index)));
    }
    data.push(scale_trace(panel, steps.as_ref()));
    let labels = rays.iter().filter_map(|&frequency| ray_label(panel, frequency, false));
    let best_label = panel.best_fit_frequency_hz.and_then(|frequency| ray_label(panel, frequency, true));
    let mut layout = map_layout(panel);
    let weaker = panel.weaker_branches().filter_map(branch_label);
    layout["annotations"] = labels.chain(weaker).chain(best_label).collect();
    if panel.strongest_growth().is_none() {
        layout["annotations"] = json!([{ "text": "no growth in this window", "showarrow": false,
            "xref": "paper", "yref": "paper", "x": 0.5, "y": 0.5 }]);
    }
    let hover = panel.hover_values.as_ref().map_or(Value::Null, |values| {
        let hover = Grid { values: values.clone(), ..panel.grid() }.thinned(MOST_GRID_POINTS);
        rows(&hover, number)
    });
    PagePanel { data, layout, hover }
}

fn map_layout(panel: &MapPanel) -> Value {
    let window = panel.window();
    let axis = |title: &str, (low, high): (f64, f64), unit: f64| {
        let mut axis = html::axis(title);
        axis["range"] = coordinates([low * unit, high * unit]);
        axis
    };
    let x = axis("wavelength λ [mm]", window.wavelength_m, 1e3);
    let mut y = axis("speed V [km/h]", window.speed_m_per_s, 3.6);
    let mut right = axis("speed V [m/s]", window.speed_m_per_s, 1.0);
    y["mirror"] = json!(false);
    right["mirror"] = json!(false);
    right["overlaying"] = json!("y");
    right["side"] = json!("right");
    right["showgrid"] = json!(false);
    let mut layout = html::layout(&panel.subtitle, x, y);
    layout["yaxis2"] = right;
    layout["margin"]["r"] = json!(92);
    layout
}

/// Cells without a number, grey below the map.
fn missing_trace(grid: &Grid) -> Option<Value> {
    if grid.values.iter().all(|value| value.is_finite()) {
        return None;
    }
    let grey = Rgb::NOT_COMPUTED.hex();
    Some(json!({
        "type": "heatmap", "x": places(&grid.x, 1e3), "y": places(&grid.y, 3.6),
        "z": rows(grid, |value| if value.is_finite() { Value::Null } else { json!(1) }),
        "colorscale": [[0, grey], [1, grey]], "showscale": false, "hoverinfo": "skip",
    }))
}

/// The filled contours. A map without growth is white and keeps its numbers under the pointer.
fn map_trace(panel: &MapPanel, grid: &Grid, steps: Option<&Steps>) -> Value {
    let mut template = format!(
        "λ = %{{x:.1f}} mm<br>V = %{{y:.1f}} km/h = %{{customdata[0]:.1f}} m/s<br>f = %{{customdata[1]:.0f}} Hz<br>\
         {} = %{{z:.4g}}",
        words(&panel.value_label)
    );
    if panel.hover_values.is_some() {
        template += &format!("<br>{} = %{{customdata[2]:.4g}}", words(&panel.hover_label));
    }
    template += "<extra></extra>";
    // Bands from the strongest growth up to zero, and one more for decay. plotly.js centres the
    // first and the last colour of the scale on the bands outside `start` and `end`.
    let count = steps.map_or(1, |steps| steps.count);
    let scale: Vec<Value> = (0..=count)
        .map(|band| {
            let color = steps.filter(|_| band < count).map_or(Rgb::WHITE, |steps| steps.color(count - 1 - band));
            json!([band as f64 / count as f64, color.hex()])
        })
        .collect();
    let least = steps.map_or(-1.0, |steps| steps.least);
    let size = -least / count as f64;
    let start = if count == 1 { 0.0 } else { least + size };
    json!({
        "type": "contour", "name": "map", "x": places(&grid.x, 1e3), "y": places(&grid.y, 3.6),
        "z": rows(grid, number), "hovertemplate": template, "hoverlabel": { "align": "left" },
        "colorscale": scale, "showscale": false, "autocontour": false,
        "contours": { "coloring": "fill", "start": start, "end": 0, "size": size, "showlines": steps.is_some() },
        "line": { "width": 0.4, "color": growth_color(1.0).hex() },
    })
}

/// The zero contour; its grid is that of the map.
fn zero_trace() -> Value {
    json!({
        "type": "contour", "meta": "zero", "name": "neither growth nor decay", "showlegend": true,
        "showscale": false, "autocontour": false, "hoverinfo": "skip",
        "contours": { "coloring": "none", "start": 0, "end": 0, "size": 1 },
        "line": { "width": 1.3, "color": ZERO_CONTOUR.color.hex() },
    })
}

/// A trace without points: it makes plotly.js draw the right axis and carries the colour bar in
/// equal steps.
fn scale_trace(panel: &MapPanel, steps: Option<&Steps>) -> Value {
    let mut trace = json!({ "type": "scatter", "mode": "markers", "x": [null], "y": [null], "yaxis": "y2",
        "showlegend": false, "hoverinfo": "skip" });
    let Some(steps) = steps else { return trace };
    let share = |boundary: usize| boundary as f64 / steps.count as f64;
    let scale: Vec<Value> = (0..steps.count)
        .flat_map(|band| {
            let color = steps.color(steps.count - 1 - band).hex();
            [json!([share(band), color]), json!([share(band + 1), color])]
        })
        .collect();
    let marks = || (0..=steps.count).step_by(steps.count.div_ceil(10));
    trace["marker"] = json!({
        "color": [0], "cmin": number(steps.least), "cmax": 0, "colorscale": scale, "showscale": true,
        "colorbar": {
            "title": { "text": words(&steps.title(&panel.value_label)), "side": "right" }, "thickness": 14,
            "len": 1, "lenmode": "fraction", "ypad": 0, "outlinewidth": 0.7,
            "xref": "container", "x": 1, "xanchor": "right",
            "tickvals": coordinates(marks().map(|index| steps.value(index))),
            "ticktext": marks().map(|index| steps.label(index)).collect::<Vec<_>>(),
        },
    });
    trace
}

fn rows(grid: &Grid, cell: impl Fn(f64) -> Value) -> Value {
    (0..grid.y.len()).map(|j| (0..grid.x.len()).map(|i| cell(grid.value(i, j))).collect::<Value>()).collect()
}

fn places(points: &[f64], unit: f64) -> Value {
    coordinates(points.iter().map(|point| point * unit))
}

fn ray_trace(panel: &MapPanel, frequency: f64, name: &str, line: Value, showlegend: bool) -> Option<Value> {
    let [from, to] = panel.window().ray(frequency)?;
    Some(json!({
        "type": "scatter", "mode": "lines", "name": name, "legendgroup": name, "showlegend": showlegend,
        "x": coordinates([1e3 * from.0, 1e3 * to.0]), "y": coordinates([3.6 * from.1, 3.6 * to.1]),
        "line": line, "hoverinfo": "skip",
    }))
}

/// The frequency near the upper end of its ray: on it, but above it for the best fit, which runs
/// through the ridge.
fn ray_label(panel: &MapPanel, frequency: f64, best: bool) -> Option<Value> {
    let [from, to] = panel.window().ray(frequency)?;
    let share = if best { 0.86 } else { 0.93 };
    let at = (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
    let text = if best { format!("<b>f = {} Hz</b>", hertz(frequency)) } else { format!("{} Hz", hertz(frequency)) };
    let (color, size) = if best { (BEST_FIT.hex(), 13) } else { ("#505050".to_owned(), 11) };
    Some(json!({
        "text": text, "showarrow": false, "x": number(1e3 * at.0), "y": number(3.6 * at.1),
        "xshift": if best { -46 } else { 0 }, "yshift": if best { 18 } else { 0 },
        "font": { "color": color, "size": size }, "bgcolor": "rgba(255,255,255,0.82)", "borderpad": 1,
    }))
}

/// A branch of growth, with its frequency under the pointer.
fn branch_trace(branch: &BranchLine, showlegend: bool) -> Value {
    let name = "branches of growth";
    json!({
        "type": "scatter", "mode": "lines", "name": name, "legendgroup": name, "showlegend": showlegend,
        "x": coordinates(branch.points.iter().map(|point| 1e3 * point.0)),
        "y": coordinates(branch.points.iter().map(|point| 3.6 * point.1)),
        "line": { "color": BEST_FIT.hex(), "width": 1.6 }, "hoverinfo": "skip",
    })
}

/// The frequency of a weaker branch beside its upper end.
fn branch_label(branch: &BranchLine) -> Option<Value> {
    let &(wavelength, speed) = branch.points.get(branch.points.len() * 4 / 5)?;
    (wavelength.is_finite() && speed.is_finite()).then(|| {
        json!({
            "text": format!("<b>{} Hz</b>", hertz(branch.frequency_hz.round())), "showarrow": false,
            "x": number(1e3 * wavelength), "y": number(3.6 * speed), "xshift": -30, "yshift": 12,
            "font": { "color": BEST_FIT.hex(), "size": 11 }, "bgcolor": "rgba(255,255,255,0.82)", "borderpad": 1,
        })
    })
}

fn ridge_trace(ridge: &[RidgeMark], at_edge: bool, name: &str) -> Option<Value> {
    let marks: Vec<&RidgeMark> = ridge
        .iter()
        .filter(|mark| mark.at_edge == at_edge && mark.wavelength_m.is_finite() && mark.speed_m_per_s.is_finite())
        .collect();
    if marks.is_empty() {
        return None;
    }
    let marks: Vec<&RidgeMark> =
        thinned_indices(marks.len(), MOST_RIDGE_MARKS).into_iter().map(|index| marks[index]).collect();
    Some(point_trace(
        name,
        marks.iter().map(|mark| (mark.wavelength_m, mark.speed_m_per_s)),
        json!({ "symbol": if at_edge { Marker::Circle } else { Marker::Disc }.plotly_symbol(), "size": 5,
            "color": "#000", "line": { "width": if at_edge { 1.2 } else { 0.6 },
            "color": if at_edge { "#000" } else { "#fff" } } }),
    ))
}

fn observation_trace(observations: &[Observation], label: &str, marker: Marker) -> Option<Value> {
    let mut points =
        observations.iter().filter(|other| other.label == label).map(|o| (o.wavelength_m, o.speed_m_per_s)).peekable();
    points.peek()?;
    let style = json!({ "symbol": marker.plotly_symbol(), "size": 10, "color": "#000", "line": { "width": 1.6 } });
    Some(point_trace(label, points, style))
}

fn point_trace(name: &str, points: impl Iterator<Item = (f64, f64)>, marker: Value) -> Value {
    let (wavelengths, speeds): (Vec<f64>, Vec<f64>) = points.unzip();
    let frequencies = wavelengths.iter().zip(&speeds).map(|(wavelength, speed)| number(speed / wavelength));
    json!({
        "type": "scatter", "mode": "markers", "name": words(name), "marker": marker, "cliponaxis": false,
        "customdata": frequencies.collect::<Value>(),
        "x": coordinates(wavelengths.iter().map(|wavelength| 1e3 * wavelength)),
        "y": coordinates(speeds.iter().map(|speed| 3.6 * speed)),
        "hovertemplate": "λ = %{x:.1f} mm<br>V = %{y:.1f} km/h<br>f = %{customdata:.0f} Hz",
    })
}
