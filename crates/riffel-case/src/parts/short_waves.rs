//! Waves that are short beside the patch.

use riffel::HertzContact;
use riffel_keys::{Message, fixed, say};

/// Shortest wavelength in contact lengths 2a₀ at which averaging over the patch may be left out;
/// Afferrante & Ciavarella (2009), introduction, quoting Frederick (1987).
const CONTACT_FILTER_LENGTHS: f64 = 1.5;

/// Shortest wavelength \[m\] that the patch does not average out.
pub(crate) fn shortest_not_averaged(hertz: HertzContact) -> f64 {
    CONTACT_FILTER_LENGTHS * 2.0 * hertz.semi_axis_longitudinal()
}

/// That the geometry of a wave \[m\] is beyond what is known of it.
pub(crate) fn shorter_than_patch(hertz: HertzContact, wavelength: f64) -> Option<Message> {
    let shortest = 3.0 * hertz.semi_axis_longitudinal();
    (wavelength < shortest).then(|| say!(wave_shorter_than_patch, shortest = fixed(1e3 * shortest, 0)))
}
