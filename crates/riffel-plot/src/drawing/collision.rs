//! Words of a picture that lie over each other or leave the sheet: what a figure must not have, and its tests look for.

use super::font::{self, Weight};
use super::picture::Horizontal;
use super::sheet_box::SheetBox;

/// Ink of two words that shares no more than this is not seen to touch, pixels: the sheet counts in tenths of a pixel.
const TOUCH: f64 = 0.5;

/// One sentence for each two words whose ink overlaps in an SVG document of [`Picture`](crate::Picture), and for each
/// word that leaves the sheet. None for a picture that can be read. Subscripts count as large as the words around them.
pub fn collisions(svg: &str) -> Vec<String> {
    let side = |name| number(svg, name).unwrap_or(0.0);
    let sheet = SheetBox { left: 0.0, top: 0.0, right: side("width"), bottom: side("height") };
    let words: Vec<(String, SheetBox)> = svg.lines().filter_map(ink).collect();
    let mut found = Vec::new();
    for (index, (said, ink)) in words.iter().enumerate() {
        if !sheet.encloses(ink) {
            found.push(format!("{said:?} leaves the sheet"));
        }
        let over =
            words[..index].iter().filter(|(_, other)| ink.shrunk(TOUCH / 2.0).overlaps(&other.shrunk(TOUCH / 2.0)));
        found.extend(over.map(|(other, _)| format!("{said:?} lies over {other:?}")));
    }
    found
}

/// The words of an element of text, and their ink on the sheet.
fn ink(element: &str) -> Option<(String, SheetBox)> {
    let element = element.strip_prefix("<text")?;
    let (head, words) = element.split_once('>')?;
    let words = words.split('<').map(|piece| piece.split_once('>').map_or(piece, |(_, words)| words));
    let words = words.collect::<String>().replace("&lt;", "<").replace("&gt;", ">");
    let words = words.replace("&quot;", "\"").replace("&amp;", "&");
    let weight = match attribute(head, "font-weight") {
        Some(_) => Weight::Bold,
        None => Weight::Regular,
    };
    let horizontal = match attribute(head, "text-anchor") {
        Some("middle") => Horizontal::Center,
        Some(_) => Horizontal::Right,
        None => Horizontal::Left,
    };
    let (glyphs, width) = font::set(&words, number(head, "font-size")?, weight);
    let boxes = glyphs.iter().filter_map(|glyph| {
        let ink = weight.face().glyph_bounding_box(glyph.id)?;
        let (x, y) = glyph.at;
        let units = |units: i16| glyph.scale * f64::from(units);
        let (left, right) = (x + units(ink.x_min), x + units(ink.x_max));
        Some((left, y - units(ink.y_max), right, y - units(ink.y_min)))
    });
    let (left, top, right, bottom) = boxes.reduce(|a, b| (a.0.min(b.0), a.1.min(b.1), a.2.max(b.2), a.3.max(b.3)))?;
    let (x, y) = (number(head, "x")?, number(head, "y")?);
    let before = horizontal.share_before() * width;
    let (left, right) = (left - before, right - before);
    let place = match attribute(head, "transform") {
        None => SheetBox { left: x + left, top: y + top, right: x + right, bottom: y + bottom },
        Some(_) => SheetBox { left: x + top, top: y - right, right: x + bottom, bottom: y - left },
    };
    Some((words, place))
}

fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = element.split_once(&format!(" {name}=\""))?;
    rest.split_once('"').map(|(value, _)| value)
}

fn number(element: &str, name: &str) -> Option<f64> {
    attribute(element, name)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::picture::{Lettering, Picture};

    #[test]
    fn words_in_one_place_are_found() {
        let at = |places: &[(f64, f64)]| {
            let mut picture = Picture::new((200.0, 50.0), "", "");
            for &place in places {
                picture.text("0.8", place, Lettering::new(12.0));
            }
            collisions(&picture.svg())
        };
        assert!(at(&[(20.0, 12.0), (20.0, 24.0), (60.0, 12.0)]).is_empty());
        assert_eq!(at(&[(20.0, 12.0), (25.0, 16.0)]), ["\"0.8\" lies over \"0.8\""]);
        assert_eq!(at(&[(190.0, 12.0)]), ["\"0.8\" leaves the sheet"]);
    }
}
