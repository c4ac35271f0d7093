//! The sheet of a figure: where title, panels, legend and caption stand.

use super::font::Weight;
use super::legend::{self, Entry};
use super::picture::{Horizontal, Lettering, Picture, Vertical};
use super::sheet_box::SheetBox;
use super::text;
use crate::color::Rgb;

/// Height of a line of the words above a panel, pixels.
const SUBTITLE: f64 = 21.0;
const MARGIN: f64 = 10.0;
const TITLE_FONT: f64 = 14.0;
const TITLE_LINE: f64 = 19.0;
const SUBTITLE_FONT: f64 = 13.0;
const CAPTION_FONT: f64 = 12.0;
const CAPTION_LINE: f64 = 16.5;
/// Distance between panels side by side, pixels.
const COLUMN_GAP: f64 = 14.0;
/// Distance between panels one above the other, pixels.
const ROW_GAP: f64 = 12.0;

/// Room above a panel without words, pixels.
const LEAST_ABOVE: f64 = 8.0;

/// Panels of equal size in rows, with the words around them. All lengths are in pixels, 96 per
/// inch.
pub(crate) struct Sheet<'a> {
    pub(crate) title: &'a str,
    pub(crate) caption: &'a str,
    /// Words above each panel.
    pub(crate) subtitles: Vec<&'a str>,
    pub(crate) columns: usize,
    /// Width and height of the frame of a panel.
    pub(crate) frame_size: (f64, f64),
    /// Room left and right of a frame for its words.
    pub(crate) left: f64,
    pub(crate) right: f64,
    /// Room below the frame of each panel; a row takes what the panel with most words needs.
    pub(crate) below: Vec<f64>,
    pub(crate) legend: &'a [Entry],
}

impl Sheet<'_> {
    /// The words of the sheet, and each panel as it is drawn on its frame.
    pub(crate) fn picture(&self, mut draw: impl FnMut(&mut Picture, usize, SheetBox)) -> Picture {
        let mut picture = Picture::new(self.size(), self.title, self.caption);
        self.draw_words(&mut picture);
        for (index, subtitle) in self.subtitles.iter().enumerate() {
            let frame = self.frame(index);
            draw_subtitle(&mut picture, &frame, subtitle);
            draw(&mut picture, index, frame);
        }
        picture
    }

    fn width(&self) -> f64 {
        let column = self.left + self.frame_size.0 + self.right;
        2.0 * MARGIN + self.columns as f64 * (column + COLUMN_GAP) - COLUMN_GAP
    }

    fn text_width(&self) -> f64 {
        self.width() - 2.0 * MARGIN
    }

    fn title_lines(&self) -> Vec<String> {
        text::wrap(self.title, TITLE_FONT, Weight::Bold, self.text_width())
    }

    fn caption_lines(&self) -> Vec<String> {
        text::wrap(self.caption, CAPTION_FONT, Weight::Regular, self.text_width())
    }

    fn panels_top(&self) -> f64 {
        let lines = self.title_lines().len() as f64;
        MARGIN + lines * TITLE_LINE + if lines > 0.0 { 4.0 } else { 0.0 }
    }

    /// Height of the first rows with the gaps below them.
    fn height_of(&self, rows: usize) -> f64 {
        let below = self.below.chunks(self.columns.max(1)).take(rows);
        let height = |row: &[f64]| {
            let below = row.iter().copied().fold(0.0, f64::max);
            self.above() + self.frame_size.1 + below + ROW_GAP
        };
        below.map(height).sum()
    }

    fn above(&self) -> f64 {
        let lines = |subtitle: &&str| subtitle_lines(subtitle, self.frame_size.0).len();
        let most = self.subtitles.iter().map(lines).max().unwrap_or(0);
        (most as f64 * SUBTITLE).max(LEAST_ABOVE)
    }

    fn legend_top(&self) -> f64 {
        self.panels_top() + self.height_of(usize::MAX) - ROW_GAP + 8.0
    }

    fn caption_top(&self) -> f64 {
        let legend = legend::height(self.legend, self.text_width());
        self.legend_top() + legend + if legend > 0.0 { 8.0 } else { 0.0 }
    }

    fn size(&self) -> (f64, f64) {
        (self.width(), self.caption_top() + self.caption_lines().len() as f64 * CAPTION_LINE + MARGIN)
    }

    fn frame(&self, index: usize) -> SheetBox {
        let (row, column) = (index / self.columns, index % self.columns);
        let left = MARGIN + column as f64 * (self.left + self.frame_size.0 + self.right + COLUMN_GAP) + self.left;
        let top = self.panels_top() + self.height_of(row) + self.above();
        SheetBox { left, top, right: left + self.frame_size.0, bottom: top + self.frame_size.1 }
    }

    /// Title, legend and caption.
    fn draw_words(&self, picture: &mut Picture) {
        let style = Lettering::new(TITLE_FONT).bold().color(Rgb::BLACK).anchor(Horizontal::Left, Vertical::Top);
        for (index, line) in self.title_lines().iter().enumerate() {
            picture.text(line, (MARGIN, MARGIN + index as f64 * TITLE_LINE), style);
        }
        legend::draw_rows(picture, self.legend, (MARGIN, self.legend_top()), self.text_width());
        let style = Lettering::new(CAPTION_FONT).anchor(Horizontal::Left, Vertical::Top);
        for (index, line) in self.caption_lines().iter().enumerate() {
            picture.text(line, (MARGIN, self.caption_top() + index as f64 * CAPTION_LINE), style);
        }
    }
}

/// Words above a panel.
fn draw_subtitle(picture: &mut Picture, frame: &SheetBox, subtitle: &str) {
    let style = Lettering::new(SUBTITLE_FONT).anchor(Horizontal::Center, Vertical::Center);
    let lines = subtitle_lines(subtitle, frame.width());
    for (above, line) in lines.iter().rev().enumerate() {
        let height = (above as f64 + 0.5) * SUBTITLE;
        picture.text(line, (frame.center().0, frame.top - height), style);
    }
}

fn subtitle_lines(subtitle: &str, width: f64) -> Vec<String> {
    text::wrap(subtitle, SUBTITLE_FONT, Weight::Regular, width)
}
