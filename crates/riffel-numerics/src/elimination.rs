//! Solution of small dense systems of equations by elimination with the largest pivot of each column.
//!
//! Source: Golub & Van Loan (2013), *Matrix Computations*, 3.4. Error: roundings times the condition of the matrix.

use num_complex::Complex64;

/// Solution x of Ax = b, A given row by row; `None` where A is singular or x not finite. Cost: 2n³/3 operations.
pub fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let count = right.len();
    for column in 0..count {
        let weight = |row: &usize| matrix[*row][column].abs();
        let pivot = (column..count).max_by(|one, other| weight(one).total_cmp(&weight(other)))?;
        let largest = matrix[pivot][column].abs();
        if largest == 0.0 || largest.is_nan() {
            return None;
        }
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let (above, below) = matrix.split_at_mut(column + 1);
        let pivot_row = &above[column];
        for (row, below) in below.iter_mut().enumerate() {
            let factor = below[column] / pivot_row[column];
            let entries = below.iter_mut().zip(pivot_row).skip(column);
            entries.for_each(|(entry, above)| *entry -= factor * above);
            right[column + 1 + row] -= factor * right[column];
        }
    }
    for row in (0..count).rev() {
        let known: f64 = (row + 1..count).map(|entry| matrix[row][entry] * right[entry]).sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    right.iter().all(|value| value.is_finite()).then_some(right)
}

/// Inverse of a square matrix given row by row; not a number where it is singular. Cost: 2n³ operations.
pub fn inverse(mut matrix: Vec<Vec<Complex64>>) -> Vec<Vec<Complex64>> {
    let count = matrix.len();
    let mut inverse = identity(count);
    for column in 0..count {
        let largest = (column..count).max_by(|&one, &other| {
            let size = |row: usize| matrix[row][column].norm_sqr();
            size(one).total_cmp(&size(other))
        });
        let largest = largest.unwrap_or(column);
        matrix.swap(column, largest);
        inverse.swap(column, largest);
        let pivot = matrix[column][column].inv();
        for entry in matrix[column].iter_mut().chain(&mut inverse[column]) {
            *entry *= pivot;
        }
        for row in (0..count).filter(|&row| row != column) {
            let factor = matrix[row][column];
            for other in 0..count {
                let (of_matrix, of_inverse) = (matrix[column][other], inverse[column][other]);
                matrix[row][other] -= factor * of_matrix;
                inverse[row][other] -= factor * of_inverse;
            }
        }
    }
    inverse
}

/// Ones on the diagonal.
pub fn identity(count: usize) -> Vec<Vec<Complex64>> {
    let row = |index: usize| {
        let mut row = vec![Complex64::ZERO; count];
        row[index] = Complex64::ONE;
        row
    };
    (0..count).map(row).collect()
}
