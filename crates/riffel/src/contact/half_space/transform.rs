//! Fourier transform of a field on the elements of a patch, padded with zeros to a larger grid.

use std::sync::Arc;

use num_complex::Complex64;
use rustfft::{Fft, FftPlanner};

/// Transforms between the first `rows` rows of a grid and the spectrum of all of it, size × size.
pub(super) struct Transform {
    rows: usize,
    size: usize,
    forward: Arc<dyn Fft<f64>>,
    backward: Arc<dyn Fft<f64>>,
}

/// Memory that a transform works in, kept from one to the next.
pub(super) struct Workspace {
    /// Rows × size: the field, row by row.
    pub(super) field: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl Transform {
    /// For fields of `rows` rows and distances of up to as many elements, either way.
    pub(super) fn new(rows: usize) -> Self {
        let is_smooth = |size: usize| {
            let without = |mut rest: usize, factor: usize| {
                while rest.is_multiple_of(factor) {
                    rest /= factor;
                }
                rest
            };
            [2, 3, 5, 7].into_iter().fold(size, without) == 1
        };
        // Even sizes are the quicker ones.
        let size = (rows + 1..)
            .map(|half| 2 * half)
            .find(|&size| is_smooth(size))
            .unwrap_or(2 * rows + 2);
        let mut planner = FftPlanner::new();
        Self {
            rows,
            size,
            forward: planner.plan_fft_forward(size),
            backward: planner.plan_fft_inverse(size),
        }
    }

    /// Points in each direction.
    pub(super) fn size(&self) -> usize {
        self.size
    }

    pub(super) fn workspace(&self) -> Workspace {
        let scratch = self.forward.get_inplace_scratch_len();
        Workspace {
            field: vec![Complex64::ZERO; self.rows * self.size],
            scratch: vec![Complex64::ZERO; scratch.max(self.backward.get_inplace_scratch_len())],
        }
    }

    /// The spectrum of a whole grid in its place; rows and columns alike.
    pub(super) fn full(&self, grid: &mut [Complex64], workspace: &mut Workspace) {
        let size = self.size;
        for _ in 0..2 {
            self.forward
                .process_with_scratch(grid, &mut workspace.scratch);
            for column in 1..size {
                for row in 0..column {
                    grid.swap(column * size + row, row * size + column);
                }
            }
        }
    }

    /// The spectrum of the field in the workspace, which is lost; columns first.
    pub(super) fn forward(&self, workspace: &mut Workspace, spectrum: &mut [Complex64]) {
        let Workspace { field, scratch, .. } = workspace;
        self.forward.process_with_scratch(field, scratch);
        for (column, values) in spectrum.chunks_exact_mut(self.size).enumerate() {
            let (inside, beyond) = values.split_at_mut(self.rows);
            for (value, row) in inside.iter_mut().zip(field.chunks_exact(self.size)) {
                *value = row[column];
            }
            beyond.fill(Complex64::ZERO);
        }
        self.forward.process_with_scratch(spectrum, scratch);
    }

    /// The field of a spectrum, which is lost, times the number of points; of its rows only the first.
    pub(super) fn backward(&self, spectrum: &mut [Complex64], workspace: &mut Workspace) {
        let Workspace { field, scratch, .. } = workspace;
        self.backward.process_with_scratch(spectrum, scratch);
        for (column, values) in spectrum.chunks_exact(self.size).enumerate() {
            for (&value, row) in values.iter().zip(field.chunks_exact_mut(self.size)) {
                row[column] = value;
            }
        }
        self.backward.process_with_scratch(field, scratch);
    }
}
