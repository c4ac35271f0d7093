//! A picture: lines, regions, circles and words in pixels with fractions, in the order in which they are drawn.

use super::font::Weight;
use super::point::Point;
use super::text;
use crate::color::Rgb;

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
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
        Stroke { color, width, opacity: 1.0, dash: None }
    }

    pub(crate) const fn dashed(color: Rgb, width: f64, dash: f64, gap: f64) -> Self {
        Stroke { dash: Some((dash, gap)), ..Stroke::solid(color, width) }
    }

    pub(crate) const fn with_opacity(self, opacity: f64) -> Self {
        Stroke { opacity, ..self }
    }
}

/// The end of a text, or its middle, that stands at the given place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Horizontal {
    Left,
    Center,
    Right,
}

impl Horizontal {
    /// The part of the text that stands before the place.
    pub(crate) fn share_before(self) -> f64 {
        match self {
            Horizontal::Left => 0.0,
            Horizontal::Center => 0.5,
            Horizontal::Right => 1.0,
        }
    }
}

/// The height of a line of text that stands at the given place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Vertical {
    Top,
    Center,
}

impl Vertical {
    /// Depth of the baseline below the place, in sizes of the text: the height of its capitals, half of that of its
    /// small letters.
    fn depth(self) -> f64 {
        match self {
            Vertical::Top => 0.76,
            Vertical::Center => 0.273,
        }
    }
}

/// How a text is set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Lettering {
    /// Font size in pixels.
    pub(crate) size: f64,
    pub(crate) weight: Weight,
    pub(crate) color: Rgb,
    pub(crate) horizontal: Horizontal,
    pub(crate) vertical: Vertical,
    /// Reads from bottom to top.
    pub(crate) upward: bool,
}

impl Lettering {
    pub(crate) const fn new(size: f64) -> Self {
        Lettering {
            size,
            weight: Weight::Regular,
            color: Rgb::INK,
            horizontal: Horizontal::Left,
            vertical: Vertical::Center,
            upward: false,
        }
    }

    pub(crate) const fn bold(self) -> Self {
        Lettering { weight: Weight::Bold, ..self }
    }

    pub(crate) const fn color(self, color: Rgb) -> Self {
        Lettering { color, ..self }
    }

    pub(crate) const fn anchor(self, horizontal: Horizontal, vertical: Vertical) -> Self {
        Lettering { horizontal, vertical, ..self }
    }

    pub(crate) const fn upward(self) -> Self {
        Lettering { upward: true, ..self }
    }
}

/// What is drawn.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Shape {
    /// A line through points.
    Line(Vec<Point>, Stroke),
    /// Closed rings, filled where an odd number of them lies around.
    Region(Vec<Vec<Point>>, Rgb, f64),
    /// A filled circle.
    Disc(Point, f64, Rgb),
    /// A circle.
    Circle(Point, f64, Stroke),
    /// A text on one line, at a place of its baseline.
    Text(String, Point, Lettering),
}

/// A picture on white ground, to be written as [SVG](Picture::svg) or as [PNG](Picture::png).
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Width and height, whole pixels.
    pub(crate) size: (f64, f64),
    /// For readers that do not see the picture.
    pub(crate) title: String,
    pub(crate) description: String,
    pub(crate) shapes: Vec<Shape>,
}

impl Picture {
    /// A white sheet of at least a size.
    pub(crate) fn new(size: (f64, f64), title: &str, description: &str) -> Self {
        let size = (size.0.ceil(), size.1.ceil());
        let mut picture =
            Picture { size, title: title.to_owned(), description: description.to_owned(), shapes: Vec::new() };
        picture.rectangle((0.0, 0.0), size, Rgb::WHITE, 1.0);
        picture
    }

    /// Picture with another decimal mark in the numbers of its axes.
    #[must_use]
    pub fn with_decimal_mark(mut self, mark: &str) -> Self {
        for shape in &mut self.shapes {
            let Shape::Text(words, ..) = shape else {
                continue;
            };
            let first = words.split(' ').next().unwrap_or_default();
            if first.replace('\u{2212}', "-").parse::<f64>().is_ok() {
                *words = words.replace('.', mark);
            }
        }
        self
    }

    /// A line through points.
    pub(crate) fn line(&mut self, points: &[Point], stroke: Stroke) {
        if points.len() > 1 {
            self.shapes.push(Shape::Line(points.to_vec(), stroke));
        }
    }

    /// What lies within an odd number of closed rings.
    pub(crate) fn region(&mut self, rings: Vec<Vec<Point>>, fill: Rgb, opacity: f64) {
        self.shapes.push(Shape::Region(rings, fill, opacity));
    }

    /// A filled rectangle between two corners.
    pub(crate) fn rectangle(&mut self, from: Point, to: Point, fill: Rgb, opacity: f64) {
        let corners = vec![from, (to.0, from.1), to, (from.0, to.1)];
        self.region(vec![corners], fill, opacity);
    }

    pub(crate) fn disc(&mut self, center: Point, radius: f64, fill: Rgb) {
        self.shapes.push(Shape::Disc(center, radius, fill));
    }

    pub(crate) fn circle(&mut self, center: Point, radius: f64, stroke: Stroke) {
        self.shapes.push(Shape::Circle(center, radius, stroke));
    }

    /// A text on one line.
    pub(crate) fn text(&mut self, words: &str, at: Point, lettering: Lettering) {
        let words = text::printable(words);
        let words = words.trim();
        if !words.is_empty() {
            let depth = lettering.size * lettering.vertical.depth();
            let baseline = match lettering.upward {
                true => (at.0 + depth, at.1),
                false => (at.0, at.1 + depth),
            };
            let shape = Shape::Text(words.to_owned(), baseline, lettering);
            self.shapes.push(shape);
        }
    }
}
