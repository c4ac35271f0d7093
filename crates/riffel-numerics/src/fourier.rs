//! Plans of discrete Fourier transforms, which do not normalise.

use std::sync::Arc;

use realfft::RealFftPlanner;
pub use realfft::{ComplexToReal, RealToComplex};
pub use rustfft::Fft;
use rustfft::FftPlanner;

/// Plans of double precision, which share what they have in common.
///
/// Planning is generic over the precision: each crate that plans compiles rustfft anew, a fifth of all code of the physics.
#[derive(Default)]
pub struct Plans {
    of_complex: Option<FftPlanner<f64>>,
    of_real: Option<RealFftPlanner<f64>>,
}

impl Plans {
    /// Plan of Zₖ = Σ zⱼ e^(−2πi jk/size).
    #[inline(never)]
    pub fn forward(&mut self, size: usize) -> Arc<dyn Fft<f64>> {
        self.of_complex.get_or_insert_with(FftPlanner::new).plan_fft_forward(size)
    }

    /// Plan of zⱼ = Σ Zₖ e^(2πi jk/size).
    #[inline(never)]
    pub fn inverse(&mut self, size: usize) -> Arc<dyn Fft<f64>> {
        self.of_complex.get_or_insert_with(FftPlanner::new).plan_fft_inverse(size)
    }

    /// Plan of the first count/2 + 1 lines of `count` real numbers; the others are their conjugates.
    #[inline(never)]
    pub fn real_forward(&mut self, count: usize) -> Arc<dyn RealToComplex<f64>> {
        self.of_real.get_or_insert_with(RealFftPlanner::new).plan_fft_forward(count)
    }

    /// Plan of `count` real numbers from these lines.
    #[inline(never)]
    pub fn real_inverse(&mut self, count: usize) -> Arc<dyn ComplexToReal<f64>> {
        self.of_real.get_or_insert_with(RealFftPlanner::new).plan_fft_inverse(count)
    }
}
