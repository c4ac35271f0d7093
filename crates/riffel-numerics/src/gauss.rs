//! Quadrature by the rules of Gauss and Legendre.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// Places and weights of Gauss and Legendre's rule of N points between 0 and 1, in order: exact for polynomials of degree 2N − 1.
///
/// Method: zeros of the Legendre polynomial by Newton's method, slopes by its recurrence (Abramowitz & Stegun 1964, 25.4.29). Error:
/// rounding. Cost: 20N² steps of the recurrence.
pub fn gauss_legendre<const N: usize>() -> [(f64, f64); N] {
    std::array::from_fn(|index| {
        let count = N as f64;
        let mut x = ((index as f64 + 0.75) / (count + 0.5) * PI).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut last, mut value) = (1.0, x);
            for order in 2..=N {
                let n = order as f64;
                (last, value) = (value, ((2.0 * n - 1.0) * x * value - (n - 1.0) * last) / n);
            }
            slope = count * (x * value - last) / (x * x - 1.0);
            x -= value / slope;
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// Rule of five points: to 1e-9 for the square of a wave over a radian.
pub static GAUSS: LazyLock<[(f64, f64); 5]> = LazyLock::new(gauss_legendre);

/// Places and weights of the rule on each of some panels, given by their edges.
pub fn panels(edges: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    edges.windows(2).flat_map(|ends| {
        let length = ends[1] - ends[0];
        GAUSS.map(|(share, weight)| (ends[0] + share * length, weight * length))
    })
}

/// Edges of equal panels no longer than some length.
pub fn equal_panels([from, to]: [f64; 2], longest: f64) -> Vec<f64> {
    let count = ((to - from) / longest).ceil().max(1.0);
    let step = (to - from) / count;
    (0..=count as usize).map(|edge| from + step * edge as f64).collect()
}
