use num_complex::Complex64;
use riffel_numerics::elimination::{inverse, solve};

/// Hilbert's matrix of four rows has an inverse of integers and the condition 1.6·10⁴.
#[test]
fn the_inverse_of_hilberts_matrix_is_whole() {
    let hilbert = |row: usize| (0..4).map(|column| 1.0 / (row + column + 1) as f64).collect::<Vec<f64>>();
    let first = [16.0, -120.0, 240.0, -140.0];
    let solution = solve((0..4).map(hilbert).collect(), vec![1.0, 0.0, 0.0, 0.0]).unwrap();
    let complex = |row: usize| hilbert(row).into_iter().map(|entry| Complex64::new(0.0, entry)).collect();
    let inverse = inverse((0..4).map(complex).collect());
    for (index, expected) in first.into_iter().enumerate() {
        assert!((solution[index] - expected).abs() < 1e-9, "{solution:?}");
        assert!((inverse[0][index] - Complex64::new(0.0, -expected)).norm() < 1e-9);
    }
}

#[test]
fn rows_are_exchanged() {
    let solution = solve(vec![vec![0.0, 2.0], vec![3.0, 0.0]], vec![4.0, 6.0]).unwrap();
    assert_eq!(solution, [2.0, 2.0]);
    assert!(solve(vec![vec![1.0, 2.0], vec![2.0, 4.0]], vec![1.0, 1.0]).is_none());
    assert!(solve(vec![vec![f64::NAN]], vec![1.0]).is_none());
}
