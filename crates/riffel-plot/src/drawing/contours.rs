//! Filled contours: the regions of a map in which a quantity reaches given levels.

use std::collections::BTreeMap;

use super::point::Point;
use crate::grid::Grid;

/// A closed line: the last point repeats the first.
pub(crate) type Ring = Vec<Point>;

/// Regions of `grid` in which `quantity(value)` is at least each of the `levels`: rings in the coordinates of the
/// grid, inside of which is what an odd number of them surrounds.
///
/// Marching squares: the quantity is linear along the edges of a cell, and the mean of its corners decides a saddle.
/// Where the quantity is not finite, and beyond the border, it counts as lying far below every level; so rings close
/// along the border.
pub(crate) fn regions(grid: &Grid, quantity: impl Fn(f64) -> f64, levels: &[f64]) -> Vec<Vec<Ring>> {
    let scale = levels.iter().fold(0.0_f64, |scale, level| scale.max(level.abs()));
    let below = levels.iter().copied().fold(f64::INFINITY, f64::min) - scale.max(f64::MIN_POSITIVE);
    // One more row and column on each side, in the place of the outermost.
    let framed = |points: &[f64]| [&points[..1], points, &points[points.len() - 1..]].concat();
    let (x, y) = (framed(&grid.x), framed(&grid.y));
    let mut field = Field { values: vec![below; x.len() * y.len()], x, y };
    for (row, values) in grid.values.chunks(grid.x.len()).enumerate() {
        for (column, value) in values.iter().map(|&value| quantity(value)).enumerate() {
            if value.is_finite() {
                field.values[(row + 1) * field.x.len() + column + 1] = value;
            }
        }
    }
    levels.iter().map(|&level| field.rings(level)).collect()
}

/// An edge from the node at a column and a row to the next one, up the column or along the row.
type Edge = (usize, usize, bool);

struct Field {
    x: Vec<f64>,
    y: Vec<f64>,
    values: Vec<f64>,
}

impl Field {
    fn value(&self, (column, row): (usize, usize)) -> f64 {
        self.values[row * self.x.len() + column]
    }

    fn rings(&self, level: f64) -> Vec<Ring> {
        let mut next: BTreeMap<Edge, Edge> = BTreeMap::new();
        for row in 0..self.y.len() - 1 {
            for column in 0..self.x.len() - 1 {
                next.extend(self.segments((column, row), level).into_iter().flatten());
            }
        }
        let mut rings = Vec::new();
        while let Some((start, mut edge)) = next.pop_first() {
            let mut ring = vec![self.crossing(start, level)];
            while let Some(after) = next.remove(&edge) {
                ring.push(self.crossing(edge, level));
                edge = after;
            }
            ring.push(ring[0]);
            rings.push(ring);
        }
        rings
    }

    /// The pieces of rings in a cell, each from the edge through which one that walks around the cell leaves the
    /// region to that through which it enters again.
    fn segments(&self, (i, j): (usize, usize), level: f64) -> [Option<(Edge, Edge)>; 2] {
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|node| self.value(node));
        let inside = corners.map(|value| value >= level);
        let edges = [(i, j, false), (i + 1, j, true), (i, j + 1, false), (i, j, true)];
        let leaves = |k: usize| inside[k % 4] && !inside[(k + 1) % 4];
        let enters = |k: usize| !inside[k % 4] && inside[(k + 1) % 4];
        // Around the corner that is cut off, or around that which is not.
        let joined = corners.iter().map(|value| value / 4.0).sum::<f64>() >= level;
        let turns = if joined { [1, 2, 3] } else { [3, 2, 1] };
        let mut starts = (0..4).filter(|&k| leaves(k)).map(|k| {
            let end = turns.into_iter().map(|turn| k + turn).find(|&k| enters(k));
            (edges[k], edges[end.unwrap_or(k) % 4])
        });
        [starts.next(), starts.next()]
    }

    /// The place on an edge where the quantity reaches the level.
    fn crossing(&self, (i, j, upright): Edge, level: f64) -> Point {
        let (from, to) = ((i, j), if upright { (i, j + 1) } else { (i + 1, j) });
        let (a, b) = (self.value(from) / 2.0, self.value(to) / 2.0);
        let t = (level / 2.0 - a) / (b - a);
        let between = |points: &[f64], from: usize, to: usize| points[from] + t * (points[to] - points[from]);
        (between(&self.x, from.0, to.0), between(&self.y, from.1, to.1))
    }
}

/// The pieces of a ring that do not run along the border of the rectangle `from` … `to`: contour
/// lines proper.
pub(crate) fn off_border(ring: &[Point], from: Point, to: Point) -> Vec<Vec<Point>> {
    let along = |a: f64, b: f64, side: f64| a == side && b == side;
    let border = |a: Point, b: Point| {
        along(a.0, b.0, from.0) || along(a.0, b.0, to.0) || along(a.1, b.1, from.1) || along(a.1, b.1, to.1)
    };
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut open = false;
    // Around from where the ring meets the border, so that no line is cut where the ring happens to begin.
    let count = ring.len() - 1;
    let start = (0..count).find(|&k| border(ring[k], ring[k + 1]));
    for k in (0..count).map(|k| (k + start.unwrap_or(0)) % count) {
        let (from, to) = (ring[k], ring[k + 1]);
        if border(from, to) {
            open = false;
            continue;
        }
        match pieces.last_mut().filter(|_| open) {
            Some(piece) => piece.push(to),
            None => pieces.push(vec![from, to]),
        }
        open = true;
    }
    pieces
}

/// Leaves out the points of a line that lie within `tolerance` of the line without them (Douglas
/// and Peucker, 1973).
pub(crate) fn simplified(line: &[Point], tolerance: f64) -> Vec<Point> {
    if line.len() < 3 {
        return line.to_vec();
    }
    let mut keep = vec![false; line.len()];
    (keep[0], keep[line.len() - 1]) = (true, true);
    let mut spans = vec![(0, line.len() - 1)];
    while let Some((first, last)) = spans.pop() {
        let (mut farthest, mut distance) = (first, tolerance);
        for (index, &point) in line.iter().enumerate().take(last).skip(first + 1) {
            let d = distance_to_segment(point, line[first], line[last]);
            if d > distance {
                (farthest, distance) = (index, d);
            }
        }
        if farthest > first {
            keep[farthest] = true;
            spans.push((first, farthest));
            spans.push((farthest, last));
        }
    }
    line.iter().zip(keep).filter_map(|(&point, keep)| keep.then_some(point)).collect()
}

fn distance_to_segment(point: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let squared = dx * dx + dy * dy;
    let t = if squared > 0.0 { (((point.0 - a.0) * dx + (point.1 - a.1) * dy) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (point.0 - a.0 - t * dx).hypot(point.1 - a.1 - t * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(x: Vec<f64>, y: Vec<f64>, field: impl Fn(f64, f64) -> f64) -> Grid {
        let values = y.iter().flat_map(|&v| x.iter().map(|&u| field(u, v)).collect::<Vec<_>>()).collect();
        Grid { x, y, values }
    }

    fn even(low: f64, high: f64, count: usize) -> Vec<f64> {
        (0..count).map(|k| low + (high - low) * k as f64 / (count - 1) as f64).collect()
    }

    fn ring_area(ring: &[Point]) -> f64 {
        ring.windows(2).map(|pair| pair[0].0 * pair[1].1 - pair[1].0 * pair[0].1).sum::<f64>() / 2.0
    }

    #[test]
    fn circle_lies_on_its_radius() {
        let field = grid(even(-1.0, 1.0, 81), even(-1.0, 1.0, 61), |x, y| x.hypot(y));
        let regions = regions(&field, |r| 1.0 - r, &[0.4]);
        assert_eq!(regions[0].len(), 1);
        // Linear interpolation across a cell of at most 1/30: the error is far below a tenth of a
        // cell.
        for &(x, y) in &regions[0][0] {
            assert!((x.hypot(y) - 0.6).abs() < 0.1 / 30.0, "({x}, {y})");
        }
    }

    #[test]
    fn plane_is_exact_on_an_unequally_spaced_grid_and_reaches_the_border() {
        let x: Vec<f64> = (0..12).map(|k| 1.3f64.powi(k)).collect();
        let y: Vec<f64> = (0..9).map(|k| f64::from(k * k) + 1.0).collect();
        let field = grid(x.clone(), y.clone(), |x, y| 2.0 * x + 0.1 * y);
        let regions = regions(&field, |v| -v, &[-12.0]);
        let (from, to) = ((x[0], y[0]), (x[11], y[8]));
        let lines = off_border(&regions[0][0], from, to);
        assert_eq!(lines.len(), 1);
        for &(x, y) in &lines[0] {
            assert!((2.0 * x + 0.1 * y - 12.0).abs() < 1e-9, "({x}, {y})");
        }
        let ends = [lines[0][0], *lines[0].last().unwrap()];
        assert!(ends.iter().any(|p| (p.1 - from.1).abs() < 1e-12) && ends.iter().any(|p| (p.1 - to.1).abs() < 1e-12));
    }

    #[test]
    fn plane_is_exact_on_every_border() {
        for (a, b) in [(1.0, 0.3), (-1.0, 0.3), (0.3, 1.0), (0.3, -1.0)] {
            let field = grid(even(0.0, 1.0, 7), even(0.0, 1.0, 6), |x, y| a * x + b * y);
            let level = 0.5 * (a + b);
            let regions = regions(&field, |v| v, &[level]);
            let lines = off_border(&regions[0][0], (0.0, 0.0), (1.0, 1.0));
            assert_eq!(lines.len(), 1);
            for &(x, y) in &lines[0] {
                assert!((a * x + b * y - level).abs() < 1e-12, "({x}, {y}) for {a}, {b}");
            }
        }
    }

    #[test]
    fn a_hole_turns_against_its_outline() {
        let field = grid(even(-1.0, 1.0, 101), even(-1.0, 1.0, 101), |x, y| x.hypot(y));
        let regions = regions(&field, |r| 0.2 - (r - 0.6).abs(), &[0.0]);
        assert_eq!(regions[0].len(), 2);
        let area = regions[0].iter().map(|ring| ring_area(ring)).sum::<f64>().abs();
        let exact = std::f64::consts::PI * (0.64 - 0.16);
        assert!((area - exact).abs() < 2e-3, "{area} {exact}");
    }

    #[test]
    fn missing_values_and_empty_levels_are_no_obstacle() {
        let mut field = grid(even(0.0, 1.0, 9), even(0.0, 1.0, 9), |x, _| -x);
        field.values[40] = f64::NAN;
        field.values[3] = f64::INFINITY;
        let regions = regions(&field, |v| -v, &[0.0, 0.5, 5.0]);
        assert!(regions[2].is_empty());
        assert!(regions[0].iter().flatten().all(|p| p.0.is_finite() && p.1.is_finite()));
    }

    #[test]
    fn simplified_line_stays_within_its_tolerance() {
        let line: Vec<Point> = (0..=200).map(|k| f64::from(k) / 20.0).map(|x| (x, x.sin())).collect();
        let short = simplified(&line, 0.01);
        assert!(short.len() < 60);
        for &point in &line {
            let d = short.windows(2).map(|s| distance_to_segment(point, s[0], s[1])).fold(f64::INFINITY, f64::min);
            assert!(d <= 0.01 + 1e-12);
        }
    }
}
