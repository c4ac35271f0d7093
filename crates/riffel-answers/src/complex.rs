//! Complex numbers as documents have them, `[re, im]`.

use riffel::Complex64;
use serde::{Serialize, Serializer};

fn pair(value: &Complex64) -> [f64; 2] {
    [value.re, value.im]
}

pub(crate) fn pairs(values: &[Complex64]) -> Vec<[f64; 2]> {
    values.iter().map(pair).collect()
}

/// For `serialize_with`.
pub(crate) fn as_pairs<S: Serializer>(values: &[Complex64], serializer: S) -> Result<S::Ok, S::Error> {
    pairs(values).serialize(serializer)
}

/// Real and imaginary parts of matrices, for `serialize_with`.
pub(crate) fn as_matrices<const N: usize, S: Serializer>(
    matrices: &[[[Complex64; N]; N]],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(matrices.iter().map(|matrix| matrix.each_ref().map(|row| pairs(row)).to_vec()))
}
