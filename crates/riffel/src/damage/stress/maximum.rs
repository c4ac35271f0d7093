//! Where a stress is largest.

use super::{EllipseStress, StressMeasure, Traction};

/// Where it is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// At the surface of the patch and its edge.
    Surface,
    /// From 0.03 of the smaller semi-axis down.
    Below,
}

impl Depth {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Surface, Self::Below];

    /// Name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Surface => "surface",
            Self::Below => "subsurface",
        }
    }
}

/// The largest value of a measure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressMaximum {
    /// Over p₀.
    pub value: f64,
    /// x/a, y/b and z/a.
    pub place: [f64; 3],
}

impl StressMaximum {
    /// The largest value of a measure under a traction.
    ///
    /// Method: a grid over the half y ≥ 0, or all of it under a traction across the rail, then closer and closer about the best point. At the
    /// surface in polar places √(1 − ρ²), for its stress has a root at the edge.
    pub fn find(
        ellipse: &EllipseStress,
        traction: &Traction,
        measure: StressMeasure,
        depth: Depth,
    ) -> Self {
        match depth {
            Depth::Surface => {
                let at = |[angle, root]: [f64; 2]| {
                    // The edge itself has no field; this close the root of what is left is 1e-6.
                    let radius = (1.0 - root * root).clamp(0.0, 1.0 - 1e-12).sqrt();
                    let (sine, cosine) = angle.sin_cos();
                    let place = [radius * cosine, radius * sine, 0.0];
                    Self {
                        value: measure.of(&traction.stress(ellipse, place)),
                        place,
                    }
                };
                let half = std::f64::consts::PI;
                search(at, [[-half, half], [0.0, 1.0]], [24, 12])
            }
            Depth::Below => {
                let smaller = ellipse.across_over_along().min(1.0);
                let (from, to) = (0.03 * smaller, 1.5 * smaller.sqrt());
                let at = |[x, y, z]: [f64; 3]| {
                    let place = [x, y, z];
                    Self {
                        value: measure.of(&traction.stress(ellipse, place)),
                        place,
                    }
                };
                search(at, [[-1.3, 1.3], [-0.9, 0.9], [from, to]], [14, 6, 10])
            }
        }
    }
}

/// The largest value in a box, from a grid of so many steps on.
fn search<const N: usize>(
    at: impl Fn([f64; N]) -> StressMaximum,
    bounds: [[f64; 2]; N],
    steps: [usize; N],
) -> StressMaximum {
    let point = |mut number: usize, counts: [usize; N], bounds: [[f64; 2]; N]| {
        std::array::from_fn(|axis| {
            let count = counts[axis] + 1;
            let step = number % count;
            number /= count;
            let [low, high] = bounds[axis];
            low + (high - low) * step as f64 / counts[axis] as f64
        })
    };
    let all = |counts: [usize; N]| counts.iter().map(|count| count + 1).product::<usize>();
    let mut best = ([0.0; N], StressMaximum { value: -1.0, place: [0.0; 3] });
    let look = |counts: [usize; N], inside: [[f64; 2]; N], best: &mut ([f64; N], StressMaximum)| {
        for number in 0..all(counts) {
            let place = point(number, counts, inside);
            let found = at(place);
            if found.value > best.1.value {
                *best = (place, found);
            }
        }
    };
    look(steps, bounds, &mut best);
    let mut half: [f64; N] =
        std::array::from_fn(|axis| (bounds[axis][1] - bounds[axis][0]) / steps[axis] as f64);
    for _ in 0..24 {
        let inside = std::array::from_fn(|axis| {
            let [low, high] = bounds[axis];
            [
                (best.0[axis] - half[axis]).max(low),
                (best.0[axis] + half[axis]).min(high),
            ]
        });
        look([4; N], inside, &mut best);
        half = half.map(|half| 0.55 * half);
    }
    best.1
}
