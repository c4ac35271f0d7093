//! Displacements that tractions cause on a half-space.

use std::sync::Arc;

use num_complex::Complex64;
use rustfft::{Fft, FftPlanner};

use super::patch::Patch;
use crate::ElasticMaterial;

/// Tangential tractions or displacements of the elements: x and y part.
pub(super) type Field = [Vec<Complex64>; 2];

/// The surface displacement of the wheel relative to the rail under tractions that are constant on
/// each element, by convolution.
///
/// Cerruti (1882): a tangential point force causes (1/πG)\[(1 − ν)/r + νx²/r³\] along itself and
/// (ν/πG) xy/r³ across, both bodies together and of one material. Its integrals over a rectangle are
/// closed: ∬x²/r³ = \[y ln(x + r)\], ∬y²/r³ = \[x ln(y + r)\], ∬xy/r³ = −\[r\], differences over the four
/// corners. The sum over all elements is a convolution, done by Fourier transforms on twice the grid;
/// exact to rounding.
pub(super) struct Influence {
    across: usize,
    /// Points of the transform in each direction.
    size: usize,
    /// Spectra of the kernels xx, yy and xy, columns first.
    kernels: [Vec<Complex64>; 3],
    /// Influence of an element on itself along x, less that on its neighbour in front.
    pub(super) own: f64,
    /// xx and yy between elements of one row, by their distance in elements.
    along: [Vec<f64>; 2],
    forward: Arc<dyn Fft<f64>>,
    backward: Arc<dyn Fft<f64>>,
}

impl Influence {
    pub(super) fn new(material: ElasticMaterial, patch: &Patch) -> Self {
        let across = patch.across;
        // Distances from −n to +n: the neighbours before the first and behind the last are asked for.
        let size = (2 * across + 1..)
            .find(|&size| {
                [2, 3, 5].iter().fold(size, |rest, &factor| {
                    let mut rest = rest;
                    while rest % factor == 0 {
                        rest /= factor;
                    }
                    rest
                }) == 1
            })
            .unwrap_or(2 * across + 1);
        let mut planner = FftPlanner::new();
        let (forward, backward) = (
            planner.plan_fft_forward(size),
            planner.plan_fft_inverse(size),
        );
        let mut influence = Self {
            across,
            size,
            kernels: [0, 1, 2].map(|_| vec![Complex64::ZERO; size * size]),
            own: 0.0,
            along: [0, 1].map(|part| {
                (0..=across)
                    .map(|distance| {
                        let step = (patch.dx, patch.dy);
                        rectangle(material, distance as f64 * patch.dx, 0.0, step)[part]
                    })
                    .collect()
            }),
            forward,
            backward,
        };
        let distance = |index: usize| {
            if index <= across {
                index as f64
            } else {
                index as f64 - size as f64
            }
        };
        let scale = 1.0 / (size * size) as f64;
        for row in 0..size {
            for column in 0..size {
                let values = rectangle(
                    material,
                    distance(column) * patch.dx,
                    distance(row) * patch.dy,
                    (patch.dx, patch.dy),
                );
                for (kernel, value) in influence.kernels.iter_mut().zip(values) {
                    kernel[row * size + column] = Complex64::from(scale * value);
                }
            }
        }
        influence.own = (influence.kernels[0][0].re - influence.kernels[0][1].re) / scale;
        for kernel in 0..3 {
            let mut spectrum = std::mem::take(&mut influence.kernels[kernel]);
            influence.transform(&mut spectrum, size);
            influence.kernels[kernel] = spectrum;
        }
        influence
    }

    /// Influence of an element on one of its row, in direction x or y.
    pub(super) fn along(&self, part: usize, distance: isize) -> f64 {
        self.along[part][distance.unsigned_abs()]
    }

    /// Forward transform of the first `rows` rows, the others being zero; the result has columns first.
    fn transform(&self, data: &mut Vec<Complex64>, rows: usize) {
        let size = self.size;
        self.forward.process(&mut data[..rows * size]);
        let mut columns = vec![Complex64::ZERO; size * size];
        for row in 0..rows {
            for column in 0..size {
                columns[column * size + row] = data[row * size + column];
            }
        }
        self.forward.process(&mut columns);
        *data = columns;
    }

    /// Inverse transform from columns first; only the first half of the rows is made.
    fn transform_back(&self, data: &mut Vec<Complex64>) {
        let size = self.size;
        self.backward.process(data);
        let mut rows = vec![Complex64::ZERO; self.across * size];
        for row in 0..self.across {
            for column in 0..size {
                rows[row * size + column] = data[column * size + row];
            }
        }
        self.backward.process(&mut rows);
        *data = rows;
    }

    /// ∂u/∂y in the middle of every step, by central differences.
    pub(super) fn slope_across(&self, patch: &Patch, tractions: &Field) -> Field {
        let ahead = |angle_x: f64| 0.5 * (1.0 + Complex64::cis(angle_x));
        self.filtered(patch, tractions, |x, y| {
            ahead(x) * Complex64::new(0.0, y.sin() / patch.dy)
        })
    }

    /// u(x) − u(x + dx) at the end x of every step of the material, for tractions that are real: both parts
    /// go through one transform as real and imaginary part.
    pub(super) fn difference(&self, patch: &Patch, tractions: &[Vec<f64>; 2]) -> [Vec<f64>; 2] {
        let size = self.size;
        let mut data = vec![Complex64::ZERO; size * size];
        for (index, &(column, row)) in patch.places.iter().enumerate() {
            data[row * size + column] = Complex64::new(tractions[0][index], tractions[1][index]);
        }
        self.transform(&mut data, self.across);
        let [xx, yy, xy] = &self.kernels;
        let mut moved = vec![Complex64::ZERO; size * size];
        for column in 0..size {
            let angle = 2.0 * std::f64::consts::PI * column as f64 / size as f64;
            let factor = 1.0 - Complex64::cis(angle);
            let mirrored_column = (size - column) % size;
            for row in 0..size {
                let index = column * size + row;
                let value = data[index];
                let mirrored = data[mirrored_column * size + (size - row) % size].conj();
                let x = 0.5 * (value + mirrored);
                let y = Complex64::new(0.0, -0.5) * (value - mirrored);
                let moved_x = factor * (xx[index] * x + xy[index] * y);
                let moved_y = factor * (xy[index] * x + yy[index] * y);
                moved[index] = moved_x + Complex64::i() * moved_y;
            }
        }
        self.transform_back(&mut moved);
        let at = |step: &super::patch::Step| {
            let (column, row) = step.end;
            moved[row * size + column.rem_euclid(size as isize) as usize]
        };
        [
            patch.steps.iter().map(|step| at(step).re).collect(),
            patch.steps.iter().map(|step| at(step).im).collect(),
        ]
    }

    /// `here`·u(x) + `ahead`·u(x + dx) at the end x of every step of
    /// the material, for the displacement u under the tractions.
    pub(super) fn apply(
        &self,
        patch: &Patch,
        tractions: &Field,
        [here, ahead]: [Complex64; 2],
    ) -> Field {
        self.filtered(patch, tractions, |x, _| here + ahead * Complex64::cis(x))
    }

    /// The displacement with a filter on its spectrum, a function of the phase angles from one element
    /// to the next.
    fn filtered(
        &self,
        patch: &Patch,
        tractions: &Field,
        filter: impl Fn(f64, f64) -> Complex64,
    ) -> Field {
        let size = self.size;
        let spread = |part: &[Complex64]| {
            let mut data = vec![Complex64::ZERO; size * size];
            for (&(column, row), &value) in patch.places.iter().zip(part) {
                data[row * size + column] = value;
            }
            self.transform(&mut data, self.across);
            data
        };
        let [mut x, mut y] = [spread(&tractions[0]), spread(&tractions[1])];
        let [xx, yy, xy] = &self.kernels;
        let angle = |index: usize| 2.0 * std::f64::consts::PI * index as f64 / size as f64;
        for column in 0..size {
            for row in 0..size {
                let index = column * size + row;
                let factor = filter(angle(column), angle(row));
                let (px, py) = (x[index], y[index]);
                x[index] = factor * (xx[index] * px + xy[index] * py);
                y[index] = factor * (xy[index] * px + yy[index] * py);
            }
        }
        self.transform_back(&mut x);
        self.transform_back(&mut y);
        let gather = |data: &[Complex64]| -> Vec<Complex64> {
            patch
                .steps
                .iter()
                .map(|step| {
                    let (column, row) = step.end;
                    data[row * size + column.rem_euclid(size as isize) as usize]
                })
                .collect()
        };
        [gather(&x), gather(&y)]
    }
}

/// xx, yy and xy at the distance (x, y) from the centre of a rectangle under unit traction \[m/Pa\].
fn rectangle(material: ElasticMaterial, x: f64, y: f64, (dx, dy): (f64, f64)) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (side_x, sign_x) in [(0.5, 1.0), (-0.5, -1.0)] {
        for (side_y, sign_y) in [(0.5, 1.0), (-0.5, -1.0)] {
            let (x, y) = (x + side_x * dx, y + side_y * dy);
            let r = x.hypot(y);
            let sign = sign_x * sign_y;
            sums[0] += sign * y * logarithm(x, y, r);
            sums[1] += sign * x * logarithm(y, x, r);
            sums[2] -= sign * r;
        }
    }
    let poisson = material.poisson_ratio();
    let scale = 1.0 / (std::f64::consts::PI * material.shear_modulus());
    [
        scale * (sums[0] + (1.0 - poisson) * sums[1]),
        scale * ((1.0 - poisson) * sums[0] + sums[1]),
        scale * poisson * sums[2],
    ]
}

/// ln(s + r) for r² = s² + t², without cancellation for s < 0.
fn logarithm(s: f64, t: f64, r: f64) -> f64 {
    if s >= 0.0 {
        (s + r).ln()
    } else {
        2.0 * t.abs().ln() - (r - s).ln()
    }
}
