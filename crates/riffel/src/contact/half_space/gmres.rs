//! Linear equations of which only the product with a vector is known.

use num_complex::Complex64;

/// Solve A x = b by the generalised minimal residual method (Saad & Schultz 1986) without restart, from
/// x = 0, until ‖b − Ax‖ ≤ `tolerance`·‖b‖. None if `most` products do not do.
/// `inverse` is an approximate inverse of A, applied first.
pub(super) fn gmres(
    product: impl Fn(&[Complex64]) -> Vec<Complex64>,
    inverse: impl Fn(&[Complex64]) -> Vec<Complex64>,
    right: &[Complex64],
    tolerance: f64,
    most: usize,
) -> Option<Vec<Complex64>> {
    let size = norm(right);
    if size == 0.0 {
        return Some(vec![Complex64::ZERO; right.len()]);
    }
    let mut basis: Vec<Vec<Complex64>> = vec![right.iter().map(|value| value / size).collect()];
    // Columns of the triangular matrix, the rotations that made it, and the rotated right-hand side.
    let mut columns: Vec<Vec<Complex64>> = Vec::new();
    let mut rotations: Vec<(f64, Complex64)> = Vec::new();
    let mut rotated = vec![Complex64::from(size)];
    for step in 0..most {
        let mut next = product(&inverse(&basis[step]));
        let mut column: Vec<Complex64> = Vec::with_capacity(step + 2);
        for direction in &basis {
            let share = dot(direction, &next);
            for (value, other) in next.iter_mut().zip(direction) {
                *value -= share * other;
            }
            column.push(share);
        }
        let rest = norm(&next);
        for (index, &(cosine, sine)) in rotations.iter().enumerate() {
            let (upper, lower) = (column[index], column[index + 1]);
            column[index] = cosine * upper + sine * lower;
            column[index + 1] = -sine.conj() * upper + cosine * lower;
        }
        let last = column[step];
        let length = last.norm().hypot(rest);
        if length == 0.0 {
            return None;
        }
        // The rotation that turns (last, rest) into (phase·length, 0).
        let (cosine, sine) = if last.norm() == 0.0 {
            (0.0, Complex64::ONE)
        } else {
            (last.norm() / length, last / last.norm() * rest / length)
        };
        column[step] = cosine * last + sine * rest;
        let value = rotated[step];
        rotated[step] = cosine * value;
        rotated.push(-sine.conj() * value);
        rotations.push((cosine, sine));
        columns.push(column);
        if rotated[step + 1].norm() <= tolerance * size || rest == 0.0 {
            let solution = inverse(&combine(&basis, &columns, &rotated));
            return Some(solution);
        }
        basis.push(next.into_iter().map(|value| value / rest).collect());
    }
    None
}

/// Back substitution, and the solution in the basis.
fn combine(
    basis: &[Vec<Complex64>],
    columns: &[Vec<Complex64>],
    rotated: &[Complex64],
) -> Vec<Complex64> {
    let mut shares = rotated[..columns.len()].to_vec();
    for index in (0..columns.len()).rev() {
        shares[index] /= columns[index][index];
        for upper in 0..index {
            let known = shares[index];
            shares[upper] -= columns[index][upper] * known;
        }
    }
    let mut solution = vec![Complex64::ZERO; basis[0].len()];
    for (direction, share) in basis.iter().zip(&shares) {
        for (value, other) in solution.iter_mut().zip(direction) {
            *value += share * other;
        }
    }
    solution
}

fn dot(a: &[Complex64], b: &[Complex64]) -> Complex64 {
    a.iter().zip(b).map(|(a, b)| a.conj() * b).sum()
}

fn norm(a: &[Complex64]) -> f64 {
    a.iter().map(Complex64::norm_sqr).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A full matrix that is not symmetric, to the tolerance asked for.
    #[test]
    fn solves() {
        let entry = |row: usize, column: usize| {
            let diagonal = if row == column { 4.0 } else { 0.0 };
            Complex64::new(
                diagonal + (row as f64 * 1.7 + column as f64).sin(),
                (column as f64 - 0.3 * row as f64).cos(),
            )
        };
        let product = |x: &[Complex64]| -> Vec<Complex64> {
            (0..x.len())
                .map(|row| {
                    (0..x.len())
                        .map(|column| entry(row, column) * x[column])
                        .sum()
                })
                .collect()
        };
        let right: Vec<Complex64> = (0..20).map(|row| Complex64::new(1.0, row as f64)).collect();
        let solution = gmres(product, <[_]>::to_vec, &right, 1e-10, 20).unwrap();
        let residual: Vec<Complex64> = product(&solution)
            .iter()
            .zip(&right)
            .map(|(a, b)| a - b)
            .collect();
        assert!(norm(&residual) < 1e-9 * norm(&right));
        assert!(gmres(product, <[_]>::to_vec, &right, 1e-10, 1).is_none());
    }
}
