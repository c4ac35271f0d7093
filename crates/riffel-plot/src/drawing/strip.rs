//! Strips as pictures.

use super::axis::{Axis, Direction, Ticks};
use super::frame::{self, Side};
use super::legend::{Entry, Sample};
use super::picture::Picture;
use super::sheet::Sheet;
use super::sheet_box::SheetBox;
use crate::error::PlotError;
use crate::scale::Scale;
use crate::strip_figure::{StripClass, StripFigure, StripPanel, StripRow};

const WIDTH: f64 = 560.0;
/// Height of a row and of the gap between two, pixels.
const ROW: f64 = 13.0;
const ROW_GAP: f64 = 3.0;

impl StripFigure {
    /// The figure as a picture. Identical data give an identical one.
    ///
    /// # Errors
    /// [`PlotError::NoPanel`].
    pub fn picture(&self) -> Result<Picture, PlotError> {
        if self.panels.is_empty() {
            return Err(PlotError::NoPanel);
        }
        let tallest = self.panels.iter().map(height).fold(0.0, f64::max);
        let beside = |panel| frame::room_beside(&row_ticks(panel), "", tallest);
        let below = |panel| frame::BELOW + height(panel) - tallest;
        let entry = |class: &StripClass| Entry { sample: Sample::Patch(class.color), name: class.label.clone() };
        let sheet = Sheet {
            title: &self.title,
            caption: &self.caption,
            subtitles: self.panels.iter().map(|panel| &*panel.subtitle).collect(),
            columns: 1,
            frame_size: (WIDTH, tallest),
            left: self.panels.iter().map(beside).fold(0.0, f64::max),
            right: 14.0,
            below: self.panels.iter().map(below).collect(),
            legend: &self.classes.iter().map(entry).collect::<Vec<_>>(),
        };
        Ok(sheet.picture(|picture, index, mut frame| {
            let panel = &self.panels[index];
            frame.bottom = frame.top + height(panel);
            self.draw(picture, panel, &frame);
        }))
    }

    fn draw(&self, picture: &mut Picture, panel: &StripPanel, frame: &SheetBox) {
        let strips = || panel.rows.iter().flat_map(|row| &row.strips);
        let range = Scale::Linear.range_of(strips().flat_map(|strip| [strip.from, strip.to]));
        let x = Axis::linear(range, (frame.left, frame.right));
        let inner = frame.shrunk(0.5 * ROW_GAP);
        let y = Axis::linear((0.0, panel.rows.len() as f64), (inner.top, inner.bottom));
        for (index, row) in panel.rows.iter().enumerate() {
            let middle = y.at(index as f64 + 0.5);
            let (top, bottom) = (middle - 0.5 * ROW, middle + 0.5 * ROW);
            for (left, right, class) in self.runs(row, &x) {
                let color = self.classes[class].color;
                picture.rectangle((left, top), (right, bottom), color, 1.0);
            }
        }
        let ticks = x.ticks((frame.width() / 60.0) as usize, Direction::Across);
        frame::draw_outline(picture, frame);
        frame::draw_axis(picture, frame, Side::Bottom, &x, &ticks, &panel.x_label);
        frame::draw_axis(picture, frame, Side::Left, &y, &row_ticks(panel), "");
    }

    /// Runs of pixels of one class: left and right end, and the class.
    fn runs(&self, row: &StripRow, x: &Axis) -> Vec<(f64, f64, usize)> {
        let pixels = (x.end - x.start).ceil() as usize;
        let mut classes: Vec<Option<usize>> = vec![None; pixels];
        for strip in row.strips.iter().filter(|strip| strip.value.is_finite()) {
            let class = self.classes.iter().position(|class| strip.value <= class.to);
            let place = |at: f64| (x.at(at) - x.start).max(0.0);
            let first = (place(strip.from).round() as usize).min(pixels.saturating_sub(1));
            let end = (place(strip.to).round() as usize).clamp(first + 1, pixels);
            for pixel in &mut classes[first..end] {
                *pixel = (*pixel).max(class);
            }
        }
        let mut runs: Vec<(f64, f64, usize)> = Vec::new();
        for (pixel, class) in classes.into_iter().enumerate() {
            let Some(class) = class else { continue };
            let left = x.start + pixel as f64;
            match runs.last_mut() {
                Some((_, right, last)) if *last == class && *right == left => *right += 1.0,
                _ => runs.push((left, left + 1.0, class)),
            }
        }
        runs
    }
}

fn height(panel: &StripPanel) -> f64 {
    panel.rows.len().max(1) as f64 * (ROW + ROW_GAP) + ROW_GAP
}

fn row_ticks(panel: &StripPanel) -> Ticks {
    Ticks::of_rows(panel.rows.iter().map(|row| row.label.as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::strip_figure::Strip;

    fn figure(strips: Vec<Strip>) -> StripFigure {
        let class =
            |label: &str, to: f64, grey: u8| StripClass { label: label.to_owned(), to, color: Rgb(grey, grey, grey) };
        StripFigure {
            classes: vec![class("low", 1.0, 200), class("high", f64::INFINITY, 50)],
            panels: vec![StripPanel {
                rows: vec![StripRow { label: "2026-01-31".to_owned(), strips }],
                ..StripPanel::default()
            }],
            ..StripFigure::default()
        }
    }

    /// Ten thousand strips on 560 pixels: the one that is high is seen.
    #[test]
    fn the_largest_value_of_a_pixel_is_drawn() {
        let strips: Vec<Strip> = (0..10_000)
            .map(|index| Strip {
                from: f64::from(index),
                to: f64::from(index + 1),
                value: if index == 5_003 { 2.0 } else { 0.5 },
            })
            .collect();
        let figure = figure(strips);
        let x = Axis::linear((0.0, 10_000.0), (0.0, WIDTH));
        let runs = figure.runs(&figure.panels[0].rows[0], &x);
        let drawn: Vec<(f64, usize)> = runs.iter().map(|run| (run.1 - run.0, run.2)).collect();
        assert_eq!(drawn, [(280.0, 0), (1.0, 1), (279.0, 0)]);
        assert!(figure.picture().unwrap().svg().contains("2026-01-31"));
    }

    #[test]
    fn what_is_not_known_stays_white() {
        let strip = |from: f64, value: f64| Strip { from, to: from + 10.0, value };
        let figure = figure(vec![strip(0.0, 0.5), strip(10.0, f64::NAN), strip(30.0, 3.0)]);
        let x = Axis::linear((0.0, 40.0), (0.0, 40.0));
        let runs = figure.runs(&figure.panels[0].rows[0], &x);
        assert_eq!(runs, [(0.0, 10.0, 0), (30.0, 40.0, 1)]);
    }
}
