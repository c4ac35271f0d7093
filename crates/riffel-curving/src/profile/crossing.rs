//! Outlines that cross themselves or close.

use super::{PointFault, ProfileError};

/// Most points of an outline: a tenth of a millimetre apart they would go around it fifty times.
const MOST: usize = 50_000;
/// Distance of the ends over the length of an outline below which it is closed. A rail head down to its flanks has 0.5.
const CLOSED: f64 = 0.05;

/// `Ok` for the points (x, height) of an open outline that does not cross, touch or retrace itself; `length` is that of its chords.
///
/// Method: the chords in the order of their first ends along the longer side of the outline, each held against those that reach beyond
/// its own. Cost: about n log n for an outline that runs one way, n² at most.
pub(super) fn check_outline(points: &[[f64; 2]], length: f64) -> Result<(), ProfileError> {
    let at_fault = |index: usize, fault: PointFault| Err(ProfileError::Point { index, fault });
    let count = points.len();
    if count > MOST {
        return at_fault(MOST, PointFault::TooMany { count, most: MOST });
    }
    if let Some((index, other)) = crossing(points) {
        let place = points[other][0];
        return at_fault(index, PointFault::Crossing { place });
    }
    let (first, last) = (points[0], points[count - 1]);
    if (last[0] - first[0]).hypot(last[1] - first[1]) < CLOSED * length {
        return at_fault(count - 1, PointFault::Closed);
    }
    Ok(())
}

/// The later one of two chords that meet, by its first point, and the other one; the earliest there is.
fn crossing(points: &[[f64; 2]]) -> Option<(usize, usize)> {
    let chords = points.len() - 1;
    let span = |axis: usize, chord: usize| {
        let (one, other) = (points[chord][axis], points[chord + 1][axis]);
        (one.min(other), one.max(other))
    };
    let extent = |axis: usize| {
        let values = || points.iter().map(|point| point[axis]);
        values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
    };
    let along = usize::from(extent(1) > extent(0));
    let across = 1 - along;
    let mut order: Vec<usize> = (0..chords).collect();
    order.sort_by(|&one, &other| span(along, one).0.total_cmp(&span(along, other).0));
    let mut open: Vec<usize> = Vec::new();
    let mut found: Option<(usize, usize)> = None;
    for chord in order {
        let (first, _) = span(along, chord);
        let (low, high) = span(across, chord);
        open.retain(|&other| span(along, other).1 >= first);
        for &other in &open {
            let (lowest, highest) = span(across, other);
            if lowest > high || highest < low {
                continue;
            }
            let (early, late) = (chord.min(other), chord.max(other));
            if found.is_none_or(|(least, _)| late < least) && meet(points, early, late) {
                found = Some((late, early));
            }
        }
        open.push(chord);
    }
    found
}

/// Twice the area of a triangle, positive where it turns left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether two chords have a point in common, beside the one that neighbours share.
fn meet(points: &[[f64; 2]], early: usize, late: usize) -> bool {
    let ([a, b], [c, d]) = ([points[early], points[early + 1]], [points[late], points[late + 1]]);
    if late == early + 1 {
        let back = (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1]) < 0.0;
        return back && turn(a, b, d) == 0.0;
    }
    let sides = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
    if sides.iter().all(|side| *side == 0.0) {
        // On one line, where the boxes overlap already.
        return true;
    }
    sides[0] * sides[1] <= 0.0 && sides[2] * sides[3] <= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::profile::chords;

    fn check(points: &[[f64; 2]]) -> Result<(), ProfileError> {
        check_outline(points, *chords(points).last().unwrap())
    }

    fn index_of(points: &[[f64; 2]], words: &str) -> usize {
        match check(points) {
            Err(ProfileError::Point { index, fault }) => {
                assert!(fault.to_string().contains(words), "{fault}");
                index
            }
            other => panic!("{other:?}"),
        }
    }

    /// A head with its flanks is open; a bow tie, a retraced line, a fold and a ring are not.
    #[test]
    fn outlines_that_meet_themselves_are_found() {
        let arc = |from: f64, to: f64, count: usize| -> Vec<[f64; 2]> {
            let angle = |index: usize| from + (to - from) * index as f64 / count as f64;
            (0..=count).map(|index| [0.036 * angle(index).sin(), 0.036 * angle(index).cos()]).collect()
        };
        check(&arc(-2.0, 2.0, 40)).unwrap();
        let ring = arc(-3.1, 3.1, 60);
        assert_eq!(index_of(&ring, "closes here"), 60);
        let mut twice = arc(-1.0, 1.0, 20);
        let mut back = twice.clone();
        back.reverse();
        twice.extend(&back[1..]);
        assert_eq!(index_of(&twice, "retraces itself"), 20);
        // The second pass lies 0.1 mm above the first and comes down through it.
        let mut passes = arc(-1.0, 1.0, 20);
        passes.extend(back.iter().enumerate().map(|(place, point)| {
            let off = if place < 10 { 1e-4 } else { -1e-4 };
            [point[0], point[1] + off]
        }));
        let index = index_of(&passes, "crosses");
        assert!((28..=33).contains(&index), "{index}");
        let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(index_of(&bow, "crosses"), 2);
    }

    /// A vertical flank, and points that touch from afar, are no crossings.
    #[test]
    fn close_calls_are_open() {
        check(&[[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [1.0, 2.0], [2.0, 2.0]]).unwrap();
        check(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.5, 1e-6]]).unwrap();
    }
}
