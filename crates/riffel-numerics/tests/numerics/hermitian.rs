use num_complex::Complex64;
use riffel_numerics::hermitian::solve_hermitian;

#[test]
fn solves_hermitian() {
    let full = |row: usize, column: usize| {
        let (low, high) = (row.min(column) as f64, row.max(column) as f64);
        let value = Complex64::new(0.3 * (low + high), (low - high) * 0.4 - 0.1 * low * high);
        match row.cmp(&column) {
            std::cmp::Ordering::Less => value,
            std::cmp::Ordering::Equal => Complex64::from(20.0 + low),
            std::cmp::Ordering::Greater => value.conj(),
        }
    };
    let rows = (0..5).map(|row| (0..=row).map(|column| full(row, column)).collect());
    let values: Vec<Complex64> = (0..5).map(|row| Complex64::new(1.0, f64::from(row))).collect();
    let solution = solve_hermitian(rows.collect(), values.clone());
    for (row, value) in values.iter().enumerate() {
        let image: Complex64 = (0..5).map(|column| full(row, column) * solution[column]).sum();
        assert!((image - value).norm() < 1e-12);
    }
    assert!(solve_hermitian(Vec::new(), Vec::new()).is_empty());
}
