//! The Fourier series of values around a ring.

use num_complex::Complex64;
use riffel_numerics::fourier::Plans;

/// Coefficients of the Fourier series, not scaled.
pub(super) fn spectrum(values: &[f64]) -> Vec<Complex64> {
    let transform = Plans::default().real_forward(values.len());
    let mut values = values.to_vec();
    let mut waves = transform.make_output_vec();
    // Lengths are those of the plan.
    let _ = transform.process(&mut values, &mut waves);
    waves
}

/// The values of a series.
pub(super) fn series(mut waves: Vec<Complex64>, count: usize) -> Vec<f64> {
    let transform = Plans::default().real_inverse(count);
    let mut values = transform.make_output_vec();
    if count.is_multiple_of(2)
        && let Some(last) = waves.last_mut()
    {
        last.im = 0.0;
    }
    let _ = transform.process(&mut waves, &mut values);
    values.iter().map(|value| value / count as f64).collect()
}
