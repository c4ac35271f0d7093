//! Sums over long lists of real or complex numbers, in vector registers.

use num_complex::{Complex64, ComplexFloat};
use pulp::{Arch, Simd, WithSimd};

/// Real or complex numbers, and the two sums that linear equations are made of.
pub(super) trait Scalar: ComplexFloat<Real = f64> {
    fn of(value: f64) -> Self;

    /// Add a multiple of other values.
    fn add_multiple<S: Simd>(simd: S, values: &mut [Self], factor: Self, others: &[Self]);

    /// The inner product Σāb.
    fn dot<S: Simd>(simd: S, a: &[Self], b: &[Self]) -> Self;
}

/// Add a multiple of other values.
pub(super) fn add_multiple<T: Scalar>(values: &mut [T], factor: T, others: &[T]) {
    Arch::new().dispatch(AddMultiple { values, factor, others });
}

/// The inner product Σāb.
pub(super) fn dot<T: Scalar>(a: &[T], b: &[T]) -> T {
    Arch::new().dispatch(Dot { a, b })
}

/// The norm √Σ|a|².
pub(super) fn norm<T: Scalar>(a: &[T]) -> f64 {
    dot(a, a).re().sqrt()
}

struct AddMultiple<'a, T> {
    values: &'a mut [T],
    factor: T,
    others: &'a [T],
}

impl<T: Scalar> WithSimd for AddMultiple<'_, T> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        T::add_multiple(simd, self.values, self.factor, self.others);
    }
}

struct Dot<'a, T> {
    a: &'a [T],
    b: &'a [T],
}

impl<T: Scalar> WithSimd for Dot<'_, T> {
    type Output = T;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> T {
        T::dot(simd, self.a, self.b)
    }
}

/// Sums side by side, so that one addition need not wait for the one before.
const SUMS: usize = 4;

/// For real and complex numbers the same, but for the names of the instructions.
macro_rules! scalar {
    ($scalar:ty, $as_simd:ident, $as_mut_simd:ident, $splat:ident, $times_plus:ident, $conj_times_plus:ident, $plus:ident, $sum:ident) => {
        impl Scalar for $scalar {
            fn of(value: f64) -> Self {
                value.into()
            }

            #[inline(always)]
            fn add_multiple<S: Simd>(simd: S, values: &mut [Self], factor: Self, others: &[Self]) {
                let (values, last) = S::$as_mut_simd(values);
                let (others, others_last) = S::$as_simd(others);
                let factors = simd.$splat(factor);
                for (value, &other) in values.iter_mut().zip(others) {
                    *value = simd.$times_plus(factors, other, *value);
                }
                for (value, other) in last.iter_mut().zip(others_last) {
                    *value += factor * other;
                }
            }

            #[inline(always)]
            fn dot<S: Simd>(simd: S, a: &[Self], b: &[Self]) -> Self {
                let ((a, a_last), (b, b_last)) = (S::$as_simd(a), S::$as_simd(b));
                let mut sums = [simd.$splat(Self::of(0.0)); SUMS];
                let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<SUMS>(), b.as_chunks::<SUMS>());
                for (a, b) in a.iter().zip(b) {
                    for (sum, (&a, &b)) in sums.iter_mut().zip(a.iter().zip(b)) {
                        *sum = simd.$conj_times_plus(a, b, *sum);
                    }
                }
                for (&a, &b) in a_rest.iter().zip(b_rest) {
                    sums[0] = simd.$conj_times_plus(a, b, sums[0]);
                }
                let [first, second, third, fourth] = sums;
                let sum = simd.$plus(simd.$plus(first, second), simd.$plus(third, fourth));
                let last = a_last.iter().zip(b_last);
                last.fold(simd.$sum(sum), |sum, (&a, &b)| sum + ComplexFloat::conj(a) * b)
            }
        }
    };
}

scalar!(f64, as_simd_f64s, as_mut_simd_f64s, splat_f64s, mul_add_e_f64s, mul_add_e_f64s, add_f64s, reduce_sum_f64s);
scalar!(
    Complex64,
    as_simd_c64s,
    as_mut_simd_c64s,
    splat_c64s,
    mul_add_e_c64s,
    conj_mul_add_e_c64s,
    add_c64s,
    reduce_sum_c64s
);

#[cfg(test)]
mod tests {
    use super::*;

    /// Lists of any length, those that fill no register among them.
    #[test]
    fn sums_are_those_of_each_number() {
        for length in 0..40 {
            let value = |index: usize, turn: f64| Complex64::cis(turn * index as f64) * 1.3;
            let a: Vec<Complex64> = (0..length).map(|index| value(index, 0.7)).collect();
            let mut b: Vec<Complex64> = (0..length).map(|index| value(index, 1.9)).collect();
            let expected: Complex64 = a.iter().zip(&b).map(|(a, b)| a.conj() * b).sum();
            assert!((dot(&a, &b) - expected).norm() < 1e-13 * 40.0);
            let (re_a, mut re_b): (Vec<f64>, Vec<f64>) = a.iter().zip(&b).map(|(a, b)| (a.re, b.im)).unzip();
            let expected: f64 = re_a.iter().zip(&re_b).map(|(a, b)| a * b).sum();
            assert!((dot(&re_a, &re_b) - expected).abs() < 1e-13 * 40.0);
            let factor = Complex64::new(0.3, -2.0);
            let sums: Vec<Complex64> = a.iter().zip(&b).map(|(a, b)| b + factor * a).collect();
            add_multiple(&mut b, factor, &a);
            assert!(b.iter().zip(sums).all(|(b, sum)| (b - sum).norm() < 1e-14));
            let sums: Vec<f64> = re_a.iter().zip(&re_b).map(|(a, b)| b - 0.4 * a).collect();
            add_multiple(&mut re_b, -0.4, &re_a);
            assert!(re_b.iter().zip(sums).all(|(b, sum)| (b - sum).abs() < 1e-14));
        }
    }
}
