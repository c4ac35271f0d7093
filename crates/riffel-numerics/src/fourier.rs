//! Plans of discrete Fourier transforms, which do not normalise.

use std::sync::Arc;

use realfft::RealFftPlanner;
pub use realfft::{ComplexToReal, RealToComplex};
pub use rustfft::Fft;
use rustfft::FftPlanner;

/// Plans of double precision, which share what they have in common.
///
/// What plans is generic over the precision and would be compiled anew by each crate that plans, a fifth of all code of the physics: here it is
/// compiled once.
#[derive(Default)]
pub struct Plans {
    of_complex: Option<FftPlanner<f64>>,
    of_real: Option<RealFftPlanner<f64>>,
}

impl Plans {
    /// From complex numbers to complex numbers, with e^(−i…).
    #[inline(never)]
    pub fn forward(&mut self, size: usize) -> Arc<dyn Fft<f64>> {
        self.of_complex.get_or_insert_with(FftPlanner::new).plan_fft_forward(size)
    }

    /// The way back, with e^(+i…).
    #[inline(never)]
    pub fn inverse(&mut self, size: usize) -> Arc<dyn Fft<f64>> {
        self.of_complex.get_or_insert_with(FftPlanner::new).plan_fft_inverse(size)
    }

    /// From so many real numbers to the lines that are not conjugates of others.
    #[inline(never)]
    pub fn real_forward(&mut self, count: usize) -> Arc<dyn RealToComplex<f64>> {
        self.of_real.get_or_insert_with(RealFftPlanner::new).plan_fft_forward(count)
    }

    /// The way back, to so many real numbers.
    #[inline(never)]
    pub fn real_inverse(&mut self, count: usize) -> Arc<dyn ComplexToReal<f64>> {
        self.of_real.get_or_insert_with(RealFftPlanner::new).plan_fft_inverse(count)
    }
}
