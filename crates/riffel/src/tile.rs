//! Complex numbers with their parts apart.

use num_complex::Complex64;

/// How many wavelengths of a row are worked on at a time: what they read and write stays in the
/// first-level cache.
pub const TILE: usize = 64;

/// Real numbers of one tile.
pub type Tile = [f64; TILE];

/// A tile of complex numbers as two tiles of real ones, which vector instructions read without
/// shuffling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SplitComplex {
    /// Real parts.
    pub re: Tile,
    /// Imaginary parts.
    pub im: Tile,
}

impl SplitComplex {
    /// Zeros.
    pub const ZERO: Self = Self { re: [0.0; TILE], im: [0.0; TILE] };

    /// A tile with a function of the place.
    pub fn from_fn(value: impl Fn(usize) -> Complex64) -> Self {
        let values: [Complex64; TILE] = std::array::from_fn(value);
        Self { re: values.map(|value| value.re), im: values.map(|value| value.im) }
    }

    /// Set every number to a function of the real number in the same place.
    #[inline]
    pub fn set(&mut self, arguments: &Tile, value: impl Fn(f64) -> Complex64) {
        for ((re, im), &argument) in self.re.iter_mut().zip(&mut self.im).zip(arguments) {
            let value = value(argument);
            (*re, *im) = (value.re, value.im);
        }
    }

    /// The numbers with their parts together.
    #[inline]
    pub fn joined(&self) -> [Complex64; TILE] {
        std::array::from_fn(|j| Complex64::new(self.re[j], self.im[j]))
    }
}

/// A tile of angular frequencies with their reciprocals, which a map has for nothing and which spare
/// the simplest structures a division.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frequencies {
    /// ω \[rad/s\].
    pub angular: Tile,
    /// 1/ω \[s/rad\].
    pub reciprocal: Tile,
}
