//! Where two undeformed surfaces overlap, and the elements over it.

use riffel::Error;
use riffel::contact::{ContactGrid, GapStrip};

use crate::profile::ContactGap;

/// Means over the overlap of the undeformed surfaces at an approach, weighted by the square of its depth.
pub(super) struct Overlap {
    /// \[m\].
    pub(super) x: f64,
    /// \[m\].
    pub(super) y: f64,
    /// Of the rail \[rad\].
    pub(super) inclination: f64,
}

impl Overlap {
    /// Along a strip of depth d the overlap is a parabola, and the integral of its square (16/15) d² √(2d/κ).
    pub(super) fn new(gap: &ContactGap, strips: &[GapStrip], approach: f64) -> Self {
        let mut sums = [0.0; 4];
        for (index, strip) in strips.iter().enumerate() {
            let depth = approach - strip.gap;
            let Some(inclination) = gap.inclination_at(strip.y).filter(|_| depth > 0.0) else {
                continue;
            };
            let before = strips[index.saturating_sub(1)].y;
            let after = strips[(index + 1).min(strips.len() - 1)].y;
            let weight = (after - before) * depth * depth * (depth / strip.curvature).sqrt();
            let values = [1.0, strip.x, strip.y, inclination];
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += weight * value;
            }
        }
        Self { x: sums[1] / sums[0], y: sums[2] / sums[0], inclination: sums[3] / sums[0] }
    }
}

/// First and last x and y at which the gap is below a limit \[m\].
pub(super) fn ends_of(strips: &[GapStrip], limit: f64) -> [[f64; 2]; 2] {
    let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for strip in strips.iter().filter(|strip| strip.gap < limit) {
        let half = (2.0 * (limit - strip.gap) / strip.curvature).sqrt();
        for (ends, [low, high]) in ends.iter_mut().zip([[strip.x - half, strip.x + half], [strip.y; 2]]) {
            *ends = [ends[0].min(low), ends[1].max(high)];
        }
    }
    ends
}

/// A grid over a rectangle, and its middle: elements nearly square, even numbers of them.
pub(super) fn grid_over(ends: [[f64; 2]; 2], elements: usize) -> Result<(ContactGrid, [f64; 2]), Error> {
    let [length, width] = ends.map(|[low, high]| high - low);
    let even = |count: f64| {
        let least = 16.max(elements / 2) as f64;
        2 * (0.5 * count.clamp(least, 4.0 * elements as f64)).round() as usize
    };
    let ratio = (length / width).sqrt();
    let (columns, rows) = (even(elements as f64 * ratio), even(elements as f64 / ratio));
    let grid = ContactGrid::over(columns, rows, 0.5 * length, 0.5 * width)?;
    Ok((grid, ends.map(|[low, high]| 0.5 * (low + high))))
}
