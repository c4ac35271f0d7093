//! Complex matrices of one or two rows.

use std::ops::{Add, Mul};

use num_complex::Complex64;

/// A square matrix of N = 1 or 2 rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Square<const N: usize>(pub [[Complex64; N]; N]);

impl<const N: usize> Square<N> {
    /// Matrix of zeros.
    pub const ZERO: Self = Self([[Complex64::ZERO; N]; N]);

    /// Matrix that changes nothing.
    pub fn identity() -> Self {
        Self::ZERO.plus_diagonal(&[Complex64::ONE; N])
    }

    /// Matrix with a diagonal added.
    #[inline(always)]
    pub fn plus_diagonal(mut self, diagonal: &[Complex64; N]) -> Self {
        for (i, value) in diagonal.iter().enumerate() {
            self.0[i][i] += value;
        }
        self
    }

    /// Of a motion seen from the other end of the axle, where rotations, the second of two, change sign.
    #[inline(always)]
    pub fn mirrored(mut self) -> Self {
        if N == 2 {
            self.0[0][1] = -self.0[0][1];
            self.0[1][0] = -self.0[1][0];
        }
        self
    }

    /// Inverse matrix, by its determinant; not finite where that is zero.
    #[inline(always)]
    pub fn inverse(&self) -> Self {
        let m = &self.0;
        let mut inverse = Self::ZERO;
        if N == 1 {
            inverse.0[0][0] = m[0][0].inv();
        } else {
            let factor = (m[0][0] * m[1][1] - m[0][1] * m[1][0]).inv();
            inverse.0[0][0] = m[1][1] * factor;
            inverse.0[0][1] = -m[0][1] * factor;
            inverse.0[1][0] = -m[1][0] * factor;
            inverse.0[1][1] = m[0][0] * factor;
        }
        inverse
    }

    /// Matrix with rows and columns exchanged.
    pub fn transposed(&self) -> Self {
        Self(std::array::from_fn(|i| std::array::from_fn(|j| self.0[j][i])))
    }

    /// The symmetric matrix of which it is a rounding.
    #[inline(always)]
    pub fn symmetric(mut self) -> Self {
        if N == 2 {
            let mean = 0.5 * (self.0[0][1] + self.0[1][0]);
            (self.0[0][1], self.0[1][0]) = (mean, mean);
        }
        self
    }

    /// Number of negative eigenvalues of the real part, taken as symmetric.
    pub fn negative_eigenvalues(&self) -> usize {
        let m = &self.symmetric().0;
        if N == 1 {
            return usize::from(m[0][0].re < 0.0);
        }
        let (first, coupling, last) = (m[0][0].re, m[0][1].re, m[1][1].re);
        if first * last < coupling * coupling {
            1
        } else if first < 0.0 {
            2
        } else {
            0
        }
    }

    /// Product with a vector.
    #[inline(always)]
    pub fn apply(&self, vector: &[Complex64; N]) -> [Complex64; N] {
        std::array::from_fn(|i| (0..N).map(|j| self.0[i][j] * vector[j]).sum())
    }
}

impl<const N: usize> Add for Square<N> {
    type Output = Self;

    #[inline(always)]
    fn add(mut self, other: Self) -> Self {
        for i in 0..N {
            for j in 0..N {
                self.0[i][j] += other.0[i][j];
            }
        }
        self
    }
}

impl<const N: usize> Mul for Square<N> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let mut product = Self::ZERO;
        for i in 0..N {
            for j in 0..N {
                for k in 0..N {
                    product.0[i][j] += self.0[i][k] * other.0[k][j];
                }
            }
        }
        product
    }
}
