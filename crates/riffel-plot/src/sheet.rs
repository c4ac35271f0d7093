//! The sheet of a figure: where title, panels, legend and caption stand.

use plotters::style::text_anchor::{HPos, VPos};

use crate::canvas::{Canvas, Lettering};
use crate::color::Rgb;
use crate::error::PlotError;
use crate::legend::{self, Entry};
use crate::sheet_box::SheetBox;
use crate::text::{self, Weight};

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

/// Panels of equal size in rows, with the words around them. All lengths are in pixels, 96 per
/// inch.
pub(crate) struct Sheet<'a> {
    pub(crate) title: &'a str,
    pub(crate) caption: &'a str,
    pub(crate) columns: usize,
    pub(crate) panel_count: usize,
    /// Width and height of the frame of a panel.
    pub(crate) frame_size: (f64, f64),
    /// Room left, right, above and below a frame for its words.
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) above: f64,
    pub(crate) below: f64,
    pub(crate) legend: &'a [Entry],
}

impl Sheet<'_> {
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
        text::wrap(
            self.caption,
            CAPTION_FONT,
            Weight::Regular,
            self.text_width(),
        )
    }

    fn panels_top(&self) -> f64 {
        let lines = self.title_lines().len() as f64;
        MARGIN + lines * TITLE_LINE + if lines > 0.0 { 4.0 } else { 0.0 }
    }

    fn row_height(&self) -> f64 {
        self.above + self.frame_size.1 + self.below
    }

    fn legend_top(&self) -> f64 {
        let rows = self.panel_count.div_ceil(self.columns.max(1)) as f64;
        self.panels_top() + rows * (self.row_height() + ROW_GAP) - ROW_GAP + 8.0
    }

    fn caption_top(&self) -> f64 {
        let legend = legend::height(self.legend, self.text_width());
        self.legend_top() + legend + if legend > 0.0 { 8.0 } else { 0.0 }
    }

    /// Width and height of the sheet.
    pub(crate) fn size(&self) -> (f64, f64) {
        (
            self.width(),
            self.caption_top() + self.caption_lines().len() as f64 * CAPTION_LINE + MARGIN,
        )
    }

    /// Frame of the panel `index`.
    pub(crate) fn frame(&self, index: usize) -> SheetBox {
        let (row, column) = (index / self.columns, index % self.columns);
        let left = MARGIN
            + column as f64 * (self.left + self.frame_size.0 + self.right + COLUMN_GAP)
            + self.left;
        let top = self.panels_top() + row as f64 * (self.row_height() + ROW_GAP) + self.above;
        SheetBox {
            left,
            top,
            right: left + self.frame_size.0,
            bottom: top + self.frame_size.1,
        }
    }

    /// Title, legend and caption.
    pub(crate) fn draw_words(&self, canvas: &mut Canvas<'_>) -> Result<(), PlotError> {
        let style = Lettering::new(TITLE_FONT)
            .bold()
            .color(Rgb::BLACK)
            .anchor(HPos::Left, VPos::Top);
        for (index, line) in self.title_lines().iter().enumerate() {
            canvas.text(line, (MARGIN, MARGIN + index as f64 * TITLE_LINE), style)?;
        }
        legend::draw_rows(
            canvas,
            self.legend,
            (MARGIN, self.legend_top()),
            self.text_width(),
        )?;
        let style = Lettering::new(CAPTION_FONT).anchor(HPos::Left, VPos::Top);
        for (index, line) in self.caption_lines().iter().enumerate() {
            canvas.text(
                line,
                (MARGIN, self.caption_top() + index as f64 * CAPTION_LINE),
                style,
            )?;
        }
        Ok(())
    }

    /// Words above a panel.
    pub(crate) fn draw_subtitle(
        &self,
        canvas: &mut Canvas<'_>,
        frame: &SheetBox,
        subtitle: &str,
    ) -> Result<(), PlotError> {
        let style = Lettering::new(SUBTITLE_FONT).anchor(HPos::Center, VPos::Center);
        let lines = subtitle_lines(subtitle, frame.width());
        for (above, line) in lines.iter().rev().enumerate() {
            let place = (
                frame.center().0,
                frame.top - (above as f64 + 0.5) * SUBTITLE,
            );
            canvas.text(line, place, style)?;
        }
        Ok(())
    }
}

fn subtitle_lines(subtitle: &str, width: f64) -> Vec<String> {
    text::wrap(subtitle, SUBTITLE_FONT, Weight::Regular, width)
}

/// Height of the highest of the words above panels of a width, pixels.
pub(crate) fn subtitle_height<'a>(subtitles: impl Iterator<Item = &'a str>, width: f64) -> f64 {
    let lines = subtitles.map(|subtitle| subtitle_lines(subtitle, width).len());
    lines.max().unwrap_or(0) as f64 * SUBTITLE
}
