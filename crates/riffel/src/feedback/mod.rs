//! The loop that corrugation closes: profile, normal force, creepage, dissipation, wear, profile.

mod answers;
mod at_speeds;
mod closed_form;
mod contact;
mod continued_fraction;
mod determinant;
mod line_group;
mod linear;
mod normal_direction;
mod one_wheel;
mod solve;
mod stability;
mod state;
mod system;

use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;

use crate::cancel::check;
use crate::contact::MeanRolling;
use crate::damage::Damage;
use crate::receptance::Structure;
use crate::wheelset::Motion;
use crate::{Error, Rail};

pub(crate) use answers::Answers;
pub(crate) use at_speeds::AtSpeeds;
pub(crate) use closed_form::ClosedForm;
pub use contact::{Contact, WaveState};
pub(crate) use contact::{Derivative, Derivatives, later_of_wave};
pub(crate) use line_group::LineGroup;
pub use normal_direction::NormalDirection;
pub use one_wheel::OneWheel;
pub use stability::{Stability, UnstableRoot};
pub use state::{ContactState, LoopState};
pub(crate) use system::System;

/// The loop, linear in the amplitude Δ of the profile: any number of contacts on all axes.
///
/// ```text
///  profile Δ e^{iωt} ──► vertical dynamics ──► P₁ ──┐
///    ▲                                              ├─► rolling contact ──► Q₁, e₁ ──► wear
///    │                    wheel rotation ◄── Q₁ ────┘        ▲                          │
///    │                          └───────── creepage ξ₁ ──────┘                          │
///    └──────────────────────── growth rate per passage ◄────────────────────────────────┘
/// ```
/// ω = 2πV/λ. For each contact, with the forces f = (Q_x, Q_t, P) of the wheel on the rail in the axes of the contact, and H the
/// receptance of track and wheels together, over all contacts:
///
/// ```text
/// normal    P₁/k_H = Δ p − (H f₁)_n                   p = e^{ikx} of the place, times the profile of its rail
/// creepage  V ξ₁ = −iω (H f₁)_{x,t}                   with what the direction of P₀ adds, see [`NormalDirection`]
/// creep     Q₁ = F_P P₁ + F_ξ ξ₁ + F_κ κ
/// energy    e₁ = e_P P₁ + e_ξ ξ₁ + e_κ κ                κ = R k²Φ Δ p, where the wave's own geometry has a part
/// growth    g = −k_w/(ρ 2b) · Re(e₁ at the rail point / p)/Δ per passage of the wheel
/// ```
///
/// Axes of a contact: x in the direction of travel, n normal to the plane of contact and into the rail, t in that plane
/// and to the right; under a contact angle γ, below zero where a hollow wheel is inclined the other way, n = (0, ± sin γ, cos γ) and t = (0, cos γ, ∓ sin γ) in those of the track,
/// upper sign on the right rail. A held axis has no ξ₁; on a free one Q₁ vanishes and ξ₁ takes its place among the
/// unknowns.
///
/// Where the loop is unstable without any profile (see [`stability`](Self::stability)) its growth rates mean
/// nothing.
///
/// Method: 3n complex linear equations by elimination with row pivots, in a map for as many wavelengths at once as a vector
/// register holds. Cost: O(27n³) and the receptance matrices of n contacts a point. The loop of one wheel that is held across an even
/// rail and only moves down and turns, the paper's, is solved in closed form and agrees to rounding (test
/// `one_wheel_and_one_axis_is_the_closed_form`).
#[derive(Clone)]
pub struct Loop {
    track: Arc<dyn Structure>,
    wheels: Arc<dyn Structure>,
    contacts: Vec<Contact>,
    position: f64,
    comb: Comb,
    amplitude: f64,
    /// How hubs move where the normal force turns with the wave.
    normal_direction: Option<NormalDirection>,
    /// The closed form, if the loop has one.
    closed: Option<Arc<ClosedForm>>,
}

/// How the interference of several wheels is read: over the wavelength it is a comb of the step λ²/l for wheels at the
/// distance l, finer than any wear pattern resolves whose wavelength or wheelbase varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Comb {
    /// Interference at its full resolution: every wheel meets the profile at the phase of its place.
    #[default]
    Resolved,
    /// Its mean over the phase: each wheelset is excited by the profile under itself alone, with all others on the rail.
    Mean,
}

impl Loop {
    /// The loop of a track, the wheels with all that connects them, and their contacts, for a profile of amplitude Δ
    /// \[m\]. The first contact is that of the first wheel on the rail under study, which has the profile one.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] without contacts, for two at one place, a contact angle outside −π/2 < γ < π/2, a stiffness or
    /// an amplitude not above zero; [`Error::NoResponse`] where a contact moves across the rail and does not tell its
    /// response to lateral creepage.
    pub fn new(
        track: Arc<dyn Structure>,
        wheels: Arc<dyn Structure>,
        contacts: Vec<Contact>,
        amplitude: f64,
    ) -> Result<Self, Error> {
        let range = |quantity, value, unit, rule| Error::OutOfRange { quantity, value, unit, rule };
        Error::unless_positive("number of contacts", contacts.len() as f64, "")?;
        Error::unless_positive("amplitude", amplitude, "m")?;
        for (index, contact) in contacts.iter().enumerate() {
            contact.check()?;
            let there = |other: &Contact| (other.along, other.rail) == (contact.along, contact.rail);
            if contacts[..index].iter().any(there) {
                let rule = "must differ from that of every other wheel on its rail";
                return Err(range("place of a wheel", contact.along, "m", rule));
            }
        }
        let comb = Comb::default();
        Ok(Self { track, wheels, contacts, position: 0.0, comb, amplitude, normal_direction: None, closed: None }
            .decided())
    }

    /// The loop with its closed form found again, after a change of what that contains.
    fn decided(self) -> Self {
        let closed = ClosedForm::of(&self).map(Arc::new);
        Self { closed, ..self }
    }

    /// The loop with its first wheel at another place of the track \[m\], counted from a support where there are some.
    pub fn at_position(mut self, position: f64) -> Self {
        self.position = position;
        self
    }

    /// The loop with another reading of the interference of several wheels.
    pub fn with_comb(mut self, comb: Comb) -> Self {
        self.comb = comb;
        self
    }

    /// The loop in which the normal forces turn with the slope of the wave, see [`NormalDirection`]; it counts where a wheel yields along the rail.
    pub fn with_normal_direction(self, normal_direction: NormalDirection) -> Self {
        Self { normal_direction: Some(normal_direction), ..self }.decided()
    }

    /// Loop with normal forces that stay upright, on hubs that move.
    pub fn without_normal_direction(self) -> Self {
        Self { normal_direction: None, ..self }.decided()
    }

    /// How hubs move where normal forces turn with the wave.
    pub fn normal_direction(&self) -> Option<&NormalDirection> {
        self.normal_direction.as_ref()
    }

    /// The loop without any part of the waves' own geometry.
    pub fn without_wave_geometry(mut self) -> Self {
        for contact in &mut self.contacts {
            contact.wave = None;
        }
        self.decided()
    }

    /// The loop with laws of damage for each contact; none: wear alone.
    pub fn with_damage(mut self, of: impl Fn(&Contact) -> Option<Arc<Damage>>) -> Self {
        for contact in &mut self.contacts {
            contact.damage = of(contact);
        }
        self.decided()
    }

    /// The loop whose contacts wear so many times as much.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the factor is above zero.
    pub fn with_wear_times(mut self, factor: f64) -> Result<Self, Error> {
        Error::unless_positive("factor of wear", factor, "")?;
        for contact in &mut self.contacts {
            contact.wear = contact.wear.times(factor);
        }
        Ok(self.decided())
    }

    /// The loop without flow that hardens.
    pub(crate) fn without_flow_that_hardens(self) -> Self {
        self.with_damage(|contact| {
            let damage = contact.damage.as_ref()?;
            Some(Arc::new(damage.without_flow_that_hardens()))
        })
    }

    /// Whether the growth of a wave depends on its amplitude.
    pub fn depends_on_amplitude(&self) -> bool {
        let mut contacts = self.contacts.iter();
        contacts.any(|contact| contact.clipped_damage().is_some())
    }

    /// The loop at another amplitude Δ of the profile \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is above zero.
    pub fn with_amplitude(self, amplitude: f64) -> Result<Self, Error> {
        Error::unless_positive("amplitude", amplitude, "m")?;
        Ok(Self { amplitude, ..self }.decided())
    }

    /// The loop on another track.
    pub fn with_track(self, track: Arc<dyn Structure>) -> Self {
        Self { track, ..self }.decided()
    }

    /// The loop with other contacts on the same track and wheels.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn with_contacts(self, contacts: Vec<Contact>) -> Result<Self, Error> {
        let Self { track, wheels, position, comb, amplitude, normal_direction, .. } = self;
        let feedback = Self::new(track, wheels, contacts, amplitude)?;
        Ok(Self { normal_direction, ..feedback.at_position(position).with_comb(comb) }.decided())
    }

    /// The contacts, that of the first wheel on the rail under study first.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Amplitude Δ of the profile \[m\].
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// State of the loop at the wavelength \[m\] and speed \[m/s\], both positive. Its numbers are NaN if the
    /// equations are singular.
    pub fn at(&self, wavelength: f64, speed: f64) -> LoopState {
        if let Some(closed) = &self.closed {
            return closed.at(wavelength, speed);
        }
        check();
        let mut system = System::new(self);
        let answers = system.answers(self, &[wavelength]);
        system.solve(self, &answers, speed);
        system.take_first(self);
        let states = (0..self.contacts.len()).map(|index| system.state(self, index, wavelength));
        let contacts: Vec<ContactState> = states.collect();
        let equivalent = system.equivalent(self, wavelength, speed, 0);
        let first = contacts[0];
        let [track_receptance, wheel_receptance] = system.at_first();
        let steady = self.steady();
        let dissipation = first.energy * speed;
        let dissipation_at_rail = first.energy_at_rail * speed;
        LoopState {
            wavelength,
            speed,
            angular_frequency: 2.0 * PI * speed / wavelength,
            track_receptance,
            wheel_receptance,
            response: self.contacts[0].rolling.response(wavelength),
            dissipation,
            dissipation_lag_angle: -(dissipation_at_rail / dissipation).arg(),
            dissipation_at_rail,
            normalized_dissipation: first.energy_at_rail / steady.full_slip_energy_per_metre(),
            mean_dissipation: steady.energy_per_metre() * speed,
            growth_rate: self.growth_rate_per_dissipation() * equivalent.re,
            contacts,
        }
    }

    /// The mean state of the first contact.
    pub fn steady(&self) -> MeanRolling {
        self.contacts[0].rolling.steady()
    }

    /// The rail under study.
    pub fn rail(&self) -> Rail {
        self.contacts[0].rail
    }

    /// Whether it is that of one wheel which is held across an even rail, and only moves down and turns.
    pub fn is_along_one_axis(&self) -> bool {
        self.closed.is_some()
    }

    pub(crate) fn closed_form(&self) -> Option<&Arc<ClosedForm>> {
        self.closed.as_ref()
    }

    /// Receptance matrices of track and wheel at the first contact \[m/N\], in the axes x, y, z of the track; `None` if a wheel follows
    /// every oscillation of the tangential force, which no receptance tells.
    pub fn receptances(&self, angular_frequency: f64, speed: f64) -> Option<[[[Complex64; 3]; 3]; 2]> {
        let motion = &self.contacts[0].motion;
        let free = motion.iter().any(|motion| matches!(motion, Motion::Free));
        (!free).then(|| {
            let mut system = System::new(self);
            system.receptances(self, angular_frequency, speed);
            system.at_first()
        })
    }

    /// Receptances of track and wheel at the first contact along its normal \[m/N\].
    pub fn normal_receptances(&self, angular_frequency: f64, speed: f64) -> [Complex64; 2] {
        let mut system = System::new(self);
        system.receptances(self, angular_frequency, speed);
        system.turn_axes(self);
        system.at_first().map(|matrix| matrix[2][2])
    }

    /// Receptances H of track and wheels together between all contacts \[m/N\] in their axes x, t, n, by rows.
    pub fn contact_receptances(&self, angular_frequency: f64, speed: f64) -> Vec<Complex64> {
        let mut system = System::new(self);
        system.receptances(self, angular_frequency, speed);
        system.turn_axes(self);
        system.together()
    }

    /// Receptances of track and wheels together, and of the wheels alone, between all contacts by rows \[m/N\].
    pub(crate) fn receptances_with_those_of_wheels(&self, angular_frequency: f64, speed: f64) -> [Vec<Complex64>; 2] {
        let mut system = System::new(self);
        system.receptances(self, angular_frequency, speed);
        system.turn_axes(self);
        [system.together(), system.of_wheels().collect()]
    }

    /// Part A \[1/kg\] of the receptances of the wheels, H → −A/ω² for ω → 0, see [`Structure::free`]. Between all contacts in
    /// their axes, by rows.
    pub(crate) fn free_motion(&self) -> Vec<f64> {
        System::new(self).free_wheels(self)
    }

    /// Receptances of the hubs along the rail \[m/N\] between all contacts, by rows; `None` if normal forces stay upright.
    pub(crate) fn hub_receptances(&self, angular_frequency: f64, speed: f64) -> Option<Vec<Complex64>> {
        let (hubs, places) = (self.normal_direction.as_ref()?, self.places_of_wheels());
        let mut matrix = vec![Complex64::ZERO; places.len() * places.len()];
        hubs.between(&[angular_frequency], speed, &places, &mut matrix);
        Some(matrix)
    }

    /// Part A \[1/kg\] of the receptances of the hubs, as [`free_motion`](Self::free_motion) of those of the wheels.
    pub(crate) fn free_hubs(&self) -> Option<Vec<f64>> {
        Some(self.normal_direction.as_ref()?.free(&self.places_of_wheels()))
    }

    fn places_of_wheels(&self) -> Vec<(f64, Rail)> {
        self.contacts.iter().map(|contact| (contact.along, contact.rail)).collect()
    }

    /// Growth rate per passage for a value of Ŵ₁: g = this factor · Re Ŵ₁, negative factor.
    pub fn growth_rate_per_dissipation(&self) -> f64 {
        let first = &self.contacts[0];
        let energy = first.rolling.steady().full_slip_energy_per_metre();
        -first.wear.depth_per_energy() * energy / self.amplitude
    }

    /// What Ŵ₁ of the mean growth takes of a contact's energy at the rail point \[m/J\]: the mean is over the wheels on the
    /// rail under study.
    pub(crate) fn share_of_growth(&self, index: usize) -> f64 {
        let (first, contact) = (&self.contacts[0], &self.contacts[index]);
        if contact.rail != first.rail {
            return 0.0;
        }
        let wheels = self.contacts.iter().filter(|other| other.rail == first.rail);
        let energy = first.rolling.steady().full_slip_energy_per_metre();
        let wear = contact.wear.depth_per_energy() / first.wear.depth_per_energy();
        wear / (energy * wheels.count() as f64)
    }

    /// Growth of a wave per passage as a complex number, in the mean over the wheels on the rail under study: its real part is
    /// the growth rate of |Δ|, its imaginary part the change of the phase.
    pub fn complex_growth_rate(&self, wavelength: f64, speed: f64) -> Complex64 {
        self.growth_rate_per_dissipation() * self.normalized_dissipation()(wavelength, speed)
    }

    /// Ŵ₁ of the mean growth at a wavelength and a speed, for a search that turns the loop many times.
    pub(crate) fn normalized_dissipation(&self) -> impl Fn(f64, f64) -> Complex64 + Sync + '_ {
        move |wavelength, speed| match &self.closed {
            Some(closed) => closed.normalized_dissipation(wavelength, speed),
            None => {
                check();
                let mut system = System::new(self);
                system.solve(self, &system.answers(self, &[wavelength]), speed);
                system.equivalent(self, wavelength, speed, 0)
            }
        }
    }
}

impl From<&Loop> for Loop {
    fn from(feedback: &Loop) -> Self {
        feedback.clone()
    }
}
