//! Linear least squares of real numbers, for a few dozen unknowns.
//!
//! Own, because a crate for dense matrices takes longer to build than all of this one.

/// The x of least |A x − b|, by Householder reflections (Golub & Van Loan, *Matrix Computations*, 5.2): `columns` are
/// those of A, each as long as `right`, b; all are used up. Columns of any size: each is first scaled to length one. A
/// column that depends on those before it to rounding takes no part, its unknown is zero.
///
/// Cost: 2n²m operations for n unknowns and m equations.
pub(super) fn least_squares(columns: &mut [Vec<f64>], right: &mut [f64]) -> Vec<f64> {
    /// Some hundred roundings of a column of length one.
    const DEPENDENT: f64 = 3e-14;
    let length = |column: &Vec<f64>| Some(norm(column)).filter(|length| *length > 0.0);
    let scales: Vec<f64> = columns
        .iter()
        .map(|column| length(column).unwrap_or(1.0))
        .collect();
    for (column, scale) in columns.iter_mut().zip(&scales) {
        column.iter_mut().for_each(|entry| *entry /= scale);
    }
    let mut solution = vec![0.0; columns.len()];
    // Columns with their rows of R.
    let mut taken: Vec<(usize, usize)> = Vec::new();
    for index in 0..columns.len() {
        let row = taken.len();
        let (known, others) = columns.split_at_mut(index + 1);
        let pivot = &mut known[index];
        let length = norm(&pivot[row..]);
        if length <= DEPENDENT {
            continue;
        }
        // The reflection that leaves the first entry alone.
        let first = -length.copysign(pivot[row]);
        let mut mirror = pivot[row..].to_vec();
        mirror[0] -= first;
        let factor = 2.0 / mirror.iter().map(|entry| entry * entry).sum::<f64>();
        let reflect = |column: &mut [f64]| {
            let share = factor * dot(&mirror, column);
            for (entry, mirror) in column.iter_mut().zip(&mirror) {
                *entry -= share * mirror;
            }
        };
        others
            .iter_mut()
            .for_each(|column| reflect(&mut column[row..]));
        reflect(&mut right[row..]);
        pivot[row] = first;
        taken.push((index, row));
    }
    for &(index, row) in taken.iter().rev() {
        let after = taken.iter().filter(|(_, later)| *later > row);
        let known: f64 = after
            .map(|&(other, _)| columns[other][row] * solution[other])
            .sum();
        solution[index] = (right[row] - known) / columns[index][row];
    }
    for (value, scale) in solution.iter_mut().zip(&scales) {
        *value /= scale;
    }
    solution
}

fn norm(column: &[f64]) -> f64 {
    dot(column, column).sqrt()
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The residual is normal to every column, whatever their sizes: twenty roundings of the longest.
        #[test]
        fn residual_is_normal_to_the_columns(
            entries in proptest::collection::vec(-1.0..1.0f64, 8 * 30), right in proptest::collection::vec(-1.0..1.0f64, 30),
        ) {
            let sizes = [1.0, 1e-9, 1e6, 1.0, 30.0, 1e-3, 1.0, 1e3];
            let columns: Vec<Vec<f64>> = entries
                .chunks_exact(30)
                .zip(sizes)
                .map(|(column, size)| column.iter().map(|entry| size * entry).collect())
                .collect();
            let solution = least_squares(&mut columns.clone(), &mut right.clone());
            let mut residual = right;
            for (column, value) in columns.iter().zip(&solution) {
                for (residual, entry) in residual.iter_mut().zip(column) {
                    *residual -= value * entry;
                }
            }
            for column in &columns {
                prop_assert!(dot(column, &residual).abs() <= 1e-12 * norm(column));
            }
        }
    }

    #[test]
    fn a_column_that_depends_on_others_takes_no_part() {
        let mut columns = [
            vec![1.0, 2.0, 3.0],
            vec![-2.0, -4.0, -6.0],
            vec![0.0, 1.0, 1.0],
        ];
        let solution = least_squares(&mut columns, &mut [2.0, 5.0, 7.0]);
        let expected = [2.0, 0.0, 1.0];
        for (value, expected) in solution.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-13, "{solution:?}");
        }
    }
}
