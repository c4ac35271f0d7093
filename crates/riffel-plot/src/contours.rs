//! Filled contours: the regions of a map in which a quantity reaches given levels.
//!
//! Marching squares come from the crate `contour`. Two things are added: the map is continued by
//! one cell beyond its border, because that crate interpolates along its own border with values of
//! the neighbouring row; and its coordinates (in cells) become coordinates of the map, which need
//! not be equally spaced.

use contour::{ContourBuilder, Pt};

use crate::canvas::Point;
use crate::error::PlotError;
use crate::grid::Grid;

/// A region with holes. Rings are closed: the last point repeats the first.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Region {
    pub(crate) outline: Vec<Point>,
    pub(crate) holes: Vec<Vec<Point>>,
}

impl Region {
    /// Outline and holes.
    pub(crate) fn rings(&self) -> impl Iterator<Item = &Vec<Point>> {
        std::iter::once(&self.outline).chain(&self.holes)
    }

    /// Applies a change of coordinates to every point.
    pub(crate) fn map(&self, change: impl Fn(Point) -> Point) -> Region {
        let ring = |points: &Vec<Point>| points.iter().map(|&point| change(point)).collect();
        Region {
            outline: ring(&self.outline),
            holes: self.holes.iter().map(ring).collect(),
        }
    }

    /// The region as one closed path: every hole is reached over a bridge that is walked both ways,
    /// so that it adds nothing to the area. Holes turn against the outline, hence both filling
    /// rules leave them empty.
    pub(crate) fn single_path(&self) -> Vec<Point> {
        let mut path = self.outline.clone();
        for hole in self.holes.iter().filter(|hole| hole.len() > 2) {
            let (mut best, mut at) = (f64::INFINITY, (0, 0));
            for (i, p) in path.iter().enumerate() {
                for (j, q) in hole.iter().enumerate() {
                    let distance = (p.0 - q.0).powi(2) + (p.1 - q.1).powi(2);
                    if distance < best {
                        (best, at) = (distance, (i, j));
                    }
                }
            }
            let open = &hole[..hole.len() - 1];
            let start = at.1 % open.len();
            let mut detour: Vec<Point> = open[start..]
                .iter()
                .chain(&open[..=start])
                .copied()
                .collect();
            detour.push(path[at.0]);
            path.splice(at.0 + 1..at.0 + 1, detour);
        }
        path
    }
}

/// Regions of `grid` in which `quantity(value)` is at least each of the `levels`, in the
/// coordinates of the grid.
///
/// Where the quantity is not finite it counts as lying far below every level.
pub(crate) fn regions(
    grid: &Grid,
    quantity: impl Fn(f64) -> f64,
    levels: &[f64],
) -> Result<Vec<Vec<Region>>, PlotError> {
    let (columns, rows) = (grid.x.len(), grid.y.len());
    let scale = levels
        .iter()
        .fold(0.0_f64, |scale, level| scale.max(level.abs()));
    let below = levels.iter().copied().fold(f64::INFINITY, f64::min) - scale.max(f64::MIN_POSITIVE);
    let mut field = Vec::with_capacity((columns + 2) * (rows + 2));
    for row in 0..rows + 2 {
        for column in 0..columns + 2 {
            let i = column.saturating_sub(1).min(columns - 1);
            let j = row.saturating_sub(1).min(rows - 1);
            let value = quantity(grid.value(i, j));
            field.push(if value.is_finite() { value } else { below });
        }
    }
    // Node (i, j) of the grid lies at (i + 1.5, j + 1.5) of the continued field.
    let place = |x: f64, y: f64| (at_index(&grid.x, x - 1.5), at_index(&grid.y, y - 1.5));
    let contours = ContourBuilder::new(columns + 2, rows + 2, true)
        .contours(&field, levels)
        .map_err(|error| PlotError::Drawing {
            reason: error.to_string(),
        })?;
    let ring = |line: &[Pt]| line.iter().map(|c| place(c.x, c.y)).collect::<Vec<_>>();
    Ok(contours
        .iter()
        .map(|level| {
            level
                .geometry()
                .iter()
                .map(|polygon| Region {
                    outline: ring(&polygon.exterior().0),
                    holes: polygon
                        .interiors()
                        .iter()
                        .map(|hole| ring(&hole.0))
                        .collect(),
                })
                .collect()
        })
        .collect())
}

/// Coordinate at a fractional index, linear between the points and held at the ends.
fn at_index(points: &[f64], index: f64) -> f64 {
    let last = points.len() - 1;
    let index = index.clamp(0.0, last as f64);
    let lower = (index.floor() as usize).min(last.saturating_sub(1));
    let t = index - lower as f64;
    points[lower] + t * (points[last.min(lower + 1)] - points[lower])
}

/// The pieces of a ring that do not run along the border of the rectangle `from` … `to`: contour
/// lines proper.
pub(crate) fn off_border(ring: &[Point], from: Point, to: Point) -> Vec<Vec<Point>> {
    let along = |a: f64, b: f64, side: f64| a == side && b == side;
    let border = |a: Point, b: Point| {
        along(a.0, b.0, from.0)
            || along(a.0, b.0, to.0)
            || along(a.1, b.1, from.1)
            || along(a.1, b.1, to.1)
    };
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut open = false;
    for pair in ring.windows(2) {
        if border(pair[0], pair[1]) {
            open = false;
            continue;
        }
        match pieces.last_mut().filter(|_| open) {
            Some(piece) => piece.push(pair[1]),
            None => pieces.push(vec![pair[0], pair[1]]),
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
    line.iter()
        .zip(keep)
        .filter_map(|(&point, keep)| keep.then_some(point))
        .collect()
}

fn distance_to_segment(point: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let squared = dx * dx + dy * dy;
    let t = if squared > 0.0 {
        (((point.0 - a.0) * dx + (point.1 - a.1) * dy) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (point.0 - a.0 - t * dx).hypot(point.1 - a.1 - t * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(x: Vec<f64>, y: Vec<f64>, field: impl Fn(f64, f64) -> f64) -> Grid {
        let values = y
            .iter()
            .flat_map(|&v| x.iter().map(|&u| field(u, v)).collect::<Vec<_>>())
            .collect();
        Grid { x, y, values }
    }

    fn even(low: f64, high: f64, count: usize) -> Vec<f64> {
        (0..count)
            .map(|k| low + (high - low) * k as f64 / (count - 1) as f64)
            .collect()
    }

    fn ring_area(ring: &[Point]) -> f64 {
        ring.windows(2)
            .map(|pair| pair[0].0 * pair[1].1 - pair[1].0 * pair[0].1)
            .sum::<f64>()
            / 2.0
    }

    #[test]
    fn circle_lies_on_its_radius() {
        let field = grid(even(-1.0, 1.0, 81), even(-1.0, 1.0, 61), |x, y| x.hypot(y));
        let regions = regions(&field, |r| 1.0 - r, &[0.4]).unwrap();
        assert_eq!(regions[0].len(), 1);
        // Linear interpolation across a cell of at most 1/30: the error is far below a tenth of a
        // cell.
        for &(x, y) in &regions[0][0].outline {
            assert!((x.hypot(y) - 0.6).abs() < 0.1 / 30.0, "({x}, {y})");
        }
    }

    #[test]
    fn plane_is_exact_on_an_unequally_spaced_grid_and_reaches_the_border() {
        let x: Vec<f64> = (0..12).map(|k| 1.3f64.powi(k)).collect();
        let y: Vec<f64> = (0..9).map(|k| f64::from(k * k) + 1.0).collect();
        let field = grid(x.clone(), y.clone(), |x, y| 2.0 * x + 0.1 * y);
        let regions = regions(&field, |v| -v, &[-12.0]).unwrap();
        let (from, to) = ((x[0], y[0]), (x[11], y[8]));
        let lines = off_border(&regions[0][0].outline, from, to);
        assert_eq!(lines.len(), 1);
        for &(x, y) in &lines[0] {
            assert!((2.0 * x + 0.1 * y - 12.0).abs() < 1e-9, "({x}, {y})");
        }
        let ends = [lines[0][0], *lines[0].last().unwrap()];
        assert!(
            ends.iter().any(|p| (p.1 - from.1).abs() < 1e-12)
                && ends.iter().any(|p| (p.1 - to.1).abs() < 1e-12)
        );
    }

    #[test]
    fn plane_is_exact_on_every_border() {
        for (a, b) in [(1.0, 0.3), (-1.0, 0.3), (0.3, 1.0), (0.3, -1.0)] {
            let field = grid(even(0.0, 1.0, 7), even(0.0, 1.0, 6), |x, y| a * x + b * y);
            let level = 0.5 * (a + b);
            let regions = regions(&field, |v| v, &[level]).unwrap();
            let lines = off_border(&regions[0][0].outline, (0.0, 0.0), (1.0, 1.0));
            assert_eq!(lines.len(), 1);
            for &(x, y) in &lines[0] {
                assert!(
                    (a * x + b * y - level).abs() < 1e-12,
                    "({x}, {y}) for {a}, {b}"
                );
            }
        }
    }

    #[test]
    fn hole_is_cut_out_of_the_single_path() {
        let field = grid(even(-1.0, 1.0, 101), even(-1.0, 1.0, 101), |x, y| {
            x.hypot(y)
        });
        let regions = regions(&field, |r| 0.2 - (r - 0.6).abs(), &[0.0]).unwrap();
        assert_eq!((regions[0].len(), regions[0][0].holes.len()), (1, 1));
        let area = ring_area(&regions[0][0].single_path()).abs();
        let exact = std::f64::consts::PI * (0.64 - 0.16);
        assert!((area - exact).abs() < 2e-3, "{area} {exact}");
    }

    #[test]
    fn missing_values_and_empty_levels_are_no_obstacle() {
        let mut field = grid(even(0.0, 1.0, 9), even(0.0, 1.0, 9), |x, _| -x);
        field.values[40] = f64::NAN;
        field.values[3] = f64::INFINITY;
        let regions = regions(&field, |v| -v, &[0.0, 0.5, 5.0]).unwrap();
        assert!(regions[2].is_empty());
        assert!(
            regions[0]
                .iter()
                .flat_map(Region::rings)
                .flatten()
                .all(|p| p.0.is_finite() && p.1.is_finite())
        );
    }

    #[test]
    fn simplified_line_stays_within_its_tolerance() {
        let line: Vec<Point> = (0..=200)
            .map(|k| f64::from(k) / 20.0)
            .map(|x| (x, x.sin()))
            .collect();
        let short = simplified(&line, 0.01);
        assert!(short.len() < 60);
        for &point in &line {
            let d = short
                .windows(2)
                .map(|s| distance_to_segment(point, s[0], s[1]))
                .fold(f64::INFINITY, f64::min);
            assert!(d <= 0.01 + 1e-12);
        }
    }
}
