//! What is drawn upon a map: rays of constant frequency and their labels, the ridge, observations.

use super::contours::simplified;
use super::marker::Marker;
use super::picture::{Horizontal, Lettering, Picture, Stroke, Vertical};
use super::point::Point;
use super::sheet_box::{self, Obstacles, SheetBox};
use super::text;
use crate::color::{BEST_FIT, Rgb};
use crate::grid::thinned_indices;
use crate::map_figure::MapPanel;

/// Ridge marks drawn in a panel.
pub(crate) const MOST_RIDGE_MARKS: usize = 50;
pub(crate) const RIDGE_RADIUS: f64 = 2.4;
pub(crate) const OBSERVATION_RADIUS: f64 = 4.0;
pub(crate) const RAY: Stroke = Stroke::solid(Rgb::AUXILIARY, 0.8);
pub(crate) const BEST_FIT_RAY: Stroke = Stroke::dashed(BEST_FIT, 2.0, 7.0, 4.0);
/// A branch of growth.
pub(crate) const BRANCH: Stroke = Stroke::solid(BEST_FIT, 1.4);
/// Distance by which a drawn branch may leave its points, pixels.
const BRANCH_TOLERANCE: f64 = 0.1;
const RAY_FONT: f64 = 10.5;
const BEST_FIT_FONT: f64 = 12.0;

/// What is drawn upon the map of a panel.
pub(crate) struct Marks<'a> {
    pub(crate) panel: &'a MapPanel,
    /// Labels of all observations of the figure.
    pub(crate) labels: &'a [&'a str],
}

impl Marks<'_> {
    pub(crate) fn draw_rays(&self, picture: &mut Picture, place: &impl Fn(Point) -> Point) {
        let window = self.panel.window();
        for ray in self.panel.other_rays().filter_map(|frequency| window.ray(frequency)) {
            picture.line(&ray.map(place), RAY);
        }
        if let Some(ray) = self.panel.best_fit_frequency_hz.and_then(|frequency| window.ray(frequency)) {
            let under = Stroke { color: Rgb::WHITE, width: 3.6, opacity: 0.7, dash: None };
            picture.line(&ray.map(place), under);
            picture.line(&ray.map(place), BEST_FIT_RAY);
        }
        for branch in self.panel.branches.iter().filter(|branch| branch.points.len() > 1) {
            let line: Vec<Point> = branch.points.iter().map(|&point| place(point)).collect();
            picture.line(&simplified(&line, BRANCH_TOLERANCE), BRANCH);
        }
    }

    fn ridge_points(&self, frame: &SheetBox, place: &impl Fn(Point) -> Point) -> Vec<(Point, bool)> {
        let marks: Vec<(Point, bool)> = self
            .panel
            .ridge
            .iter()
            .map(|mark| (place((mark.wavelength_m, mark.speed_m_per_s)), mark.at_edge))
            .filter(|(point, _)| frame.shrunk(-0.01).contains(*point))
            .collect();
        thinned_indices(marks.len(), MOST_RIDGE_MARKS).into_iter().map(|index| marks[index]).collect()
    }

    fn observation_points(&self, frame: &SheetBox, place: &impl Fn(Point) -> Point) -> Vec<(Point, usize)> {
        let shape = |label: &str| self.labels.iter().position(|other| *other == label).unwrap_or(0);
        self.panel
            .observations
            .iter()
            .map(|observation| {
                (place((observation.wavelength_m, observation.speed_m_per_s)), shape(&observation.label))
            })
            .filter(|(point, _)| frame.shrunk(-0.01).contains(*point))
            .collect()
    }

    pub(crate) fn draw_marks(&self, picture: &mut Picture, frame: &SheetBox, place: &impl Fn(Point) -> Point) {
        for (point, at_edge) in self.ridge_points(frame, place) {
            ridge_marker(at_edge).draw(picture, point, RIDGE_RADIUS, Rgb::BLACK);
        }
        for (point, shape) in self.observation_points(frame, place) {
            Marker::open(shape).draw(picture, point, OBSERVATION_RADIUS, Rgb::BLACK);
        }
    }

    pub(crate) fn draw_ray_labels(&self, picture: &mut Picture, frame: &SheetBox, place: &impl Fn(Point) -> Point) {
        let window = self.panel.window();
        let line = |frequency: f64| window.ray(frequency).map(|[from, to]| (place(from), place(to)));
        let marks: Vec<Point> = self
            .ridge_points(frame, place)
            .iter()
            .map(|mark| mark.0)
            .chain(self.observation_points(frame, place).iter().map(|mark| mark.0))
            .collect();
        let best = self.panel.best_fit_frequency_hz;
        let best_label = best.and_then(|frequency| {
            let label = format!("f = {} Hz", hertz(frequency));
            Some((Name::Best, line(frequency)?, label))
        });
        let named = |frequency: f64| format!("{} Hz", hertz(frequency));
        let branches = self.panel.weaker_branches().filter_map(|branch| {
            let (first, last) = (branch.points.first()?, branch.points.last()?);
            let ends = (place(*first), place(*last));
            Some((Name::Branch, ends, named(branch.frequency_hz.round())))
        });
        let others =
            self.panel.other_rays().filter_map(|frequency| Some((Name::Ray, line(frequency)?, named(frequency))));
        let inner = frame.shrunk(3.0);
        let mut taken: Vec<SheetBox> = Vec::new();
        for (name, ray, label) in best_label.into_iter().chain(branches).chain(others) {
            let lettering = match name {
                Name::Best => Lettering::new(BEST_FIT_FONT).bold().color(BEST_FIT),
                Name::Branch => Lettering::new(RAY_FONT).bold().color(BEST_FIT),
                Name::Ray => Lettering::new(RAY_FONT).color(Rgb(80, 80, 80)),
            };
            let size = (text::width(&label, lettering.size, lettering.weight) + 5.0, lettering.size + 3.0);
            let lines: Vec<(Point, Point)> =
                self.panel.other_rays().chain(best).filter_map(line).filter(|other| *other != ray).collect();
            let obstacles = Obstacles { labels: &taken, marks: &marks, lines: &lines };
            // A branch runs through marks of the ridge: its label stands beside it, the others break
            // their rays.
            let beside: &[f64] = match name {
                Name::Best | Name::Branch => &[1.0, -1.0, 0.0],
                Name::Ray => &[0.0],
            };
            let Some(spot) = sheet_box::along_line(ray, size, &inner, &obstacles, beside) else {
                continue;
            };
            picture.rectangle((spot.left, spot.top), (spot.right, spot.bottom), Rgb::WHITE, 0.85);
            picture.text(&label, spot.center(), lettering.anchor(Horizontal::Center, Vertical::Center));
            taken.push(spot);
        }
    }
}

/// What a frequency on a map is the name of.
enum Name {
    /// The strongest branch.
    Best,
    /// Another branch.
    Branch,
    /// A ray of constant frequency.
    Ray,
}

/// A frequency in words: whole hertz, decimals only for slow undulations.
pub(crate) fn hertz(frequency: f64) -> String {
    if frequency >= 100.0 || frequency.fract().abs() < 1e-9 {
        text::fixed(frequency, 0)
    } else {
        let digits = text::fixed(frequency, 2);
        digits.trim_end_matches('0').trim_end_matches('.').to_owned()
    }
}

/// Mark of the ridge.
pub(crate) fn ridge_marker(at_edge: bool) -> Marker {
    if at_edge { Marker::Circle } else { Marker::Disc }
}
