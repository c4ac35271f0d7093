//! Pictures in pixels, rendered from the SVG with the same font on every machine.

use std::sync::{Arc, OnceLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{self, fontdb};

use crate::error::PlotError;

/// Scale of [`png`] that suits a report: two device pixels per pixel of the SVG, 192 per inch.
pub const DEFAULT_PNG_SCALE: f32 = 2.0;

/// Longest side of a rendered picture, pixels: 16384² pixels take 1 GiB.
const LONGEST_SIDE: u32 = 16_384;

/// Renders an SVG document as a PNG file.
///
/// `scale` is the number of device pixels per pixel of the SVG, see [`DEFAULT_PNG_SCALE`]. Text is
/// set in DejaVu Sans, which is compiled in; fonts of the machine are never looked at, nor any file
/// the document may refer to.
///
/// # Errors
/// [`PlotError::Svg`] if the text is not an SVG document, [`PlotError::PictureSize`] if the picture
/// would have a side below 1 or above 16384 pixels.
pub fn png(svg: &str, scale: f32) -> Result<Vec<u8>, PlotError> {
    let tree = tree(svg)?;
    let (width, height) = (
        f64::from(tree.size().width() * scale).ceil(),
        f64::from(tree.size().height() * scale).ceil(),
    );
    let size = || PlotError::PictureSize {
        width,
        height,
        limit: LONGEST_SIDE,
    };
    let allowed = 1.0..=f64::from(LONGEST_SIDE);
    if !allowed.contains(&width) || !allowed.contains(&height) {
        return Err(size());
    }
    let mut pixmap = Pixmap::new(width as u32, height as u32).ok_or_else(size)?;
    resvg::render(
        &tree,
        Transform::from_scale(scale, scale),
        &mut pixmap.as_mut(),
    );
    pixmap.encode_png().map_err(|error| PlotError::Drawing {
        reason: error.to_string(),
    })
}

/// Reads an SVG document with the fonts of this crate.
pub(crate) fn tree(svg: &str) -> Result<usvg::Tree, PlotError> {
    let mut options = usvg::Options {
        fontdb: fonts(),
        font_family: "DejaVu Sans".to_owned(),
        ..Default::default()
    };
    options.image_href_resolver.resolve_string = Box::new(|_, _| None);
    usvg::Tree::from_str(svg, &options).map_err(|error| PlotError::Svg {
        reason: error.to_string(),
    })
}

fn fonts() -> Arc<fontdb::Database> {
    static FONTS: OnceLock<Arc<fontdb::Database>> = OnceLock::new();
    let fonts = FONTS.get_or_init(|| {
        let mut database = fontdb::Database::new();
        database.load_font_data(dejavu::sans::regular().to_vec());
        database.load_font_data(dejavu::sans::bold().to_vec());
        database.set_sans_serif_family("DejaVu Sans");
        Arc::new(database)
    });
    Arc::clone(fonts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::{self, Lettering};
    use crate::text::{Weight, width};

    /// Widths by which labels are placed agree with the widths that are drawn. The tolerance covers
    /// side bearings of the first and last glyph and whole design units.
    #[test]
    fn words_are_as_wide_as_computed() {
        for weight in [Weight::Regular, Weight::Bold] {
            let words = "HgHf = 537 Hz, wavelength λ [mm] Re Ŵ₁ × 10⁻⁹H";
            let style = Lettering {
                weight,
                ..Lettering::new(12.0)
            };
            let svg = canvas::picture((600.0, 40.0), "", "", |canvas| {
                canvas.text(words, (20.0, 20.0), style)
            })
            .unwrap();
            let tree = tree(&svg).unwrap();
            let text = tree.root().children().iter().find_map(|node| match node {
                usvg::Node::Group(group) => group
                    .children()
                    .iter()
                    .find(|node| matches!(node, usvg::Node::Text(_))),
                node => matches!(node, usvg::Node::Text(_)).then_some(node),
            });
            let drawn = f64::from(text.unwrap().abs_bounding_box().width());
            let computed = width(words, 12.0, weight);
            assert!(
                (drawn / computed - 1.0).abs() < 0.02,
                "{weight:?}: drawn {drawn}, computed {computed}"
            );
        }
    }

    #[test]
    fn impossible_pictures_are_refused() {
        assert!(matches!(png("no picture", 2.0), Err(PlotError::Svg { .. })));
        let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\"/>";
        for scale in [0.0, -1.0, f32::NAN, 1e9] {
            assert!(
                matches!(png(svg, scale), Err(PlotError::PictureSize { .. })),
                "{scale}"
            );
        }
    }
}
