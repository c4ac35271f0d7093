//! What moves at a contact, per metre of profile.

use std::f64::consts::PI;

use num_complex::Complex64;

use crate::damage::Oscillation;
use crate::feedback::solve::NORMAL;
use crate::feedback::{Contact, Derivative, Derivatives};

/// What moves a contact.
pub(super) struct Moved {
    pub(super) force: [Complex64; 3],
    pub(super) creepage: [Complex64; 2],
    pub(super) spin: Complex64,
    pub(super) shift: Complex64,
    /// Of its place.
    pub(super) phase: Complex64,
    /// \[m\].
    pub(super) profile: Complex64,
}

impl Moved {
    /// What derivatives make of it.
    pub(super) fn sum(&self, of: &Derivatives, what: fn(&Derivative) -> Complex64) -> Complex64 {
        let inputs = [
            (&of.by_load, self.force[NORMAL]),
            (&of.by_creepage[0], self.creepage[0]),
            (&of.by_creepage[1], self.creepage[1]),
            (&of.by_spin, self.spin),
            (&of.by_profile, self.profile),
        ];
        let parts = inputs.into_iter().map(|(by, input)| what(by) * input);
        parts.fold(Complex64::ZERO, |sum, part| sum + part)
    }

    /// The wave under the contact, or that of the rail under study where its own rail is smooth \[m\].
    pub(super) fn profile_or_one(&self, contact: &Contact, amplitude: f64) -> Complex64 {
        amplitude * contact.profile_or_one() * self.phase
    }

    /// What laws of damage take.
    pub(super) fn oscillation(&self, of: &Derivatives, receptance: Complex64, wavelength: f64) -> Oscillation {
        Oscillation {
            demand: self.sum(of, |by| by.demand),
            wear: self.sum(of, |by| by.at_rail),
            energy: self.sum(of, |by| by.dissipated),
            load: self.force[NORMAL],
            receptance,
            wavenumber: 2.0 * PI / wavelength,
        }
    }
}
