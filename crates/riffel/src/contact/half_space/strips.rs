//! Each row of elements by itself: an approximate inverse of the whole contact.

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use super::influence::Influence;
use super::patch::Patch;
use super::scalar::{Scalar, add_multiple};

/// The displacements along every row of elements, x and y part apart, by the tractions of that row and
/// part alone. What is left out is smooth, so that few products with the whole matrix make up for it.
///
/// Method: elements are alike, so the displacement of one by another depends on their distance alone,
/// and the triangular factors of the longest row, without pivots, contain those of every shorter one.
/// All rows are solved at once. Cost: O(n³) for n elements across, once and for each solution.
pub(super) struct Strips<'a, T> {
    patch: &'a Patch,
    /// x and y part.
    factors: [Factors<T>; 2],
}

/// The equation p·identity + (displacement)·difference of an element and part, of which an approximate
/// inverse keeps the larger term.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Diagonal {
    pub(super) identity: f64,
    pub(super) difference: f64,
}

/// [`Strips`] with the equations of all elements.
pub(super) struct StripInverse<'a, T> {
    strips: &'a Strips<'a, T>,
    /// x and y part.
    equations: [Equations; 2],
}

struct Equations {
    /// Factor on the right-hand side of each element.
    scale: Vec<f64>,
    runs: Vec<Run>,
}

/// Elements of a row, one behind the other, whose displacement counts.
struct Run {
    elements: Range<usize>,
    /// The row they are in.
    row: Range<usize>,
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
        Self { patch, factors: [factors(0), factors(1)] }
    }

    /// `diagonal` gives the equation of an element and part.
    pub(super) fn inverse(&'a self, diagonal: impl Fn(usize, usize) -> Diagonal) -> StripInverse<'a, T> {
        let equations = [0, 1].map(|part| {
            let own = self.factors[part].own;
            let diagonal: Vec<Diagonal> = (0..self.patch.len()).map(|index| diagonal(index, part)).collect();
            let counts = |diagonal: &Diagonal| diagonal.difference * own > diagonal.identity;
            let mut runs = Vec::new();
            for row in self.patch.rows() {
                let mut begin = row.start;
                for run in diagonal[row.clone()].chunk_by(|a, b| counts(a) == counts(b)) {
                    let elements = begin..begin + run.len();
                    begin = elements.end;
                    if counts(&run[0]) {
                        let row = row.clone();
                        runs.push(Run { elements, row });
                    }
                }
            }
            Equations {
                scale: diagonal
                    .iter()
                    .map(|diagonal| {
                        let Diagonal { identity, difference } = *diagonal;
                        if counts(diagonal) { difference.recip() } else { (identity + difference * own).recip() }
                    })
                    .collect(),
                runs,
            }
        });
        StripInverse { strips: self, equations }
    }
}

impl<T: Scalar> StripInverse<'_, T> {
    /// The approximate solution for a right-hand side, x part first, in its place.
    pub(super) fn solve(&self, values: &mut [T]) {
        let count = self.strips.patch.len();
        let parts = self.strips.factors.iter().zip(&self.equations);
        for ((factors, equations), values) in parts.zip(values.chunks_exact_mut(count)) {
            for (value, &scale) in values.iter_mut().zip(&equations.scale) {
                *value = *value * T::of(scale);
            }
            // Place in the run first, then run.
            let lines = equations.runs.len();
            let longest = equations.runs.iter().map(|run| run.elements.len()).max();
            let mut block = vec![T::zero(); longest.unwrap_or(0) * lines];
            for (line, run) in equations.runs.iter().enumerate() {
                let places = block.iter_mut().skip(line).step_by(lines);
                for (place, index) in places.zip(run.elements.clone()) {
                    *place = values[index] - factors.caused(values, run, index);
                }
            }
            let arch = Arch::new();
            arch.dispatch(Lower { factors, block: &mut block, lines });
            for (line, run) in equations.runs.iter().enumerate() {
                let beyond = block.iter_mut().skip(line).step_by(lines);
                for value in beyond.skip(run.elements.len()) {
                    *value = T::zero();
                }
            }
            arch.dispatch(Upper { factors, block: &mut block, lines });
            for (line, run) in equations.runs.iter().enumerate() {
                let solution = block.iter().skip(line).step_by(lines);
                for (&solution, value) in solution.zip(&mut values[run.elements.clone()]) {
                    *value = solution;
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
        let end = size as isize;
        let mut values = Vec::with_capacity(size * size);
        for column in 0..end {
            values.extend((0..end).map(|row| entry(row - column)));
        }
        for column in 0..size {
            let (done, rest) = values.split_at_mut((column + 1) * size);
            let lower = &mut done[column * size + column..];
            let (pivot, lower) = (lower[0], &mut lower[1..]);
            for value in lower.iter_mut() {
                *value = *value / pivot;
            }
            for other in rest.chunks_exact_mut(size) {
                let (above, below) = other.split_at_mut(column + 1);
                add_multiple(below, -above[column], lower);
            }
        }
        Self { size, own: entry(0).abs(), entries: (1 - end..end).map(entry).collect(), values }
    }

    /// Displacement of an element of a run by the others of its row, whose tractions are known.
    fn caused(&self, tractions: &[T], run: &Run, index: usize) -> T {
        let entry = |cause: usize| self.entries[index + self.size - 1 - cause];
        (run.row.start..run.elements.start)
            .chain(run.elements.end..run.row.end)
            .fold(T::zero(), |sum, cause| sum + entry(cause) * tractions[cause])
    }
}

/// Solve with L for all lines of a block.
struct Lower<'a, T> {
    factors: &'a Factors<T>,
    block: &'a mut [T],
    lines: usize,
}

impl<T: Scalar> WithSimd for Lower<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let (lines, size) = (self.lines, self.factors.size);
        for column in 0..self.block.len().checked_div(lines).unwrap_or(0) {
            let (known, rest) = self.block.split_at_mut((column + 1) * lines);
            let known = &known[column * lines..];
            let factors = &self.factors.values[column * size + column + 1..];
            for (values, &factor) in rest.chunks_exact_mut(lines).zip(factors) {
                T::add_multiple(simd, values, -factor, known);
            }
        }
    }
}

/// Solve with U for all lines of a block.
struct Upper<'a, T> {
    factors: &'a Factors<T>,
    block: &'a mut [T],
    lines: usize,
}

impl<T: Scalar> WithSimd for Upper<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let lines = self.lines;
        for column in (0..self.block.len().checked_div(lines).unwrap_or(0)).rev() {
            let factors = &self.factors.values[column * self.factors.size..];
            let (rest, known) = self.block.split_at_mut(column * lines);
            let known = &mut known[..lines];
            let pivot = factors[column].recip();
            for value in known.iter_mut() {
                *value = *value * pivot;
            }
            for (values, &factor) in rest.chunks_exact_mut(lines).zip(factors) {
                T::add_multiple(simd, values, -factor, known);
            }
        }
    }
}
