//! Pressures and gaps that complement one another, by conjugate gradients.

use super::boussinesq::Boussinesq;

/// Largest overlap, and largest gap under pressure, relative to the largest displacement.
pub(super) const TOLERANCE: f64 = 1e-9;

/// Steps after which the solution is given up. Of punches, cones, smooth, wavy and rough contacts on up to 200 ×
/// 200 elements none took more than 100, and with elements a hundred times as long as wide 251.
pub(super) const MOST_STEPS: usize = 1000;

/// What is prescribed.
#[derive(Debug, Clone, Copy)]
pub(super) enum Condition {
    /// Sum of the pressures \[Pa\].
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

/// Pressures p ≥ 0 with g = z + u(p) − δ ≥ 0 and p g = 0 on every element.
///
/// They are the minimum of ½p·u(p) + p·(z − δ) over p ≥ 0, of which g is the gradient. Polonsky & Keer
/// (1999): a step of conjugate gradients on the elements under pressure, negative pressures cut off,
/// overlapping elements without pressure taken in by a step of steepest descent, after which the
/// directions start anew; if the load is given, gradients lose their mean over the contact, δ is that
/// mean, and the pressures are scaled to the load.
///
/// # Errors
/// The residual after `most_steps`.
pub(super) fn solve(
    influence: &Boussinesq,
    undeformed: &[f64],
    condition: Condition,
    most_steps: usize,
) -> Result<Solution, f64> {
    let mut pressures = start(influence, undeformed, condition);
    let mut direction = vec![0.0; pressures.len()];
    // Square of the last gradient; infinite where the directions start anew.
    let mut last_square = f64::INFINITY;
    let mut residual = f64::NAN;
    for steps in 0..=most_steps {
        let displacements = influence.displacements(&pressures);
        let largest = displacements.iter().copied().fold(0.0, f64::max);
        let mut gaps: Vec<f64> = undeformed
            .iter()
            .zip(displacements)
            .map(|(gap, displacement)| gap + displacement)
            .collect();
        let approach = match condition {
            Condition::PressureSum(_) => mean_in_contact(&pressures, &gaps),
            Condition::Approach(approach) => approach,
        };
        for gap in &mut gaps {
            *gap -= approach;
        }
        let violation = pressures
            .iter()
            .zip(&gaps)
            .map(|(&pressure, &gap)| if pressure > 0.0 { gap.abs() } else { -gap })
            .fold(0.0, f64::max);
        residual = violation / largest.max(f64::MIN_POSITIVE);
        if residual <= TOLERANCE {
            return Ok(Solution {
                pressures,
                gaps,
                approach,
                steps,
            });
        }

        let square: f64 = pressures
            .iter()
            .zip(&gaps)
            .filter(|(pressure, _)| **pressure > 0.0)
            .map(|(_, gap)| gap * gap)
            .sum();
        let share = square / last_square;
        for ((direction, &gap), &pressure) in direction.iter_mut().zip(&gaps).zip(&pressures) {
            *direction = if pressure > 0.0 {
                gap + share * *direction
            } else {
                0.0
            };
        }
        let mut change = influence.displacements(&direction);
        if let Condition::PressureSum(_) = condition {
            let mean = mean_in_contact(&pressures, &change);
            for change in &mut change {
                *change -= mean;
            }
        }
        let slope: f64 = dot(&gaps, &direction);
        let curvature: f64 = dot(&change, &direction);
        // A contact of one element has no direction to go: overlapping elements then come in with the
        // step of an element on its own.
        let length = if curvature > 0.0 {
            slope / curvature
        } else {
            influence.own().recip()
        };
        let mut overlaps = false;
        for ((pressure, direction), &gap) in pressures.iter_mut().zip(&direction).zip(&gaps) {
            *pressure = (*pressure - length * direction).max(0.0);
            if *pressure == 0.0 && gap < 0.0 {
                *pressure = -length * gap;
                overlaps = true;
            }
        }
        last_square = if overlaps { f64::INFINITY } else { square };
        if let Condition::PressureSum(wanted) = condition {
            let scale = wanted / pressures.iter().sum::<f64>();
            for pressure in &mut pressures {
                *pressure *= scale;
            }
        }
    }
    Err(residual)
}

/// The load spread evenly, or the penetration of the rigid bodies as pressure, in the share that leaves the
/// least energy.
fn start(influence: &Boussinesq, undeformed: &[f64], condition: Condition) -> Vec<f64> {
    match condition {
        Condition::PressureSum(sum) => vec![sum / undeformed.len() as f64; undeformed.len()],
        Condition::Approach(approach) => {
            let penetration: Vec<f64> = undeformed
                .iter()
                .map(|gap| (approach - gap).max(0.0))
                .collect();
            let energy = dot(&penetration, &influence.displacements(&penetration));
            if energy <= 0.0 {
                return penetration;
            }
            let share = dot(&penetration, &penetration) / energy;
            penetration.iter().map(|depth| share * depth).collect()
        }
    }
}

/// Mean of a field over the elements under pressure.
fn mean_in_contact(pressures: &[f64], field: &[f64]) -> f64 {
    let (sum, count) = pressures
        .iter()
        .zip(field)
        .filter(|(pressure, _)| **pressure > 0.0)
        .fold((0.0, 0), |(sum, count), (_, value)| {
            (sum + value, count + 1)
        });
    sum / f64::from(count)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
