//! Determinants of many equations.

use num_complex::Complex64;

/// A determinant as a number times a power of two: that of a hundred equations leaves the range of a double.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Determinant {
    factor: Complex64,
    exponent: i32,
}

impl Determinant {
    /// One, or minus one.
    pub(super) fn one(negative: bool) -> Self {
        let sign = if negative { -1.0 } else { 1.0 };
        Self { factor: sign.into(), exponent: 0 }
    }

    /// The ratio of two.
    pub(super) fn over(self, other: Self) -> Complex64 {
        self.factor / other.factor * 2.0_f64.powi(self.exponent - other.exponent)
    }

    /// A factor more.
    pub(super) fn times(self, pivot: Complex64) -> Self {
        let factor = self.factor * pivot;
        let exponent = binary_exponent(factor.norm_sqr()) / 2;
        Self { factor: factor * 2.0_f64.powi(-exponent), exponent: self.exponent + exponent }
    }
}

/// The power of two below a positive number.
fn binary_exponent(value: f64) -> i32 {
    /// Bits of the fraction, bits of the exponent, and what it is counted from.
    const FRACTION: u32 = 52;
    const EXPONENT: u64 = 0x7ff;
    const ZERO: i32 = 1023;
    ((value.to_bits() >> FRACTION) & EXPONENT) as i32 - ZERO
}
