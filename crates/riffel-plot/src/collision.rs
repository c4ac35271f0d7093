//! Words of a picture that lie over each other or leave the sheet: what a figure must not have, and its tests look for.

use resvg::tiny_skia::Rect;
use resvg::usvg::{Group, Node};

use crate::error::PlotError;
use crate::raster;

/// Ink of two words that shares no more than this is not seen to touch, pixels: the sheet counts in tenths of a pixel,
/// and glyphs are drawn with whole design units.
const TOUCH: f32 = 0.5;

/// One sentence for each two words of an SVG document whose ink overlaps, and for each word that leaves the sheet. None
/// for a picture that can be read.
///
/// # Errors
/// [`PlotError::Svg`] if the text is not an SVG document.
pub fn collisions(svg: &str) -> Result<Vec<String>, PlotError> {
    let picture = raster::tree(svg)?;
    let mut words = Vec::new();
    find(picture.root(), &mut words);
    let sheet = picture.size();
    let mut found = Vec::new();
    for (index, (said, ink)) in words.iter().enumerate() {
        let outside = ink.left() < 0.0
            || ink.top() < 0.0
            || ink.right() > sheet.width()
            || ink.bottom() > sheet.height();
        if outside {
            found.push(format!("{said:?} leaves the sheet"));
        }
        let over = words[..index]
            .iter()
            .filter(|(_, other)| overlap(ink, other));
        found.extend(over.map(|(other, _)| format!("{said:?} lies over {other:?}")));
    }
    Ok(found)
}

/// The texts below a node and the ink of each on the sheet.
fn find(group: &Group, words: &mut Vec<(String, Rect)>) {
    for node in group.children() {
        match node {
            Node::Group(group) => find(group, words),
            Node::Text(text) => {
                let said: String = text.chunks().iter().map(|chunk| chunk.text()).collect();
                words.push((said.trim().to_owned(), text.flattened().abs_bounding_box()));
            }
            _ => {}
        }
    }
}

fn overlap(one: &Rect, other: &Rect) -> bool {
    let shared = |from: f32, to: f32| to - from > TOUCH;
    shared(one.left().max(other.left()), one.right().min(other.right()))
        && shared(one.top().max(other.top()), one.bottom().min(other.bottom()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::{self, Lettering};

    #[test]
    fn words_in_one_place_are_found() {
        let at = |places: &[(f64, f64)]| {
            let svg = canvas::picture((200.0, 50.0), "", "", |canvas| {
                places
                    .iter()
                    .try_for_each(|&place| canvas.text("0.8", place, Lettering::new(12.0)))
            });
            collisions(&svg.unwrap()).unwrap()
        };
        assert!(at(&[(20.0, 12.0), (20.0, 24.0), (60.0, 12.0)]).is_empty());
        assert_eq!(
            at(&[(20.0, 12.0), (25.0, 16.0)]),
            ["\"0.8\" lies over \"0.8\""]
        );
        assert_eq!(at(&[(190.0, 12.0)]), ["\"0.8\" leaves the sheet"]);
    }
}
