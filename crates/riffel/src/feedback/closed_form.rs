//! The loop of one wheel and one axis in closed form, the paper's.

use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;

use super::contact::{Derivative, Derivatives};
use super::{Contact, ContactState, Loop, LoopState, NormalDirection};
use crate::Receptance;
use crate::contact::MeanRolling;
use crate::damage::Oscillation;
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
    /// How its hub moves along the rail, where the normal force turns with the wave and the wheel yields.
    pub(crate) hub: Option<Arc<dyn Receptance>>,
    /// The mean state of the contact.
    pub(crate) steady: MeanRolling,
    /// Amplitude Δ of the profile \[m\].
    pub(crate) amplitude: f64,
}

/// Solution of the loop at one wavelength and speed.
struct Solution {
    track_receptance: Complex64,
    wheel_receptance: Complex64,
    normal_force: Complex64,
    creep: Creep,
}

/// What a contact makes of its normal force and its profile.
struct Creep {
    tangential_force: Complex64,
    /// s₁/V \[-\], the creepage but for what the wave's own geometry makes of it.
    slip: Complex64,
    energy: Complex64,
    dissipation_at_rail: Complex64,
    /// Of [`Derivative`], energies per metre.
    worn: Complex64,
    dissipated: Complex64,
    growth: Complex64,
    demand: Complex64,
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
        let hub = match (&feedback.normal_direction, &rotation) {
            (Some(NormalDirection::OfWheelsets(_)), _) => return None,
            (Some(NormalDirection::Lone(hub)), Motion::Compliant(_)) => Some(hub.clone()),
            _ => None,
        };
        Some(Self {
            track: track.vertical.clone()?,
            wheel: wheels.vertical.clone()?,
            hub,
            rotation,
            steady: contact.rolling.steady(),
            contact: contact.clone(),
            amplitude: feedback.amplitude,
        })
    }

    pub(super) fn at(&self, wavelength: f64, speed: f64) -> LoopState {
        let response = self.contact.rolling.response(wavelength);
        let derivatives = self.contact.derivatives_of(&response, wavelength);
        let Solution { track_receptance, wheel_receptance, normal_force, creep } =
            self.solve(&derivatives, wavelength, speed);
        let angular_frequency = 2.0 * PI * speed / wavelength;
        let dissipation = creep.energy * speed; // (19)
        let dissipation_at_rail = creep.dissipation_at_rail;
        let normalized = dissipation_at_rail / self.full_slip(speed); // (20)
        let wave = self.contact.wave_state(wavelength, self.amplitude.into());
        let creepage = wave.map_or(creep.slip, |wave| creep.slip + wave.creepage[0]);
        let along = match &self.rotation {
            Motion::Compliant(structure) => structure.receptance(angular_frequency, speed),
            Motion::Held | Motion::Free => Complex64::ZERO,
        };
        let oscillation = self.oscillation(&creep, normal_force, track_receptance, wavelength);
        let force = [creep.tangential_force, Complex64::ZERO, normal_force];
        let damage = self.contact.damage_state(&oscillation, force, self.amplitude.into());
        let growth_rate = match &damage {
            Some(damage) => damage.growth().re,
            None => self.growth_rate(normalized),
        };
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
                force,
                creepage: [creepage, Complex64::ZERO],
                spin: Complex64::ZERO,
                shift: Complex64::ZERO,
                energy: creep.energy,
                energy_at_rail: dissipation_at_rail / speed,
                growth_rate: Some(growth_rate),
                wave,
                slip_by_direction: (self.hub.as_ref())
                    .map(|_| self.slip_by_direction(wavelength, speed) * self.amplitude),
                damage,
            }],
        }
    }

    /// Growth rate per passage of Ŵ₁: the profile loses the depth k_w e₁/(ρ·2b), and |Δ| grows like exp(g · passages).
    pub(crate) fn growth_rate(&self, dissipation: Complex64) -> f64 {
        let worn = self.contact.wear.depth_per_energy() * (self.steady.full_slip_energy_per_metre() * dissipation.re);
        -worn / self.amplitude
    }

    /// Ŵ₁ of [`at`](Self::at) alone.
    pub(crate) fn normalized_dissipation(&self, wavelength: f64, speed: f64) -> Complex64 {
        let derivatives = self.contact.derivatives(wavelength);
        self.dissipation_and_force(&derivatives, wavelength, speed).0
    }

    /// Ŵ₁ and P₁ \[N\] of [`at`](Self::at) alone, of the derivatives of the contact at the wavelength.
    pub(crate) fn dissipation_and_force(
        &self,
        derivatives: &Derivatives,
        wavelength: f64,
        speed: f64,
    ) -> (Complex64, Complex64) {
        let solution = self.solve(derivatives, wavelength, speed);
        let Some(damage) = self.contact.clipped_damage() else {
            let dissipation = solution.creep.growth * speed / self.full_slip(speed);
            return (dissipation, solution.normal_force);
        };
        let receptance = solution.track_receptance;
        let at = self.oscillation(&solution.creep, solution.normal_force, receptance, wavelength);
        let clipped = damage.clipped(self.contact.mean_of_damage(), &at);
        let equivalent = solution.creep.growth + clipped / self.contact.wear.depth_per_energy();
        let dissipation = equivalent / self.steady.full_slip_energy_per_metre();
        (dissipation, solution.normal_force)
    }

    /// What laws of damage take.
    fn oscillation(&self, creep: &Creep, load: Complex64, receptance: Complex64, wavelength: f64) -> Oscillation {
        Oscillation {
            demand: creep.demand,
            wear: creep.worn,
            energy: creep.dissipated,
            load,
            receptance,
            wavenumber: 2.0 * PI / wavelength,
        }
    }

    /// The share of a profile of the wavenumber \[rad/m\] that presses.
    pub(crate) fn pressed(&self, wavenumber: f64) -> f64 {
        let wave = self.contact.wave.as_ref();
        wave.map_or(1.0, |wave| wave.pressed(wavenumber))
    }

    /// μP₀Vξ₀ \[W\].
    fn full_slip(&self, speed: f64) -> f64 {
        self.steady.full_slip_energy_per_metre() * speed
    }

    /// Oscillation of the energy per metre left at a rail point \[J/m\] by one newton of the normal force, and by a metre of
    /// the profile under a constant one.
    pub(crate) fn energy_by_normal_force_and_profile(&self, wavelength: f64, speed: f64) -> [Complex64; 2] {
        let derivatives = self.contact.derivatives(wavelength);
        let force = self.solve(&derivatives, wavelength, speed).normal_force;
        let by_force = self.creep(&derivatives, [force, Complex64::ZERO], wavelength, speed);
        let inputs = [Complex64::ZERO, Complex64::ONE];
        let by_profile = self.creep(&derivatives, inputs, wavelength, speed);
        [by_force.dissipation_at_rail / (force * speed), by_profile.dissipation_at_rail / speed]
    }

    fn solve(&self, derivatives: &Derivatives, wavelength: f64, speed: f64) -> Solution {
        let angular_frequency = 2.0 * PI * speed / wavelength;
        let track_receptance = self.track.receptance(angular_frequency, speed);
        let wheel_receptance = self.wheel.receptance(angular_frequency, speed);
        // (24)
        let normal_force = self.amplitude * derivatives.pressed
            / (track_receptance + wheel_receptance + self.contact.stiffness.recip());
        let inputs = [normal_force, self.amplitude.into()];
        Solution {
            track_receptance,
            wheel_receptance,
            normal_force,
            creep: self.creep(derivatives, inputs, wavelength, speed),
        }
    }

    /// s₁/V that the direction of the normal force makes of a metre of the profile, k²T P₀ \[1/m\], see [`NormalDirection`].
    fn slip_by_direction(&self, wavelength: f64, speed: f64) -> Complex64 {
        let Some(hub) = &self.hub else {
            return Complex64::ZERO;
        };
        let wavenumber = 2.0 * PI / wavelength;
        let load = wavenumber * wavenumber * self.steady.normal_force;
        load * hub.receptance(wavenumber * speed, speed)
    }

    /// What a normal force \[N\] and a profile \[m\] do.
    fn creep(
        &self,
        derivatives: &Derivatives,
        [normal_force, profile]: [Complex64; 2],
        wavelength: f64,
        speed: f64,
    ) -> Creep {
        let Derivatives { by_load, by_creepage: [by_creepage, _], by_profile, .. } = derivatives;
        // (13) and (16) for s₁/V and Q₁, finite in both limits of the inertia: (17), (18)
        let ratio = self.rotation.ratio(2.0 * PI * speed / wavelength, speed);
        let slip = -ratio.speed / speed;
        let of_direction = self.slip_by_direction(wavelength, speed) * profile;
        let force =
            by_load.force[0] * normal_force + by_profile.force[0] * profile + by_creepage.force[0] * of_direction;
        let share = force / (ratio.force - by_creepage.force[0] * slip);
        let slip = share * slip + of_direction;
        let energy = |of: fn(&Derivative) -> Complex64| {
            of(by_load) * normal_force + of(by_creepage) * slip + of(by_profile) * profile
        };
        Creep {
            tangential_force: share * ratio.force,
            slip,
            energy: energy(|by| by.energy), // (14)
            dissipation_at_rail: energy(|by| by.at_rail) * speed,
            worn: energy(|by| by.at_rail),
            dissipated: energy(|by| by.dissipated),
            growth: energy(|by| by.growth),
            demand: energy(|by| by.demand),
        }
    }
}
