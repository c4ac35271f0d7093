//! Each row of elements by itself: an approximate inverse of the whole contact.

use num_complex::ComplexFloat;

use super::influence::Influence;
use super::patch::Patch;

/// Factors of the equations of every row of elements along the rail, x and y part apart, with the other
/// rows and the other part left out. What is left out is smooth, so that few products with the whole
/// matrix make up for it.
pub(super) struct Strips<T> {
    strips: Vec<Strip<T>>,
}

struct Strip<T> {
    first: usize,
    /// LU factors, x and y part.
    factors: [Factors<T>; 2],
}

struct Factors<T> {
    size: usize,
    values: Vec<T>,
    pivots: Vec<usize>,
}

impl<T: ComplexFloat<Real = f64>> Strips<T> {
    /// `row` gives, for an element and a part, the equation p → identity·p + difference·(u − u ahead):
    /// the factors (identity, difference) of its diagonal block.
    pub(super) fn new(
        patch: &Patch,
        influence: &Influence,
        [here, ahead]: [T; 2],
        of: impl Fn(f64) -> T,
        row: impl Fn(usize, usize) -> (f64, f64),
    ) -> Option<Self> {
        let mut strips: Vec<Strip<T>> = Vec::new();
        let mut begin = 0;
        while begin < patch.len() {
            let line = patch.places[begin].1;
            let end = patch.places[begin..]
                .iter()
                .position(|place| place.1 != line)
                .map_or(patch.len(), |length| begin + length);
            let size = end - begin;
            let factors = |part: usize| {
                let mut values = Vec::with_capacity(size * size);
                for i in 0..size {
                    let (identity, difference) = row(begin + i, part);
                    for j in 0..size {
                        let distance = i as isize - j as isize;
                        let moved = here * of(influence.along(part, distance))
                            + ahead * of(influence.along(part, distance + 1));
                        let unit = if i == j { identity } else { 0.0 };
                        values.push(of(unit) + of(difference) * moved);
                    }
                }
                Factors::new(size, values)
            };
            strips.push(Strip {
                factors: [factors(0)?, factors(1)?],
                first: begin,
            });
            begin = end;
        }
        Some(Self { strips })
    }

    /// The approximate solution for a right-hand side, x part first.
    pub(super) fn solve(&self, right: &[T]) -> Vec<T> {
        let count = right.len() / 2;
        let mut solution = right.to_vec();
        for strip in &self.strips {
            for part in 0..2 {
                let first = part * count + strip.first;
                let range = first..first + strip.factors[part].size;
                strip.factors[part].solve(&mut solution[range]);
            }
        }
        solution
    }
}

impl<T: ComplexFloat<Real = f64>> Factors<T> {
    /// Gaussian elimination with row pivots; none if the matrix is singular.
    fn new(size: usize, mut values: Vec<T>) -> Option<Self> {
        let mut pivots = Vec::with_capacity(size);
        for column in 0..size {
            let pivot = (column..size).max_by(|&a, &b| {
                let size_of = |row: usize| values[row * size + column].abs();
                size_of(a).total_cmp(&size_of(b))
            })?;
            pivots.push(pivot);
            if values[pivot * size + column] == T::zero() {
                return None;
            }
            if pivot != column {
                for other in 0..size {
                    values.swap(pivot * size + other, column * size + other);
                }
            }
            let inverse = values[column * size + column].recip();
            for row in column + 1..size {
                let factor = values[row * size + column] * inverse;
                values[row * size + column] = factor;
                let (above, below) = values.split_at_mut(row * size);
                let upper = &above[column * size + column + 1..(column + 1) * size];
                let lower = &mut below[column + 1..size];
                for (value, upper) in lower.iter_mut().zip(upper) {
                    *value = *value - factor * *upper;
                }
            }
        }
        Some(Self {
            size,
            values,
            pivots,
        })
    }

    fn solve(&self, solution: &mut [T]) {
        let size = self.size;
        for (row, &pivot) in self.pivots.iter().enumerate() {
            solution.swap(row, pivot);
        }
        let product = |line: &[T], known: &[T]| {
            line.iter()
                .zip(known)
                .fold(T::zero(), |sum, (&a, &b)| sum + a * b)
        };
        for row in 0..size {
            let line = &self.values[row * size..row * size + row];
            solution[row] = solution[row] - product(line, &solution[..row]);
        }
        for row in (0..size).rev() {
            let line = &self.values[row * size + row + 1..(row + 1) * size];
            let rest = solution[row] - product(line, &solution[row + 1..]);
            solution[row] = rest / self.values[row * size + row];
        }
    }
}
