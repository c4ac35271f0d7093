//! The loop that corrugation closes: profile, normal force, creepage, dissipation, wear, profile.

mod general;
mod kind;

pub(crate) use general::{Answers, System};
pub use general::{Comb, Contact, ContactState, GeneralLoop, GeneralState, Stability};
pub use kind::{Loop, State};

use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;

use crate::contact::{ContactResponse, MeanRolling};
use crate::wheelset::Motion;
use crate::{EnergyWear, PlaceOfWear, Receptance, RollingContact};

/// The joints of the loop, each of any kind.
///
/// ```text
///  profile Δ e^{iωt} ──► vertical dynamics ──► P₁ ──┐
///    ▲                                              ├─► rolling contact ──► Q₁, W₁ ──► wear
///    │                    wheel rotation ◄── Q₁ ────┘        ▲                          │
///    │                          └───────── creepage ξ₁ ──────┘                          │
///    └──────────────────────── growth rate per passage ◄────────────────────────────────┘
/// ```
/// ω = 2πV/λ. Everything is linear in the amplitude Δ of the profile.
#[derive(Clone)]
pub struct FeedbackLoop {
    /// Receptance of the track at the contact.
    pub track: Arc<dyn Receptance>,
    /// Receptance of the wheel at the contact.
    pub wheel: Arc<dyn Receptance>,
    /// Linearised stiffness of the contact k_H \[N/m\].
    pub contact_stiffness: f64,
    /// Steady rolling and its linear response.
    pub contact: Arc<dyn RollingContact>,
    /// How the surface of the wheel moves along the rail under the tangential force: its rotation.
    pub rotation: Motion,
    /// Rolling radius R \[m\], which turns angular velocity into creepage.
    pub rolling_radius: f64,
    /// Phase between dissipation at the wheel and at a point of the rail.
    pub place_of_wear: PlaceOfWear,
    /// Law of wear.
    pub wear: EnergyWear,
    /// Amplitude Δ of the profile \[m\].
    pub amplitude: f64,
}

/// One turn of the loop at one wavelength and speed: every oscillation as complex amplitude for
/// exp(+iωt), relative to a profile of real amplitude Δ, upward on the rail.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct LoopState {
    /// Wavelength λ \[m\].
    pub wavelength: f64,
    /// Speed V \[m/s\].
    pub speed: f64,
    /// Angular frequency ω = 2πV/λ \[rad/s\].
    pub angular_frequency: f64,
    /// Receptance of the track \[m/N\].
    pub track_receptance: Complex64,
    /// Receptance of the wheel \[m/N\].
    pub wheel_receptance: Complex64,
    /// Normal force P₁ \[N\], equation (24).
    pub normal_force: Complex64,
    /// Q_P \[-\], equation (9).
    pub dq_dp: Complex64,
    /// Q_Ω \[N s/rad\], equation (10).
    pub dq_domega: Complex64,
    /// W_P \[m/s\], equation (11).
    pub dw_dp: Complex64,
    /// W_Ω \[W s/rad\], equation (12).
    pub dw_domega: Complex64,
    /// Tangential force Q₁ \[N\], equation (18).
    pub tangential_force: Complex64,
    /// Angular velocity Ω₁ \[rad/s\], equation (16).
    pub angular_velocity: Complex64,
    /// Dissipated power W₁ at the wheel centre \[W\], equation (19).
    pub dissipation: Complex64,
    /// Angle by which the dissipation at a rail point lags W₁ \[rad\].
    pub dissipation_lag_angle: f64,
    /// Dissipated power at a rail point, W₁ e^{−i·angle} \[W\].
    pub dissipation_at_rail: Complex64,
    /// Ŵ₁ = W₁/(μP₀Vξ₀) at a rail point \[-\], equation (20). Growth where its real part is negative.
    pub normalized_dissipation: Complex64,
    /// Mean dissipated power W₀ \[W\], equation (8).
    pub mean_dissipation: f64,
    /// Growth rate of |Δ| per passage of a wheel \[-\], positive where corrugation grows.
    pub growth_rate: f64,
}

/// What one turn of the loop needs to reach the rail again.
struct Turn {
    angular_frequency: f64,
    track_receptance: Complex64,
    wheel_receptance: Complex64,
    normal_force: Complex64,
    response: ContactResponse,
    tangential_force: Complex64,
    creepage: Complex64,
    dissipation_at_rail: Complex64,
}

impl FeedbackLoop {
    /// The state of the loop at the wavelength \[m\] and speed \[m/s\], both positive.
    pub fn at(&self, wavelength: f64, speed: f64) -> LoopState {
        let Turn {
            angular_frequency,
            track_receptance,
            wheel_receptance,
            normal_force,
            response,
            tangential_force,
            creepage,
            dissipation_at_rail,
        } = self.turn(wavelength, speed);
        let steady = self.contact.steady();
        let (by_load, by_creepage) = (response.by_load, response.by_longitudinal);

        // ξ₁ = −Ω₁R/V from (4) turns creepage and derivatives by it into those of angular velocity.
        let creepage_per_omega = -self.rolling_radius / speed;
        let angular_velocity = creepage / creepage_per_omega;
        let dq_domega = by_creepage.force[0] * creepage_per_omega; // (10)
        let dw_dp = by_load.energy * speed; // (11)
        let dw_domega = by_creepage.energy * creepage_per_omega * speed; // (12)
        let dissipation = dw_dp * normal_force + dw_domega * angular_velocity; // (14), (19)
        let dissipation_lag_angle = -(dissipation_at_rail / dissipation).arg();
        let normalized_dissipation =
            dissipation_at_rail / (steady.full_slip_energy_per_metre() * speed); // (20)

        LoopState {
            wavelength,
            speed,
            angular_frequency,
            track_receptance,
            wheel_receptance,
            normal_force,
            dq_dp: by_load.force[0],
            dq_domega,
            dw_dp,
            dw_domega,
            tangential_force,
            angular_velocity,
            dissipation,
            dissipation_lag_angle,
            dissipation_at_rail,
            normalized_dissipation,
            mean_dissipation: steady.energy_per_metre() * speed,
            growth_rate: self.growth_rate(&steady, normalized_dissipation),
        }
    }

    /// Ŵ₁ of [`at`](Self::at) alone, for a search that turns the loop many times; `steady` is the mean state of
    /// the contact.
    pub(crate) fn normalized_dissipation(
        &self,
        steady: &MeanRolling,
        wavelength: f64,
        speed: f64,
    ) -> Complex64 {
        self.turn(wavelength, speed).dissipation_at_rail
            / (steady.full_slip_energy_per_metre() * speed)
    }

    /// Oscillation of the energy per metre left at a rail point \[J/m\] by an oscillation of one newton of the normal force.
    pub(crate) fn energy_by_normal_force(&self, wavelength: f64, speed: f64) -> Complex64 {
        let turn = self.turn(wavelength, speed);
        turn.dissipation_at_rail / (turn.normal_force * speed)
    }

    /// Receptance between profile and normal force, H + H_w + 1/k_H \[m/N\]: the denominator of equation (24).
    pub fn vertical_receptance(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        let track = self.track.receptance(angular_frequency, speed);
        let wheel = self.wheel.receptance(angular_frequency, speed);
        track + wheel + self.contact_stiffness.recip()
    }

    fn turn(&self, wavelength: f64, speed: f64) -> Turn {
        let angular_frequency = 2.0 * PI * speed / wavelength;
        let response = self.contact.response(wavelength);
        let (by_load, by_creepage) = (response.by_load, response.by_longitudinal);

        let track_receptance = self.track.receptance(angular_frequency, speed);
        let wheel_receptance = self.wheel.receptance(angular_frequency, speed);
        // (24)
        let normal_force =
            self.amplitude / (track_receptance + wheel_receptance + self.contact_stiffness.recip());

        // (13) and (16) for ξ₁ and Q₁, finite in both limits of the inertia: (17), (18)
        let ratio = self.rotation.ratio(angular_frequency, speed);
        let creepage = -ratio.speed / speed;
        let slip =
            by_load.force[0] * normal_force / (ratio.force - by_creepage.force[0] * creepage);
        let tangential_force = slip * ratio.force;
        let creepage = slip * creepage;

        let lag = self.place_of_wear.lag(wavelength);
        let dissipation_at_rail =
            (by_load.at_rail(lag) * normal_force + by_creepage.at_rail(lag) * creepage) * speed;
        Turn {
            angular_frequency,
            track_receptance,
            wheel_receptance,
            normal_force,
            response,
            tangential_force,
            creepage,
            dissipation_at_rail,
        }
    }

    /// Growth rate per passage for a value of Ŵ₁: g = this factor · Re Ŵ₁, negative factor.
    pub fn growth_rate_per_dissipation(&self) -> f64 {
        self.growth_rate(&self.contact.steady(), Complex64::ONE)
    }

    /// Growth rate per passage \[-\] that belongs to a normalised dissipation Ŵ₁.
    ///
    /// The profile loses the depth k_w e₁/(ρ·2b) per passage, so g = −Re(k_w e₁/(ρ·2b))/Δ with
    /// e₁ = Ŵ₁ μP₀ξ₀, and |Δ| grows like exp(g · passages).
    fn growth_rate(&self, steady: &MeanRolling, normalized: Complex64) -> f64 {
        let energy = steady.full_slip_energy_per_metre() * normalized.re;
        -self.wear.depth_per_energy() * energy / self.amplitude
    }
}
