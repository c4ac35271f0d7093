//! The sheet a picture is drawn on: lines, polygons, marks and text in pixels with fractions.
//!
//! The backend counts in whole units. A unit is a tenth of a pixel here, and the root element of
//! the SVG scales it back, so curves are smooth and strokes can be thin.

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, RGBAColor, RGBColor, ShapeStyle, TextStyle};

use crate::color::Rgb;
use crate::error::PlotError;
use crate::subscript;
use crate::text::{self, Weight};

/// Backend units per pixel.
const UNITS: f64 = 10.0;

/// A point of the sheet in pixels, x to the right and y downward.
pub(crate) type Point = (f64, f64);

/// How a line is drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stroke {
    pub(crate) color: Rgb,
    /// Width in pixels.
    pub(crate) width: f64,
    pub(crate) opacity: f64,
    /// Lengths of dash and gap in pixels.
    pub(crate) dash: Option<(f64, f64)>,
}

impl Stroke {
    pub(crate) const fn solid(color: Rgb, width: f64) -> Self {
        Stroke {
            color,
            width,
            opacity: 1.0,
            dash: None,
        }
    }

    pub(crate) const fn dashed(color: Rgb, width: f64, dash: f64, gap: f64) -> Self {
        Stroke {
            color,
            width,
            opacity: 1.0,
            dash: Some((dash, gap)),
        }
    }

    pub(crate) const fn with_opacity(self, opacity: f64) -> Self {
        Stroke { opacity, ..self }
    }
}

/// How a text is set.
#[derive(Clone, Copy)]
pub(crate) struct Lettering {
    /// Font size in pixels.
    pub(crate) size: f64,
    pub(crate) weight: Weight,
    pub(crate) color: Rgb,
    pub(crate) horizontal: HPos,
    pub(crate) vertical: VPos,
    /// Reads from bottom to top.
    pub(crate) upward: bool,
}

impl Lettering {
    pub(crate) const fn new(size: f64) -> Self {
        Lettering {
            size,
            weight: Weight::Regular,
            color: Rgb::INK,
            horizontal: HPos::Left,
            vertical: VPos::Center,
            upward: false,
        }
    }

    pub(crate) const fn bold(self) -> Self {
        Lettering {
            weight: Weight::Bold,
            ..self
        }
    }

    pub(crate) const fn color(self, color: Rgb) -> Self {
        Lettering { color, ..self }
    }

    pub(crate) const fn anchor(self, horizontal: HPos, vertical: VPos) -> Self {
        Lettering {
            horizontal,
            vertical,
            ..self
        }
    }

    pub(crate) const fn upward(self) -> Self {
        Lettering {
            upward: true,
            ..self
        }
    }
}

/// The sheet.
pub(crate) struct Canvas<'a> {
    backend: SVGBackend<'a>,
}

/// Draws a picture of `size` pixels and returns it as an SVG document; `title` and `description`
/// are for readers that do not see it.
pub(crate) fn picture(
    size: (f64, f64),
    title: &str,
    description: &str,
    draw: impl FnOnce(&mut Canvas<'_>) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    let (width, height) = (size.0.ceil(), size.1.ceil());
    let units = ((width * UNITS) as u32, (height * UNITS) as u32);
    let mut buffer = String::new();
    {
        let mut canvas = Canvas {
            backend: SVGBackend::with_string(&mut buffer, units),
        };
        canvas.rectangle((0.0, 0.0), (width, height), Rgb::WHITE, 1.0)?;
        draw(&mut canvas)?;
        canvas.backend.present().map_err(drawing)?;
    }
    let body = buffer.find('>').map_or("", |end| &buffer[end + 1..]);
    let body = with_subscripts(body);
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {} {}\" \
         role=\"img\" stroke-linejoin=\"round\">\n<title>{}</title>\n<desc>{}</desc>{body}",
        units.0,
        units.1,
        text::escape(title),
        text::escape(description),
    ))
}

/// The document with subscripts in the words between its tags; the backend knows of none.
fn with_subscripts(body: &str) -> String {
    let mut whole = String::with_capacity(body.len());
    for piece in body.split_inclusive('>') {
        // Words, then the tag that ends them; every `<` and `>` of the words themselves is escaped.
        let (words, tag) = piece.split_at(piece.find('<').unwrap_or(piece.len()));
        whole += &subscript::svg(words);
        whole += tag;
    }
    whole
}

impl Canvas<'_> {
    /// A line through the points.
    pub(crate) fn line(&mut self, points: &[Point], stroke: Stroke) -> Result<(), PlotError> {
        match stroke.dash {
            None => self.solid_line(points, stroke),
            Some((dash, gap)) => dashes(points, dash, gap)
                .iter()
                .try_for_each(|piece| self.solid_line(piece, stroke)),
        }
    }

    fn solid_line(&mut self, points: &[Point], stroke: Stroke) -> Result<(), PlotError> {
        if points.len() < 2 {
            return Ok(());
        }
        let path: Vec<_> = points.iter().map(|&point| units(point)).collect();
        let width = (stroke.width * UNITS).round().max(1.0) as u32;
        let style = ShapeStyle {
            color: color(stroke.color, stroke.opacity),
            filled: false,
            stroke_width: width,
        };
        self.backend.draw_path(path, &style).map_err(drawing)
    }

    /// A filled polygon, closed by itself.
    pub(crate) fn polygon(
        &mut self,
        points: &[Point],
        fill: Rgb,
        opacity: f64,
    ) -> Result<(), PlotError> {
        if points.len() < 3 {
            return Ok(());
        }
        let path: Vec<_> = points.iter().map(|&point| units(point)).collect();
        self.backend
            .fill_polygon(path, &color(fill, opacity))
            .map_err(drawing)
    }

    /// A filled rectangle between two corners.
    pub(crate) fn rectangle(
        &mut self,
        from: Point,
        to: Point,
        fill: Rgb,
        opacity: f64,
    ) -> Result<(), PlotError> {
        self.backend
            .draw_rect(units(from), units(to), &color(fill, opacity), true)
            .map_err(drawing)
    }

    /// A disc.
    pub(crate) fn disc(&mut self, center: Point, radius: f64, fill: Rgb) -> Result<(), PlotError> {
        let radius = (radius * UNITS).round() as u32;
        self.backend
            .draw_circle(units(center), radius, &color(fill, 1.0), true)
            .map_err(drawing)
    }

    /// A circle.
    pub(crate) fn circle(
        &mut self,
        center: Point,
        radius: f64,
        stroke: Stroke,
    ) -> Result<(), PlotError> {
        let radius = (radius * UNITS).round() as u32;
        let width = (stroke.width * UNITS).round().max(1.0) as u32;
        let style = ShapeStyle {
            color: color(stroke.color, stroke.opacity),
            filled: false,
            stroke_width: width,
        };
        self.backend
            .draw_circle(units(center), radius, &style, false)
            .map_err(drawing)
    }

    /// A text on one line.
    pub(crate) fn text(
        &mut self,
        words: &str,
        at: Point,
        lettering: Lettering,
    ) -> Result<(), PlotError> {
        let words = text::printable(words);
        if words.trim().is_empty() {
            return Ok(());
        }
        // The backend divides the size by 1.24 to obtain the em of CSS.
        let size = lettering.size * UNITS * 1.24;
        let mut font = text::font(size, lettering.weight);
        if lettering.upward {
            font = font.transform(FontTransform::Rotate270);
        }
        let color = color(lettering.color, 1.0);
        let style = TextStyle::from(font)
            .color(&color)
            .pos(Pos::new(lettering.horizontal, lettering.vertical));
        self.backend
            .draw_text(&words, &style, units(at))
            .map_err(drawing)
    }
}

fn drawing(error: impl std::fmt::Display) -> PlotError {
    PlotError::Drawing {
        reason: error.to_string(),
    }
}

fn color(rgb: Rgb, opacity: f64) -> RGBAColor {
    RGBColor(rgb.0, rgb.1, rgb.2).mix(opacity)
}

fn units(point: Point) -> (i32, i32) {
    (
        (point.0 * UNITS).round() as i32,
        (point.1 * UNITS).round() as i32,
    )
}

/// Cuts a line into dashes; the pattern runs on around corners.
fn dashes(points: &[Point], dash: f64, gap: f64) -> Vec<Vec<Point>> {
    let mut pieces = Vec::new();
    let mut piece: Vec<Point> = points.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, dash);
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let t = done / length;
            let corner = (from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1));
            if drawing {
                piece.push(corner);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![corner];
            }
            drawing = !drawing;
            left = if drawing { dash } else { gap };
        }
        left -= length - done;
        if drawing {
            piece.push(to);
        }
    }
    if drawing && piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_cover_their_share_of_a_bent_line() {
        let bent = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)];
        let pieces = dashes(&bent, 3.0, 2.0);
        let total: f64 = pieces
            .iter()
            .flat_map(|piece| piece.windows(2))
            .map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1))
            .sum();
        assert_eq!(pieces.len(), 4);
        assert!((total - 12.0).abs() < 1e-12, "{total}");
    }
}
