//! Bars as pictures.

use super::axis::{Axis, Direction, Ticks};
use super::font::Weight;
use super::frame::{self, Side};
use super::legend::{Entry, Sample};
use super::picture::{Horizontal, Lettering, Picture, Stroke, Vertical};
use super::sheet::Sheet;
use super::sheet_box::SheetBox;
use super::text;
use crate::bar_figure::{BarArrangement, BarFigure, BarPanel};
use crate::color::{OKABE_ITO, Rgb};
use crate::error::PlotError;
use crate::scale::Scale;

const WIDTH: f64 = 400.0;
/// Height of a bar, pixels.
const BAR: f64 = 11.0;
/// Distance of one row from the next, pixels.
const ROW_GAP: f64 = 11.0;
const NOTE_FONT: f64 = 10.5;
const NOTE_GAP: f64 = 4.0;
/// Length from which a bar has words at its end, pixels.
const SEEN: f64 = 0.5;
const BAR_OPACITY: f64 = 0.85;

impl BarFigure {
    /// The figure as a picture. Identical data give an identical one.
    ///
    /// # Errors
    /// [`PlotError::NoPanel`], [`PlotError::SeriesLength`] where rows and bars differ in number.
    pub fn picture(&self) -> Result<Picture, PlotError> {
        self.check()?;
        let height = |panel: &BarPanel| panel.rows.len().max(1) as f64 * row_height(panel) + ROW_GAP;
        let tallest = self.panels.iter().map(height).fold(0.0, f64::max);
        let beside = |panel| frame::room_beside(&row_ticks(panel), "", tallest);
        let below = |panel| frame::BELOW + height(panel) - tallest;
        let sheet = Sheet {
            title: &self.title,
            caption: &self.caption,
            subtitles: self.panels.iter().map(|panel| &*panel.subtitle).collect(),
            columns: 1,
            frame_size: (WIDTH, tallest),
            left: self.panels.iter().map(beside).fold(0.0, f64::max),
            right: 14.0,
            below: self.panels.iter().map(below).collect(),
            legend: &entries(self),
        };
        Ok(sheet.picture(|picture, index, mut frame| {
            let panel = &self.panels[index];
            frame.bottom = frame.top + height(panel);
            draw(picture, panel, &frame);
        }))
    }

    fn check(&self) -> Result<(), PlotError> {
        if self.panels.is_empty() {
            return Err(PlotError::NoPanel);
        }
        for (index, panel) in self.panels.iter().enumerate() {
            for series in &panel.series {
                if series.bars.len() != panel.rows.len() {
                    return Err(PlotError::SeriesLength {
                        panel: index,
                        label: series.label.clone(),
                        x_count: panel.rows.len(),
                        y_count: series.bars.len(),
                    });
                }
            }
        }
        Ok(())
    }
}

fn row_height(panel: &BarPanel) -> f64 {
    let bars = match panel.arrangement {
        BarArrangement::SideBySide => panel.series.len().max(1),
        BarArrangement::OnOneLine => 1,
    };
    bars as f64 * BAR + ROW_GAP
}

fn row_ticks(panel: &BarPanel) -> Ticks {
    Ticks::of_rows(panel.rows.iter().map(String::as_str))
}

/// The series of all panels by name, each once.
fn entries(figure: &BarFigure) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for panel in &figure.panels {
        for (index, series) in panel.series.iter().enumerate() {
            let known = entries.iter().any(|entry| entry.name == series.label);
            if !series.label.is_empty() && !known {
                entries.push(Entry { sample: Sample::Patch(color(panel, index)), name: series.label.clone() });
            }
        }
    }
    entries
}

fn color(panel: &BarPanel, index: usize) -> Rgb {
    panel.series[index].color.unwrap_or(OKABE_ITO[index % OKABE_ITO.len()])
}

/// Range of the bars with room for the words at their ends.
fn range(panel: &BarPanel) -> (f64, f64) {
    if let Some(range) = panel.x_range {
        return range;
    }
    let bars = || panel.series.iter().flat_map(|series| &series.bars);
    let values = bars().flat_map(|bar| {
        let (low, high) = bar.interval.unwrap_or((bar.value, bar.value));
        [bar.value, low, high]
    });
    let (low, high) = Scale::Linear.with_air(Scale::Linear.range_of(values.chain([panel.base])));
    let widest = bars().map(|bar| text::width(&bar.note, NOTE_FONT, Weight::Regular)).fold(0.0, f64::max);
    if widest == 0.0 {
        return (low, high);
    }
    // Words stand outside of the bars, on either side.
    let share = ((widest + 2.0 * NOTE_GAP) / WIDTH).min(0.4);
    let room = share / (1.0 - 2.0 * share) * (high - low);
    (low - room, high + room)
}

fn draw(picture: &mut Picture, panel: &BarPanel, frame: &SheetBox) {
    let (low, high) = range(panel);
    let x = Axis::linear((low, high), (frame.left, frame.right));
    let inner = frame.shrunk(0.5 * ROW_GAP);
    let y = Axis::linear((0.0, panel.rows.len() as f64), (inner.top, inner.bottom));
    let ticks = x.ticks((frame.width() / 60.0) as usize, Direction::Across);
    frame::draw_grid(picture, frame, (&x, &ticks), (&y, &Ticks::default()));
    let base = x.at(panel.base).clamp(frame.left, frame.right);
    for (index, series) in panel.series.iter().enumerate() {
        for (row, bar) in series.bars.iter().enumerate() {
            if !bar.value.is_finite() {
                continue;
            }
            let middle = y.at(row as f64 + 0.5);
            let top = match panel.arrangement {
                BarArrangement::OnOneLine => middle - 0.5 * BAR,
                BarArrangement::SideBySide => middle + (index as f64 - 0.5 * panel.series.len() as f64) * BAR,
            };
            let end = x.at(bar.value).clamp(frame.left, frame.right);
            let (left, right) = (base.min(end), base.max(end));
            picture.rectangle((left, top + 0.5), (right, top + BAR - 0.5), color(panel, index), BAR_OPACITY);
            if let Some((from, to)) = bar.interval {
                let at = top + 0.5 * BAR;
                let [from, to] = [from, to].map(|value| x.at(value).clamp(frame.left, frame.right));
                let stroke = Stroke::solid(Rgb::INK, 1.0);
                picture.line(&[(from, at), (to, at)], stroke);
                for end in [from, to] {
                    picture.line(&[(end, at - 2.5), (end, at + 2.5)], stroke);
                }
            }
            let (place, anchor) = match bar.value < panel.base {
                true => (left - NOTE_GAP, Horizontal::Right),
                false => (right + NOTE_GAP, Horizontal::Left),
            };
            if right - left < SEEN {
                // Two bars of no length would have their words in one place.
                continue;
            }
            let lettering = Lettering::new(NOTE_FONT).anchor(anchor, Vertical::Center);
            picture.text(&bar.note, (place, top + 0.5 * BAR), lettering);
        }
    }
    picture.line(&[(base, frame.top), (base, frame.bottom)], Stroke::solid(Rgb::INK, 1.0));
    frame::draw_outline(picture, frame);
    frame::draw_axis(picture, frame, Side::Bottom, &x, &ticks, &panel.x_label);
    frame::draw_axis(picture, frame, Side::Left, &y, &row_ticks(panel), "")
}
