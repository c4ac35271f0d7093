//! Maps of growth as pictures.

use crate::axis::{Axis, Direction, Ticks};
use crate::canvas::{self, Canvas, Point, Stroke};
use crate::color::Rgb;
use crate::color_bar;
use crate::contours::{self, Region};
use crate::error::PlotError;
use crate::frame::{self, Side};
use crate::grid::Grid;
use crate::legend::{Entry, Sample};
use crate::map_figure::{MapFigure, MapPanel};
use crate::map_marks::{
    BEST_FIT_RAY, BRANCH, Marks, OBSERVATION_RADIUS, RAY, RIDGE_RADIUS, ridge_marker,
};
use crate::marker::Marker;
use crate::scale::Scale;
use crate::sheet::{self, Sheet};
use crate::sheet_box::SheetBox;
use crate::steps::Steps;

const SPEED_KM_PER_H: &str = "speed V [km/h]";
const SPEED_M_PER_S: &str = "speed V [m/s]";
/// Grid points drawn along an axis: two per pixel of the frame would not be seen.
const MOST_GRID_POINTS: usize = 500;
/// Distance by which drawn contours may leave the computed ones, pixels: half a unit of the sheet.
const CONTOUR_TOLERANCE: f64 = 0.05;

pub(crate) const ZERO_CONTOUR: Stroke = Stroke::solid(Rgb(20, 30, 60), 1.1);
const CONTOUR: Stroke = Stroke::solid(Rgb(40, 60, 110), 0.4).with_opacity(0.6);

impl MapFigure {
    /// The figure as an SVG document. Identical data give identical text.
    ///
    /// # Errors
    /// [`PlotError::NoPanel`], [`PlotError::GridShape`], [`PlotError::TooFewGridPoints`],
    /// [`PlotError::GridOrder`].
    pub fn svg(&self) -> Result<String, PlotError> {
        svg(self)
    }
}

fn svg(figure: &MapFigure) -> Result<String, PlotError> {
    figure.check()?;
    let labels = figure.observation_labels();
    let columns = figure.panels.len().min(2);
    let (frame_width, frame_height) = if columns == 1 {
        (440.0, 350.0)
    } else {
        (262.0, 290.0)
    };
    let panels: Vec<Drawing<'_>> = figure
        .panels
        .iter()
        .map(|panel| Drawing::new(panel, &labels, frame_height))
        .collect();
    let entries = legend_entries(&panels, &labels);
    let widest = |room: &dyn Fn(&Drawing<'_>) -> f64| panels.iter().map(room).fold(0.0, f64::max);
    let left =
        widest(&|panel| frame::room_beside(&panel.speed_ticks.0, SPEED_KM_PER_H, frame_height));
    let right =
        widest(&|panel| frame::room_beside(&panel.speed_ticks.1, SPEED_M_PER_S, frame_height));
    let subtitles = panels.iter().map(|panel| &*panel.panel.subtitle);
    let sheet = Sheet {
        title: &figure.title,
        caption: &figure.caption,
        columns,
        panel_count: panels.len(),
        frame_size: (frame_width, frame_height),
        left,
        right,
        above: sheet::subtitle_height(subtitles, frame_width).max(4.0),
        below: frame::BELOW + 8.0 + color_bar::HEIGHT,
        legend: &entries,
    };
    canvas::picture(sheet.size(), &figure.title, &figure.caption, |canvas| {
        sheet.draw_words(canvas)?;
        panels.iter().enumerate().try_for_each(|(index, panel)| {
            let frame = sheet.frame(index);
            sheet.draw_subtitle(canvas, &frame, &panel.panel.subtitle)?;
            panel.draw(canvas, &frame)
        })
    })
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
        let ticks = |unit: f64| {
            Axis {
                scale: Scale::Linear,
                low: low * unit,
                high: high * unit,
                start: 0.0,
                end: height,
            }
            .ticks(10, Direction::Upright)
        };
        Drawing {
            panel,
            labels,
            grid: grid.thinned(MOST_GRID_POINTS),
            steps,
            speed_ticks: (ticks(3.6), ticks(1.0)),
        }
    }

    fn has_missing_values(&self) -> bool {
        self.grid.values.iter().any(|value| !value.is_finite())
    }

    fn draw(&self, canvas: &mut Canvas<'_>, frame: &SheetBox) -> Result<(), PlotError> {
        let window = self.panel.window();
        let (x_low, x_high) = window.wavelength_m;
        let (y_low, y_high) = window.speed_m_per_s;
        let axis = |low: f64, high: f64, start: f64, end: f64| Axis {
            scale: Scale::Linear,
            low,
            high,
            start,
            end,
        };
        let x = axis(1e3 * x_low, 1e3 * x_high, frame.left, frame.right);
        let km_per_h = axis(3.6 * y_low, 3.6 * y_high, frame.bottom, frame.top);
        let m_per_s = axis(y_low, y_high, frame.bottom, frame.top);
        let x_ticks = x.ticks(if frame.width() > 350.0 { 8 } else { 6 }, Direction::Across);
        let place = |(wavelength, speed): (f64, f64)| (x.at(1e3 * wavelength), m_per_s.at(speed));

        frame::draw_grid(
            canvas,
            frame,
            (&x, &x_ticks),
            (&km_per_h, &self.speed_ticks.0),
        )?;
        self.draw_contours(canvas, frame, &place)?;
        let marks = Marks {
            panel: self.panel,
            labels: self.labels,
        };
        marks.draw_rays(canvas, &place)?;
        marks.draw_marks(canvas, frame, &place)?;
        marks.draw_ray_labels(canvas, frame, &place)?;
        frame::draw_outline(canvas, frame)?;
        frame::draw_axis(
            canvas,
            frame,
            Side::Bottom,
            &x,
            &x_ticks,
            "wavelength λ [mm]",
        )?;
        frame::draw_axis(
            canvas,
            frame,
            Side::Left,
            &km_per_h,
            &self.speed_ticks.0,
            SPEED_KM_PER_H,
        )?;
        frame::draw_axis(
            canvas,
            frame,
            Side::Right,
            &m_per_s,
            &self.speed_ticks.1,
            SPEED_M_PER_S,
        )?;
        let bar = (frame.left, frame.right, frame.bottom + frame::BELOW + 8.0);
        color_bar::draw(canvas, bar, self.steps.as_ref(), &self.panel.value_label)
    }

    fn draw_contours(
        &self,
        canvas: &mut Canvas<'_>,
        frame: &SheetBox,
        place: &impl Fn(Point) -> Point,
    ) -> Result<(), PlotError> {
        let (from, to) = ((frame.left, frame.top), (frame.right, frame.bottom));
        let on_sheet = |region: &Region| {
            let region = region.map(place);
            // Points of the border lie exactly on the frame, whatever the rounding.
            region.map(|(x, y)| (snap(x, from.0, to.0), snap(y, from.1, to.1)))
        };
        if let Some(steps) = &self.steps {
            let levels = contours::regions(&self.grid, |value| -value, &steps.growth_levels())?;
            let levels: Vec<Vec<Region>> = levels
                .iter()
                .map(|regions| regions.iter().map(on_sheet).collect())
                .collect();
            for (index, regions) in levels.iter().enumerate() {
                for region in regions {
                    let path = contours::simplified(&region.single_path(), CONTOUR_TOLERANCE);
                    canvas.polygon(&path, steps.color(index), 1.0)?;
                }
            }
            for (index, regions) in levels.iter().enumerate() {
                let stroke = if index == 0 { ZERO_CONTOUR } else { CONTOUR };
                for ring in regions.iter().flat_map(Region::rings) {
                    for line in contours::off_border(ring, from, to) {
                        canvas.line(&contours::simplified(&line, CONTOUR_TOLERANCE), stroke)?;
                    }
                }
            }
        }
        if self.has_missing_values() {
            let missing = |value: f64| if value.is_finite() { 0.0 } else { 1.0 };
            for region in contours::regions(&self.grid, missing, &[0.5])?
                .iter()
                .flatten()
            {
                canvas.polygon(&on_sheet(region).single_path(), Rgb::NOT_COMPUTED, 1.0)?;
            }
        }
        Ok(())
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
fn legend_entries(panels: &[Drawing<'_>], labels: &[&str]) -> Vec<Entry> {
    let mut entries = Vec::new();
    let mut add = |present: bool, sample: Sample, name: &str| {
        if present {
            entries.push(Entry {
                sample,
                name: name.to_owned(),
            });
        }
    };
    let any = |test: &dyn Fn(&Drawing<'_>) -> bool| panels.iter().any(test);
    let ridge = |at_edge: bool| {
        any(&|drawing| {
            drawing
                .panel
                .ridge
                .iter()
                .any(|mark| mark.at_edge == at_edge)
        })
    };
    let mark = |at_edge| Sample::Mark(ridge_marker(at_edge), RIDGE_RADIUS, Rgb::BLACK);
    add(ridge(false), mark(false), "strongest growth at each speed");
    add(
        ridge(true),
        mark(true),
        "strongest at the edge of the window",
    );
    add(
        any(&|drawing| drawing.panel.best_fit_frequency_hz.is_some()),
        Sample::Line(BEST_FIT_RAY),
        "constant frequency of the strongest branch",
    );
    add(
        any(&|drawing| {
            drawing
                .panel
                .branches
                .iter()
                .any(|branch| branch.points.len() > 1)
        }),
        Sample::Line(BRANCH),
        "branches of growth",
    );
    add(
        any(&|drawing| drawing.panel.other_rays().next().is_some()),
        Sample::Line(RAY),
        "constant frequency V = fλ",
    );
    add(
        any(&|drawing| drawing.steps.is_some()),
        Sample::Line(ZERO_CONTOUR),
        "neither growth nor decay",
    );
    add(
        any(&|drawing| drawing.has_missing_values()),
        Sample::Patch(Rgb::NOT_COMPUTED),
        "not computed",
    );
    for (index, label) in labels.iter().enumerate() {
        add(
            true,
            Sample::Mark(Marker::open(index), OBSERVATION_RADIUS, Rgb::BLACK),
            label,
        );
    }
    entries
}
