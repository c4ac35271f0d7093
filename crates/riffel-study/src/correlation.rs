//! Correlated parameters.

use riffel_numerics::normal_distribution::{below, quantile};

/// A Gaussian copula: points of the unit cube are turned into normal scores, mixed by the Cholesky factor of their
/// correlation matrix, and turned back (Nataf 1962). Each parameter keeps its distribution.
///
/// The coefficient ρ is that of the normal scores. It is the correlation of the parameters themselves where both
/// are normal; their rank correlation is 6/π asin(ρ/2) whatever their distributions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GaussianCopula {
    /// Rows of the lower triangle.
    factor: Vec<Vec<f64>>,
}

impl GaussianCopula {
    /// The copula of pairs with their coefficients, all others 0; none if that is no correlation matrix.
    pub(crate) fn new(parameters: usize, pairs: &[([usize; 2], f64)]) -> Option<Self> {
        let coefficient = |i: usize, j: usize| {
            let pair = pairs.iter().find(|(pair, _)| *pair == [i, j] || *pair == [j, i]);
            match pair {
                _ if i == j => 1.0,
                Some((_, coefficient)) => *coefficient,
                None => 0.0,
            }
        };
        let mut factor: Vec<Vec<f64>> = Vec::with_capacity(parameters);
        for i in 0..parameters {
            let mut row = vec![0.0; i + 1];
            for j in 0..=i {
                let other = if j == i { &row } else { &factor[j] };
                let known: f64 = (0..j).map(|k| row[k] * other[k]).sum();
                let rest = coefficient(i, j) - known;
                row[j] = match i == j {
                    true if rest <= f64::EPSILON * parameters as f64 => return None,
                    true => rest.sqrt(),
                    false => rest / factor[j][j],
                };
            }
            factor.push(row);
        }
        Some(Self { factor })
    }

    /// Move a point of independent coordinates to one of correlated ones.
    pub(crate) fn apply(&self, point: &mut [f64]) {
        let scores: Vec<f64> = point.iter().map(|&u| quantile(u)).collect();
        for (u, row) in point.iter_mut().zip(&self.factor) {
            let (own, others) = row.split_last().unwrap_or((&1.0, &[]));
            // A parameter without partners keeps its share, digit for digit.
            if others.iter().any(|&factor| factor != 0.0) {
                let mixed: f64 = row.iter().zip(&scores).map(|(factor, z)| factor * z).sum();
                *u = below(mixed).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0);
            }
            debug_assert!(*own > 0.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Random;

    #[test]
    fn coefficients_come_back() {
        let pairs = [([0, 1], 0.7), ([2, 0], -0.4)];
        let copula = GaussianCopula::new(4, &pairs).unwrap();
        let samples = 40_000;
        let design = Random::new(samples, 4, 1);
        let scores: Vec<Vec<f64>> = (0..samples)
            .map(|index| {
                let mut point = design.point(index);
                let before = point[3];
                copula.apply(&mut point);
                assert_eq!(point[3], before);
                point.iter().map(|&u| quantile(u)).collect()
            })
            .collect();
        let correlation = |i: usize, j: usize| scores.iter().map(|z| z[i] * z[j]).sum::<f64>() / samples as f64;
        // Five standard errors.
        let tolerance = 5.0 / (samples as f64).sqrt();
        for (i, j, expected) in [(0, 1, 0.7), (0, 2, -0.4), (1, 2, 0.0), (0, 3, 0.0), (1, 1, 1.0)] {
            let found = correlation(i, j);
            assert!((found - expected).abs() < 1.5 * tolerance, "{i} {j}: {found}");
        }
    }

    #[test]
    fn what_is_no_correlation_is_refused() {
        let cyclic = [([0, 1], 0.9), ([1, 2], 0.9), ([0, 2], -0.9)];
        assert_eq!(GaussianCopula::new(3, &cyclic), None);
        assert_eq!(GaussianCopula::new(2, &[([0, 1], 1.0)]), None);
    }
}
