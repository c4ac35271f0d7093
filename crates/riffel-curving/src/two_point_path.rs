//! Path of a wheelset across the track, on which two-point contact has a length.
//!
//! A rigid wheel whose contact jumps from one place to another touches both at one shift η* at the level of the rails. There η
//! is held and how the two normal forces share the load is free, P₁ ≥ 0 and P₂ ≥ 0; before it P₂ = 0, after it P₁ = 0. One
//! coordinate u tells all three: η = u before, η = η* while the share of the second point goes from 0 to 1 over a length,
//! η = u less that length after. Equilibrium is continuous in u, and complementarity holds by construction.

use riffel::Rail;

use super::TwoPoints;

/// Length of u \[m\] over which the load goes from one point to the other: a scale for Newton's steps, without a meaning.
const LENGTH: f64 = 1e-3;

/// Place on the path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<'a> {
    /// Shift η at the level of the rails \[m\].
    pub(super) shift: f64,
    /// Where a wheel stands on two points, and the share of its normal force on the second, 0 to 1.
    pub(super) between: Option<(&'a TwoPoints, f64)>,
}

impl Place<'_> {
    /// The two points of a wheel with the share of the second, if it stands on two.
    pub(super) fn two_points(&self, rail: Rail) -> Option<(&TwoPoints, f64)> {
        self.between.filter(|(points, _)| points.rail == rail)
    }
}

/// The place of a coordinate u \[m\], with jumps in the order of their shifts. Zero is the centred wheelset.
pub(super) fn place(jumps: &[TwoPoints], u: f64) -> Place<'_> {
    let middle = jumps.partition_point(|jump| jump.shift < 0.0);
    let mut passed = 0.0;
    let outward: &mut dyn Iterator<Item = &TwoPoints> =
        if u >= 0.0 { &mut jumps[middle..].iter() } else { &mut jumps[..middle].iter().rev() };
    for jump in outward {
        let beyond = u.abs() - passed - jump.shift.abs();
        if beyond < 0.0 {
            break;
        }
        if beyond <= LENGTH {
            let share = beyond / LENGTH;
            return Place { shift: jump.shift, between: Some((jump, if u >= 0.0 { share } else { 1.0 - share })) };
        }
        passed += LENGTH;
    }
    Place { shift: u - passed.copysign(u), between: None }
}

/// The coordinate u \[m\] of a shift \[m\] beside all jumps.
pub(super) fn coordinate(jumps: &[TwoPoints], shift: f64) -> f64 {
    let passed = jumps.iter().filter(|jump| {
        let at = jump.shift;
        (at >= 0.0) == (shift >= 0.0) && at.abs() < shift.abs()
    });
    shift + (LENGTH * passed.count() as f64).copysign(shift)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RollingPosition;

    #[test]
    fn the_way_is_continuous_and_turns_back() {
        let jump = |shift| TwoPoints { rail: Rail::Right, shift, positions: [RollingPosition::default(); 2] };
        let jumps = [-0.006, -0.001, 0.002, 0.006].map(jump);
        for shift in [-0.008, -0.003, -0.0005, 0.0, 0.001, 0.004, 0.007] {
            let there = place(&jumps, coordinate(&jumps, shift));
            assert!((there.shift - shift).abs() < 1e-15 && there.between.is_none());
        }
        // The share of the point of larger shifts falls from one to zero on the way to the left.
        let mut last = place(&jumps, 0.009);
        for index in (-9000..9000).rev() {
            let next = place(&jumps, 1e-6 * f64::from(index));
            let fallen = last.shift - next.shift;
            assert!((-1e-12..=1.001e-6).contains(&fallen));
            if let (Some((one, before)), Some((other, after))) = (last.between, next.between) {
                assert!(one == other && (before - after - 1e-3).abs() < 1e-9);
            }
            last = next;
        }
    }
}
