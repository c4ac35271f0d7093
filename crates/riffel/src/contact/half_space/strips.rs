//! Each row of elements by itself: an approximate inverse of the whole contact.

use std::ops::Range;

use super::gmres::Scalar;
use super::influence::Influence;
use super::patch::Patch;

/// The equations of every row of elements along the rail, x and y part apart, with the other rows and
/// the other part left out. What is left out is smooth, so that few products with the whole matrix make
/// up for it.
///
/// Method: elements are alike, so the displacement of one by another depends on their distance alone,
/// and so do its triangular factors without pivots: those of the longest row contain those of every
/// shorter one. Cost: O(n³) once for n elements across and O(n²) for each row and solution.
pub(super) struct Strips<'a, T> {
    patch: &'a Patch,
    /// x and y part.
    factors: [Factors<T>; 2],
}

/// The equation p·identity + difference·(displacement) of an element and part, of which an approximate
/// inverse keeps the larger term.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Diagonal {
    pub(super) identity: f64,
    pub(super) difference: f64,
}

impl<'a, T: Scalar> Strips<'a, T> {
    /// For displacements here·u(x) + ahead·u(x + dx).
    pub(super) fn new(patch: &'a Patch, influence: &Influence, [here, ahead]: [T; 2]) -> Self {
        let factors = |part: usize| {
            let entry = |distance: isize| {
                let influence = |distance| T::of(influence.along(part, distance));
                here * influence(distance) + ahead * influence(distance + 1)
            };
            Factors::new(patch.across, entry)
        };
        Self {
            patch,
            factors: [factors(0), factors(1)],
        }
    }

    /// The approximate solution for a right-hand side, x part first, in its place.
    pub(super) fn solve(&self, diagonal: impl Fn(usize, usize) -> Diagonal, values: &mut [T]) {
        for (part, values) in values.chunks_exact_mut(self.patch.len()).enumerate() {
            let factors = &self.factors[part];
            let of_displacement = |index: usize| {
                let Diagonal {
                    identity,
                    difference,
                } = diagonal(index, part);
                difference * factors.own > identity
            };
            for row in self.patch.rows() {
                for index in row.clone() {
                    let Diagonal {
                        identity,
                        difference,
                    } = diagonal(index, part);
                    let size = if of_displacement(index) {
                        difference
                    } else {
                        identity + difference * factors.own
                    };
                    values[index] = values[index] / T::of(size);
                }
                let mut next = row.start;
                while next < row.end {
                    let begin = next;
                    while next < row.end && of_displacement(next) {
                        next += 1;
                    }
                    for cause in row.clone().filter(|&cause| !of_displacement(cause)) {
                        factors.subtract(values[cause], begin..next, cause, values);
                    }
                    factors.solve(&mut values[begin..next]);
                    next += 1;
                }
            }
        }
    }
}

/// L and U of the displacements along a row, by columns.
struct Factors<T> {
    size: usize,
    own: f64,
    /// Displacement by the distance from its cause, from 1 − n on.
    entries: Vec<T>,
    values: Vec<T>,
}

impl<T: Scalar> Factors<T> {
    fn new(size: usize, entry: impl Fn(isize) -> T) -> Self {
        let mut values = Vec::with_capacity(size * size);
        for column in 0..size as isize {
            values.extend((0..size as isize).map(|row| entry(row - column)));
        }
        for column in 0..size {
            let (done, rest) = values.split_at_mut((column + 1) * size);
            let lower = &mut done[column * size + column..];
            let (pivot, lower) = (lower[0], &mut lower[1..]);
            for value in lower.iter_mut() {
                *value = *value / pivot;
            }
            for other in rest.chunks_exact_mut(size) {
                let upper = other[column];
                for (value, &lower) in other[column + 1..].iter_mut().zip(lower.iter()) {
                    *value = *value - upper * lower;
                }
            }
        }
        let end = size as isize;
        Self {
            size,
            own: entry(0).abs(),
            entries: (1 - end..end).map(entry).collect(),
            values,
        }
    }

    /// Subtract the displacements of a run of elements by the traction of another of its row.
    fn subtract(&self, traction: T, run: Range<usize>, cause: usize, values: &mut [T]) {
        let entries = &self.entries[run.start + self.size - 1 - cause..];
        for (value, &entry) in values[run].iter_mut().zip(entries) {
            *value = *value - traction * entry;
        }
    }

    /// Solve for a run of elements, in the place of their displacements.
    fn solve(&self, values: &mut [T]) {
        for column in 0..values.len() {
            let (known, rest) = values.split_at_mut(column + 1);
            let lower = &self.values[column * self.size + column + 1..];
            for (value, &lower) in rest.iter_mut().zip(lower) {
                *value = *value - known[column] * lower;
            }
        }
        for column in (0..values.len()).rev() {
            let upper = &self.values[column * self.size..];
            let (rest, last) = values.split_at_mut(column);
            last[0] = last[0] / upper[column];
            for (value, &upper) in rest.iter_mut().zip(upper) {
                *value = *value - last[0] * upper;
            }
        }
    }
}
