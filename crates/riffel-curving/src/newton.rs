//! Newton's method on a small dense system, with halved steps.

use riffel::cancel::check;
use riffel_numerics::elimination::solve;

/// A system of equations of which evaluating a part is what costs.
pub(super) trait Equations {
    /// What is evaluated at values of the unknowns.
    type Evaluated;

    /// `None` if the equations are not defined.
    fn evaluate(&self, unknowns: &[f64]) -> Option<Self::Evaluated>;

    fn residuals(&self, unknowns: &[f64], evaluated: &Self::Evaluated) -> Vec<f64>;

    /// Residuals where one unknown differs from those at which `evaluated` was found.
    fn moved(&self, unknowns: &[f64], evaluated: &Self::Evaluated, unknown: usize) -> Option<Vec<f64>>;
}

/// A root as far as rounding lets it be found.
pub(super) struct Root {
    pub(super) unknowns: Vec<f64>,
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

/// A root near a start; `None` if the method stays above the tolerance. Unknowns are measured by their scales.
///
/// Method: Jacobian by central differences, Gaussian elimination with partial pivoting, steps halved until the sum of
/// squares falls; ends where rounding keeps it from falling. Cost: some evaluations a step and 2N of the part that an
/// unknown moves.
pub(super) fn root<E: Equations>(equations: &E, start: Vec<f64>, scales: &[f64], tolerance: f64) -> Option<Root> {
    let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
    let mut unknowns = start;
    let mut evaluated = equations.evaluate(&unknowns)?;
    let mut values = equations.residuals(&unknowns, &evaluated);
    let mut iterations = 0;
    while iterations < MOST_STEPS && square(&values) > 0.0 {
        check();
        let Some(step) = newton_step(equations, &unknowns, &evaluated, &values, scales) else {
            break;
        };
        let trials = (0..MOST_HALVINGS as i32).map(|halvings| {
            let share = 0.5f64.powi(halvings);
            unknowns.iter().zip(&step).map(|(unknown, step)| unknown - share * step).collect::<Vec<f64>>()
        });
        // A step that rounding swallows leads nowhere, nor does half of it.
        let next = trials.take_while(|trial| *trial != unknowns).find_map(|trial| {
            let there = equations.evaluate(&trial)?;
            let values_there = equations.residuals(&trial, &there);
            (square(&values_there) < square(&values)).then_some((trial, there, values_there))
        });
        let Some(next) = next else {
            break;
        };
        iterations += 1;
        (unknowns, evaluated, values) = next;
    }
    let residual = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    (residual <= tolerance).then_some(Root { unknowns, residual, iterations })
}

fn newton_step<E: Equations>(
    equations: &E,
    unknowns: &[f64],
    evaluated: &E::Evaluated,
    values: &[f64],
    scales: &[f64],
) -> Option<Vec<f64>> {
    let count = unknowns.len();
    let mut jacobian = vec![vec![0.0; count]; count];
    let mut moved = unknowns.to_vec();
    for column in 0..count {
        let difference = DIFFERENCE * scales[column];
        let mut at = |change: f64| {
            moved[column] = unknowns[column] + change;
            equations.moved(&moved, evaluated, column)
        };
        let (above, below) = (at(difference)?, at(-difference)?);
        moved[column] = unknowns[column];
        for row in 0..count {
            jacobian[row][column] = (above[row] - below[row]) / (2.0 * difference);
        }
    }
    solve(jacobian, values.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equations of which nothing is kept.
    struct Plain<F>(F);

    impl<F: Fn(&[f64]) -> Vec<f64>> Equations for Plain<F> {
        type Evaluated = ();

        fn evaluate(&self, _: &[f64]) -> Option<()> {
            Some(())
        }

        fn residuals(&self, unknowns: &[f64], (): &()) -> Vec<f64> {
            self.0(unknowns)
        }

        fn moved(&self, unknowns: &[f64], (): &(), _: usize) -> Option<Vec<f64>> {
            Some(self.0(unknowns))
        }
    }

    #[test]
    fn finds_where_a_circle_meets_a_hyperbola() {
        let equations = Plain(|at: &[f64]| {
            let (x, y) = (at[0], at[1]);
            vec![x * x + y * y - 5.0, x * y - 2.0]
        });
        let found = root(&equations, vec![3.0, 0.5], &[1.0, 1.0], 1e-12).unwrap();
        assert!((found.unknowns[0] - 2.0).abs() < 1e-14 && (found.unknowns[1] - 1.0).abs() < 1e-14);
        assert!(found.iterations < 10);
    }

    #[test]
    fn tells_where_there_is_none() {
        let equations = Plain(|at: &[f64]| vec![at[0] * at[0] + 1.0]);
        assert!(root(&equations, vec![3.0], &[1.0], 1e-12).is_none());
    }
}
