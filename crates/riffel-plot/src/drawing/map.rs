//! Maps of growth as pictures.

use super::axis::{Axis, Direction, Ticks};
use super::color_bar;
use super::contours::{self, Ring};
use super::frame::{self, Side};
use super::legend::{Entry, Sample};
use super::map_marks::{BEST_FIT_RAY, BRANCH, Marks, OBSERVATION_RADIUS, RAY, RIDGE_RADIUS, ridge_marker};
use super::marker::Marker;
use super::picture::{Picture, Stroke};
use super::point::Point;
use super::sheet::Sheet;
use super::sheet_box::SheetBox;
use crate::color::Rgb;
use crate::error::PlotError;
use crate::grid::Grid;
use crate::map_figure::{MapFigure, MapPanel};
use crate::map_words::MapWords;
use crate::steps::Steps;

/// Grid points drawn along an axis: two per pixel of the frame would not be seen.
const MOST_GRID_POINTS: usize = 500;
/// Distance by which drawn contours may leave the computed ones, pixels: half a unit of the sheet.
const CONTOUR_TOLERANCE: f64 = 0.05;

pub(crate) const ZERO_CONTOUR: Stroke = Stroke::solid(Rgb(20, 30, 60), 1.1);
const CONTOUR: Stroke = Stroke::solid(Rgb(40, 60, 110), 0.4).with_opacity(0.6);

impl MapFigure {
    /// The figure as a picture. Identical data give an identical one.
    ///
    /// # Errors
    /// [`PlotError::NoPanel`], [`PlotError::GridShape`], [`PlotError::TooFewGridPoints`],
    /// [`PlotError::GridOrder`].
    pub fn picture(&self) -> Result<Picture, PlotError> {
        self.picture_with(&MapWords::default())
    }

    /// Picture with words of its own, such as those of another language.
    ///
    /// # Errors
    /// Errors of [`picture`](Self::picture).
    pub fn picture_with(&self, words: &MapWords) -> Result<Picture, PlotError> {
        self.check()?;
        let labels = self.observation_labels();
        let columns = self.panels.len().min(2);
        let frame_size = if columns == 1 { (440.0, 350.0) } else { (262.0, 290.0) };
        let panel = |panel| Drawing::new(panel, &labels, frame_size.1);
        let panels: Vec<Drawing<'_>> = self.panels.iter().map(panel).collect();
        let widest = |room: &dyn Fn(&Drawing<'_>) -> f64| panels.iter().map(room).fold(0.0, f64::max);
        let beside = |ticks: &Ticks, title| frame::room_beside(ticks, title, frame_size.1);
        let sheet = Sheet {
            title: &self.title,
            caption: &self.caption,
            subtitles: self.panels.iter().map(|panel| &*panel.subtitle).collect(),
            columns,
            frame_size,
            left: widest(&|panel| beside(&panel.speed_ticks.0, &words.speed_km_per_h)),
            right: widest(&|panel| beside(&panel.speed_ticks.1, &words.speed_m_per_s)),
            below: vec![frame::BELOW + 8.0 + color_bar::HEIGHT; self.panels.len()],
            legend: &legend_entries(&panels, &labels, words),
        };
        Ok(sheet.picture(|picture, index, frame| panels[index].draw(picture, &frame, words)))
    }
}

/// A panel prepared for drawing.
struct Drawing<'a> {
    panel: &'a MapPanel,
    labels: &'a [&'a str],
    grid: Grid,
    steps: Option<Steps>,
    /// Ticks of the speed in km/h and in m/s.
    speed_ticks: (Ticks, Ticks),
}

impl<'a> Drawing<'a> {
    fn new(panel: &'a MapPanel, labels: &'a [&'a str], height: f64) -> Self {
        let grid = panel.grid();
        let steps = panel.steps();
        let (low, high) = panel.window().speed_m_per_s;
        let ticks = |unit: f64| Axis::linear((low * unit, high * unit), (0.0, height)).ticks(10, Direction::Upright);
        Drawing { panel, labels, grid: grid.thinned(MOST_GRID_POINTS), steps, speed_ticks: (ticks(3.6), ticks(1.0)) }
    }

    fn has_missing_values(&self) -> bool {
        self.grid.values.iter().any(|value| !value.is_finite())
    }

    fn draw(&self, picture: &mut Picture, frame: &SheetBox, words: &MapWords) {
        let window = self.panel.window();
        let (x_low, x_high) = window.wavelength_m;
        let (y_low, y_high) = window.speed_m_per_s;
        let (across, upright) = ((frame.left, frame.right), (frame.bottom, frame.top));
        let x = Axis::linear((1e3 * x_low, 1e3 * x_high), across);
        let km_per_h = Axis::linear((3.6 * y_low, 3.6 * y_high), upright);
        let m_per_s = Axis::linear((y_low, y_high), upright);
        let x_ticks = x.ticks(if frame.width() > 350.0 { 8 } else { 6 }, Direction::Across);
        let place = |(wavelength, speed): (f64, f64)| (x.at(1e3 * wavelength), m_per_s.at(speed));

        frame::draw_grid(picture, frame, (&x, &x_ticks), (&km_per_h, &self.speed_ticks.0));
        self.draw_contours(picture, frame, &place);
        let marks = Marks { panel: self.panel, labels: self.labels };
        marks.draw_rays(picture, &place);
        marks.draw_marks(picture, frame, &place);
        marks.draw_ray_labels(picture, frame, &place);
        frame::draw_outline(picture, frame);
        let mut axis = |side, axis, ticks, title| {
            frame::draw_axis(picture, frame, side, axis, ticks, title);
        };
        axis(Side::Bottom, &x, &x_ticks, &words.wavelength);
        let speed = &words.speed_km_per_h;
        axis(Side::Left, &km_per_h, &self.speed_ticks.0, speed);
        let speed = &words.speed_m_per_s;
        axis(Side::Right, &m_per_s, &self.speed_ticks.1, speed);
        let bar = (frame.left, frame.right, frame.bottom + frame::BELOW + 8.0);
        color_bar::draw(picture, bar, self.steps.as_ref(), &self.panel.value_label)
    }

    fn draw_contours(&self, picture: &mut Picture, frame: &SheetBox, place: &impl Fn(Point) -> Point) {
        let (from, to) = ((frame.left, frame.top), (frame.right, frame.bottom));
        let regions = |quantity: &dyn Fn(f64) -> f64, levels: &[f64]| {
            let mut regions = contours::regions(&self.grid, quantity, levels);
            for point in regions.iter_mut().flatten().flatten() {
                // Points of the border lie exactly on the frame, whatever the rounding.
                let (x, y) = place(*point);
                *point = (snap(x, from.0, to.0), snap(y, from.1, to.1));
            }
            regions
        };
        let simplified = |line: &Ring| contours::simplified(line, CONTOUR_TOLERANCE);
        if let Some(steps) = &self.steps {
            let levels = regions(&|value| -value, &steps.growth_levels());
            for (index, rings) in levels.iter().enumerate() {
                picture.region(rings.iter().map(simplified).collect(), steps.color(index), 1.0);
            }
            for (index, rings) in levels.iter().enumerate() {
                let stroke = if index == 0 { ZERO_CONTOUR } else { CONTOUR };
                for line in rings.iter().flat_map(|ring| contours::off_border(ring, from, to)) {
                    picture.line(&simplified(&line), stroke);
                }
            }
        }
        if self.has_missing_values() {
            let missing = |value: f64| if value.is_finite() { 0.0 } else { 1.0 };
            for rings in regions(&missing, &[0.5]) {
                picture.region(rings, Rgb::NOT_COMPUTED, 1.0);
            }
        }
    }
}

fn snap(value: f64, low: f64, high: f64) -> f64 {
    const ROUNDING: f64 = 1e-6;
    if (value - low).abs() < ROUNDING {
        low
    } else if (value - high).abs() < ROUNDING {
        high
    } else {
        value
    }
}

fn legend_entries(panels: &[Drawing<'_>], labels: &[&str], words: &MapWords) -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut add = |present: bool, sample: Sample, name: &str| {
        if present {
            entries.push(Entry { sample, name: name.to_owned() });
        }
    };
    let any = |test: &dyn Fn(&Drawing<'_>) -> bool| panels.iter().any(test);
    let ridge = |at_edge: bool| any(&|drawing| drawing.panel.ridge.iter().any(|mark| mark.at_edge == at_edge));
    let mark = |at_edge| Sample::Mark(ridge_marker(at_edge), RIDGE_RADIUS, Rgb::BLACK);
    add(ridge(false), mark(false), &words.ridge);
    add(ridge(true), mark(true), &words.ridge_at_edge);
    add(any(&|drawing| drawing.panel.best_fit_frequency_hz.is_some()), Sample::Line(BEST_FIT_RAY), &words.best_fit_ray);
    add(
        any(&|drawing| drawing.panel.branches.iter().any(|branch| branch.points.len() > 1)),
        Sample::Line(BRANCH),
        &words.branches,
    );
    add(any(&|drawing| drawing.panel.other_rays().next().is_some()), Sample::Line(RAY), &words.rays);
    add(any(&|drawing| drawing.steps.is_some()), Sample::Line(ZERO_CONTOUR), &words.zero);
    add(any(&|drawing| drawing.has_missing_values()), Sample::Patch(Rgb::NOT_COMPUTED), &words.not_computed);
    for (index, label) in labels.iter().enumerate() {
        add(true, Sample::Mark(Marker::open(index), OBSERVATION_RADIUS, Rgb::BLACK), label);
    }
    entries
}
