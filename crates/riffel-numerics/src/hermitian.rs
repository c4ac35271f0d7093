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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_hermitian() {
        let full = |row: usize, column: usize| {
            let (low, high) = (row.min(column) as f64, row.max(column) as f64);
            let value = Complex64::new(0.3 * (low + high), (low - high) * 0.4 - 0.1 * low * high);
            match row.cmp(&column) {
                std::cmp::Ordering::Less => value,
                std::cmp::Ordering::Equal => Complex64::from(20.0 + low),
                std::cmp::Ordering::Greater => value.conj(),
            }
        };
        let rows = (0..5).map(|row| (0..=row).map(|column| full(row, column)).collect());
        let values: Vec<Complex64> = (0..5).map(|row| Complex64::new(1.0, f64::from(row))).collect();
        let solution = solve_hermitian(rows.collect(), values.clone());
        for (row, value) in values.iter().enumerate() {
            let image: Complex64 = (0..5).map(|column| full(row, column) * solution[column]).sum();
            assert!((image - value).norm() < 1e-12);
        }
        assert!(solve_hermitian(Vec::new(), Vec::new()).is_empty());
    }
}
