//! Pictures in pixels.

use tiny_skia::{FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, StrokeDash, Transform};
use ttf_parser::OutlineBuilder;

use super::font::{self, Glyph};
use super::picture::{Lettering, Picture, Shape, Stroke};
use super::point::Point;
use crate::color::Rgb;
use crate::error::PlotError;

/// Scale of [`Picture::png`] that suits a report: two device pixels per pixel of the sheet, 192 per inch.
pub const DEFAULT_PNG_SCALE: f32 = 2.0;

/// Longest side of a rendered picture, pixels: 16384² pixels take 1 GiB.
const LONGEST_SIDE: u32 = 16_384;

impl Picture {
    /// The picture as a PNG file.
    ///
    /// `scale` is the number of device pixels per pixel of the sheet, see [`DEFAULT_PNG_SCALE`]. Text is set in
    /// DejaVu Sans, which is compiled in; fonts of the machine are never looked at.
    ///
    /// # Errors
    /// [`PlotError::PictureSize`] if the picture would have a side below 1 or above 16384 pixels.
    pub fn png(&self, scale: f32) -> Result<Vec<u8>, PlotError> {
        let side = |length: f64| (length * f64::from(scale)).ceil();
        let (width, height) = (side(self.size.0), side(self.size.1));
        let size = || PlotError::PictureSize { width, height, limit: LONGEST_SIDE };
        let allowed = 1.0..=f64::from(LONGEST_SIDE);
        if !allowed.contains(&width) || !allowed.contains(&height) {
            return Err(size());
        }
        let mut pixels = Pixmap::new(width as u32, height as u32).ok_or_else(size)?;
        let to_device = Transform::from_scale(scale, scale);
        for shape in &self.shapes {
            draw(&mut pixels, to_device, shape);
        }
        pixels.encode_png().map_err(|error| PlotError::Drawing { reason: error.to_string() })
    }
}

fn draw(pixels: &mut Pixmap, to_device: Transform, shape: &Shape) {
    let mut path = PathBuilder::new();
    let mut fill = |path: Option<Path>, rule, color, opacity| {
        if let Some(path) = path {
            pixels.fill_path(&path, &paint(color, opacity), rule, to_device, None);
        }
    };
    let circle = |(x, y): Point, radius: f64| PathBuilder::from_circle(x as f32, y as f32, radius as f32);
    let (path, pen) = match shape {
        Shape::Line(points, stroke) => {
            trace(&mut path, points);
            (path.finish(), stroke)
        }
        Shape::Circle(center, radius, stroke) => (circle(*center, *radius), stroke),
        Shape::Disc(center, radius, color) => {
            return fill(circle(*center, *radius), FillRule::Winding, *color, 1.0);
        }
        Shape::Region(rings, color, opacity) => {
            for ring in rings.iter().filter(|ring| ring.len() > 2) {
                trace(&mut path, ring);
                path.close();
            }
            return fill(path.finish(), FillRule::EvenOdd, *color, *opacity);
        }
        Shape::Text(words, at, lettering) => {
            // Glyphs one by one: two that touch do not leave white where they overlap.
            for glyph in outlines(words, *at, *lettering) {
                fill(glyph, FillRule::Winding, lettering.color, 1.0);
            }
            return;
        }
    };
    if let Some(path) = path {
        let paint = paint(pen.color, pen.opacity);
        pixels.stroke_path(&path, &paint, &stroke(*pen), to_device, None);
    }
}

fn trace(path: &mut PathBuilder, points: &[Point]) {
    for (index, &(x, y)) in points.iter().enumerate() {
        match index {
            0 => path.move_to(x as f32, y as f32),
            _ => path.line_to(x as f32, y as f32),
        }
    }
}

fn paint(Rgb(red, green, blue): Rgb, opacity: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, (255.0 * opacity).round() as u8);
    paint
}

fn stroke(stroke: Stroke) -> tiny_skia::Stroke {
    tiny_skia::Stroke {
        width: stroke.width as f32,
        line_join: LineJoin::Round,
        dash: stroke.dash.and_then(|(dash, gap)| StrokeDash::new(vec![dash as f32, gap as f32], 0.0)),
        ..tiny_skia::Stroke::default()
    }
}

/// The outline of each character of a text.
fn outlines(words: &str, at: Point, lettering: Lettering) -> impl Iterator<Item = Option<Path>> {
    let (glyphs, width) = font::set(words, lettering.size, lettering.weight);
    let start = -lettering.horizontal.share_before() * width;
    glyphs.into_iter().map(move |glyph| {
        let mut outline = Outline { path: PathBuilder::new(), glyph, start, at, upward: lettering.upward };
        lettering.weight.face().outline_glyph(glyph.id, &mut outline);
        outline.path.finish()
    })
}

/// Takes an outline in design units to its place on the sheet.
struct Outline {
    path: PathBuilder,
    glyph: Glyph,
    /// Beginning of the text on its baseline, and the place of the text on the sheet.
    start: f64,
    at: Point,
    upward: bool,
}

impl Outline {
    fn place(&self, x: f32, y: f32) -> (f32, f32) {
        let along = self.start + self.glyph.at.0 + self.glyph.scale * f64::from(x);
        let down = self.glyph.at.1 - self.glyph.scale * f64::from(y);
        let (x, y) =
            if self.upward { (self.at.0 + down, self.at.1 - along) } else { (self.at.0 + along, self.at.1 + down) };
        (x as f32, y as f32)
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.place(x1, y1), self.place(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::font::Weight;
    use super::*;
    use crate::drawing::picture::{Horizontal, Vertical};

    /// The columns of a picture of words that have ink.
    fn inked_columns(words: &str, lettering: Lettering) -> Vec<usize> {
        let mut picture = Picture::new((300.0, 300.0), "", "");
        picture.text(words, (150.0, 150.0), lettering);
        let pixels = Pixmap::decode_png(&picture.png(1.0).unwrap()).unwrap();
        let dark = |x: u32| (0..300).any(|y| pixels.pixel(x, y).unwrap().red() < 128);
        (0..300).filter(|&x| dark(x)).map(|x| x as usize).collect()
    }

    /// Widths by which labels are placed agree with the widths that are drawn. The tolerance covers
    /// side bearings of the first and last glyph.
    #[test]
    fn words_are_as_wide_as_computed() {
        for weight in [Weight::Regular, Weight::Bold] {
            let words = "HgHf = 537 Hz, λ [mm] Re Ŵ₁ × 10⁻⁹ µüH";
            let lettering = Lettering { weight, ..Lettering::new(12.0).anchor(Horizontal::Center, Vertical::Center) };
            let columns = inked_columns(words, lettering);
            let drawn = (columns[columns.len() - 1] - columns[0] + 1) as f64;
            let computed = font::set(words, 12.0, weight).1;
            assert!((drawn / computed - 1.0).abs() < 0.02, "{weight:?}: drawn {drawn}, computed {computed}");
            // Upright they are as wide as a line is high.
            assert!(inked_columns(words, lettering.upward()).len() <= 15);
        }
    }

    #[test]
    fn impossible_pictures_are_refused() {
        let picture = Picture::new((100.0, 50.0), "", "");
        for scale in [0.0, -1.0, f32::NAN, 1e9] {
            assert!(matches!(picture.png(scale), Err(PlotError::PictureSize { .. })), "{scale}");
        }
    }
}
