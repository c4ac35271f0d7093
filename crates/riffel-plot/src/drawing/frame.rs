//! The frame of a panel: axes, ticks, grid and their words.

use super::axis::{Axis, Ticks};
use super::font::Weight;
use super::picture::{Horizontal, Lettering, Picture, Stroke, Vertical};
use super::sheet_box::SheetBox;
use super::text::{self, TICK_FONT, TITLE_FONT};
use crate::color::Rgb;

/// Distance from a frame to its tick labels, pixels.
const TICK_GAP: f64 = 5.0;
/// Distance from tick labels to the axis title, pixels.
const TITLE_GAP: f64 = 5.0;
/// Distance of the lines of an axis title beside a frame, pixels.
const TITLE_LINE: f64 = TITLE_FONT + 3.0;
/// Height of the tick labels and the title below a frame, pixels.
pub(crate) const BELOW: f64 = TICK_GAP + TICK_FONT + TITLE_GAP + TITLE_FONT + 3.0;

const OUTLINE: Stroke = Stroke::solid(Rgb::INK, 0.9);
const GRID: Stroke = Stroke::solid(Rgb::GRID, 0.7);
const MINOR_GRID: Stroke = Stroke::solid(Rgb::GRID, 0.4);

/// Side of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Bottom,
    Left,
    Right,
}

/// Room a vertical axis of `length` pixels needs beside its frame, pixels.
pub(crate) fn room_beside(ticks: &Ticks, title: &str, length: f64) -> f64 {
    let lines = upright_title(ticks, title, length).len().max(1);
    TICK_GAP + label_width(ticks) + TITLE_GAP + lines as f64 * TITLE_LINE
}

/// The lines of the title beside a frame. It may stand out as far as the words below the frame, no farther: there
/// the next panel begins.
fn upright_title(ticks: &Ticks, title: &str, length: f64) -> Vec<String> {
    let title = ticks.title(title);
    text::wrap(&title, TITLE_FONT, Weight::Regular, length + BELOW)
}

fn label_width(ticks: &Ticks) -> f64 {
    ticks.labels().map(|label| text::width(label, TICK_FONT, Weight::Regular)).fold(0.0, f64::max)
}

/// Grid lines at the ticks of both axes.
pub(crate) fn draw_grid(
    picture: &mut Picture,
    frame: &SheetBox,
    (x, x_ticks): (&Axis, &Ticks),
    (y, y_ticks): (&Axis, &Ticks),
) {
    let stroke = |label: &Option<String>| if label.is_some() { GRID } else { MINOR_GRID };
    for tick in &x_ticks.ticks {
        let at = x.at(tick.value);
        picture.line(&[(at, frame.top), (at, frame.bottom)], stroke(&tick.label));
    }
    for tick in &y_ticks.ticks {
        let at = y.at(tick.value);
        picture.line(&[(frame.left, at), (frame.right, at)], stroke(&tick.label));
    }
}

/// The four sides of the frame.
pub(crate) fn draw_outline(picture: &mut Picture, frame: &SheetBox) {
    let SheetBox { left, top, right, bottom } = *frame;
    picture.line(&[(left, top), (right, top), (right, bottom), (left, bottom), (left, top), (right, top)], OUTLINE)
}

/// Ticks, tick labels and title of one side.
pub(crate) fn draw_axis(picture: &mut Picture, frame: &SheetBox, side: Side, axis: &Axis, ticks: &Ticks, title: &str) {
    let label_style = Lettering::new(TICK_FONT);
    for tick in &ticks.ticks {
        let at = axis.at(tick.value);
        let length = if tick.label.is_some() { 4.0 } else { 2.2 };
        let label = tick.label.as_deref().unwrap_or("");
        match side {
            Side::Bottom => {
                picture.line(&[(at, frame.bottom), (at, frame.bottom - length)], OUTLINE);
                let place = (at, frame.bottom + TICK_GAP);
                picture.text(label, place, label_style.anchor(Horizontal::Center, Vertical::Top));
            }
            Side::Left => {
                picture.line(&[(frame.left, at), (frame.left + length, at)], OUTLINE);
                let place = (frame.left - TICK_GAP, at);
                picture.text(label, place, label_style.anchor(Horizontal::Right, Vertical::Center));
            }
            Side::Right => {
                picture.line(&[(frame.right, at), (frame.right - length, at)], OUTLINE);
                let place = (frame.right + TICK_GAP, at);
                picture.text(label, place, label_style.anchor(Horizontal::Left, Vertical::Center));
            }
        }
    }
    let style = Lettering::new(TITLE_FONT);
    let (middle_x, middle_y) = frame.center();
    if side == Side::Bottom {
        let place = (middle_x, frame.bottom + TICK_GAP + TICK_FONT + TITLE_GAP);
        let title = ticks.title(title);
        picture.text(&title, place, style.anchor(Horizontal::Center, Vertical::Top));
        return;
    }
    let style = style.anchor(Horizontal::Center, Vertical::Center).upward();
    let lines = upright_title(ticks, title, frame.height());
    let beside = TICK_GAP + label_width(ticks) + TITLE_GAP + TITLE_FONT / 2.0;
    for (index, line) in lines.iter().enumerate() {
        // Lines that read upward follow each other to the right.
        let x = match side {
            Side::Right => frame.right + beside + index as f64 * TITLE_LINE,
            _ => frame.left - beside - (lines.len() - 1 - index) as f64 * TITLE_LINE,
        };
        picture.text(line, (x, middle_y), style);
    }
}
