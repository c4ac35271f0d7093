//! Curves as pictures.

use super::axis::{Axis, Direction, Ticks};
use super::contours;
use super::frame::{self, Side};
use super::legend::{self, Entry, Sample};
use super::mark_name::{self, MarkName};
use super::marker::Marker;
use super::picture::{Picture, Stroke};
use super::point::Point;
use super::sheet::Sheet;
use super::sheet_box::SheetBox;
use crate::color::{OKABE_ITO, Rgb};
use crate::error::PlotError;
use crate::line_figure::{Area, Arrangement, LineFigure, LinePanel, LineStyle, Mark, Series};

const LINE_WIDTH: f64 = 1.4;
const MARK_RADIUS: f64 = 3.2;
const MARK_LINE_WIDTH: f64 = 0.8;
/// Distance by which a drawn line may leave its samples, pixels: half a unit of the sheet.
const LINE_TOLERANCE: f64 = 0.05;
/// Distance from a legend to the frame around it, pixels.
const LEGEND_MARGIN: f64 = 8.0;
/// Distance a legend inside a frame keeps from lines and marks, pixels.
const LEGEND_CLEARANCE: f64 = 4.0;

impl LineFigure {
    /// The figure as a picture. Identical data give an identical one.
    ///
    /// # Errors
    /// [`PlotError::NoPanel`], [`PlotError::SeriesLength`], [`PlotError::AxisRange`].
    pub fn picture(&self) -> Result<Picture, PlotError> {
        self.check()?;
        let columns = match self.arrangement {
            Arrangement::Stacked | Arrangement::Strips => 1,
            Arrangement::SideBySide => self.panels.len().min(2),
        };
        let frame_size = match (columns, self.panels.len()) {
            _ if self.arrangement == Arrangement::Strips => (600.0, 110.0),
            (1, 1) => (450.0, 290.0),
            (1, _) => (450.0, 200.0),
            _ => (278.0, 240.0),
        };
        let frame = SheetBox { left: 0.0, top: 0.0, right: frame_size.0, bottom: frame_size.1 };
        let panels = self.panels.iter().map(|panel| Drawing::new(panel, &frame));
        let panels: Vec<Drawing<'_>> = panels.collect();
        let beside =
            |drawing: &Drawing<'_>| frame::room_beside(&drawing.y_ticks, &drawing.panel.y_label, frame.height());
        let below = |drawing: &Drawing<'_>| frame::BELOW + drawing.legend_height_below(&frame);
        let sheet = Sheet {
            title: &self.title,
            caption: &self.caption,
            subtitles: self.panels.iter().map(|panel| &*panel.subtitle).collect(),
            columns,
            frame_size,
            left: panels.iter().map(beside).fold(0.0, f64::max),
            right: 14.0,
            below: panels.iter().map(below).collect(),
            legend: &[],
        };
        Ok(sheet.picture(|picture, index, frame| panels[index].draw(picture, &frame)))
    }
}

/// Colour of the series `index`.
pub(crate) fn series_color(series: &Series, index: usize) -> Rgb {
    series.color.unwrap_or(OKABE_ITO[index % OKABE_ITO.len()])
}

/// A panel prepared for drawing on a frame whose upper left corner is the origin.
struct Drawing<'a> {
    panel: &'a LinePanel,
    x: Axis,
    y: Axis,
    x_ticks: Ticks,
    y_ticks: Ticks,
    /// Lines or single marks of each series, clipped to the frame.
    lines: Vec<Vec<Vec<Point>>>,
    names: Vec<MarkName>,
    entries: Vec<Entry>,
    /// Upper left corner of a legend within the frame; None puts it below.
    legend_corner: Option<Point>,
}

impl<'a> Drawing<'a> {
    fn new(panel: &'a LinePanel, frame: &SheetBox) -> Self {
        let (low_x, high_x) = panel.drawn_x_range();
        let x = Axis { scale: panel.x_scale, ..Axis::linear((low_x, high_x), (frame.left, frame.right)) };
        let y = Axis { scale: panel.y_scale, ..Axis::linear(panel.drawn_y_range(), (frame.bottom, frame.top)) };
        let lines: Vec<Vec<Vec<Point>>> = panel
            .series
            .iter()
            .map(|series| match series.style {
                LineStyle::Markers => marks(panel, series, &x, &y, frame),
                _ => clipped_lines(panel, series, &x, &y, frame),
            })
            .collect();
        let entries = legend_entries(panel);
        let marks = panel.marks.iter().filter(|mark| low_x <= mark.x && mark.x <= high_x);
        let marks: Vec<(&str, f64)> = marks.map(|mark| (&*mark.label, x.at(mark.x))).collect();
        let names = mark_name::beside(&marks, &lines, frame);
        // A legend keeps clear of the lines of marks and of their names.
        let mut obstacles = lines.clone();
        let upright = |&(_, at): &(&str, f64)| vec![(at, frame.top), (at, frame.bottom)];
        obstacles.push(marks.iter().map(upright).collect());
        obstacles.push(names.iter().map(MarkName::diagonal).collect());
        obstacles.extend(panel.areas.iter().map(|area| {
            let place = |v: f64| y.at(v).clamp(frame.top, frame.bottom);
            let sample = |((&u, &low), &high)| vec![(x.at(u), place(low)), (x.at(u), place(high))];
            let samples = area.x.iter().zip(&area.low).zip(&area.high);
            samples.map(sample).collect()
        }));
        let legend_corner = free_corner(&entries, &obstacles, frame);
        let count = |length: f64, least: f64| (length / least).floor() as usize;
        let vertical_ticks = |count| {
            if panel.y_is_angle() {
                y.degree_ticks(count, Direction::Upright)
            } else {
                y.ticks(count, Direction::Upright)
            }
        };
        let (x_ticks, y_ticks) =
            (x.ticks(count(frame.width(), 44.0), Direction::Across), vertical_ticks(count(frame.height(), 29.0)));
        Drawing { panel, x, y, x_ticks, y_ticks, lines, names, entries, legend_corner }
    }

    fn legend_height_below(&self, frame: &SheetBox) -> f64 {
        if self.legend_corner.is_some() { 0.0 } else { legend::height(&self.entries, frame.width()) + 6.0 }
    }

    /// The samples of an area within the range of the abscissa, as one polygon; ordinates beyond the frame end
    /// at it.
    fn draw_area(&self, picture: &mut Picture, frame: &SheetBox, (x, y): (&Axis, &Axis), area: &Area) {
        let point = |u: f64, v: f64| (x.at(u), y.at(v).clamp(frame.top, frame.bottom));
        let inside = |u: f64| self.x.low <= u && u <= self.x.high;
        let samples: Vec<(f64, f64, f64)> = area
            .x
            .iter()
            .zip(&area.low)
            .zip(&area.high)
            .map(|((&u, &low), &high)| (u, low, high))
            .filter(|&(u, low, high)| inside(u) && self.panel.admits(u, low) && self.panel.admits(u, high))
            .collect();
        let upper = samples.iter().map(|&(u, _, high)| point(u, high));
        let lower = samples.iter().rev().map(|&(u, low, _)| point(u, low));
        let outline: Vec<Point> = upper.chain(lower).collect();
        picture.region(vec![outline], area.color, 1.0);
    }

    /// Marks within the range of the abscissa.
    fn marks(&self) -> impl Iterator<Item = &Mark> {
        let (low, high) = (self.x.low, self.x.high);
        let within = move |mark: &&Mark| low <= mark.x && mark.x <= high;
        self.panel.marks.iter().filter(within)
    }

    fn draw(&self, picture: &mut Picture, frame: &SheetBox) {
        let shift = (frame.left, frame.top);
        let moved = |axis: &Axis, by: f64| Axis { start: axis.start + by, end: axis.end + by, ..*axis };
        let (x, y) = (moved(&self.x, shift.0), moved(&self.y, shift.1));
        frame::draw_grid(picture, frame, (&x, &self.x_ticks), (&y, &self.y_ticks));
        for area in &self.panel.areas {
            self.draw_area(picture, frame, (&x, &y), area);
        }
        for mark in self.marks() {
            let at = x.at(mark.x);
            let line = [(at, frame.top), (at, frame.bottom)];
            picture.line(&line, Stroke::dashed(Rgb::INK, MARK_LINE_WIDTH, 1.0, 2.0));
        }
        for (index, (series, lines)) in self.panel.series.iter().zip(&self.lines).enumerate() {
            let color = series_color(series, index);
            for line in lines {
                let line: Vec<Point> = line.iter().map(|point| (point.0 + shift.0, point.1 + shift.1)).collect();
                match (series.style, line[..].first()) {
                    (LineStyle::Markers, Some(&at)) => Marker::open(index).draw(picture, at, MARK_RADIUS, color),
                    _ => picture.line(&contours::simplified(&line, LINE_TOLERANCE), stroke(series.style, color)),
                }
            }
        }
        for name in &self.names {
            name.draw(picture, shift);
        }
        frame::draw_outline(picture, frame);
        frame::draw_axis(picture, frame, Side::Bottom, &x, &self.x_ticks, &self.panel.x_label);
        frame::draw_axis(picture, frame, Side::Left, &y, &self.y_ticks, &self.panel.y_label);
        match self.legend_corner {
            Some(corner) => {
                let corner = (corner.0 + shift.0, corner.1 + shift.1);
                let size = legend::column_size(&self.entries);
                let from = (corner.0 - 4.0, corner.1 - 2.0);
                picture.rectangle(from, (corner.0 + size.0 + 4.0, corner.1 + size.1 + 2.0), Rgb::WHITE, 0.85);
                legend::draw_column(picture, &self.entries, corner)
            }
            None => {
                let corner = (frame.left, frame.bottom + frame::BELOW + 6.0);
                legend::draw_rows(picture, &self.entries, corner, frame.width())
            }
        }
    }
}

fn stroke(style: LineStyle, color: Rgb) -> Stroke {
    match style {
        LineStyle::Solid | LineStyle::Markers => Stroke::solid(color, LINE_WIDTH),
        LineStyle::Dashed => Stroke::dashed(color, LINE_WIDTH, 6.0, 3.5),
        LineStyle::Dotted => Stroke::dashed(color, LINE_WIDTH, 1.6, 2.6),
    }
}

fn legend_entries(panel: &LinePanel) -> Vec<Entry> {
    let named = panel.series.iter().enumerate().filter(|(_, series)| !series.label.is_empty() && panel.shows(series));
    let areas = panel.areas.iter().filter(|area| !area.label.is_empty());
    let areas = areas.map(|area| Entry { sample: Sample::Patch(area.color), name: area.label.clone() });
    named
        .map(|(index, series)| {
            let color = series_color(series, index);
            let sample = match series.style {
                LineStyle::Markers => Sample::Mark(Marker::open(index), MARK_RADIUS, color),
                style => Sample::Line(stroke(style, color)),
            };
            Entry { sample, name: series.label.clone() }
        })
        .chain(areas)
        .collect()
}

/// Samples as single points inside the frame.
fn marks(panel: &LinePanel, series: &Series, x: &Axis, y: &Axis, frame: &SheetBox) -> Vec<Vec<Point>> {
    let samples = series.x.iter().zip(&series.y).filter(|&(&u, &v)| panel.admits(u, v));
    samples.map(|(&u, &v)| (x.at(u), y.at(v))).filter(|&point| frame.contains(point)).map(|point| vec![point]).collect()
}

/// Lines through consecutive samples that can be drawn, cut at the frame.
fn clipped_lines(panel: &LinePanel, series: &Series, x: &Axis, y: &Axis, frame: &SheetBox) -> Vec<Vec<Point>> {
    let mut lines: Vec<Vec<Point>> = Vec::new();
    let mut previous: Option<Point> = None;
    for (&u, &v) in series.x.iter().zip(&series.y) {
        let point = panel.admits(u, v).then(|| (x.at(u), y.at(v)));
        if let Some((a, b)) = previous.zip(point).and_then(|(a, b)| frame.clip(a, b)) {
            match lines.last_mut().filter(|line| line.last() == Some(&a)) {
                Some(line) => line.push(b),
                None => lines.push(vec![a, b]),
            }
        }
        previous = point;
    }
    lines
}

/// The corner of the frame in which a legend covers nothing; None if there is no such corner. An
/// empty legend fits anywhere.
fn free_corner(entries: &[Entry], lines: &[Vec<Vec<Point>>], frame: &SheetBox) -> Option<Point> {
    let (width, height) = legend::column_size(entries);
    let (left, right) = (frame.left + LEGEND_MARGIN, frame.right - LEGEND_MARGIN - width);
    let (top, bottom) = (frame.top + LEGEND_MARGIN, frame.bottom - LEGEND_MARGIN - height);
    if entries.is_empty() {
        return Some((left, top));
    }
    let middle = (left + right) / 2.0;
    [(right, top), (left, top), (left, bottom), (right, bottom), (middle, top), (middle, bottom)]
        .into_iter()
        .filter(|corner| corner.0 >= left && corner.1 >= top)
        .find(|corner| {
            let place = SheetBox { left: corner.0, top: corner.1, right: corner.0 + width, bottom: corner.1 + height };
            let near = place.shrunk(-LEGEND_CLEARANCE);
            !lines.iter().flatten().any(|line| match line[..] {
                [point] => near.contains(point),
                _ => line.windows(2).any(|pair| near.clip(pair[0], pair[1]).is_some()),
            })
        })
}
