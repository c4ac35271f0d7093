//! Receptance matrices in the axes of the contacts.

use num_complex::Complex64;
use pulp::{Scalar, Simd, bytemuck};

use crate::feedback::solve::NORMAL;
use crate::feedback::{Contact, Loop};
use crate::vector::Parts;

/// Turn a receptance matrix of all contacts from the axes of the track to those of each contact: T H Tᵀ.
pub(super) fn turn_axes(of: &Loop, matrix: &mut [Complex64]) {
    turn_lanes(Scalar, &of.contacts, bytemuck::cast_slice_mut(matrix));
}

/// Turn numbers along the axes of the track to those of a contact.
pub(super) fn turn_numbers(contact: &Contact, numbers: &mut [Complex64]) {
    turn(Scalar, contact.cosine_and_sine(), bytemuck::cast_slice_mut(numbers), [1, NORMAL]);
}

/// Turn matrices that lie in the lanes of vector registers as [`turn_axes`], to the last bit.
#[inline(always)]
pub(in crate::feedback) fn turn_lanes<S: Simd>(simd: S, contacts: &[Contact], matrix: &mut [Parts<S>]) {
    let size = 3 * contacts.len();
    for (index, contact) in contacts.iter().enumerate() {
        if contact.angle == 0.0 {
            continue;
        }
        let by = contact.cosine_and_sine().map(|part| simd.splat_f64s(part));
        let axes = [3 * index + 1, 3 * index + NORMAL];
        // Rows, then columns.
        for (step, stride) in [(size, 1), (1, size)] {
            for other in 0..size {
                turn(simd, by, matrix, axes.map(|axis| axis * step + other * stride));
            }
        }
    }
}

/// Turn a lateral and a vertical number at their places: u_t = u_y cos γ ∓ u_z sin γ and u_n = u_z cos γ ± u_y sin γ, upper sign on the
/// right rail.
#[inline(always)]
fn turn<S: Simd>(simd: S, by: [S::f64s; 2], numbers: &mut [Parts<S>], [lateral, vertical]: [usize; 2]) {
    let ([re, im], [re_down, im_down]) = (numbers[lateral], numbers[vertical]);
    numbers[lateral] = [less(simd, [re, re_down], by), less(simd, [im, im_down], by)];
    numbers[vertical] = [more(simd, [re_down, re], by), more(simd, [im_down, im], by)];
}

#[inline(always)]
fn less<S: Simd>(simd: S, [one, other]: [S::f64s; 2], [cosine, sine]: [S::f64s; 2]) -> S::f64s {
    simd.sub_f64s(simd.mul_f64s(one, cosine), simd.mul_f64s(other, sine))
}

#[inline(always)]
fn more<S: Simd>(simd: S, [one, other]: [S::f64s; 2], [cosine, sine]: [S::f64s; 2]) -> S::f64s {
    simd.add_f64s(simd.mul_f64s(one, cosine), simd.mul_f64s(other, sine))
}
