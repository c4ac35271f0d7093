//! Square linear equations of complex numbers, for systems of a few dozen unknowns.
//!
//! Own, because a crate for dense matrices takes longer to build than all of this one, and none solves small systems side
//! by side in the lanes of vector registers.

use num_complex::Complex64;
use pulp::{Simd, WithSimd};

use super::determinant::Determinant;
use crate::vector::{Parts, Vector, add_row, lanes};

/// Columns cleared together: those of a contact.
const PANEL: usize = 3;

/// Equations A X = B, one system in each lane of a vector register.
#[derive(Clone)]
pub(super) struct Equations {
    size: usize,
    /// Entries of a row of A and of B together.
    width: usize,
    lanes: usize,
    /// Rows of A, each followed by that of B; of each entry the real parts of all lanes, then the imaginary ones.
    entries: Vec<f64>,
    /// One over the square of the largest entry of each row of A, of all lanes.
    weights: Vec<f64>,
    /// Of each lane, whether an odd number of rows was exchanged.
    odd: Vec<bool>,
}

impl Equations {
    /// Zeros.
    pub(super) fn new(size: usize, columns: usize, lanes: usize) -> Self {
        let width = size + columns;
        Self {
            size,
            width,
            lanes,
            entries: vec![0.0; 2 * size * width * lanes],
            weights: vec![0.0; size * lanes],
            odd: vec![false; lanes],
        }
    }

    pub(super) fn size(&self) -> usize {
        self.size
    }

    /// Entries of a row of A and of B together.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// All rows, to write to.
    #[inline(always)]
    pub(super) fn rows_mut<S: Simd>(&mut self) -> &mut [Parts<S>] {
        Vector::<S>::row_mut(&mut self.entries)
    }

    /// An unknown in a column of X, once solved.
    #[inline(always)]
    pub(super) fn unknown<S: Simd>(&self, index: usize, column: usize) -> Vector<S> {
        let rows = Vector::<S>::row(&self.entries);
        rows[index * self.width + self.size + column].into()
    }

    /// Unknown in one lane.
    pub(super) fn unknown_of_lane(&self, index: usize, column: usize, lane: usize) -> Complex64 {
        self.entry(index, self.size + column, lane)
    }

    /// Set an entry of A, or of B beside it, in one lane.
    pub(super) fn set(&mut self, row: usize, column: usize, lane: usize, value: Complex64) {
        let parts = &mut self.entries[2 * (row * self.width + column) * self.lanes..];
        (parts[lane], parts[self.lanes + lane]) = (value.re, value.im);
    }

    /// An entry of A or B in one lane.
    fn entry(&self, row: usize, column: usize, lane: usize) -> Complex64 {
        let parts = &self.entries[2 * (row * self.width + column) * self.lanes..];
        Complex64::new(parts[lane], parts[self.lanes + lane])
    }

    /// Solve by elimination with row pivots, in place: A is used up, and X stands where B was. X is no number in a lane whose
    /// A is singular.
    ///
    /// Each lane chooses its own pivots, by the size of an entry within its row: forces and displacements differ by ten
    /// orders. Backward stable as elimination with partial pivots is, in each lane.
    /// Cost: 8n³/3 operations on vectors of real numbers, and 8n² for each right-hand side.
    #[inline(always)]
    pub(super) fn solve<S: Simd>(&mut self, simd: S) {
        self.odd.fill(false);
        self.weigh(simd);
        let mut column = 0;
        while column + PANEL <= self.size {
            self.eliminate::<S, PANEL>(simd, column);
            column += PANEL;
        }
        for column in column..self.size {
            self.eliminate::<S, 1>(simd, column);
        }
        self.substitute(simd);
    }

    #[inline(always)]
    fn weigh<S: Simd>(&mut self, simd: S) {
        let rows = Vector::<S>::row(&self.entries).chunks_exact(self.width);
        let (weights, _) = S::as_mut_simd_f64s(&mut self.weights);
        for (row, weight) in rows.zip(weights) {
            let most = row[..self.size]
                .iter()
                .map(|&entry| Vector::<S>::from(entry).norm_sqr(simd))
                .fold(simd.splat_f64s(0.0), |most, size| simd.max_f64s(most, size));
            *weight = simd.div_f64s(simd.splat_f64s(1.0), most);
        }
    }

    /// Of each lane, the row from the diagonal down whose entry weighs most in a column.
    #[inline(always)]
    fn pivots<S: Simd>(&self, simd: S, column: usize) -> S::f64s {
        let rows = Vector::<S>::row(&self.entries).chunks_exact(self.width);
        let (weights, _) = S::as_simd_f64s(&self.weights);
        let mut pivots = simd.splat_f64s(column as f64);
        let mut most = simd.splat_f64s(0.0);
        for (index, (row, &weight)) in rows.zip(weights).enumerate().skip(column) {
            let size = Vector::<S>::from(row[column]).norm_sqr(simd);
            let size = simd.mul_f64s(size, weight);
            let larger = simd.greater_than_f64s(size, most);
            most = simd.select_f64s(larger, size, most);
            pivots = simd.select_f64s(larger, simd.splat_f64s(index as f64), pivots);
        }
        pivots
    }

    /// Exchange two rows in one lane, from a column on.
    fn exchange(&mut self, from: usize, [upper, lower]: [usize; 2], lane: usize) {
        let row = 2 * self.width * self.lanes;
        let from = 2 * from * self.lanes + lane;
        let (above, below) = self.entries.split_at_mut(lower * row);
        let upper_row = above[upper * row..][from..row].iter_mut();
        let lower_row = below[from..row].iter_mut();
        for (one, other) in upper_row.zip(lower_row).step_by(self.lanes) {
            std::mem::swap(one, other);
        }
        let [one, other] = [upper, lower].map(|row| row * self.lanes + lane);
        self.weights.swap(one, other);
        self.odd[lane] ^= true;
    }

    /// Clear N columns below the diagonal: first among themselves, then with all that stands right of them at once, which
    /// is read and written once instead of N times.
    #[inline(always)]
    fn eliminate<S: Simd, const N: usize>(&mut self, simd: S, first: usize) {
        let (width, end) = (self.width, first + N);
        for column in first..end {
            let pivots = self.pivots(simd, column);
            for (lane, &pivot) in lanes::<S>(&pivots).iter().enumerate() {
                let pivot = pivot as usize;
                if pivot != column {
                    self.exchange(first, [column, pivot], lane);
                }
            }
            let rows = Vector::<S>::row_mut(&mut self.entries);
            let (above, below) = rows.split_at_mut((column + 1) * width);
            let pivots = &above[column * width..];
            let reciprocal = Vector::<S>::from(pivots[column]).reciprocal(simd);
            let reciprocal = reciprocal.negative(simd);
            for row in below.chunks_exact_mut(width) {
                let factor = Vector::from(row[column]).times(simd, reciprocal);
                row[column] = factor.parts();
                for other in column + 1..end {
                    let sum = factor.times_plus(simd, pivots[other].into(), row[other].into());
                    row[other] = sum.parts();
                }
            }
        }
        let rows = Vector::<S>::row_mut(&mut self.entries);
        let (above, below) = rows.split_at_mut(end * width);
        let (_, panel) = above.split_at_mut(first * width);
        for lower in 1..N {
            let (above, row) = panel.split_at_mut(lower * width);
            let (factors, entries) = row[first..width].split_at_mut(N);
            for (factor, pivots) in factors.iter().zip(above.chunks_exact(width)) {
                add_row(simd, entries, [(*factor).into()], [&pivots[end..]]);
            }
        }
        let pivots: [_; N] = std::array::from_fn(|row| &panel[row * width..][end..width]);
        for row in below.chunks_exact_mut(width) {
            let (factors, entries) = row[first..].split_at_mut(N);
            let factors = std::array::from_fn(|index| factors[index].into());
            add_row(simd, entries, factors, pivots);
        }
    }

    /// Solve the triangle that elimination leaves, the last unknown first, each taken from all rows above it at once.
    #[inline(always)]
    fn substitute<S: Simd>(&mut self, simd: S) {
        let (size, width) = (self.size, self.width);
        let rows = Vector::<S>::row_mut(&mut self.entries);
        for index in (0..size).rev() {
            let (above, row) = rows.split_at_mut(index * width);
            let reciprocal = Vector::<S>::from(row[index]).reciprocal(simd);
            for (column, unknown) in row[size..width].iter_mut().enumerate() {
                *unknown = reciprocal.times(simd, (*unknown).into()).parts();
                let solved = Vector::<S>::from(*unknown).negative(simd);
                for row in above.chunks_exact_mut(width) {
                    let share = Vector::from(row[index]);
                    let sum = share.times_plus(simd, solved, row[size + column].into());
                    row[size + column] = sum.parts();
                }
            }
        }
    }

    /// The determinant of A in a lane, once solved.
    pub(super) fn determinant(&self, lane: usize) -> Determinant {
        let one = Determinant::one(self.odd[lane]);
        (0..self.size).fold(one, |product, index| product.times(self.entry(index, index, lane)))
    }
}

/// Equations to solve by themselves.
pub(super) struct Solve<'a>(pub(super) &'a mut Equations);

impl WithSimd for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        self.0.solve(simd);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::lanes_of;
    use proptest::prelude::*;
    use pulp::Arch;

    /// Lanes as wide as any register here, and not a multiple of a panel.
    const LANES: usize = 8;
    const SIZE: usize = 7;
    const COLUMNS: usize = 2;

    /// Rows of A and B together, one system.
    type Rows = [[Complex64; SIZE + COLUMNS]; SIZE];

    /// The equations solved in the widest registers of the machine and without any, each lane another system.
    fn solved(systems: &[Rows]) -> [Equations; 2] {
        [Arch::new(), Arch::Scalar].map(|arch| {
            let mut equations = Equations::new(SIZE, COLUMNS, lanes_of(arch));
            let lanes = equations.lanes;
            for (lane, system) in systems.iter().enumerate().take(lanes) {
                for (row, entries) in system.iter().enumerate() {
                    for (column, &entry) in entries.iter().enumerate() {
                        equations.set(row, column, lane, entry);
                    }
                }
            }
            arch.dispatch(Solve(&mut equations));
            equations
        })
    }

    proptest! {
        /// A X is B again in every lane to the rounding of what is summed, in rows of very different size and close to a
        /// singular matrix too.
        #[test]
        fn solves(
            numbers in proptest::collection::vec(-1.0..1.0f64, LANES * 2 * SIZE * (SIZE + COLUMNS)),
            rows in proptest::collection::vec(-10..10i32, SIZE),
            // How close, as a power of ten.
            close in proptest::collection::vec(0..15i32, LANES),
        ) {
            let mut numbers = numbers.chunks_exact(2).map(|pair| Complex64::new(pair[0], pair[1]));
            let systems: Vec<Rows> = close.iter().map(|&close| {
                let mut system: Rows = [[Complex64::ZERO; SIZE + COLUMNS]; SIZE];
                system.as_flattened_mut().fill_with(|| numbers.next().unwrap_or_default());
                // The last row is the sum of two others, but for a part.
                let [one, .., other, last] = &mut system;
                for ((last, one), other) in last[..SIZE].iter_mut().zip(one).zip(other) {
                    *last = *one + *other + *last * 10.0_f64.powi(-close);
                }
                for (row, &scale) in system.iter_mut().zip(&rows) {
                    row.iter_mut().for_each(|entry| *entry *= 10.0_f64.powi(scale));
                }
                system
            }).collect();
            for equations in solved(&systems) {
                for (lane, system) in systems[..equations.lanes].iter().enumerate() {
                    for column in 0..COLUMNS {
                        let unknown = |index| equations.unknown_of_lane(index, column, lane);
                        let largest = (0..SIZE).map(|index| unknown(index).norm()).fold(0.0, f64::max);
                        for row in system {
                            let product: Complex64 = (0..SIZE).map(|index| row[index] * unknown(index)).sum();
                            let entry = row[..SIZE].iter().map(|entry| entry.norm()).fold(0.0, f64::max);
                            let error = (product - row[SIZE + column]).norm() / (entry * largest);
                            // Some dozen roundings, and pivots that grow a few times.
                            prop_assert!(error < 1e-14, "{error}");
                        }
                    }
                }
            }
        }
    }

    /// A matrix with one entry in each row and column, the rows turned further from lane to lane: each lane takes rows in an
    /// order of its own, whatever their scale, and has the determinant of its sign.
    #[test]
    fn lanes_take_rows_in_their_own_order() {
        let scale = |row: usize| 10.0_f64.powi(3 * row as i32 - 9);
        let systems: Vec<Rows> = (0..LANES)
            .map(|lane| {
                std::array::from_fn(|row| {
                    let mut entries = [Complex64::ZERO; SIZE + COLUMNS];
                    entries[(row + lane) % SIZE] = scale(row).into();
                    entries[SIZE] = (scale(row) * row as f64).into();
                    entries
                })
            })
            .collect();
        for equations in solved(&systems) {
            for lane in 0..equations.lanes {
                for row in 0..SIZE {
                    let unknown = equations.unknown_of_lane((row + lane) % SIZE, 0, lane);
                    assert!((unknown - row as f64).norm() < 1e-14);
                }
                // A turn of seven rows is an even permutation; the scales multiply to one.
                let determinant = equations.determinant(lane).over(Determinant::one(false));
                assert!((determinant - 1.0).norm() < 1e-12, "{determinant}");
            }
        }
        let mut exchanged = systems[0];
        exchanged.swap(0, 1);
        let [equations, _] = solved(&[exchanged; LANES]);
        assert!((equations.determinant(0).over(Determinant::one(false)) + 1.0).norm() < 1e-12);
    }

    /// A singular matrix gives no numbers, in its lane alone.
    #[test]
    fn a_singular_lane_has_no_numbers() {
        let identity: Rows = std::array::from_fn(|row| {
            let mut entries = [Complex64::ONE; SIZE + COLUMNS];
            entries[..SIZE].fill(Complex64::ZERO);
            entries[row] = Complex64::ONE;
            entries
        });
        let mut systems = [identity; LANES];
        systems[0][4][4] = Complex64::ZERO;
        for equations in solved(&systems) {
            for lane in 0..equations.lanes {
                for index in 0..SIZE {
                    let unknown = equations.unknown_of_lane(index, 1, lane);
                    if lane == 0 {
                        assert!(unknown.is_nan());
                    } else {
                        assert_eq!(unknown, Complex64::ONE);
                    }
                }
            }
        }
    }

    /// A hundred equations in nanometres have a determinant far below the smallest double, and a solution.
    #[test]
    fn small_rows_are_not_singular() {
        const SIZE: usize = 100;
        let arch = Arch::new();
        let diagonal = |scale: f64| {
            let mut equations = Equations::new(SIZE, 1, lanes_of(arch));
            for row in 0..SIZE {
                equations.set(row, row, 0, scale.into());
                equations.set(row, SIZE, 0, 2e-9.into());
            }
            arch.dispatch(Solve(&mut equations));
            equations
        };
        let equations = diagonal(1e-9);
        assert!((0..SIZE).all(|index| (equations.unknown_of_lane(index, 0, 0) - 2.0).norm() < 1e-12));
        let twice = diagonal(2e-9).determinant(0);
        let ratio = twice.over(equations.determinant(0)).re / 2.0_f64.powi(SIZE as i32);
        assert!((ratio - 1.0).abs() < 1e-12, "{ratio}");
    }
}
