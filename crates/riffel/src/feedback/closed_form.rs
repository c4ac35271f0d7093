//! The loop of one wheel and one axis in closed form, the paper's.

use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;

use super::{Contact, ContactState, Loop, LoopState};
use crate::Receptance;
use crate::contact::{ContactResponse, MeanRolling};
use crate::wheelset::Motion;

/// One wheel that is held across the rail, and whose own receptances and that of the track say all.
#[derive(Clone)]
pub(crate) struct ClosedForm {
    /// Receptance of the track at the contact.
    pub(crate) track: Arc<dyn Receptance>,
    /// Receptance of the wheel at the contact.
    pub(crate) wheel: Arc<dyn Receptance>,
    /// How the surface of the wheel moves along the rail under the tangential force: its rotation.
    pub(crate) rotation: Motion,
    pub(crate) contact: Contact,
    /// The mean state of the contact.
    pub(crate) steady: MeanRolling,
    /// Amplitude Δ of the profile \[m\].
    pub(crate) amplitude: f64,
}

/// What one turn of the loop needs to reach the rail again.
struct Turn {
    track_receptance: Complex64,
    wheel_receptance: Complex64,
    normal_force: Complex64,
    response: ContactResponse,
    tangential_force: Complex64,
    creepage: Complex64,
    dissipation_at_rail: Complex64,
}

impl ClosedForm {
    /// That of a loop, if it has one.
    pub(super) fn of(feedback: &Loop) -> Option<Self> {
        let [contact] = &feedback.contacts[..] else {
            return None;
        };
        let plain = contact.angle == 0.0
            && contact.along == 0.0
            && contact.profile == 1.0
            && contact.moving.is_none()
            && matches!(contact.motion[1], Motion::Held);
        let (track, wheels) = (feedback.track.uncoupled()?, feedback.wheels.uncoupled()?);
        if !plain || track.longitudinal.is_some() {
            return None;
        }
        let rotation = match (&contact.motion[0], &wheels.longitudinal) {
            (Motion::Compliant(()), Some(rotation)) => Motion::Compliant(rotation.clone()),
            (Motion::Compliant(()), None) | (Motion::Held, _) => Motion::Held,
            (Motion::Free, _) => Motion::Free,
        };
        Some(Self {
            track: track.vertical.clone()?,
            wheel: wheels.vertical.clone()?,
            rotation,
            steady: contact.rolling.steady(),
            contact: contact.clone(),
            amplitude: feedback.amplitude,
        })
    }

    pub(super) fn at(&self, wavelength: f64, speed: f64) -> LoopState {
        let Turn {
            track_receptance,
            wheel_receptance,
            normal_force,
            response,
            tangential_force,
            creepage,
            dissipation_at_rail,
        } = self.turn(wavelength, speed);
        let angular_frequency = 2.0 * PI * speed / wavelength;
        let (by_load, by_creepage) = (response.by_load, response.by_longitudinal);
        // (14), (19)
        let energy = by_load.energy * normal_force + by_creepage.energy * creepage;
        let dissipation = energy * speed;
        let normalized = dissipation_at_rail / self.full_slip(speed); // (20)
        let along = match &self.rotation {
            Motion::Compliant(structure) => structure.receptance(angular_frequency, speed),
            Motion::Held | Motion::Free => Complex64::ZERO,
        };
        // The profile loses the depth k_w e₁/(ρ·2b) per passage, and |Δ| grows like exp(g · passages).
        let worn = self.contact.wear.depth_per_energy()
            * (self.steady.full_slip_energy_per_metre() * normalized.re);
        let growth_rate = -worn / self.amplitude;
        let diagonal = |along, normal| {
            let mut matrix = [[Complex64::ZERO; 3]; 3];
            (matrix[0][0], matrix[2][2]) = (along, normal);
            matrix
        };
        LoopState {
            wavelength,
            speed,
            angular_frequency,
            track_receptance: diagonal(Complex64::ZERO, track_receptance),
            wheel_receptance: diagonal(along, wheel_receptance),
            response,
            dissipation,
            dissipation_lag_angle: -(dissipation_at_rail / dissipation).arg(),
            dissipation_at_rail,
            normalized_dissipation: normalized,
            mean_dissipation: self.steady.energy_per_metre() * speed,
            growth_rate,
            contacts: vec![ContactState {
                force: [tangential_force, Complex64::ZERO, normal_force],
                creepage: [creepage, Complex64::ZERO],
                spin: Complex64::ZERO,
                shift: Complex64::ZERO,
                energy,
                energy_at_rail: dissipation_at_rail / speed,
                growth_rate: Some(growth_rate),
            }],
        }
    }

    /// Ŵ₁ of [`at`](Self::at) alone.
    pub(crate) fn normalized_dissipation(&self, wavelength: f64, speed: f64) -> Complex64 {
        self.turn(wavelength, speed).dissipation_at_rail / self.full_slip(speed)
    }

    /// μP₀Vξ₀ \[W\].
    fn full_slip(&self, speed: f64) -> f64 {
        self.steady.full_slip_energy_per_metre() * speed
    }

    /// Oscillation of the energy per metre left at a rail point \[J/m\] by an oscillation of one newton of the normal force.
    pub(crate) fn energy_by_normal_force(&self, wavelength: f64, speed: f64) -> Complex64 {
        let turn = self.turn(wavelength, speed);
        turn.dissipation_at_rail / (turn.normal_force * speed)
    }

    fn turn(&self, wavelength: f64, speed: f64) -> Turn {
        let angular_frequency = 2.0 * PI * speed / wavelength;
        let response = self.contact.rolling.response(wavelength);
        let (by_load, by_creepage) = (response.by_load, response.by_longitudinal);

        let track_receptance = self.track.receptance(angular_frequency, speed);
        let wheel_receptance = self.wheel.receptance(angular_frequency, speed);
        // (24)
        let normal_force =
            self.amplitude / (track_receptance + wheel_receptance + self.contact.stiffness.recip());

        // (13) and (16) for ξ₁ and Q₁, finite in both limits of the inertia: (17), (18)
        let ratio = self.rotation.ratio(angular_frequency, speed);
        let creepage = -ratio.speed / speed;
        let slip =
            by_load.force[0] * normal_force / (ratio.force - by_creepage.force[0] * creepage);
        let tangential_force = slip * ratio.force;
        let creepage = slip * creepage;

        let lag = self.contact.place_of_wear.lag(wavelength);
        let dissipation_at_rail =
            (by_load.at_rail(lag) * normal_force + by_creepage.at_rail(lag) * creepage) * speed;
        Turn {
            track_receptance,
            wheel_receptance,
            normal_force,
            response,
            tangential_force,
            creepage,
            dissipation_at_rail,
        }
    }
}
