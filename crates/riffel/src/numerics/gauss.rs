//! Quadrature over short panels.

/// Places and weights of Gauss and Legendre's rule of five points between 0 and 1: exact for polynomials of degree nine,
/// and to 1e-9 for the square of a wave over a radian.
pub(crate) const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_095),
    (0.230_765_344_947_158, 0.239_314_335_249_683),
    (0.5, 0.284_444_444_444_444),
    (0.769_234_655_052_842, 0.239_314_335_249_683),
    (0.953_089_922_969_332, 0.118_463_442_528_095),
];

/// Places and weights of the rule on each of some panels, given by their edges.
pub(crate) fn panels(edges: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    edges.windows(2).flat_map(|ends| {
        let length = ends[1] - ends[0];
        GAUSS.map(|(share, weight)| (ends[0] + share * length, weight * length))
    })
}

/// Edges of equal panels no longer than some length.
pub(crate) fn equal_panels([from, to]: [f64; 2], longest: f64) -> Vec<f64> {
    let count = ((to - from) / longest).ceil().max(1.0);
    let step = (to - from) / count;
    (0..=count as usize).map(|edge| from + step * edge as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wave_is_summed_to_rounding() {
        let edges = equal_panels([0.0, 20.0], 1.0);
        let sum: f64 = panels(&edges).map(|(x, weight)| weight * x.sin()).sum();
        assert!((sum - (1.0 - 20f64.cos())).abs() < 1e-10, "{sum}");
    }
}
