//! The share of each element that slips.

use super::friction::Slip;
use super::patch::Patch;

/// Lines along an element on which the boundary of slip is sought.
const LINES: usize = 8;

/// The share of each element that slips \[-\], of a steady state.
///
/// An element sticks or slips whole, so that what follows from a steady state would jump whenever the boundary passes
/// from one element to the next. Where it lies between their centres tells the margin |p + rS| − g: below zero it is
/// the traction that lacks to slip, above it the slip. The margin is interpolated between the centres, and the share is
/// that of the element in which it is positive. Behind the last element of a row all slips; ahead of the first and beside
/// the outermost rows there is no boundary to find, and the margin is that of the element itself.
///
/// `weight` is the factor r of [`Friction::solve`](super::friction::Friction::solve) \[Pa/m\].
pub(super) fn slipping_shares(patch: &Patch, steady: &Slip, bound: &[f64], weight: f64) -> Vec<f64> {
    let slip = |step: usize| steady.distance[0][step].hypot(steady.distance[1][step]);
    let margins: Vec<f64> = (0..patch.len())
        .map(|index| {
            let traction = [0, 1].map(|part| steady.tractions[part][index]);
            traction[0].hypot(traction[1]) + weight * slip(index) - bound[index]
        })
        .collect();
    // The margin on the whole box of elements, with one column more behind it.
    let across = patch.across;
    let mut box_of_margins = vec![None; (across + 1) * across];
    for (&(column, row), &margin) in patch.places.iter().zip(&margins) {
        box_of_margins[row * (across + 1) + column + 1] = Some(margin);
    }
    for (index, step) in patch.steps.iter().enumerate().skip(patch.len()) {
        let (column, row) = step.end;
        box_of_margins[row * (across + 1) + (column + 1) as usize] = Some(weight * slip(index));
    }
    let at = |column: isize, row: isize| {
        let inside = |place: isize, end: usize| (0..end as isize).contains(&place);
        let is_inside = inside(column, across + 1) && inside(row, across);
        is_inside.then(|| box_of_margins[row as usize * (across + 1) + column as usize]).flatten()
    };
    let share = |(&(column, row), &own): (&(usize, usize), &f64)| {
        let (column, row) = (column as isize + 1, row as isize);
        let near = |along: isize, aside: isize| at(column + along, row + aside).unwrap_or(own);
        // From the centre to a side of the element, on a line `aside` of an element from its middle.
        let half = |along: isize, aside: f64| {
            let side = if aside < 0.0 { -1 } else { 1 };
            let between = |a: f64, b: f64, share: f64| a + share * (b - a);
            let middle = between(own, near(0, side), aside.abs());
            let beyond = between(near(along, 0), near(along, side), aside.abs());
            positive_share(middle, between(middle, beyond, 0.5))
        };
        let lines = (0..LINES).map(|line| (line as f64 + 0.5) / LINES as f64 - 0.5);
        let sum: f64 = lines.map(|line| half(-1, line) + half(1, line)).sum();
        0.5 * sum / LINES as f64
    };
    patch.places.iter().zip(&margins).map(share).collect()
}

/// The share of a line on which a linear function is positive, from its values at both ends.
fn positive_share(from: f64, to: f64) -> f64 {
    match (from > 0.0, to > 0.0) {
        (true, true) => 1.0,
        (false, false) => 0.0,
        (true, false) => from / (from - to),
        (false, true) => to / (to - from),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn share_of_a_line() {
        assert_eq!(positive_share(1.0, 0.0), 1.0);
        assert_eq!(positive_share(-1.0, 3.0), 0.75);
        assert_eq!(positive_share(3.0, -1.0), 0.75);
        assert_eq!(positive_share(-1.0, -2.0), 0.0);
    }

    /// A margin that is linear in x and y is positive on just the share of the patch that its line cuts off; what the
    /// edge adds is less than an element at each end of the line.
    #[test]
    fn shares_follow_a_straight_boundary() {
        let patch = Patch::new(1.0, 1.0, 20).unwrap();
        let count = patch.len();
        let part = |place: f64| {
            // Margin: 0.3 − x + 0.4y, as traction where it is negative and as slip where it is positive.
            let margin = |(x, y): (f64, f64)| place - x + 0.4 * y;
            let state = Slip {
                tractions: [patch.centres.iter().map(|&at| 10.0 + margin(at).min(0.0)).collect(), vec![0.0; count]],
                distance: [0, 1].map(|part| {
                    let slip = |step: usize| match patch.centres.get(step) {
                        Some(&at) if part == 0 => margin(at).max(0.0),
                        None if part == 0 => 1.0,
                        _ => 0.0,
                    };
                    (0..patch.steps.len()).map(slip).collect()
                }),
                slips: vec![false; count],
            };
            let shares = slipping_shares(&patch, &state, &vec![10.0; count], 1.0);
            shares.iter().sum::<f64>() * patch.area()
        };
        // A step of the line by a quarter of an element moves the area by as much times its chord.
        let (step, chord) = (0.25 * patch.dx, 2.0 * (1.0f64 - 0.09 / 1.16).sqrt());
        for offset in 0..4 {
            let from = 0.3 + step * f64::from(offset);
            let moved = part(from + step) - part(from);
            let expected = chord * step / 1.16f64.sqrt();
            assert!((moved / expected - 1.0).abs() < 0.1, "{moved} {expected}");
        }
    }
}
