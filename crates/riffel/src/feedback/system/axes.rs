//! Receptance matrices in the axes of the contacts.

use num_complex::Complex64;

use crate::feedback::Loop;

/// Turn a receptance matrix of all contacts from the axes of the track to those of each contact: T H Tᵀ.
pub(super) fn turn_axes(of: &Loop, matrix: &mut [Complex64]) {
    let size = 3 * of.contacts.len();
    for (index, contact) in of.contacts.iter().enumerate() {
        if contact.angle == 0.0 {
            continue;
        }
        let (lateral, vertical) = (3 * index + 1, 3 * index + 2);
        let (above, below) = matrix.split_at_mut(vertical * size);
        let rows = above[lateral * size..].iter_mut().zip(&mut below[..size]);
        for (lateral, vertical) in rows {
            contact.turn(lateral, vertical);
        }
        for row in matrix.chunks_exact_mut(size) {
            let (left, right) = row.split_at_mut(vertical);
            contact.turn(&mut left[lateral], &mut right[0]);
        }
    }
}
