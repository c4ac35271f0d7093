use proptest::prelude::*;
use riffel_numerics::least_squares::{least_squares, remainder, triangle};

proptest! {
    /// The residual is normal to every column, whatever their sizes: twenty roundings of the longest.
    #[test]
    fn residual_is_normal_to_the_columns(
        entries in proptest::collection::vec(-1.0..1.0f64, 8 * 30), right in proptest::collection::vec(-1.0..1.0f64, 30),
    ) {
        let sizes = [1.0, 1e-9, 1e6, 1.0, 30.0, 1e-3, 1.0, 1e3];
        let columns: Vec<Vec<f64>> = entries
            .chunks_exact(30)
            .zip(sizes)
            .map(|(column, size)| column.iter().map(|entry| size * entry).collect())
            .collect();
        let solution = least_squares(&mut columns.clone(), &right);
        let mut residual = right;
        for (column, value) in columns.iter().zip(&solution) {
            for (residual, entry) in residual.iter_mut().zip(column) {
                *residual -= value * entry;
            }
        }
        for column in &columns {
            prop_assert!(dot(column, &residual).abs() <= 1e-12 * norm(column));
        }
    }
}

/// The unknowns of some columns are those of all of them.
#[test]
fn a_remainder_keeps_its_unknowns() {
    let column = |seed: f64| -> Vec<f64> { (0..12).map(|i| (seed * f64::from(i * i + 3)).sin()).collect() };
    let columns: Vec<Vec<f64>> = [0.3, 1.1, 0.7, 2.3].map(column).to_vec();
    let right = column(1.7);
    let all = least_squares(&mut columns.clone(), &right);
    let mut with_right = columns;
    with_right.push(right);
    let mut rest = remainder(&mut with_right, 2);
    let right = rest.pop().unwrap();
    let some = least_squares(&mut rest, &right);
    for (one, other) in all[2..].iter().zip(&some) {
        assert!((one - other).abs() < 1e-12, "{all:?} {some:?}");
    }
}

/// The straight line through three points: 3 and 14 are the sums of squares, 6 that of products.
#[test]
fn a_triangle_is_the_factor_of_the_normal_equations() {
    let columns = vec![vec![1.0, 1.0, 1.0], vec![1.0, 2.0, 3.0]];
    let (upper, turned) = triangle(columns.clone(), vec![1.0, 2.0, 4.0]).unwrap();
    let product = upper.transposed().product(&upper);
    for (value, expected) in product.values.iter().zip([3.0, 6.0, 6.0, 14.0]) {
        assert!((value - expected).abs() < 1e-14);
    }
    assert!(upper.at(0, 0) > 0.0 && upper.at(1, 1) > 0.0 && upper.at(1, 0) == 0.0);
    let solution = upper.backward(&turned);
    assert!((solution[0] + 2.0 / 3.0).abs() < 1e-14 && (solution[1] - 1.5).abs() < 1e-14);
    assert_eq!(triangle(vec![columns[0].clone(); 2], vec![1.0, 2.0, 4.0]), None);
    assert_eq!(triangle(vec![vec![f64::NAN, 1.0]], vec![1.0, 2.0]), None);
}

#[test]
fn a_column_that_depends_on_others_takes_no_part() {
    let mut columns = [vec![1.0, 2.0, 3.0], vec![-2.0, -4.0, -6.0], vec![0.0, 1.0, 1.0]];
    let solution = least_squares(&mut columns, &[2.0, 5.0, 7.0]);
    let expected = [2.0, 0.0, 1.0];
    for (value, expected) in solution.iter().zip(expected) {
        assert!((value - expected).abs() < 1e-13, "{solution:?}");
    }
}

fn norm(column: &[f64]) -> f64 {
    dot(column, column).sqrt()
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}
