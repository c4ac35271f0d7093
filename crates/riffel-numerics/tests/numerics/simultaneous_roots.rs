use num_complex::Complex64;
use proptest::prelude::*;
use riffel_numerics::simultaneous_roots::polish;

fn complex() -> impl Strategy<Value = Complex64> {
    (-6.0..6.0f64, -3.1..3.1f64).prop_map(|(size, angle)| Complex64::from_polar(10f64.powf(size), angle))
}

proptest! {
    /// Roots over twelve decades from guesses that are ten per cent off.
    #[test]
    fn finds_all_roots(roots in [complex(), complex(), complex(), complex()]) {
        for (index, a) in roots.iter().enumerate() {
            for b in &roots[..index] {
                prop_assume!((a - b).norm() > 0.3 * a.norm().min(b.norm()));
            }
        }
        let mut found = roots.map(|root| root * Complex64::new(1.05, 0.1));
        polish(|z| roots.iter().map(|root| z - root).product(), &mut found);
        for (found, root) in found.iter().zip(&roots) {
            prop_assert!((found - root).norm() <= 1e-14 * root.norm(), "{found} {root}");
        }
    }
}

/// A pair of complex roots from real guesses.
#[test]
fn leaves_the_real_axis() {
    let mut roots = [Complex64::from(-1.0), Complex64::from(2.0)];
    polish(|z| z * z + 1.0, &mut roots);
    for root in roots {
        assert!((root * root + 1.0).norm() < 1e-15, "{root}");
    }
    assert!((roots[0] + roots[1]).norm() < 1e-15);
}
