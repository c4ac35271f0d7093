//! Inverse of a small dense matrix.

use num_complex::Complex64;

/// Inverse by elimination with the largest pivot of each column.
pub(crate) fn inverse(mut matrix: Vec<Vec<Complex64>>) -> Vec<Vec<Complex64>> {
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

pub(crate) fn identity(count: usize) -> Vec<Vec<Complex64>> {
    let row = |index: usize| {
        let mut row = vec![Complex64::ZERO; count];
        row[index] = Complex64::ONE;
        row
    };
    (0..count).map(row).collect()
}
