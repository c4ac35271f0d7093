//! Legends: samples of lines, marks and fills with their names, in rows.

use super::font::Weight;
use super::marker::Marker;
use super::picture::{Horizontal, Lettering, Picture, Stroke, Vertical};
use super::point::Point;
use super::text;
use crate::color::Rgb;

/// What stands before a name.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Sample {
    Line(Stroke),
    /// A mark, its radius and its colour.
    Mark(Marker, f64, Rgb),
    Patch(Rgb),
}

/// A sample and its name.
#[derive(Debug, Clone)]
pub(crate) struct Entry {
    pub(crate) sample: Sample,
    pub(crate) name: String,
}

/// Font size of legends, pixels.
pub(crate) const FONT: f64 = 11.5;
/// Height of a row, pixels.
pub(crate) const ROW: f64 = 17.0;
const SAMPLE_WIDTH: f64 = 24.0;
const SAMPLE_GAP: f64 = 6.0;
const ENTRY_GAP: f64 = 18.0;

impl Entry {
    /// Width of sample and name, pixels.
    pub(crate) fn width(&self) -> f64 {
        self.sample.width() + SAMPLE_GAP + text::width(&self.name, FONT, Weight::Regular)
    }

    /// Draws the entry with its left end in the middle of its row at `at`.
    pub(crate) fn draw(&self, picture: &mut Picture, at: Point) {
        let width = self.sample.width();
        let middle = (at.0 + width / 2.0, at.1);
        match self.sample {
            Sample::Line(stroke) => picture.line(&[at, (at.0 + width, at.1)], stroke),
            Sample::Mark(marker, radius, color) => marker.draw(picture, middle, radius, color),
            Sample::Patch(fill) => picture.rectangle((at.0, at.1 - 4.5), (at.0 + width, at.1 + 4.5), fill, 1.0),
        }
        let lettering = Lettering::new(FONT).anchor(Horizontal::Left, Vertical::Center);
        picture.text(&self.name, (at.0 + width + SAMPLE_GAP, at.1), lettering)
    }
}

impl Sample {
    fn width(self) -> f64 {
        match self {
            Sample::Line(_) => SAMPLE_WIDTH,
            Sample::Mark(..) => 9.0,
            Sample::Patch(_) => 14.0,
        }
    }
}

/// An entry with its name on lines no wider than a limit.
fn lines(entry: &Entry, limit: f64) -> Vec<Entry> {
    let room = limit - entry.sample.width() - SAMPLE_GAP;
    let lines = text::wrap(&entry.name, FONT, Weight::Regular, room);
    let line = |name| Entry { sample: entry.sample, name };
    lines.into_iter().map(line).collect()
}

/// Breaks entries into rows no wider than `limit` pixels. An entry of several lines has a row to itself.
fn rows(entries: &[Entry], limit: f64) -> Vec<Vec<Entry>> {
    let mut rows: Vec<Vec<Entry>> = Vec::new();
    let mut used = f64::INFINITY;
    for entry in entries {
        let width = entry.width();
        match rows.last_mut() {
            Some(row) if used + ENTRY_GAP + width <= limit => {
                used += ENTRY_GAP + width;
                row.push(entry.clone());
            }
            _ if width <= limit => {
                used = width;
                rows.push(vec![entry.clone()]);
            }
            _ => {
                used = f64::INFINITY;
                rows.extend(lines(entry, limit).into_iter().map(|line| vec![line]));
            }
        }
    }
    rows
}

/// Height of a legend set in rows of at most `limit` pixels.
pub(crate) fn height(entries: &[Entry], limit: f64) -> f64 {
    rows(entries, limit).len() as f64 * ROW
}

/// Draws a legend in rows of at most `limit` pixels, its upper left corner at `corner`.
pub(crate) fn draw_rows(picture: &mut Picture, entries: &[Entry], corner: Point, limit: f64) {
    for (number, row) in rows(entries, limit).iter().enumerate() {
        let mut x = corner.0;
        for entry in row {
            entry.draw(picture, (x, corner.1 + (number as f64 + 0.5) * ROW));
            x += entry.width() + ENTRY_GAP;
        }
    }
}

/// Width and height of a legend with one entry per row.
pub(crate) fn column_size(entries: &[Entry]) -> (f64, f64) {
    (entries.iter().map(Entry::width).fold(0.0, f64::max), entries.len() as f64 * ROW)
}

/// Draws a legend with one entry per row, its upper left corner at `corner`.
pub(crate) fn draw_column(picture: &mut Picture, entries: &[Entry], corner: Point) {
    for (number, entry) in entries.iter().enumerate() {
        entry.draw(picture, (corner.0, corner.1 + (number as f64 + 0.5) * ROW));
    }
}
