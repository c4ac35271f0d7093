//! Square linear equations of complex numbers, for systems of a few dozen unknowns.
//!
//! Own, because a crate for dense matrices takes longer to build than all of this one and the systems are small.

use num_complex::Complex64;

/// A determinant as a number times a power of two: that of a hundred equations leaves the range of a double.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Determinant {
    factor: Complex64,
    exponent: i32,
}

impl Determinant {
    /// True for a singular matrix.
    pub(super) fn is_zero(self) -> bool {
        self.factor == Complex64::ZERO
    }

    /// The ratio of two.
    pub(super) fn over(self, other: Self) -> Complex64 {
        self.factor / other.factor * 2.0_f64.powi(self.exponent - other.exponent)
    }

    fn times(self, pivot: Complex64) -> Self {
        let factor = self.factor * pivot;
        let exponent = binary_exponent(factor.norm_sqr()) / 2;
        Self {
            factor: factor * 2.0_f64.powi(-exponent),
            exponent: self.exponent + exponent,
        }
    }
}

/// The power of two below a positive number.
fn binary_exponent(value: f64) -> i32 {
    /// Bits of the fraction, bits of the exponent, and what it is counted from.
    const FRACTION: u32 = 52;
    const EXPONENT: u64 = 0x7ff;
    const ZERO: i32 = 1023;
    ((value.to_bits() >> FRACTION) & EXPONENT) as i32 - ZERO
}

/// Solve A X = B by elimination with row pivots, in place, and give the determinant of A: `matrix` holds the rows of A and
/// is used up, `right` the rows of B, which become those of X. X means nothing where A is singular.
///
/// Rows are first scaled by powers of two, so that pivots are chosen by the size of an entry within its own row: forces and
/// displacements differ by ten orders.
/// Cost: 8n³/3 operations on real numbers, and 8n² for each right-hand side.
pub(super) fn solve(matrix: &mut [Complex64], right: &mut [Complex64], size: usize) -> Determinant {
    let columns = right.len() / size;
    let mut determinant = Determinant {
        factor: Complex64::ONE,
        exponent: 0,
    };
    let rows = matrix.chunks_exact_mut(size);
    for (row, right) in rows.zip(right.chunks_exact_mut(columns)) {
        let largest = row.iter().map(|entry| entry.norm_sqr()).fold(0.0, f64::max);
        if largest > 0.0 {
            let exponent = binary_exponent(largest) / 2;
            let scale = 2.0_f64.powi(-exponent);
            row.iter_mut()
                .chain(right)
                .for_each(|entry| *entry *= scale);
            determinant.exponent += exponent;
        }
    }
    for column in 0..size {
        let weight = |row: usize| matrix[row * size + column].norm_sqr();
        let mut pivot = column;
        let mut most = weight(column);
        for row in column + 1..size {
            let weight = weight(row);
            if weight > most {
                (pivot, most) = (row, weight);
            }
        }
        if pivot != column {
            swap_rows(matrix, size, column, pivot);
            swap_rows(right, columns, column, pivot);
            determinant.factor = -determinant.factor;
        }
        let (above, below) = matrix.split_at_mut((column + 1) * size);
        let above = &above[column * size..];
        let (right_above, right_below) = right.split_at_mut((column + 1) * columns);
        let right_above = &right_above[column * columns..];
        determinant = determinant.times(above[column]);
        if determinant.is_zero() {
            return determinant;
        }
        let reciprocal = above[column].inv();
        let rows = below.chunks_exact_mut(size);
        for (row, right_row) in rows.zip(right_below.chunks_exact_mut(columns)) {
            let factor = row[column] * reciprocal;
            if factor == Complex64::ZERO {
                continue;
            }
            // What stands below a pivot is not read again.
            for (entry, pivot) in row[column + 1..].iter_mut().zip(&above[column + 1..]) {
                *entry -= factor * pivot;
            }
            for (entry, pivot) in right_row.iter_mut().zip(right_above) {
                *entry -= factor * pivot;
            }
        }
    }
    for row in (0..size).rev() {
        let entries = &matrix[row * size..(row + 1) * size];
        let (known, solved) = right.split_at_mut((row + 1) * columns);
        let known = &mut known[row * columns..];
        for (share, solved) in entries[row + 1..].iter().zip(solved.chunks_exact(columns)) {
            for (known, solved) in known.iter_mut().zip(solved) {
                *known -= share * solved;
            }
        }
        let reciprocal = entries[row].inv();
        for known in known {
            *known *= reciprocal;
        }
    }
    determinant
}

fn swap_rows(matrix: &mut [Complex64], size: usize, one: usize, other: usize) {
    let (first, second) = matrix.split_at_mut(other * size);
    first[one * size..(one + 1) * size].swap_with_slice(&mut second[..size]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ONE: Determinant = Determinant {
        factor: Complex64::ONE,
        exponent: 0,
    };

    proptest! {
        /// A X is B again, and the determinant that of the product of two factors known.
        #[test]
        fn solves(numbers in proptest::collection::vec(-1.0..1.0f64, 2 * (36 + 12))) {
            let numbers: Vec<Complex64> =
                numbers.chunks_exact(2).map(|pair| Complex64::new(pair[0], pair[1])).collect();
            let (matrix, right) = numbers.split_at(36);
            let (mut used, mut solution) = (matrix.to_vec(), right.to_vec());
            let determinant = solve(&mut used, &mut solution, 6).over(ONE);
            // Random matrices of this size are seldom worse conditioned; then rounding is not what is tested.
            prop_assume!(determinant.norm() > 1e-2);
            for row in 0..6 {
                for column in 0..2 {
                    let product: Complex64 =
                        (0..6).map(|k| matrix[row * 6 + k] * solution[k * 2 + column]).sum();
                    prop_assert!((product - right[row * 2 + column]).norm() < 1e-10);
                }
            }
        }
    }

    /// A permutation has the determinant of its sign, whatever the scale of its rows.
    #[test]
    fn rows_are_taken_in_any_order() {
        let mut matrix = [0.0, 1e-9, 0.0, 0.0, 0.0, 1e5, 2.0, 0.0, 0.0].map(Complex64::from);
        let mut right = [3e-9, 4e5, 5.0].map(Complex64::from);
        let determinant = solve(&mut matrix, &mut right, 3).over(ONE);
        assert!((determinant.re - 2e-4).abs() < 1e-18);
        for (got, expected) in right.iter().zip([2.5, 3.0, 4.0]) {
            assert!((got - expected).norm() < 1e-12);
        }
        let mut singular = [1.0, 2.0, 2.0, 4.0].map(Complex64::from);
        assert!(solve(&mut singular, &mut [Complex64::ONE; 2], 2).is_zero());
    }

    /// A hundred equations in nanometres have a determinant far below the smallest double, and a solution.
    #[test]
    fn small_rows_are_not_singular() {
        const SIZE: usize = 100;
        let diagonal = |scale: f64| -> Vec<Complex64> {
            let entry = |index: usize| {
                if index.is_multiple_of(SIZE + 1) {
                    scale
                } else {
                    0.0
                }
            };
            (0..SIZE * SIZE).map(|index| entry(index).into()).collect()
        };
        let mut right = vec![Complex64::from(2e-9); SIZE];
        let determinant = solve(&mut diagonal(1e-9), &mut right, SIZE);
        assert!(right.iter().all(|value| (value - 2.0).norm() < 1e-12));
        let twice = solve(&mut diagonal(2e-9), &mut [Complex64::ONE; SIZE], SIZE);
        let ratio = twice.over(determinant).re / 2.0_f64.powi(SIZE as i32);
        assert!((ratio - 1.0).abs() < 1e-12, "{ratio}");
    }
}
