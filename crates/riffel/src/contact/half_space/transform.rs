//! Fourier transform of a field on a grid of elements, padded with zeros to a larger grid.

use std::sync::Arc;

use num_complex::Complex64;
use riffel_numerics::fourier::{Fft, Plans};

/// Transforms between the first rows of a grid and the spectrum of all of it, in which a product with the
/// spectrum of a kernel is the sum over all pairs of elements.
///
/// Rows of zeros are not transformed.
pub(super) struct Transform {
    rows: usize,
    /// Points along and across.
    size: [usize; 2],
    forward: [Arc<dyn Fft<f64>>; 2],
    backward: [Arc<dyn Fft<f64>>; 2],
}

/// Memory that a transform works in, kept from one to the next.
pub(super) struct Workspace {
    /// Rows of the field, one after the other.
    pub(super) field: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl Transform {
    /// For fields of `columns` × `rows` elements and distances of up to as many, either way.
    pub(super) fn new(columns: usize, rows: usize) -> Self {
        let size = [columns, rows].map(padded);
        let mut plans = Plans::default();
        Self {
            rows,
            size,
            forward: size.map(|size| plans.forward(size)),
            backward: size.map(|size| plans.inverse(size)),
        }
    }

    /// Points along and across.
    pub(super) fn size(&self) -> [usize; 2] {
        self.size
    }

    pub(super) fn workspace(&self) -> Workspace {
        let transforms = self.forward.iter().chain(&self.backward);
        let scratch = transforms.map(|fft| fft.get_inplace_scratch_len()).max();
        Workspace {
            field: vec![Complex64::ZERO; self.rows * self.size[0]],
            scratch: vec![Complex64::ZERO; scratch.unwrap_or(0)],
        }
    }

    /// The spectrum of a kernel, divided by the number of points, columns first. The kernel is given by the
    /// distance in elements, up to the number of them, and is even in both directions, or odd in both:
    /// its spectrum is real.
    pub(super) fn kernel(&self, is_odd: bool, kernel: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        let [width, height] = self.size;
        let mirrored = if is_odd { -1.0 } else { 1.0 };
        let scale = ((width * height) as f64).recip();
        let mut values = vec![Complex64::ZERO; width * height];
        for column in 0..width / 2 {
            for row in 0..height / 2 {
                let value = scale * kernel(column, row);
                let (left, up) = ((width - column) % width, (height - row) % height);
                values[row * width + column] = value.into();
                values[row * width + left] = (mirrored * value).into();
                values[up * width + column] = (mirrored * value).into();
                values[up * width + left] = value.into();
            }
        }
        let mut workspace = self.workspace();
        workspace.field = values;
        let mut spectrum = vec![Complex64::ZERO; width * height];
        self.forward(&mut workspace, &mut spectrum);
        spectrum.iter().map(|value| value.re).collect()
    }

    /// The spectrum of the field in the workspace, which is lost; columns first.
    pub(super) fn forward(&self, workspace: &mut Workspace, spectrum: &mut [Complex64]) {
        let Workspace { field, scratch } = workspace;
        let [width, height] = self.size;
        self.forward[0].process_with_scratch(field, scratch);
        for (column, values) in spectrum.chunks_exact_mut(height).enumerate() {
            let (inside, beyond) = values.split_at_mut(field.len() / width);
            for (value, row) in inside.iter_mut().zip(field.chunks_exact(width)) {
                *value = row[column];
            }
            beyond.fill(Complex64::ZERO);
        }
        self.forward[1].process_with_scratch(spectrum, scratch);
    }

    /// The field of a spectrum, which is lost, times the number of points; of its rows only the first.
    pub(super) fn backward(&self, spectrum: &mut [Complex64], workspace: &mut Workspace) {
        let Workspace { field, scratch } = workspace;
        let [width, height] = self.size;
        self.backward[1].process_with_scratch(spectrum, scratch);
        for (column, values) in spectrum.chunks_exact(height).enumerate() {
            for (&value, row) in values.iter().zip(field.chunks_exact_mut(width)) {
                row[column] = value;
            }
        }
        self.backward[0].process_with_scratch(field, scratch);
    }
}

/// An even number above twice another with no prime factor above seven: a fast transform.
fn padded(count: usize) -> usize {
    let is_smooth = |size: &usize| {
        let without = |mut rest: usize, factor: usize| {
            while rest.is_multiple_of(factor) {
                rest /= factor;
            }
            rest
        };
        [2, 3, 5, 7].into_iter().fold(*size, without) == 1
    };
    let mut sizes = (count + 1..).map(|half| 2 * half);
    sizes.find(is_smooth).unwrap_or(2 * count + 2)
}
