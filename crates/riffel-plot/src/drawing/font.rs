//! DejaVu Sans, which travels with the crate, so that words are alike on every machine: places and outlines of glyphs.

use std::sync::LazyLock;

use ttf_parser::{Face, GlyphId};

use super::point::Point;
use super::subscript;

/// Weight of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Weight {
    Regular,
    Bold,
}

impl Weight {
    /// The font of this weight.
    pub(crate) fn face(self) -> &'static Face<'static> {
        static FACES: LazyLock<[Face<'static>; 2]> = LazyLock::new(|| {
            [dejavu::sans::regular(), dejavu::sans::bold()]
                .map(|font| Face::parse(font, 0).expect("the font that is compiled in can be read"))
        });
        &FACES[usize::from(self == Weight::Bold)]
    }
}

/// A character on its line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Glyph {
    pub(crate) id: GlyphId,
    /// Its origin in pixels from the beginning of the baseline.
    pub(crate) at: Point,
    /// Pixels per design unit.
    pub(crate) scale: f64,
}

/// The glyphs of a text with subscripts, and its width in pixels for a font size in pixels.
pub(crate) fn set(text: &str, size: f64, weight: Weight) -> (Vec<Glyph>, f64) {
    let face = weight.face();
    let (mut glyphs, mut x) = (Vec::new(), 0.0);
    for run in subscript::runs(text) {
        let (share, y) = if run.lowered { (subscript::SIZE, subscript::DEPTH * size) } else { (1.0, 0.0) };
        let scale = share * size / f64::from(face.units_per_em());
        let mut previous = None;
        for character in run.words.chars() {
            let id = face.glyph_index(character).unwrap_or_default();
            x += scale * f64::from(previous.map_or(0, |previous| kerning(face, previous, id)));
            let at = (x, y);
            glyphs.push(Glyph { id, at, scale });
            x += scale * f64::from(face.glyph_hor_advance(id).unwrap_or(0));
            previous = Some(id);
        }
    }
    (glyphs, x)
}

/// What two neighbours change of their distance, design units.
fn kerning(face: &Face<'_>, left: GlyphId, right: GlyphId) -> i16 {
    let tables = face.tables().kern.into_iter().flat_map(|kern| kern.subtables);
    let mut distances = tables
        .filter(|table| table.horizontal && !table.variable)
        .filter_map(|table| table.glyphs_kerning(left, right));
    distances.next().unwrap_or(0)
}
