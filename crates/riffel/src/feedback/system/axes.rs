//! Receptance matrices in the axes of the contacts.

use num_complex::Complex64;
use pulp::Simd;

use crate::feedback::{Contact, Loop};
use crate::vector::Parts;

/// Turn a receptance matrix of all contacts from the axes of the track to those of each contact: T H Tᵀ.
pub(super) fn turn_axes(of: &Loop, matrix: &mut [Complex64]) {
    let size = 3 * of.contacts.len();
    for (index, contact) in of.contacts.iter().enumerate() {
        if contact.angle == 0.0 {
            continue;
        }
        let turn = contact.turning();
        let (lateral, vertical) = (3 * index + 1, 3 * index + 2);
        let (above, below) = matrix.split_at_mut(vertical * size);
        let rows = above[lateral * size..].iter_mut().zip(&mut below[..size]);
        for (lateral, vertical) in rows {
            turn(lateral, vertical);
        }
        for row in matrix.chunks_exact_mut(size) {
            let (left, right) = row.split_at_mut(vertical);
            turn(&mut left[lateral], &mut right[0]);
        }
    }
}

/// [`turn_axes`] of matrices that lie in the lanes of vector registers, to the last bit.
#[inline(always)]
pub(in crate::feedback) fn turn_lanes<S: Simd>(simd: S, contacts: &[Contact], matrix: &mut [Parts<S>]) {
    let size = 3 * contacts.len();
    for (index, contact) in contacts.iter().enumerate() {
        if contact.angle == 0.0 {
            continue;
        }
        let (sine, cosine) = contact.sine_and_cosine();
        let by = [simd.splat_f64s(cosine), simd.splat_f64s(sine)];
        let (lateral, vertical) = (3 * index + 1, 3 * index + 2);
        // Rows, then columns.
        for (step, stride) in [(size, 1), (1, size)] {
            for other in 0..size {
                let [first, second] = [lateral, vertical].map(|axis| axis * step + other * stride);
                let ([re, im], [re_down, im_down]) = (matrix[first], matrix[second]);
                matrix[first] = [less(simd, [re, re_down], by), less(simd, [im, im_down], by)];
                matrix[second] = [more(simd, [re_down, re], by), more(simd, [im_down, im], by)];
            }
        }
    }
}

#[inline(always)]
fn less<S: Simd>(simd: S, [one, other]: [S::f64s; 2], [cosine, sine]: [S::f64s; 2]) -> S::f64s {
    simd.sub_f64s(simd.mul_f64s(one, cosine), simd.mul_f64s(other, sine))
}

#[inline(always)]
fn more<S: Simd>(simd: S, [one, other]: [S::f64s; 2], [cosine, sine]: [S::f64s; 2]) -> S::f64s {
    simd.add_f64s(simd.mul_f64s(one, cosine), simd.mul_f64s(other, sine))
}
