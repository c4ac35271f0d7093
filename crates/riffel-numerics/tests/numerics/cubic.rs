use riffel_numerics::cubic::{cubic, cubic_at, cubic_slope, hermite};

/// A cubic of its own is met everywhere, beyond the middle as well, to rounding.
#[test]
fn cubics_are_met() {
    let of = |x: f64| 2.0 - x + 3.0 * x * x - 0.5 * x.powi(3);
    let slope = |x: f64| -1.0 + 6.0 * x - 1.5 * x * x;
    for share in [-1.0, 0.0, 0.3, 1.0, 1.7] {
        assert!((cubic([-1.0, 0.0, 1.0, 2.0].map(of), share) - of(share)).abs() < 1e-13);
        let coefficients = hermite([of(0.0), of(1.0)], [slope(0.0), slope(1.0)]);
        assert!((cubic_at(coefficients, share) - of(share)).abs() < 1e-13);
        assert!((cubic_slope(coefficients, share) - slope(share)).abs() < 1e-13);
    }
}
