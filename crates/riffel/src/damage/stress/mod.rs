//! Stress under a rolling and sliding ellipse.

mod elements;
mod ellipse;
mod field;
mod maximum;
mod measure;
mod traction;

pub use elements::ElementStress;
pub use ellipse::{EllipseStress, UnitStress};
pub use maximum::{Depth, StressMaximum};
pub use measure::{StressMeasure, StressTensor};
pub use traction::Traction;

/// S = p₀/k of first yield by von Mises under an ellipse a/b in full slip of a friction, and d ln S/df.
pub(super) fn elastic_limit(ratio: f64, poisson_ratio: f64, friction: f64) -> [f64; 2] {
    let ellipse = EllipseStress::of_ratio(ratio, poisson_ratio);
    let largest = |friction: f64| {
        let traction = Traction::full_slip(friction, [1.0, 0.0]);
        let of = |depth| StressMaximum::find(&ellipse, &traction, StressMeasure::VonMises, depth);
        let [surface, below] = [Depth::Surface, Depth::Below].map(of);
        match surface.value > below.value {
            true => surface,
            false => below,
        }
    };
    let at = largest(friction);
    // At the largest value its place does not count.
    let stress = ellipse.at(at.place);
    let by_friction = StressMeasure::VonMises
        .slope(&Traction::full_slip(friction, [1.0, 0.0]).stress(&ellipse, at.place), &stress.along);
    [3f64.sqrt() / at.value, -by_friction / at.value]
}
