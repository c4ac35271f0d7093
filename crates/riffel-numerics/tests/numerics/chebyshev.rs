use num_complex::Complex64;
use riffel_numerics::chebyshev::{Cell, Cut};

/// To rounding times the largest coefficient of T₇, 112.
#[test]
fn a_polynomial_of_degree_seven_is_exact() {
    let cut = Cut { first_cells: 1, most_halvings: 0, checks: [0.0; 5] };
    let cells = Cell::table(|t| Complex64::new(3.0 * t.powi(7) - t, 2.0 + t.powi(4)), [-1.0, 1.0], &cut, |_, _| true);
    let powers = cells[0].polynomial;
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
