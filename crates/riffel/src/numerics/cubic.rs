//! Cubics through values at equal distances.

/// The cubic through four equidistant values (Lagrange), a share of the way from the second to the third.
pub(crate) fn cubic([a, b, c, d]: [f64; 4], share: f64) -> f64 {
    let third = (d - a) / 6.0 + (b - c) / 2.0;
    let second = (a + c) / 2.0 - b;
    let first = c - b / 2.0 - a / 3.0 - d / 6.0;
    b + share * (first + share * (second + share * third))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cubic of its own is met everywhere, beyond the middle as well, to rounding.
    #[test]
    fn cubics_are_met() {
        let of = |x: f64| 2.0 - x + 3.0 * x * x - 0.5 * x.powi(3);
        for share in [-1.0, 0.0, 0.3, 1.0, 1.7] {
            assert!((cubic([-1.0, 0.0, 1.0, 2.0].map(of), share) - of(share)).abs() < 1e-13);
        }
    }
}
