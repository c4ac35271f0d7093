//! Transforms whose tables and room are made once: those of a segment take as long as the transform itself.

use std::cell::RefCell;

use num_complex::Complex64;
use riffel_numerics::fourier::Plans;

thread_local! {
    static KEPT: RefCell<(Plans, Vec<Complex64>)> = RefCell::new((Plans::default(), Vec::new()));
}

/// The least length of a transform from a number up: those of few lengths take little time, and their tables are kept.
pub(super) fn length(least: usize) -> usize {
    let sixteenth = least.next_power_of_two() / 16;
    let lengths = [9, 10, 12, 15].map(|count| count * sixteenth);
    let enough = lengths.into_iter().find(|length| *length >= least && length % 4 == 0);
    enough.unwrap_or_else(|| least.next_power_of_two())
}

/// The transform of values of a [`length`]; they are lost.
pub(super) fn forward(values: &mut [f64]) -> Vec<Complex64> {
    KEPT.with_borrow_mut(|(plans, scratch)| {
        let transform = plans.real_forward(values.len());
        let mut lines = transform.make_output_vec();
        enlarge(scratch, transform.get_scratch_len());
        // Fails only for buffers of another length.
        let done = transform.process_with_scratch(values, &mut lines, scratch);
        debug_assert!(done.is_ok());
        lines
    })
}

/// The transform of lines back to values of a [`length`]; the lines are lost.
pub(super) fn backward(lines: &mut [Complex64]) -> Vec<f64> {
    // Of the lines without a counterpart the imaginary parts are nothing but rounded.
    lines[0].im = 0.0;
    lines[lines.len() - 1].im = 0.0;
    KEPT.with_borrow_mut(|(plans, scratch)| {
        let transform = plans.real_inverse(2 * (lines.len() - 1));
        let mut values = transform.make_output_vec();
        enlarge(scratch, transform.get_scratch_len());
        let done = transform.process_with_scratch(lines, &mut values, scratch);
        debug_assert!(done.is_ok());
        values
    })
}

/// Room for the longest transform so far.
fn enlarge(scratch: &mut Vec<Complex64>, least: usize) {
    if scratch.len() < least {
        scratch.resize(least, Complex64::ZERO);
    }
}
