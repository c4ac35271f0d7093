//! Rectangles of the sheet: clipping lines to a frame, and finding room for labels that must not
//! cover each other nor the marks of a panel.

use super::point::Point;

/// A rectangle of the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SheetBox {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl SheetBox {
    pub(crate) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub(crate) fn around(center: Point, width: f64, height: f64) -> Self {
        SheetBox {
            left: center.0 - width / 2.0,
            top: center.1 - height / 2.0,
            right: center.0 + width / 2.0,
            bottom: center.1 + height / 2.0,
        }
    }

    pub(crate) fn center(&self) -> Point {
        ((self.left + self.right) / 2.0, (self.top + self.bottom) / 2.0)
    }

    pub(crate) fn shrunk(&self, by: f64) -> Self {
        SheetBox { left: self.left + by, top: self.top + by, right: self.right - by, bottom: self.bottom - by }
    }

    pub(crate) fn contains(&self, point: Point) -> bool {
        point.0 >= self.left && point.0 <= self.right && point.1 >= self.top && point.1 <= self.bottom
    }

    pub(crate) fn encloses(&self, other: &SheetBox) -> bool {
        other.left >= self.left && other.right <= self.right && other.top >= self.top && other.bottom <= self.bottom
    }

    pub(crate) fn overlaps(&self, other: &SheetBox) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    /// The part of the segment `a` … `b` inside the rectangle (Liang and Barsky, 1984).
    pub(crate) fn clip(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let sides = [(-dx, a.0 - self.left), (dx, self.right - a.0), (-dy, a.1 - self.top), (dy, self.bottom - a.1)];
        for (step, room) in sides {
            if step == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if step < 0.0 {
                from = from.max(room / step);
            } else {
                to = to.min(room / step);
            }
        }
        // Ends inside are returned exactly, so that consecutive segments of a line join.
        let start = if from > 0.0 { (a.0 + from * dx, a.1 + from * dy) } else { a };
        let end = if to < 1.0 { (a.0 + to * dx, a.1 + to * dy) } else { b };
        (from <= to).then_some((start, end))
    }
}

/// What a label must keep clear of.
pub(crate) struct Obstacles<'a> {
    /// Labels already set, never covered.
    pub(crate) labels: &'a [SheetBox],
    /// Marks, covered only if there is no other room.
    pub(crate) marks: &'a [Point],
    /// Other lines, crossed only if there is no other room.
    pub(crate) lines: &'a [(Point, Point)],
}

/// Finds a place for a label of `size` inside `frame` on or beside the line `from` … `to`, as near
/// to `to` as can be.
///
/// The distances `beside` from the line are tried in their order, in units of the distance that
/// clears the line: 0 is on it, 1 above it and −1 below. The first place that covers least is
/// taken; None if there is no room at all.
pub(crate) fn along_line(
    (from, to): (Point, Point),
    size: (f64, f64),
    frame: &SheetBox,
    obstacles: &Obstacles<'_>,
    beside: &[f64],
) -> Option<SheetBox> {
    const STEPS: u32 = 60;
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy).max(f64::MIN_POSITIVE);
    // The normal that points up the sheet, and the half width of the label along it.
    let normal = if dx >= 0.0 { (dy / length, -dx / length) } else { (-dy / length, dx / length) };
    let clearance = (normal.0.abs() * size.0 + normal.1.abs() * size.1) / 2.0 + 5.0;
    let mut best: Option<(usize, SheetBox)> = None;
    for &distance in beside {
        let offset = distance * clearance;
        for step in 0..=STEPS {
            let t = 1.0 - f64::from(step) / f64::from(STEPS);
            let center = (from.0 + t * dx + offset * normal.0, from.1 + t * dy + offset * normal.1);
            let place = SheetBox::around(center, size.0, size.1);
            if !frame.encloses(&place) || obstacles.labels.iter().any(|label| label.overlaps(&place)) {
                continue;
            }
            let marks = obstacles.marks.iter().filter(|&&mark| place.shrunk(-3.0).contains(mark)).count();
            let lines = obstacles.lines.iter().filter(|(a, b)| place.clip(*a, *b).is_some()).count();
            let covered = 2 * marks + lines;
            if best.as_ref().is_none_or(|(least, _)| covered < *least) {
                best = Some((covered, place));
            }
        }
    }
    best.map(|(_, place)| place)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: SheetBox = SheetBox { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 };

    #[test]
    fn segments_are_clipped_to_the_frame() {
        assert_eq!(FRAME.clip((-50.0, 50.0), (150.0, 50.0)), Some(((0.0, 50.0), (100.0, 50.0))));
        assert_eq!(FRAME.clip((10.0, 10.0), (20.0, 30.0)), Some(((10.0, 10.0), (20.0, 30.0))));
        assert_eq!(FRAME.clip((-10.0, 0.0), (-10.0, 100.0)), None);
        assert_eq!(FRAME.clip((-20.0, 10.0), (10.0, -20.0)), None);
    }

    #[test]
    fn labels_give_way_to_labels_and_marks() {
        let line = ((0.0, 100.0), (100.0, 0.0));
        let place = |size, labels: &[SheetBox], marks: &[Point], beside: &[f64]| {
            along_line(line, size, &FRAME, &Obstacles { labels, marks, lines: &[] }, beside)
        };
        let first = place((20.0, 10.0), &[], &[], &[0.0]).unwrap();
        assert!(FRAME.encloses(&first) && first.center().0 > 85.0);
        let second = place((20.0, 10.0), &[first], &[], &[0.0]).unwrap();
        assert!(!second.overlaps(&first));
        let marks = [second.center()];
        let third = place((20.0, 10.0), &[first], &marks, &[0.0]).unwrap();
        assert!(!third.overlaps(&first) && !third.contains(marks[0]));
        assert!(place((200.0, 10.0), &[], &[], &[0.0, 1.0]).is_none());
    }

    #[test]
    fn label_beside_a_line_does_not_touch_it() {
        let (from, to) = ((0.0, 100.0), (100.0, 30.0));
        for side in [1.0, -1.0] {
            let clear = Obstacles { labels: &[], marks: &[], lines: &[] };
            let place = along_line((from, to), (30.0, 10.0), &FRAME, &clear, &[side]).unwrap();
            assert!(place.clip(from, to).is_none());
            let line_height = 100.0 - 0.7 * place.center().0;
            assert_eq!(place.center().1 < line_height, side > 0.0);
        }
    }
}
