use num_complex::Complex64;
use proptest::prelude::*;
use riffel_numerics::square_root::square_root;

proptest! {
    #[test]
    fn is_the_square_root(size in -60.0..60.0f64, angle in -3.1..3.1f64) {
        let z = Complex64::from_polar(10f64.powf(size), angle);
        let (root, expected) = (square_root(z), z.sqrt());
        prop_assert!((root - expected).norm() < 1e-15 * expected.norm(), "{z} {root}");
    }
}

#[test]
fn both_sides_of_the_cut() {
    let above = square_root(Complex64::new(-4.0, 0.0));
    let below = square_root(Complex64::new(-4.0, -0.0));
    assert_eq!((above, below), (Complex64::new(0.0, 2.0), Complex64::new(0.0, -2.0)));
    assert_eq!(square_root(Complex64::ZERO), Complex64::ZERO);
}
