//! Complex numbers in vector registers.

use pulp::{Arch, Simd, WithSimd, bytemuck};

/// Complex numbers, as many as a vector register has lanes, their parts apart.
#[derive(Clone, Copy)]
pub(crate) struct Vector<S: Simd> {
    pub(crate) re: S::f64s,
    pub(crate) im: S::f64s,
}

/// The two parts of a [`Vector`] in memory.
pub(crate) type Parts<S> = [<S as Simd>::f64s; 2];

impl<S: Simd> Vector<S> {
    /// A row of numbers: of each the real parts of all lanes, then the imaginary ones.
    #[inline(always)]
    pub(crate) fn row(values: &[f64]) -> &[Parts<S>] {
        S::as_simd_f64s(values).0.as_chunks().0
    }

    /// Row of parts to write to.
    #[inline(always)]
    pub(crate) fn row_mut(values: &mut [f64]) -> &mut [Parts<S>] {
        S::as_mut_simd_f64s(values).0.as_chunks_mut().0
    }

    #[inline(always)]
    pub(crate) fn zero(simd: S) -> Self {
        Self { re: simd.splat_f64s(0.0), im: simd.splat_f64s(0.0) }
    }

    #[inline(always)]
    pub(crate) fn parts(self) -> Parts<S> {
        [self.re, self.im]
    }

    #[inline(always)]
    pub(crate) fn plus(self, simd: S, other: Self) -> Self {
        Self { re: simd.add_f64s(self.re, other.re), im: simd.add_f64s(self.im, other.im) }
    }

    #[inline(always)]
    pub(crate) fn times(self, simd: S, other: Self) -> Self {
        Self {
            re: simd.negate_mul_add_e_f64s(self.im, other.im, simd.mul_f64s(self.re, other.re)),
            im: simd.mul_add_e_f64s(self.im, other.re, simd.mul_f64s(self.re, other.im)),
        }
    }

    #[inline(always)]
    pub(crate) fn times_plus(self, simd: S, other: Self, sum: Self) -> Self {
        Self {
            re: simd.negate_mul_add_e_f64s(self.im, other.im, simd.mul_add_e_f64s(self.re, other.re, sum.re)),
            im: simd.mul_add_e_f64s(self.im, other.re, simd.mul_add_e_f64s(self.re, other.im, sum.im)),
        }
    }

    #[inline(always)]
    pub(crate) fn scaled(self, simd: S, factor: S::f64s) -> Self {
        Self { re: simd.mul_f64s(self.re, factor), im: simd.mul_f64s(self.im, factor) }
    }

    #[inline(always)]
    pub(crate) fn negative(self, simd: S) -> Self {
        Self { re: simd.neg_f64s(self.re), im: simd.neg_f64s(self.im) }
    }

    #[inline(always)]
    pub(crate) fn conj(self, simd: S) -> Self {
        Self { re: self.re, im: simd.neg_f64s(self.im) }
    }

    #[inline(always)]
    pub(crate) fn norm_sqr(self, simd: S) -> S::f64s {
        simd.mul_add_e_f64s(self.re, self.re, simd.mul_f64s(self.im, self.im))
    }

    /// One over it; no number where it is zero.
    #[inline(always)]
    pub(crate) fn reciprocal(self, simd: S) -> Self {
        let inverse = simd.div_f64s(simd.splat_f64s(1.0), self.norm_sqr(simd));
        self.conj(simd).scaled(simd, inverse)
    }
}

impl<S: Simd> From<Parts<S>> for Vector<S> {
    #[inline(always)]
    fn from([re, im]: Parts<S>) -> Self {
        Self { re, im }
    }
}

/// Add N rows, each times a factor of its own.
#[inline(always)]
pub(crate) fn add_row<S: Simd, const N: usize>(
    simd: S,
    entries: &mut [Parts<S>],
    factors: [Vector<S>; N],
    rows: [&[Parts<S>]; N],
) {
    let rows = rows.map(|row| &row[..entries.len()]);
    for (index, entry) in entries.iter_mut().enumerate() {
        let mut sum = Vector::from(*entry);
        for (factor, row) in factors.iter().zip(rows) {
            sum = factor.times_plus(simd, row[index].into(), sum);
        }
        *entry = sum.parts();
    }
}

/// The lanes of a vector.
#[inline(always)]
pub(crate) fn lanes<S: Simd>(vector: &S::f64s) -> &[f64] {
    bytemuck::cast_slice(std::slice::from_ref(vector))
}

/// How many lanes a vector has.
pub(crate) fn lanes_of(arch: Arch) -> usize {
    struct Lanes;

    impl WithSimd for Lanes {
        type Output = usize;

        fn with_simd<S: Simd>(self, _: S) -> usize {
            S::F64_LANES
        }
    }

    arch.dispatch(Lanes)
}
