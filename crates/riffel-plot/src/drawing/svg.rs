//! Pictures as SVG documents: one element a line, words as words.

use std::fmt::Write;

use super::font::Weight;
use super::picture::{Horizontal, Lettering, Picture, Shape, Stroke};
use super::point::Point;
use super::subscript;
use super::text::escape;
use crate::color::Rgb;

/// `font-family` of a picture. Where a viewer lacks DejaVu Sans, its own sans serif replaces it.
const FONT_FAMILY: &str = "DejaVu Sans, sans-serif";

impl Picture {
    /// The picture as an SVG document. Identical pictures give identical text.
    pub fn svg(&self) -> String {
        let (width, height) = self.size;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" stroke-linejoin=\"round\" font-family=\"{FONT_FAMILY}\">\n\
             <title>{}</title>\n<desc>{}</desc>\n",
            escape(&self.title),
            escape(&self.description),
        );
        for shape in &self.shapes {
            svg += &element(shape);
            svg.push('\n');
        }
        svg + "</svg>\n"
    }
}

fn element(shape: &Shape) -> String {
    match shape {
        Shape::Line(points, stroke) => {
            let points = points.iter().map(|&point| place(point));
            let points = points.collect::<Vec<_>>().join(" ");
            format!("<polyline points=\"{points}\" {}/>", pen(*stroke))
        }
        Shape::Region(rings, color, opacity) => {
            let mut path = String::new();
            for ring in rings.iter().filter(|ring| ring.len() > 2) {
                let points: Vec<String> = ring.iter().map(|&point| place(point)).collect();
                let _ = write!(path, "M{}Z", points.join("L"));
            }
            let fill = paint("fill", *color, *opacity);
            format!("<path d=\"{path}\" fill-rule=\"evenodd\" {fill}/>")
        }
        Shape::Disc(center, radius, color) => {
            format!("<circle {} {}/>", round(*center, *radius), paint("fill", *color, 1.0))
        }
        Shape::Circle(center, radius, stroke) => {
            format!("<circle {} {}/>", round(*center, *radius), pen(*stroke))
        }
        Shape::Text(words, at, lettering) => text(words, *at, *lettering),
    }
}

fn round((x, y): Point, radius: f64) -> String {
    format!("cx=\"{}\" cy=\"{}\" r=\"{}\"", short(x), short(y), short(radius))
}

fn text(words: &str, (x, y): Point, lettering: Lettering) -> String {
    let (x, y) = (short(x), short(y));
    let anchor = match lettering.horizontal {
        Horizontal::Left => "",
        Horizontal::Center => " text-anchor=\"middle\"",
        Horizontal::Right => " text-anchor=\"end\"",
    };
    let weight = match lettering.weight {
        Weight::Regular => "",
        Weight::Bold => " font-weight=\"bold\"",
    };
    let turn = match lettering.upward {
        false => String::new(),
        true => format!(" transform=\"rotate(-90 {x} {y})\""),
    };
    format!(
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\"{weight}{anchor}{turn} {}>{}</text>",
        short(lettering.size),
        paint("fill", lettering.color, 1.0),
        subscript::svg(&escape(words)),
    )
}

fn pen(stroke: Stroke) -> String {
    let dash = stroke
        .dash
        .map_or(String::new(), |(dash, gap)| format!(" stroke-dasharray=\"{} {}\"", short(dash), short(gap)));
    let color = paint("stroke", stroke.color, stroke.opacity);
    format!("fill=\"none\" {color} stroke-width=\"{}\"{dash}", short(stroke.width))
}

fn paint(what: &str, color: Rgb, opacity: f64) -> String {
    match opacity < 1.0 {
        true => format!("{what}=\"{}\" {what}-opacity=\"{opacity}\"", color.hex()),
        false => format!("{what}=\"{}\"", color.hex()),
    }
}

fn place((x, y): Point) -> String {
    format!("{},{}", short(x), short(y))
}

/// A length in tenths of a pixel.
fn short(length: f64) -> String {
    let tenths = (length * 10.0).round() / 10.0 + 0.0;
    format!("{tenths}")
}
