//! Gaussian errors, some of whose sizes are unknown.

use std::f64::consts::PI;

use riffel_numerics::normal_distribution::below;

use riffel_numerics::matrix::{Matrix, dot};

/// ln of the density of data, and its derivatives.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Density {
    pub(crate) value: f64,
    /// By what the model predicts of each datum.
    pub(crate) by_prediction: Vec<f64>,
    /// By the size of each discrepancy.
    pub(crate) by_size: Vec<f64>,
}

/// Errors with the covariance noise + Σ σ_k² M_k.
#[derive(Debug, Clone)]
pub(crate) struct Gaussian {
    noise: Matrix,
    /// M_k.
    parts: Vec<Matrix>,
    /// Noise and the one part there is, both made diagonal.
    diagonal: Option<Diagonal>,
}

/// With noise = LLᵀ and L⁻¹ML⁻ᵀ = UᵀΛU: T = U L⁻¹ makes the covariance 1 + σ²Λ.
#[derive(Debug, Clone)]
struct Diagonal {
    turn: Matrix,
    back: Matrix,
    /// T⁻¹ = L Uᵀ.
    inverse: Matrix,
    values: Vec<f64>,
    log_of_noise: f64,
}

impl Diagonal {
    /// 1 + σ²Λ.
    fn variances(&self, size: f64) -> Vec<f64> {
        let values = self.values.iter();
        values.map(|value| 1.0 + size * size * value).collect()
    }

    /// The diagonal of S⁻¹, and S⁻¹r.
    fn precisions(&self, residuals: &[f64], size: f64) -> (Vec<f64>, Vec<f64>) {
        let variances = self.variances(size);
        let turned = self.turn.times(residuals).into_iter().zip(&variances);
        let weighted: Vec<f64> = turned.map(|(turned, v)| turned / v).collect();
        let of_row = |row: usize| -> f64 {
            let own = self.back.row(row).iter().zip(&variances);
            own.map(|(back, v)| back * back / v).sum()
        };
        let precisions = (0..residuals.len()).map(of_row);
        (precisions.collect(), self.back.times(&weighted))
    }
}

impl Gaussian {
    /// `None` if the noise is not positive definite.
    pub(crate) fn new(noise: Matrix, parts: Vec<Matrix>) -> Option<Self> {
        let lower = noise.cholesky()?;
        let diagonal = match &parts[..] {
            [part] => {
                let inverse = lower.inverse_of_triangle();
                let inner = inverse.product(part).product(&inverse.transposed());
                let (values, vectors) = inner.eigenvectors();
                let turn = vectors.product(&inverse);
                Some(Diagonal {
                    back: turn.transposed(),
                    turn,
                    inverse: lower.product(&vectors.transposed()),
                    values,
                    log_of_noise: log_determinant(&lower),
                })
            }
            _ => None,
        };
        Some(Self { noise, parts, diagonal })
    }

    /// Of residuals, data minus predictions, for sizes σ. `None` if the sizes are beyond numbers.
    pub(crate) fn density(&self, residuals: &[f64], sizes: &[f64]) -> Option<Density> {
        let norm = -0.5 * residuals.len() as f64 * (2.0 * PI).ln();
        if let Some(diagonal) = &self.diagonal {
            let size = sizes[0];
            let turned = diagonal.turn.times(residuals);
            let variances = diagonal.variances(size);
            let weighted: Vec<f64> = turned.iter().zip(&variances).map(|(r, v)| r / v).collect();
            let logs: f64 = variances.iter().map(|v| v.ln()).sum();
            let terms = diagonal.values.iter().zip(&variances).zip(&weighted);
            let by_size: f64 = terms.map(|((value, v), w)| value * (w * w - 1.0 / v)).sum();
            let value = norm - diagonal.log_of_noise - 0.5 * logs - 0.5 * dot(&turned, &weighted);
            return value.is_finite().then(|| Density {
                value,
                by_prediction: diagonal.back.times(&weighted),
                by_size: vec![size * by_size],
            });
        }
        let covariance = self.covariance(sizes);
        let lower = covariance.cholesky()?;
        let inverse = lower.inverse_of_square();
        let weighted = inverse.times(residuals);
        let by_size = self.parts.iter().zip(sizes).map(|(part, size)| {
            let trace = dot(&inverse.values, &part.values);
            size * (dot(&weighted, &part.times(&weighted)) - trace)
        });
        Some(Density {
            value: norm - log_determinant(&lower) - 0.5 * dot(residuals, &weighted),
            by_size: by_size.collect(),
            by_prediction: weighted,
        })
    }

    /// Density of some of the data.
    pub(crate) fn picked(&self, rows: &[usize]) -> Option<Self> {
        let picked = |matrix: &Matrix| Matrix::of(rows.len(), |i, j| matrix.at(rows[i], rows[j]));
        let parts = self.parts.iter().map(picked);
        Self::new(picked(&self.noise), parts.collect())
    }

    /// ln of the density of each datum given all others.
    pub(crate) fn of_each(&self, residuals: &[f64], sizes: &[f64]) -> Option<Vec<f64>> {
        let (precisions, weighted) = match &self.diagonal {
            Some(diagonal) => diagonal.precisions(residuals, sizes[0]),
            None => {
                let inverse = self.covariance(sizes).cholesky()?.inverse_of_square();
                let own = (0..residuals.len()).map(|place| inverse.at(place, place));
                (own.collect(), inverse.times(residuals))
            }
        };
        let of_one = |(precision, weighted): (f64, f64)| {
            0.5 * (precision / (2.0 * PI)).ln() - 0.5 * weighted * weighted / precision
        };
        let all: Vec<f64> = precisions.into_iter().zip(weighted).map(of_one).collect();
        all.iter().all(|it| it.is_finite()).then_some(all)
    }

    /// Errors, from draws of mean 0 and variance 1.
    pub(crate) fn draw(&self, sizes: &[f64], mut normal: impl FnMut() -> f64) -> Option<Vec<f64>> {
        let normals: Vec<f64> = (0..self.noise.size).map(|_| normal()).collect();
        if let Some(diagonal) = &self.diagonal {
            let variances = diagonal.variances(sizes[0]).into_iter();
            let turned = variances.zip(normals).map(|(v, normal)| v.sqrt() * normal);
            return Some(diagonal.inverse.times(&turned.collect::<Vec<f64>>()));
        }
        Some(self.covariance(sizes).cholesky()?.times(&normals))
    }

    pub(crate) fn covariance(&self, sizes: &[f64]) -> Matrix {
        self.covariance_of_mean(sizes, 1.0)
    }

    /// Of the mean of so many measurements: what the model misses stays.
    pub(crate) fn covariance_of_mean(&self, sizes: &[f64], times: f64) -> Matrix {
        let mut covariance = self.noise.clone();
        covariance.values.iter_mut().for_each(|value| *value /= times);
        for (part, size) in self.parts.iter().zip(sizes) {
            for (value, part) in covariance.values.iter_mut().zip(&part.values) {
                *value += size * size * part;
            }
        }
        covariance
    }
}

/// What is said of some data given all others of their block.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Conditional {
    /// ln of their density.
    pub(crate) log_density: f64,
    /// The share of its own distribution that lies below each.
    pub(crate) shares: Vec<f64>,
}

/// Some data given all others, from the inverse S⁻¹ of the covariance of all and from S⁻¹r.
///
/// Source: Sundararajan & Keerthi (2001), Neural Computation 13.
pub(crate) fn given_others(inverse: &Matrix, weighted: &[f64], group: &[usize]) -> Option<Conditional> {
    let precision = Matrix::of(group.len(), |i, j| inverse.at(group[i], group[j]));
    let lower = precision.cholesky()?;
    let turned = lower.forward(group.iter().map(|place| weighted[*place]).collect());
    let norm = -0.5 * group.len() as f64 * (2.0 * PI).ln();
    let covariance = lower.inverse_of_square();
    let beside = lower.transposed().backward(&turned);
    let shares = beside.iter().enumerate();
    Some(Conditional {
        log_density: norm + log_determinant(&lower) - 0.5 * dot(&turned, &turned),
        shares: shares.map(|(place, beside)| below(beside / covariance.at(place, place).sqrt())).collect(),
    })
}

/// Half of ln |LLᵀ|.
fn log_determinant(lower: &Matrix) -> f64 {
    (0..lower.size).map(|index| lower.at(index, index).ln()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conjugate::{U1, number};
    use crate::kernel::Kernel;

    /// U1: the evidence of three dates, and the density of each date given the others, over all growth and first levels.
    #[test]
    fn dates_have_their_evidence_and_tell_each_other() {
        let u1 = U1::read();
        let (columns, errors, data) = u1.equations(&[0, 1, 2]);
        let known = u1.proper();
        let covariance = Matrix::of(data.len(), |i, j| {
            let of_priors = columns.iter().zip(&known);
            let of_priors = of_priors.map(|(a, known)| a[i] * a[j] / known.precision);
            errors.at(i, j) + of_priors.sum::<f64>()
        });
        let of_means = |row: usize| -> f64 {
            let columns = columns.iter().zip(&known);
            columns.map(|(a, known)| a[row] * known.mean).sum()
        };
        let residuals: Vec<f64> = (0..data.len()).map(|row| data[row] - of_means(row)).collect();
        let gaussian = Gaussian::new(covariance.clone(), Vec::new()).unwrap();
        let evidence = gaussian.density(&residuals, &[]).unwrap().value;
        assert!((evidence - number("/U1/log_evidence")).abs() < 1e-10);
        let inverse = covariance.cholesky().unwrap().inverse_of_square();
        let weighted = inverse.times(&residuals);
        let expected = u1.numbers("/log_predictive_leaving_out_a_date");
        for (date, expected) in expected.into_iter().enumerate() {
            let group = [0, 1, 2].map(|band| 3 * date + band);
            let value = given_others(&inverse, &weighted, &group).unwrap().log_density;
            assert!((value - expected).abs() < 1e-10, "{date}: {value}");
        }
    }

    /// U5 of `validation/calibration/conjugate.json`: three lines with a Gaussian process over ln f, with and without an error
    /// of gain.
    #[test]
    fn lines_under_a_process_have_their_closed_form() {
        let frequency = [500f64, 600.0, 1000.0];
        let (residual, error) = ([0.05, 0.12, -0.08], [0.02f64, 0.03, 0.02]);
        let place: Vec<f64> = frequency.iter().map(|f| f.ln()).collect();
        let kernel = Kernel::Matern32 { length: 0.5 };
        let part = Matrix::of(3, |row, column| kernel.at(place[row] - place[column]));
        for (gain, expected) in [(0.0, 2.5701848216856784), (0.03f64, 2.509145346360277)] {
            let noise = Matrix::of(3, |row, column| {
                let own = if row == column { error[row].powi(2) } else { 0.0 };
                own + gain * gain
            });
            let one = Gaussian::new(noise.clone(), vec![part.clone()]).unwrap();
            let value = one.density(&residual, &[0.1]).unwrap().value;
            assert!((value - expected).abs() < 1e-10, "{value}");
            // The same in two halves of equal size, which are not made diagonal.
            let two = Gaussian::new(noise, vec![part.clone(), part.clone()]).unwrap();
            let half = 0.1 / 2f64.sqrt();
            let density = two.density(&residual, &[half, half]).unwrap();
            assert!((density.value - expected).abs() < 1e-10);
            for (at, derivative) in [(0, density.by_size[0]), (1, density.by_size[1])] {
                let h = 1e-6;
                let moved = |sign: f64| {
                    let mut sizes = [half, half];
                    sizes[at] += sign * h;
                    two.density(&residual, &sizes).unwrap().value
                };
                assert!(((moved(1.0) - moved(-1.0)) / (2.0 * h) - derivative).abs() < 1e-6);
            }
            let (of_each, of_halves) =
                (one.of_each(&residual, &[0.1]).unwrap(), two.of_each(&residual, &[half, half]).unwrap());
            for (one, other) in of_each.iter().zip(&of_halves) {
                assert!((one - other).abs() < 1e-9);
            }
            // Errors from unit vectors are a root of the covariance.
            let roots = [0, 1, 2].map(|unit| {
                let mut at = 0;
                let normal = || {
                    at += 1;
                    f64::from(u8::from(at == unit + 1))
                };
                one.draw(&[0.1], normal).unwrap()
            });
            let covariance = one.covariance(&[0.1]);
            for (row, column) in [(0, 0), (0, 1), (1, 2), (2, 2)] {
                let sum: f64 = roots.iter().map(|root| root[row] * root[column]).sum();
                assert!((sum - covariance.at(row, column)).abs() < 1e-12);
            }
            let of_one = one.density(&residual, &[0.1]).unwrap();
            let both = density.by_size[0] * half + density.by_size[1] * half;
            assert!((of_one.by_size[0] * 0.1 - both).abs() < 1e-10);
            for (one, other) in of_one.by_prediction.iter().zip(&density.by_prediction) {
                assert!((one - other).abs() < 1e-9);
            }
        }
    }
}
