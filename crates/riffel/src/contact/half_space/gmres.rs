//! Linear equations of which only the product with a vector is known.

use super::scalar::{Scalar, add_multiple, dot, norm};
use crate::cancel::check;

/// Solve A x = b by the generalised minimal residual method (Saad & Schultz 1986) without restart, from
/// x = 0, until ‖b − Ax‖ ≤ `tolerance`·‖b‖; the share left if `most` products do not do.
/// `inverse` applies an approximate inverse of A in place, before the product.
pub(super) fn gmres<T: Scalar>(
    mut product: impl FnMut(&[T]) -> Vec<T>,
    inverse: impl Fn(&mut [T]),
    right: &[T],
    tolerance: f64,
    most: usize,
) -> Result<Vec<T>, f64> {
    let size = norm(right);
    if size == 0.0 {
        return Ok(vec![T::zero(); right.len()]);
    }
    let mut basis: Vec<Vec<T>> = vec![scaled(right, size.recip())];
    // Columns of the triangular matrix, the rotations that made it, and the rotated right-hand side.
    let mut columns: Vec<Vec<T>> = Vec::new();
    let mut rotations: Vec<(T, T)> = Vec::new();
    let mut rotated = vec![T::of(size)];
    for step in 0..most {
        check();
        let mut direction = basis[step].clone();
        inverse(&mut direction);
        let mut next = product(&direction);
        let mut column: Vec<T> = Vec::with_capacity(step + 2);
        for direction in &basis {
            let share = dot(direction, &next);
            add_multiple(&mut next, -share, direction);
            column.push(share);
        }
        let rest = norm(&next);
        for (index, &(cosine, sine)) in rotations.iter().enumerate() {
            let (upper, lower) = (column[index], column[index + 1]);
            column[index] = cosine * upper + sine * lower;
            column[index + 1] = cosine * lower - sine.conj() * upper;
        }
        let last = column[step];
        let length = last.abs().hypot(rest);
        if length == 0.0 {
            return Err(rotated[step].abs() / size);
        }
        // The rotation that turns (last, rest) into (phase·length, 0); its cosine is real.
        let (cosine, sine) = if last.abs() == 0.0 {
            (T::zero(), T::one())
        } else {
            let phase = last / T::of(last.abs());
            (T::of(last.abs() / length), phase * T::of(rest / length))
        };
        column[step] = cosine * last + sine * T::of(rest);
        let value = rotated[step];
        rotated[step] = cosine * value;
        rotated.push(-sine.conj() * value);
        rotations.push((cosine, sine));
        columns.push(column);
        if rotated[step + 1].abs() <= tolerance * size || rest == 0.0 {
            let mut solution = combine(&basis, &columns, &rotated);
            inverse(&mut solution);
            return Ok(solution);
        }
        basis.push(scaled(&next, rest.recip()));
    }
    Err(rotated[most].abs() / size)
}

/// Back substitution, and the solution in the basis.
fn combine<T: Scalar>(basis: &[Vec<T>], columns: &[Vec<T>], rotated: &[T]) -> Vec<T> {
    let mut shares = rotated[..columns.len()].to_vec();
    for index in (0..columns.len()).rev() {
        shares[index] = shares[index] / columns[index][index];
        for upper in 0..index {
            shares[upper] = shares[upper] - columns[index][upper] * shares[index];
        }
    }
    let mut solution = vec![T::zero(); basis[0].len()];
    for (direction, &share) in basis.iter().zip(&shares) {
        add_multiple(&mut solution, share, direction);
    }
    solution
}

fn scaled<T: Scalar>(values: &[T], factor: f64) -> Vec<T> {
    values.iter().map(|&value| value * T::of(factor)).collect()
}

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

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
            (0..x.len()).map(|row| (0..x.len()).map(|column| entry(row, column) * x[column]).sum()).collect()
        };
        let right: Vec<Complex64> = (0..20).map(|row| Complex64::new(1.0, row as f64)).collect();
        let solution = gmres(product, |_: &mut [Complex64]| (), &right, 1e-10, 20).unwrap();
        let residual: Vec<Complex64> = product(&solution).iter().zip(&right).map(|(a, b)| a - b).collect();
        assert!(norm(&residual) < 1e-9 * norm(&right));
        assert!(gmres(product, |_: &mut [Complex64]| (), &right, 1e-10, 1).is_err());
    }
}
