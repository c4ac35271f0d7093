use riffel_numerics::matrix::Matrix;

#[test]
fn a_matrix_is_put_together_again() {
    let places = [0.0f64, 0.3, 0.35, 1.0, 2.5];
    let matrix = Matrix::of(5, |row, column| (-(places[row] - places[column]).abs()).exp());
    let lower = matrix.cholesky().unwrap();
    let again = lower.product(&lower.transposed());
    let (values, vectors) = matrix.eigenvectors();
    let scaled = Matrix::of(5, |row, column| values[row] * vectors.at(row, column));
    let of_vectors = vectors.transposed().product(&scaled);
    let unity = matrix.product(&lower.inverse_of_square());
    for (index, value) in matrix.values.iter().enumerate() {
        assert!((again.values[index] - value).abs() < 1e-14);
        assert!((of_vectors.values[index] - value).abs() < 1e-13);
        assert!((unity.values[index] - Matrix::identity(5).values[index]).abs() < 1e-13);
    }
    assert!(Matrix::of(2, |_, _| 1.0 + f64::EPSILON).cholesky().is_none());
}

/// Of ones everywhere: N, with equal shares, and zeros.
#[test]
fn eigenvalues_of_ones() {
    let (values, vectors) = Matrix::of(5, |_, _| 1.0).eigenvectors();
    let largest = (0..5).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap();
    for (index, value) in values.iter().enumerate() {
        let expected = if index == largest { 5.0 } else { 0.0 };
        assert!((value - expected).abs() < 1e-14, "{value}");
    }
    for share in vectors.row(largest) {
        assert!((share.abs() - 0.2f64.sqrt()).abs() < 1e-14);
    }
}
