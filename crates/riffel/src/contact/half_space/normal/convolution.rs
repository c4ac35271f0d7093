//! Sums over all pairs of elements of a grid by Fourier transforms.

use num_complex::Complex64;

use crate::contact::half_space::transform::Transform;

/// The product with a matrix whose entries depend on the distance of two elements only, and not on
/// its sign; exact to rounding.
pub(super) struct Convolution {
    columns: usize,
    transform: Transform,
    spectrum: Vec<f64>,
}

impl Convolution {
    /// The kernel is a function of the distance in elements, along and across.
    pub(super) fn new(columns: usize, rows: usize, kernel: impl Fn(f64, f64) -> f64) -> Self {
        let transform = Transform::new(columns, rows);
        let kernel = |column: usize, row: usize| kernel(column as f64, row as f64);
        Self { columns, spectrum: transform.kernel(false, kernel), transform }
    }

    /// The sum over all elements of kernel times value, at every element.
    pub(super) fn apply(&self, values: impl Iterator<Item = Complex64>) -> Vec<Complex64> {
        let [width, _] = self.transform.size();
        let mut workspace = self.transform.workspace();
        let mut values = values;
        for row in workspace.field.chunks_exact_mut(width) {
            for (point, value) in row.iter_mut().zip(values.by_ref().take(self.columns)) {
                *point = value;
            }
        }
        let mut spectrum = vec![Complex64::ZERO; self.spectrum.len()];
        self.transform.forward(&mut workspace, &mut spectrum);
        for (value, factor) in spectrum.iter_mut().zip(&self.spectrum) {
            *value *= factor;
        }
        self.transform.backward(&mut spectrum, &mut workspace);
        let rows = workspace.field.chunks_exact(width);
        rows.flat_map(|row| &row[..self.columns]).copied().collect()
    }
}
