//! The names of marks: upright beside their lines, clear of each other and, where there is room, of the curves.

use super::font::Weight;
use super::picture::{Horizontal, Lettering, Picture, Vertical};
use super::point::Point;
use super::sheet_box::SheetBox;
use super::text;
use crate::color::Rgb;

const FONT: f64 = 10.0;
/// Distance of a name from the ends of the frame, pixels.
const END_GAP: f64 = 5.0;
/// Distance of a name from its line, pixels.
const LINE_GAP: f64 = 1.5;
/// Width of an upright line of words with the room that it keeps from the next, pixels.
const THICKNESS: f64 = FONT + 1.5;
/// Pieces of curves that a name covers rather than the line of another mark.
const LINE_OF_MARK: usize = 50;
/// Step in which places along the line are tried, pixels.
const STEP: f64 = 6.0;

/// A name and its place.
pub(crate) struct MarkName {
    words: String,
    place: SheetBox,
    /// Whether curves run below it.
    covers: bool,
}

impl MarkName {
    /// A line that whoever covers the name crosses.
    pub(crate) fn diagonal(&self) -> Vec<Point> {
        let SheetBox { left, top, right, bottom } = self.place;
        vec![(left, top), (right, bottom)]
    }

    /// Draws the name, moved by `shift`.
    pub(crate) fn draw(&self, picture: &mut Picture, shift: Point) {
        let place = self.place;
        if self.covers {
            picture.rectangle(
                (place.left + shift.0, place.top + shift.1),
                (place.right + shift.0, place.bottom + shift.1),
                Rgb::WHITE,
                0.8,
            );
        }
        let at = (place.center().0 + shift.0, place.bottom + shift.1);
        let lettering = Lettering::new(FONT).anchor(Horizontal::Left, Vertical::Center).upward();
        picture.text(&self.words, at, lettering)
    }
}

/// Places for the names of marks, given with the positions of their lines: left of the line at its upper end, at its
/// lower end, anywhere along it, or the same at its right; the place with the fewest curves. A name for which there
/// is no room at all is left out.
pub(crate) fn beside(marks: &[(&str, f64)], lines: &[Vec<Vec<Point>>], frame: &SheetBox) -> Vec<MarkName> {
    let mut names: Vec<MarkName> = Vec::new();
    for &(words, at) in marks {
        let length = text::width(words, FONT, Weight::Regular);
        let room = frame.height() - 2.0 * END_GAP - length;
        if words.trim().is_empty() || room < 0.0 {
            continue;
        }
        let steps = (room / STEP) as usize;
        let along = [0.0, room].into_iter().chain((1..=steps).map(|step| step as f64 * STEP));
        let mut best: Option<(usize, SheetBox)> = None;
        for (side, down) in [-1.0, 1.0].into_iter().flat_map(|side| along.clone().map(move |down| (side, down))) {
            let center = at + side * (0.5 * THICKNESS + LINE_GAP);
            let top = frame.top + END_GAP + down;
            let place =
                SheetBox { left: center - 0.5 * THICKNESS, right: center + 0.5 * THICKNESS, top, bottom: top + length };
            if !frame.encloses(&place) || names.iter().any(|name| name.place.overlaps(&place)) {
                continue;
            }
            let crossed = |&&(_, other): &&(&str, f64)| place.left < other && other < place.right;
            let covered = covered(&place, lines) + LINE_OF_MARK * marks.iter().filter(crossed).count();
            if best.as_ref().is_none_or(|(least, _)| covered < *least) {
                best = Some((covered, place));
            }
        }
        names.extend(best.map(|(covered, place)| MarkName { words: words.to_owned(), place, covers: covered > 0 }));
    }
    names
}

/// Pieces of curves, and single points, that a place covers.
fn covered(place: &SheetBox, lines: &[Vec<Vec<Point>>]) -> usize {
    let of_line = |line: &Vec<Point>| match line[..] {
        [point] => usize::from(place.contains(point)),
        _ => line.windows(2).filter(|pair| place.clip(pair[0], pair[1]).is_some()).count(),
    };
    lines.iter().flatten().map(of_line).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: SheetBox = SheetBox { left: 0.0, top: 0.0, right: 450.0, bottom: 200.0 };

    #[test]
    fn names_stand_clear_of_curves_and_of_each_other() {
        let curve = vec![vec![(0.0, 20.0), (450.0, 20.0)]];
        let marks = [("P₂ 51 Hz", 100.0), ("full-track 52 Hz", 103.0), ("rail on pad 54 Hz", 108.0)];
        let curves = [curve];
        let names = beside(&marks, &curves, &FRAME);
        assert_eq!(names.len(), 3);
        for (index, name) in names.iter().enumerate() {
            assert!(covered(&name.place, &curves) == 0 && FRAME.encloses(&name.place));
            assert!(names[..index].iter().all(|other| !other.place.overlaps(&name.place)));
        }
    }

    #[test]
    fn names_keep_within_the_frame() {
        let names = beside(&[("pinned-pinned", 0.0), ("P₂", 450.0), ("", 5.0)], &[], &FRAME);
        assert_eq!(names.len(), 2);
        assert!(names.iter().all(|name| FRAME.encloses(&name.place)));
    }
}
