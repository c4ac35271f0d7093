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
    /// Depth over the smaller semi-axis \[-\] from which it is looked for below the surface.
    pub const FLOOR: f64 = 0.03;

    /// Whether one below the surface lies where the search begins: then the stress rises towards the surface, and it is the surface's.
    pub fn is_at_floor(&self, ellipse: &EllipseStress) -> bool {
        let floor = Self::FLOOR * ellipse.across_over_along().min(1.0);
        self.place[2] > 0.0 && self.place[2] <= floor * (1.0 + 1e-3)
    }

    /// The largest value of a measure under a traction.
    ///
    /// Method: a grid, then closer and closer about the best point. At the
    /// surface over angles, for its stress has a root at the edge.
    pub fn find(ellipse: &EllipseStress, traction: &Traction, measure: StressMeasure, depth: Depth) -> Self {
        match depth {
            Depth::Surface => {
                // x = sin α, y = cos α sin β: its root √(1 − x² − y²) is cos α cos β.
                let at = |[alpha, beta]: [f64; 2]| {
                    let place = [alpha.sin(), alpha.cos() * beta.sin(), 0.0];
                    // The edge itself has no field; this close the root of what is left is 1e-6.
                    let inside = 1.0 - 1e-12;
                    let place = place.map(|value| inside * value);
                    Self { value: measure.of(&traction.stress(ellipse, place)), place }
                };
                let quarter = std::f64::consts::FRAC_PI_2;
                search(at, [[-quarter, quarter]; 2], [24, 12])
            }
            Depth::Below => {
                let smaller = ellipse.across_over_along().min(1.0);
                let (from, to) = (Self::FLOOR * smaller, 1.5 * smaller.sqrt());
                let at = |[x, y, z]: [f64; 3]| {
                    let place = [x, y, z];
                    Self { value: measure.of(&traction.stress(ellipse, place)), place }
                };
                search(at, [[-1.3, 1.3], [-0.9, 0.9], [from, to]], [14, 6, 10])
            }
        }
    }
}

/// The largest value in a box: from a grid of so many steps on, closer and closer about its best points.
fn search<const N: usize>(
    at: impl Fn([f64; N]) -> StressMaximum,
    bounds: [[f64; 2]; N],
    steps: [usize; N],
) -> StressMaximum {
    /// Points of the grid that are looked at closer: ridges have several.
    const CLOSER: usize = 6;
    let grid = |counts: [usize; N], bounds: [[f64; 2]; N]| {
        let all: usize = counts.iter().map(|count| count + 1).product();
        (0..all).map(move |mut number| -> [f64; N] {
            std::array::from_fn(|axis| {
                let count = counts[axis] + 1;
                let step = number % count;
                number /= count;
                let [low, high] = bounds[axis];
                low + (high - low) * step as f64 / counts[axis] as f64
            })
        })
    };
    let step: [f64; N] = std::array::from_fn(|axis| (bounds[axis][1] - bounds[axis][0]) / steps[axis] as f64);
    let mut found: Vec<([f64; N], StressMaximum)> = grid(steps, bounds).map(|place| (place, at(place))).collect();
    found.sort_by(|one, other| other.1.value.total_cmp(&one.1.value));
    let mut begun: Vec<([f64; N], StressMaximum)> = Vec::new();
    for start in found {
        let near = |other: &([f64; N], StressMaximum)| {
            (0..N).all(|axis| (start.0[axis] - other.0[axis]).abs() < 1.5 * step[axis])
        };
        if begun.len() < CLOSER && !begun.iter().any(near) {
            begun.push(start);
        }
    }
    for best in &mut begun {
        let mut half = step;
        for _ in 0..16 {
            let inside = std::array::from_fn(|axis| {
                let [low, high] = bounds[axis];
                [(best.0[axis] - half[axis]).max(low), (best.0[axis] + half[axis]).min(high)]
            });
            for place in grid([4; N], inside) {
                let found = at(place);
                if found.value > best.1.value {
                    *best = (place, found);
                }
            }
            half = half.map(|half| 0.5 * half);
        }
    }
    let values = begun.into_iter().map(|(_, found)| found);
    let least = StressMaximum { value: 0.0, place: [0.0; 3] };
    values.fold(least, |best, found| match found.value > best.value {
        true => found,
        false => best,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a circle without friction von Mises' stress is largest at 0.48 a, 0.62 p₀ (Johnson 1985, section 3.4, ν = 0.3); in full slip at μ = 0.6 it
    /// is the surface's, and what the search below finds at its floor is told so.
    #[test]
    fn a_maximum_at_the_floor_is_the_surface_s() {
        let ellipse = EllipseStress::of_ratio(1.0, 0.3);
        let of = |friction: f64, depth: Depth| {
            let traction = Traction::full_slip(friction, [1.0, 0.0]);
            StressMaximum::find(&ellipse, &traction, StressMeasure::VonMises, depth)
        };
        let below = of(0.0, Depth::Below);
        // Johnson gives two digits.
        assert!((below.value - 0.62).abs() < 5e-3 && (below.place[2] - 0.48).abs() < 5e-3, "{below:?}");
        assert!(!below.is_at_floor(&ellipse) && !of(0.0, Depth::Surface).is_at_floor(&ellipse));
        let (surface, floor) = (of(0.6, Depth::Surface), of(0.6, Depth::Below));
        assert!(floor.is_at_floor(&ellipse) && floor.value < surface.value, "{floor:?} {surface:?}");
        assert!(!surface.is_at_floor(&ellipse));
    }
}
