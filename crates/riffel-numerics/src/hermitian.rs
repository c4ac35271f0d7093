//! Solution of Hermitian systems of equations by Cholesky's factors (Golub & Van Loan 2013, *Matrix Computations*, 4.2).

use num_complex::Complex64;

/// Solution x of Ax = b for a positive definite Hermitian A, given by its rows up to the diagonal; not finite for any other. Cost:
/// n³/3 complex operations.
pub fn solve_hermitian(mut rows: Vec<Vec<Complex64>>, mut values: Vec<Complex64>) -> Vec<Complex64> {
    let count = rows.len();
    for row in 0..count {
        for column in 0..=row {
            let (above, from_row) = rows.split_at_mut(row);
            let known: Complex64 = (0..column)
                .map(|place| {
                    let other = above.get(column).unwrap_or(&from_row[0])[place];
                    from_row[0][place] * other.conj()
                })
                .sum();
            let value = from_row[0][column] - known;
            from_row[0][column] = match above.get(column) {
                Some(other) => value / other[column],
                None => value.re.max(0.0).sqrt().into(),
            };
        }
        let known: Complex64 = (0..row).map(|place| rows[row][place] * values[place]).sum();
        values[row] = (values[row] - known) / rows[row][row];
    }
    for row in (0..count).rev() {
        let known: Complex64 = (row + 1..count).map(|place| rows[place][row].conj() * values[place]).sum();
        values[row] = (values[row] - known) / rows[row][row].re;
    }
    values
}
