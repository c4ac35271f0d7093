//! Polynomials of degree 7 through Chebyshev's nodes: the cells of tables.

use std::array;
use std::f64::consts::PI;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul};

/// Coefficients of the polynomial of a cell.
pub(crate) const NODES: usize = 8;

/// Power coefficients in t, lowest first, of the polynomial that meets a function at Chebyshev's nodes in [−1, 1].
pub(crate) fn through_nodes<V>(f: impl Fn(f64) -> V) -> [V; NODES]
where
    V: Copy + Default + Sum + AddAssign + Mul<f64, Output = V>,
{
    let angle = |j: usize| PI * (j as f64 + 0.5) / NODES as f64;
    let values: [V; NODES] = array::from_fn(|j| f(angle(j).cos()));
    // Sum of c_k T_k(t), the T_k by T_{k+1} = 2t T_k − T_{k−1}.
    let mut powers = [V::default(); NODES];
    let (mut before, mut current) = ([0.0; NODES], [0.0; NODES]);
    current[0] = 1.0;
    for k in 0..NODES {
        let scale = if k == 0 { 1.0 } else { 2.0 } / NODES as f64;
        let coefficient: V =
            values.iter().enumerate().map(|(j, &value)| value * (scale * (k as f64 * angle(j)).cos())).sum();
        for (power, factor) in powers.iter_mut().zip(current) {
            *power += coefficient * factor;
        }
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let next = array::from_fn(|j| {
            let raised = if j == 0 { 0.0 } else { factor * current[j - 1] };
            raised - before[j]
        });
        (before, current) = (current, next);
    }
    powers
}

/// The polynomial of some power coefficients, the lowest first, at t.
pub(crate) fn polynomial_at<V>(polynomial: &[V; NODES], t: f64) -> V
where
    V: Copy + Default + Add<Output = V> + Mul<f64, Output = V>,
{
    let powers = polynomial.iter().rev();
    powers.fold(V::default(), |sum, &power| sum * t + power)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Complex64;

    /// To rounding times the largest coefficient of T₇, 112.
    #[test]
    fn a_polynomial_of_degree_seven_is_exact() {
        let powers = through_nodes(|t| Complex64::new(3.0 * t.powi(7) - t, 2.0 + t.powi(4)));
        let expected = [
            Complex64::new(0.0, 2.0),
            Complex64::new(-1.0, 0.0),
            Complex64::ZERO,
            Complex64::ZERO,
            Complex64::i(),
            Complex64::ZERO,
            Complex64::ZERO,
            Complex64::new(3.0, 0.0),
        ];
        for (power, expected) in powers.iter().zip(expected) {
            assert!((power - expected).norm() < 1e-12, "{power} {expected}");
        }
    }
}
