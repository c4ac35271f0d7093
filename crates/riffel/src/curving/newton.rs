//! Newton's method on a small dense system, with halved steps.

/// A root as far as rounding lets it be found.
pub(super) struct Root<const N: usize> {
    pub(super) unknowns: [f64; N],
    /// Largest residual.
    pub(super) residual: f64,
    pub(super) iterations: usize,
}

/// Most Newton steps; from a start within reach some ten are needed.
const MOST_STEPS: usize = 60;
/// Most halvings of one step.
const MOST_HALVINGS: usize = 24;
/// Step of the central differences, over the scale of an unknown: their error, of the second order, is near that of
/// rounding there.
const DIFFERENCE: f64 = 1e-5;

/// A root of `residuals` near a start; none where the method stays above the tolerance. Where residuals are not
/// defined they are none. Unknowns are measured by their scales.
///
/// Method: Jacobian by central differences, Gaussian elimination with partial pivoting, steps halved until the sum of
/// squares falls; ends where rounding keeps it from falling. Cost: 2N + some evaluations a step.
pub(super) fn root<const N: usize>(
    residuals: impl Fn(&[f64; N]) -> Option<[f64; N]>,
    start: [f64; N],
    scales: &[f64; N],
    tolerance: f64,
) -> Option<Root<N>> {
    let square = |values: &[f64; N]| values.iter().map(|value| value * value).sum::<f64>();
    let mut unknowns = start;
    let mut values = residuals(&unknowns)?;
    let mut iterations = 0;
    while iterations < MOST_STEPS && square(&values) > 0.0 {
        let Some(step) = newton_step(&residuals, &unknowns, &values, scales) else {
            break;
        };
        let mut share = 1.0;
        let next = (0..MOST_HALVINGS).find_map(|_| {
            let trial: [f64; N] = std::array::from_fn(|i| unknowns[i] - share * step[i]);
            share *= 0.5;
            let values_there = residuals(&trial)?;
            (square(&values_there) < square(&values)).then_some((trial, values_there))
        });
        let Some(next) = next else {
            break;
        };
        iterations += 1;
        (unknowns, values) = next;
    }
    let residual = values
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    (residual <= tolerance).then_some(Root {
        unknowns,
        residual,
        iterations,
    })
}

fn newton_step<const N: usize>(
    residuals: &impl Fn(&[f64; N]) -> Option<[f64; N]>,
    unknowns: &[f64; N],
    values: &[f64; N],
    scales: &[f64; N],
) -> Option<[f64; N]> {
    let mut jacobian = [[0.0; N]; N];
    for column in 0..N {
        let difference = DIFFERENCE * scales[column];
        let at = |change: f64| {
            let mut moved = *unknowns;
            moved[column] += change;
            residuals(&moved)
        };
        let (above, below) = (at(difference)?, at(-difference)?);
        for row in 0..N {
            jacobian[row][column] = (above[row] - below[row]) / (2.0 * difference);
        }
    }
    solve(jacobian, *values)
}

/// The solution of a system of equations; none for a singular one.
fn solve<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    for column in 0..N {
        let weight = |row: &usize| matrix[*row][column].abs();
        let pivot = (column..N).max_by(|one, other| weight(one).total_cmp(&weight(other)))?;
        let largest = matrix[pivot][column].abs();
        if largest == 0.0 || largest.is_nan() {
            return None;
        }
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        for row in column + 1..N {
            let factor = matrix[row][column] / matrix[column][column];
            let pivot_row = matrix[column];
            let entries = matrix[row].iter_mut().zip(pivot_row).skip(column);
            entries.for_each(|(entry, above)| *entry -= factor * above);
            right[row] -= factor * right[column];
        }
    }
    for row in (0..N).rev() {
        let known: f64 = (row + 1..N)
            .map(|entry| matrix[row][entry] * right[entry])
            .sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    right.iter().all(|value| value.is_finite()).then_some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_where_a_circle_meets_a_hyperbola() {
        let residuals = |[x, y]: &[f64; 2]| Some([x * x + y * y - 5.0, x * y - 2.0]);
        let found = root(residuals, [3.0, 0.5], &[1.0, 1.0], 1e-12).unwrap();
        assert!((found.unknowns[0] - 2.0).abs() < 1e-14 && (found.unknowns[1] - 1.0).abs() < 1e-14);
        assert!(found.iterations < 10);
    }

    #[test]
    fn tells_where_there_is_none() {
        assert!(root(|[x]: &[f64; 1]| Some([x * x + 1.0]), [3.0], &[1.0], 1e-12).is_none());
    }
}
