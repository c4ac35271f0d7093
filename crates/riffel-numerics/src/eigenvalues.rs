//! Eigenvalues of a real matrix, for some hundred rows.
//!
//! Own, because a crate for dense matrices takes longer to build than all of this one.

use num_complex::Complex64;

/// Eigenvalues of a square matrix given row by row, pairs exactly conjugate.
///
/// Method: balanced by powers of two (Parlett & Reinsch 1969), Hessenberg form by reflections, and the QR algorithm with double
/// shifts (Francis 1961; steps as of Martin, Peters & Wilkinson 1970, Numer. Math. 14, 219–231). Accuracy: that of a matrix
/// changed by roundings. An eigenvalue that 60 sweeps do not part from the others is not a number. Cost: some 10n³
/// operations.
pub fn eigenvalues(mut matrix: Vec<Vec<f64>>) -> Vec<Complex64> {
    const SWEEPS: usize = 60;
    balance(&mut matrix);
    to_hessenberg(&mut matrix);
    let mut values = Vec::with_capacity(matrix.len());
    let mut count = matrix.len();
    let mut shift = 0.0;
    let mut sweeps = 0;
    while count > 0 {
        let last = count - 1;
        let first = first_of_block(&mut matrix, last);
        if last - first <= 1 {
            match last - first {
                0 => values.push(Complex64::from(matrix[last][last] + shift)),
                _ => values.extend(of_two(&matrix, last).map(|value| value + shift)),
            }
            count = first;
            sweeps = 0;
            continue;
        }
        if sweeps == SWEEPS {
            values.extend(vec![Complex64::new(f64::NAN, 0.0); count]);
            break;
        }
        let mut x = matrix[last][last];
        let mut y = matrix[last - 1][last - 1];
        let mut w = matrix[last][last - 1] * matrix[last - 1][last];
        if sweeps % 10 == 9 {
            // A shift of no meaning, where others go round in circles.
            shift += x;
            for (index, row) in matrix.iter_mut().enumerate().take(count) {
                row[index] -= x;
            }
            let size = matrix[last][last - 1].abs() + matrix[last - 1][last - 2].abs();
            x = 0.75 * size;
            y = x;
            w = -0.4375 * size * size;
        }
        sweeps += 1;
        sweep(&mut matrix, first, last, [x + y, x * y - w]);
    }
    values
}

/// The first row of the block that ends with a row: above it an entry below the diagonal is a rounding.
fn first_of_block(matrix: &mut [Vec<f64>], last: usize) -> usize {
    for row in (1..=last).rev() {
        let size = matrix[row - 1][row - 1].abs() + matrix[row][row].abs();
        if matrix[row][row - 1].abs() <= f64::EPSILON * size {
            matrix[row][row - 1] = 0.0;
            return row;
        }
    }
    0
}

/// Eigenvalues of the block of two rows that ends with `last`.
fn of_two(matrix: &[Vec<f64>], last: usize) -> [Complex64; 2] {
    let (a, d) = (matrix[last - 1][last - 1], matrix[last][last]);
    let product = matrix[last - 1][last] * matrix[last][last - 1];
    let half = 0.5 * (a - d);
    let square = half * half + product;
    if square < 0.0 {
        let value = Complex64::new(d + half, (-square).sqrt());
        return [value, value.conj()];
    }
    let larger = half + square.sqrt().copysign(half);
    let other = if larger == 0.0 { 0.0 } else { -product / larger };
    [d + larger, d + other].map(Complex64::from)
}

/// One double step of rows `first` to `last`, for shifts of the given sum and product.
#[expect(clippy::needless_range_loop, reason = "an index is that of a column, or of a row and a column")]
fn sweep(matrix: &mut [Vec<f64>], first: usize, last: usize, [sum, product]: [f64; 2]) {
    let a = &matrix;
    // The first column of (A − s₁)(A − s₂), over the entry below the diagonal.
    let (one, below) = (a[first][first], a[first + 1][first]);
    let mut column = [
        (one * one - sum * one + product) / below + a[first][first + 1],
        one + a[first + 1][first + 1] - sum,
        a[first + 2][first + 1],
    ];
    for k in first..last {
        let rows = if k + 1 < last { 3 } else { 2 };
        if k > first {
            column = [matrix[k][k - 1], matrix[k + 1][k - 1], 0.0];
            if rows == 3 {
                column[2] = matrix[k + 2][k - 1];
            }
        }
        let column = &mut column[..rows];
        let length = column.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        if length == 0.0 {
            continue;
        }
        let becomes = -length.copysign(column[0]);
        column[0] -= becomes;
        let factor = 2.0 / column.iter().map(|entry| entry * entry).sum::<f64>();
        let from = k.saturating_sub(1).max(first);
        for j in from..=last {
            let share: f64 = (0..rows).map(|i| column[i] * matrix[k + i][j]).sum();
            for i in 0..rows {
                matrix[k + i][j] -= factor * share * column[i];
            }
        }
        for row in &mut matrix[first..=last.min(k + 3)] {
            let share: f64 = (0..rows).map(|i| column[i] * row[k + i]).sum();
            for i in 0..rows {
                row[k + i] -= factor * share * column[i];
            }
        }
        if k > first {
            for i in 1..rows {
                matrix[k + i][k - 1] = 0.0;
            }
        }
    }
}

/// Rows and columns of like size, by powers of two.
#[expect(clippy::needless_range_loop, reason = "an index is that of a column, or of a row and a column")]
fn balance(matrix: &mut [Vec<f64>]) {
    let count = matrix.len();
    for _ in 0..20 {
        let mut settled = true;
        for index in 0..count {
            let others = (0..count).filter(|&other| other != index);
            let column: f64 = others.clone().map(|other| matrix[other][index].abs()).sum();
            let row: f64 = others.map(|other| matrix[index][other].abs()).sum();
            if column == 0.0 || row == 0.0 {
                continue;
            }
            let power = (0.5 * (row / column).log2()).round();
            if power != 0.0 {
                settled = false;
                let factor = power.exp2();
                for other in 0..count {
                    matrix[other][index] *= factor;
                }
                matrix[index].iter_mut().for_each(|entry| *entry /= factor);
            }
        }
        if settled {
            break;
        }
    }
}

/// Zeros below the first diagonal under the main one, by reflections from both sides.
#[expect(clippy::needless_range_loop, reason = "an index is that of a column, or of a row and a column")]
fn to_hessenberg(matrix: &mut [Vec<f64>]) {
    let count = matrix.len();
    for column in 0..count.saturating_sub(2) {
        let mut mirror: Vec<f64> = (column + 1..count).map(|row| matrix[row][column]).collect();
        let length = mirror.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        if length == 0.0 {
            continue;
        }
        mirror[0] += length.copysign(mirror[0]);
        let factor = 2.0 / mirror.iter().map(|entry| entry * entry).sum::<f64>();
        for j in column..count {
            let share: f64 = (column + 1..count).map(|row| mirror[row - column - 1] * matrix[row][j]).sum();
            for row in column + 1..count {
                matrix[row][j] -= factor * share * mirror[row - column - 1];
            }
        }
        for row in matrix.iter_mut() {
            let share: f64 = mirror.iter().zip(&row[column + 1..]).map(|(mirror, entry)| mirror * entry).sum();
            for (entry, mirror) in row[column + 1..].iter_mut().zip(&mirror) {
                *entry -= factor * share * mirror;
            }
        }
        for row in &mut matrix[column + 2..] {
            row[column] = 0.0;
        }
    }
}
