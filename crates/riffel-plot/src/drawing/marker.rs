//! Marks of single points: discs, circles and other open shapes, told apart without colour.

use super::picture::{Picture, Stroke};
use super::point::Point;
use crate::color::Rgb;

/// Shape of a mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Marker {
    Disc,
    Circle,
    Triangle,
    Cross,
    Square,
    Diamond,
    TriangleDown,
    Plus,
}

impl Marker {
    /// Open shapes in the order in which observations take them; the first three are those of the
    /// literature for the data of Bhaskar et al. (1997).
    pub(crate) const OPEN: [Marker; 7] = [
        Marker::Circle,
        Marker::Triangle,
        Marker::Cross,
        Marker::Square,
        Marker::Diamond,
        Marker::TriangleDown,
        Marker::Plus,
    ];

    /// The open shape of the group `index`, starting over after the last.
    pub(crate) fn open(index: usize) -> Self {
        Self::OPEN[index % Self::OPEN.len()]
    }

    /// Name of the shape in plotly.js.
    pub(crate) fn plotly_symbol(self) -> &'static str {
        match self {
            Marker::Disc => "circle",
            Marker::Circle => "circle-open",
            Marker::Triangle => "triangle-up-open",
            Marker::Cross => "x-thin-open",
            Marker::Square => "square-open",
            Marker::Diamond => "diamond-open",
            Marker::TriangleDown => "triangle-down-open",
            Marker::Plus => "cross-thin-open",
        }
    }

    /// Draws the mark with a white rim, so that it is seen on dark and on pale ground.
    pub(crate) fn draw(self, picture: &mut Picture, at: Point, radius: f64, color: Rgb) {
        let pen = Stroke::solid(color, 1.1);
        let rim = Stroke::solid(Rgb::WHITE, 2.7).with_opacity(0.85);
        if self == Marker::Disc {
            picture.disc(at, radius + 0.7, Rgb::WHITE);
            picture.disc(at, radius, color);
            return;
        }
        for stroke in [rim, pen] {
            match self {
                Marker::Disc | Marker::Circle => picture.circle(at, radius, stroke),
                _ => {
                    for line in self.lines() {
                        let place = |&(x, y): &Point| (at.0 + radius * x, at.1 + radius * y);
                        picture.line(&line.iter().map(place).collect::<Vec<_>>(), stroke);
                    }
                }
            }
        }
    }

    /// Lines of the shape for a circumscribed circle of radius 1.
    fn lines(self) -> Vec<Vec<Point>> {
        let closed = |corners: &[Point]| corners.iter().chain(&corners[..2]).copied().collect::<Vec<_>>();
        match self {
            Marker::Disc | Marker::Circle => Vec::new(),
            Marker::Triangle => vec![closed(&[(0.0, -1.15), (1.05, 0.7), (-1.05, 0.7)])],
            Marker::TriangleDown => vec![closed(&[(0.0, 1.15), (1.05, -0.7), (-1.05, -0.7)])],
            Marker::Square => vec![closed(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)])],
            Marker::Diamond => vec![closed(&[(0.0, -1.2), (1.2, 0.0), (0.0, 1.2), (-1.2, 0.0)])],
            Marker::Cross => vec![vec![(-0.9, -0.9), (0.9, 0.9)], vec![(-0.9, 0.9), (0.9, -0.9)]],
            Marker::Plus => vec![vec![(-1.1, 0.0), (1.1, 0.0)], vec![(0.0, -1.1), (0.0, 1.1)]],
        }
    }
}
