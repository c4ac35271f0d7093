//! Pressures and gaps that complement one another, by conjugate gradients.

use riffel_numerics::matrix::dot;

use super::boussinesq::Boussinesq;
use crate::cancel::check;

/// Largest overlap, and largest gap under pressure, relative to the largest displacement.
pub(super) const TOLERANCE: f64 = 1e-9;

/// Steps after which the solution is given up. Of punches, cones, smooth, wavy and rough contacts on up to 200 ×
/// 200 elements none took more than 100, and with elements a hundred times as long as wide 251.
pub(super) const MOST_STEPS: usize = 1000;

/// What is prescribed.
#[derive(Debug, Clone, Copy)]
pub(super) enum Condition {
    /// Sum of the pressures \[Pa\], each by the direction cosine of its normal.
    PressureSum(f64),
    /// Approach \[m\].
    Approach(f64),
}

/// Where the iteration ended.
pub(super) struct Solution {
    /// \[Pa\].
    pub(super) pressures: Vec<f64>,
    /// Distance of the deformed surfaces \[m\].
    pub(super) gaps: Vec<f64>,
    /// \[m\].
    pub(super) approach: f64,
    /// Steps taken.
    pub(super) steps: usize,
}

/// Pressures p ≥ 0 with g = z + u(p) − δ c ≥ 0 and p g = 0 on every element; c is the direction cosine of its normal.
///
/// They are the minimum of ½p·u(p) + p·(z − δ c) over p ≥ 0, of which g is the gradient. Polonsky & Keer
/// (1999): a step of conjugate gradients on the elements under pressure, negative pressures cut off,
/// overlapping elements without pressure taken in by a step of steepest descent, after which the
/// directions start anew; if the load is given, gradients lose their part along c over the contact, δ is that
/// part, and the pressures are scaled to the load. Where a step has cut off nothing, displacements follow from those of the
/// direction; the last ones are those of the pressures themselves. `near` is an approach to begin with if the load is given.
///
/// # Errors
/// The residual after `most_steps`.
pub(super) fn solve(
    influence: &Boussinesq,
    undeformed: &[f64],
    condition: Condition,
    near: Option<f64>,
    most_steps: usize,
) -> Result<Solution, f64> {
    let cosines = influence.cosines();
    let mut pressures = start(influence, undeformed, condition, near);
    let mut displacements = influence.displacements(&pressures);
    let mut are_exact = true;
    let mut direction = vec![0.0; pressures.len()];
    // Square of the last gradient; infinite where the directions start anew.
    let mut last_square = f64::INFINITY;
    let mut residual = f64::NAN;
    for steps in 0..=most_steps {
        check();
        let largest = displacements.iter().copied().fold(0.0, f64::max);
        let mut gaps: Vec<f64> =
            undeformed.iter().zip(&displacements).map(|(gap, displacement)| gap + displacement).collect();
        let approach = match condition {
            Condition::PressureSum(_) => along_in_contact(&pressures, &gaps, cosines),
            Condition::Approach(approach) => approach,
        };
        for (gap, cosine) in gaps.iter_mut().zip(cosines) {
            *gap -= approach * cosine;
        }
        let violation = violation(&pressures, &gaps);
        residual = violation / largest.max(f64::MIN_POSITIVE);
        if residual <= TOLERANCE {
            if are_exact {
                return Ok(Solution { pressures, gaps, approach, steps });
            }
            displacements = influence.displacements(&pressures);
            are_exact = true;
            last_square = f64::INFINITY;
            continue;
        }

        let square: f64 =
            pressures.iter().zip(&gaps).filter(|(pressure, _)| **pressure > 0.0).map(|(_, gap)| gap * gap).sum();
        let share = square / last_square;
        for ((direction, &gap), &pressure) in direction.iter_mut().zip(&gaps).zip(&pressures) {
            *direction = if pressure > 0.0 { gap + share * *direction } else { 0.0 };
        }
        let change = influence.displacements(&direction);
        let slope: f64 = dot(&gaps, &direction);
        // The direction has no part along c where the load is given, nor does a part of the change along c count.
        let along = match condition {
            Condition::PressureSum(_) => along_in_contact(&pressures, &change, cosines),
            Condition::Approach(_) => 0.0,
        };
        let curvature = dot(&change, &direction) - along * dot(cosines, &direction);
        // A contact of one element has no direction to go: overlapping elements then come in with the
        // step of an element on its own.
        let length = if curvature > 0.0 { slope / curvature } else { influence.own().recip() };
        let (overlaps, cuts) = step(&mut pressures, &direction, &gaps, length);
        last_square = if overlaps { f64::INFINITY } else { square };
        let scale = match condition {
            Condition::PressureSum(wanted) => wanted / dot(&pressures, cosines),
            Condition::Approach(_) => 1.0,
        };
        for pressure in &mut pressures {
            *pressure *= scale;
        }
        are_exact = overlaps || cuts;
        if are_exact {
            displacements = influence.displacements(&pressures);
        } else {
            for (displacement, change) in displacements.iter_mut().zip(&change) {
                *displacement = scale * (*displacement - length * change);
            }
        }
    }
    Err(residual)
}

/// Largest gap under pressure, and largest overlap beside it.
fn violation(pressures: &[f64], gaps: &[f64]) -> f64 {
    pressures
        .iter()
        .zip(gaps)
        .map(|(&pressure, &gap)| if pressure > 0.0 { gap.abs() } else { -gap })
        .fold(0.0, f64::max)
}

/// A step of this length against the direction; whether overlapping elements came in, and whether pressures were cut off.
fn step(pressures: &mut [f64], direction: &[f64], gaps: &[f64], length: f64) -> (bool, bool) {
    let (mut overlaps, mut cuts) = (false, false);
    for ((pressure, direction), &gap) in pressures.iter_mut().zip(direction).zip(gaps) {
        let next = *pressure - length * direction;
        cuts |= next < 0.0;
        *pressure = next.max(0.0);
        if *pressure == 0.0 && gap < 0.0 {
            *pressure = -length * gap;
            overlaps = true;
        }
    }
    (overlaps, cuts)
}

/// The penetration of the rigid bodies as pressure, in the share that leaves the least energy; if the load is given, the
/// square root of the penetration at an approach near its own, or without one the load spread evenly.
fn start(influence: &Boussinesq, undeformed: &[f64], condition: Condition, near: Option<f64>) -> Vec<f64> {
    let cosines = influence.cosines();
    let penetration = |approach: f64| -> Vec<f64> {
        let gaps = undeformed.iter().zip(cosines);
        gaps.map(|(gap, cosine)| (approach * cosine - gap).max(0.0)).collect()
    };
    match condition {
        Condition::PressureSum(sum) => {
            let mut shares = near.map_or_else(Vec::new, penetration);
            for share in &mut shares {
                *share = share.sqrt();
            }
            if !shares.iter().any(|share| *share > 0.0) {
                shares = vec![1.0; undeformed.len()];
            }
            let scale = sum / dot(&shares, cosines);
            shares.iter().map(|share| scale * share).collect()
        }
        Condition::Approach(approach) => {
            let penetration = penetration(approach);
            let energy = dot(&penetration, &influence.displacements(&penetration));
            if energy <= 0.0 {
                return penetration;
            }
            let share = dot(&penetration, &penetration) / energy;
            penetration.iter().map(|depth| share * depth).collect()
        }
    }
}

/// Part of a field along the direction cosines, over the elements under pressure: its mean where they are one.
fn along_in_contact(pressures: &[f64], field: &[f64], cosines: &[f64]) -> f64 {
    let (sum, squares) = pressures
        .iter()
        .zip(field.iter().zip(cosines))
        .filter(|(pressure, _)| **pressure > 0.0)
        .fold((0.0, 0.0), |(sum, squares), (_, (value, cosine))| (sum + value * cosine, squares + cosine * cosine));
    sum / squares
}
