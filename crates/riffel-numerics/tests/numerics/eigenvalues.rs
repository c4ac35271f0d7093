use num_complex::Complex64;
use riffel_numerics::eigenvalues::eigenvalues;

/// A companion matrix has the roots of its polynomial, over six decades and with pairs.
#[test]
fn roots_of_a_polynomial() {
    let pairs = [(-1e-3, 0.2), (-0.5, 3.0), (-20.0, 400.0)];
    let reals = [-2e-3, -7.0, -900.0];
    let mut polynomial = vec![1.0];
    let times = |polynomial: &[f64], factor: &[f64]| {
        let mut product = vec![0.0; polynomial.len() + factor.len() - 1];
        for (i, one) in polynomial.iter().enumerate() {
            for (j, other) in factor.iter().enumerate() {
                product[i + j] += one * other;
            }
        }
        product
    };
    for (re, im) in pairs {
        polynomial = times(&polynomial, &[1.0, -2.0 * re, re * re + im * im]);
    }
    for real in reals {
        polynomial = times(&polynomial, &[1.0, -real]);
    }
    let count = polynomial.len() - 1;
    let matrix = (0..count)
        .map(|row| {
            (0..count)
                .map(|column| match row {
                    0 => -polynomial[column + 1],
                    _ => f64::from(row == column + 1),
                })
                .collect()
        })
        .collect();
    let found = eigenvalues(matrix);
    assert_eq!(found.len(), count);
    let pairs = pairs.map(|(re, im)| Complex64::new(re, im));
    for known in pairs.into_iter().chain(reals.map(Complex64::from)) {
        let nearest = found.iter().map(|value| (value - known).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-9 * known.norm(), "{known} in {found:?}");
    }
    assert_eq!(found.iter().filter(|value| value.im == 0.0).count(), 3);
}
