//! Sums over all pairs of elements of a grid by Fourier transforms.

use std::sync::Arc;

use num_complex::Complex64;
use rustfft::{Fft, FftPlanner};

/// The product with a matrix whose entries depend on the distance of two elements only, and not on
/// its sign.
///
/// Method: a circular convolution on a grid of at least twice the size, filled up with zeros; exact to
/// rounding. Rows of zeros are not transformed. The spectrum of an even kernel is real.
pub(super) struct Convolution {
    columns: usize,
    rows: usize,
    /// Points of the transforms along and across.
    size: [usize; 2],
    /// Spectrum of the kernel over the number of points, columns first.
    spectrum: Vec<f64>,
    forward: [Arc<dyn Fft<f64>>; 2],
    backward: [Arc<dyn Fft<f64>>; 2],
}

impl Convolution {
    /// The kernel is a function of the distance in elements, along and across.
    pub(super) fn new(columns: usize, rows: usize, kernel: impl Fn(f64, f64) -> f64) -> Self {
        let size = [columns, rows].map(|count| smooth(2 * count - 1));
        let mut planner = FftPlanner::new();
        let mut convolution = Self {
            columns,
            rows,
            size,
            spectrum: Vec::new(),
            forward: size.map(|size| planner.plan_fft_forward(size)),
            backward: size.map(|size| planner.plan_fft_inverse(size)),
        };
        let distance = |index: usize, size: usize| index.min(size - index) as f64;
        let mut data = Vec::with_capacity(size[0] * size[1]);
        for row in 0..size[1] {
            for column in 0..size[0] {
                let value = kernel(distance(column, size[0]), distance(row, size[1]));
                data.push(Complex64::from(value));
            }
        }
        let scale = ((size[0] * size[1]) as f64).recip();
        let spectrum = convolution.transform(data);
        convolution.spectrum = spectrum.iter().map(|value| scale * value.re).collect();
        convolution
    }

    /// The sum over all elements of kernel times value, at every element.
    pub(super) fn apply(&self, values: &[f64]) -> Vec<f64> {
        let [width, height] = self.size;
        let mut data = vec![Complex64::ZERO; self.rows * width];
        for (row, values) in data
            .chunks_exact_mut(width)
            .zip(values.chunks_exact(self.columns))
        {
            for (point, &value) in row.iter_mut().zip(values) {
                *point = Complex64::from(value);
            }
        }
        let mut spectrum = self.transform(data);
        for (value, factor) in spectrum.iter_mut().zip(&self.spectrum) {
            *value *= factor;
        }
        self.backward[1].process(&mut spectrum);
        let mut data = vec![Complex64::ZERO; self.rows * width];
        for (column, points) in spectrum.chunks_exact(height).enumerate() {
            for (row, point) in points[..self.rows].iter().enumerate() {
                data[row * width + column] = *point;
            }
        }
        self.backward[0].process(&mut data);
        data.chunks_exact(width)
            .flat_map(|row| row[..self.columns].iter().map(|point| point.re))
            .collect()
    }

    /// Forward transform of full rows, of which those that are missing are zero; columns first.
    fn transform(&self, mut data: Vec<Complex64>) -> Vec<Complex64> {
        let [width, height] = self.size;
        self.forward[0].process(&mut data);
        let mut columns = vec![Complex64::ZERO; width * height];
        for (row, points) in data.chunks_exact(width).enumerate() {
            for (column, point) in points.iter().enumerate() {
                columns[column * height + row] = *point;
            }
        }
        self.forward[1].process(&mut columns);
        columns
    }
}

/// The least number not below another that has no prime factor above five, for fast transforms.
fn smooth(least: usize) -> usize {
    (least..)
        .find(|&size| {
            let mut rest = size;
            for factor in [2, 3, 5] {
                while rest.is_multiple_of(factor) {
                    rest /= factor;
                }
            }
            rest == 1
        })
        .unwrap_or(least)
}
