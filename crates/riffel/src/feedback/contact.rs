//! A contact among those of the loop.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use num_complex::Complex64;

use crate::contact::{ContactDerivative, ContactResponse, MovingContact, WaveGeometry};
use crate::damage::{Damage, DamageState, Mean, Oscillation};
use crate::wheelset::Motion;
use crate::{Direction, EnergyWear, Error, Place, PlaceOfWear, Rail, RollingContact};

/// A contact of a wheel with a rail.
#[derive(Clone)]
pub struct Contact {
    /// Distance along the rail \[m\]: zero for the first wheel, negative behind it. Contacts of one wheelset stand at the
    /// same distance.
    pub along: f64,
    /// The rail.
    pub rail: Rail,
    /// Contact angle γ \[rad\], 0 ≤ γ < π/2: the force of the wheel pushes the rail down and outward.
    pub angle: f64,
    /// The profile under the contact, along its normal, over the profile Δ of the rail under study: one there, on the
    /// opposite rail zero where it is smooth and −1 where it is in antiphase.
    pub profile: f64,
    /// Linearised stiffness k_H \[N/m\].
    pub stiffness: f64,
    /// Steady rolling and its linear response.
    pub rolling: Arc<dyn RollingContact>,
    /// What holds or frees the surfaces along the rail and across it: compliant where track and wheel say how they yield.
    pub motion: [Motion<()>; 2],
    /// How it moves across the profiles; `None` if it stays.
    pub moving: Option<MovingContact>,
    /// Phase between dissipation at the wheel and at a point of the rail.
    pub place_of_wear: PlaceOfWear,
    /// The geometry of the waves on its rail; `None` if that has no part in the loop.
    pub wave: Option<WaveGeometry>,
    /// Law of wear.
    pub wear: EnergyWear,
    /// Laws of damage, wear among them or not; none: wear alone.
    pub damage: Option<Arc<Damage>>,
}

impl Contact {
    /// Its axes as places, along, across and down.
    pub(super) fn places(&self, along: f64) -> [Place; 3] {
        Direction::ALL.map(|direction| Place { along, rail: self.rail, direction })
    }

    /// The phase of the profile under it, relative to that under the first wheel.
    pub(super) fn phase(&self, wavenumber: f64) -> Complex64 {
        Complex64::cis(wavenumber * self.along)
    }

    /// Its profile over that of the rail under study, or that one where its own rail is smooth.
    pub(super) fn profile_or_one(&self) -> f64 {
        if self.profile == 0.0 { 1.0 } else { self.profile }
    }

    /// One where the unknown of an axis is a force, zero where it is a creepage.
    pub(super) fn force_share(&self, axis: usize) -> f64 {
        match self.motion.get(axis) {
            Some(Motion::Free) => 0.0,
            _ => 1.0,
        }
    }

    /// What a shift of the contact on the wheel does, per metre to the right; nothing where the contact stays.
    pub(super) fn by_shift(&self) -> ByShift {
        let Some(moving) = self.moving else {
            return ByShift::default();
        };
        let effects = moving.effects;
        let on = |effect: bool, value: f64| if effect { value } else { 0.0 };
        let radius = moving.rolling_radius;
        let turn = moving.profiles.wheel_curvature();
        // A wheel that turns freely takes any radius.
        let turns = !matches!(self.motion[0], Motion::Free);
        let by_radius = self.rail.sign() * self.angle.sin() / radius;
        let steady = self.rolling.steady();
        ByShift {
            creepage: on(effects.rolling_radius && turns, by_radius),
            spin: on(effects.spin, self.angle.cos() * turn / radius),
            lateral_force: on(effects.contact_angle, -steady.normal_force * turn),
            normal_force: on(effects.contact_angle, steady.forces.lateral * turn),
        }
    }

    /// Whether its lateral displacement moves it: that of a contact which is held or free across the rail is not known.
    pub(super) fn shifts_with_displacement(&self) -> bool {
        matches!(self.motion[1], Motion::Compliant(()))
    }

    /// Whether the rail rolls under it, and with it.
    pub(super) fn rolls(&self) -> bool {
        self.moving.is_some_and(|moving| moving.effects.rail_roll)
    }

    /// cos γ and ± sin γ of the contact angle, upper sign on the right rail.
    pub(super) fn cosine_and_sine(&self) -> [f64; 2] {
        let (sine, cosine) = match self.rail {
            Rail::Right => self.angle.sin_cos(),
            Rail::Left => (-self.angle).sin_cos(),
        };
        [cosine, sine]
    }

    /// `Ok` if its numbers are those of a contact, and its creep forces answer to all that moves.
    pub(super) fn check(&self) -> Result<(), Error> {
        /// Any: whether a response is told does not depend on the wavelength.
        const WAVELENGTH: f64 = 0.1;
        Error::unless_positive("stiffness of a contact", self.stiffness, "N/m")?;
        if self.angle.is_nan() || self.angle.abs() >= FRAC_PI_2 {
            return Err(Error::OutOfRange {
                quantity: "contact angle",
                value: self.angle,
                unit: "rad",
                rule: "must be less than a right angle, to either side",
            });
        }
        let held = matches!(self.motion[1], Motion::Held);
        if !held && self.rolling.response(WAVELENGTH).by_lateral.is_none() {
            return Err(Error::NoResponse { creepage: "lateral creepage" });
        }
        if self.wave.is_some() && self.rolling.response(WAVELENGTH).by_curvature.is_none() {
            return Err(Error::NoResponse { creepage: "the curvature of a wave" });
        }
        Ok(())
    }

    /// What the geometry of a wave \[m\] of a profile \[m\] does under it.
    pub(super) fn wave_state(&self, wavelength: f64, profile: Complex64) -> Option<WaveState> {
        let wave = self.wave.as_ref()?;
        let wavenumber = 2.0 * PI / wavelength;
        let curvature = wave.curvature(wavenumber);
        let creepages = self.rolling.steady().creepages;
        let by = |creepage: f64| curvature * creepage * profile;
        Some(WaveState {
            curvature_per_metre: curvature,
            share: wave.share(wavenumber),
            creepage: [by(creepages.longitudinal), by(creepages.lateral)],
            spin: by(creepages.spin),
        })
    }

    /// The derivatives of its forces and its energy at one wavelength.
    pub(crate) fn derivatives(&self, wavelength: f64) -> Derivatives {
        self.derivatives_of(&self.rolling.response(wavelength), wavelength)
    }

    /// Derivatives of a response that is known.
    pub(super) fn derivatives_of(&self, response: &ContactResponse, wavelength: f64) -> Derivatives {
        let lag = self.place_of_wear.lag(wavelength);
        let wavenumber = 2.0 * PI / wavelength;
        let (mut pressed, mut later) = (1.0, Complex64::cis(-lag));
        if let Some(wave) = &self.wave {
            pressed = wave.pressed(wavenumber);
            if wave.is_sliding() {
                later = pressed.into();
            }
        }
        let of = |by: ContactDerivative| Derivative {
            force: by.force,
            energy: by.energy,
            at_rail: by.energy_at_rail.unwrap_or_else(|| by.energy * later),
            ..Derivative::default()
        };
        let on = |by: Option<ContactDerivative>| by.map_or(Derivative::default(), of);
        let by_profile = match (&self.wave, response.by_curvature) {
            (Some(wave), Some(by)) => {
                let curvature = wave.curvature(wavenumber);
                let later = match wave.is_sliding() {
                    true => Complex64::ONE,
                    false => later_of_wave(lag),
                };
                Derivative {
                    force: by.force.map(|force| force * curvature),
                    energy: by.energy * curvature,
                    at_rail: by.energy_at_rail.unwrap_or_else(|| by.energy * later) * curvature,
                    ..Derivative::default()
                }
            }
            _ => Derivative::default(),
        };
        let mut derivatives = Derivatives {
            by_load: of(response.by_load),
            by_creepage: [of(response.by_longitudinal), on(response.by_lateral)],
            by_spin: on(response.by_spin),
            by_profile,
            pressed,
        };
        derivatives.each(|by| by.dissipated = by.at_rail);
        if let Some(regime) = self.wear.regime() {
            derivatives.each(|by| by.at_rail *= regime.by_energy);
            // All of the wear comes to the rail point as the dissipation does.
            derivatives.by_load.at_rail += regime.by_load * later;
            if let Some(wave) = &self.wave {
                let patch = wave.patch_curvature(wavenumber);
                let later = if wave.is_sliding() { 1.0.into() } else { later };
                derivatives.by_profile.at_rail += regime.by_curvature * patch * later;
            }
        }
        self.damage_derivatives(&mut derivatives, wavenumber);
        derivatives
    }

    /// What damages, beside what wears.
    fn damage_derivatives(&self, derivatives: &mut Derivatives, wavenumber: f64) {
        let Some(damage) = &self.damage else {
            return derivatives.each(|by| by.growth = by.at_rail);
        };
        let wears = f64::from(damage.wears());
        derivatives.each(|by| {
            by.growth = wears * by.at_rail;
            by.demand = damage.demand.oscillation([by.force[0], by.force[1], Complex64::ZERO]);
        });
        if let Some(wave) = &self.wave {
            let patch = wave.patch_curvature(wavenumber);
            derivatives.by_profile.demand += damage.demand.by_curvature * patch;
        }
        let by_load = &mut derivatives.by_load;
        by_load.demand += damage.demand.by_load;
        by_load.growth += damage.depth_per_force() / self.wear.depth_per_energy();
    }

    /// The mean of what its laws of damage take.
    pub(crate) fn mean_of_damage(&self) -> Mean {
        Mean { energy: self.rolling.steady().energy_per_metre(), wear: self.wear.depth_per_energy() }
    }

    /// What its laws of damage say of an oscillation.
    pub(super) fn damage_state(
        &self,
        at: &Oscillation,
        force: [Complex64; 3],
        profile: Complex64,
    ) -> Option<DamageState> {
        let load = self.rolling.steady().normal_force;
        let damage = self.damage.as_ref()?;
        // On a smooth rail the wave is that of the other one.
        let wave = self.wave.as_ref().filter(|_| self.profile != 0.0);
        let curvature = wave.map_or(0.0, |wave| wave.patch_curvature(at.wavenumber)) * profile;
        Some(damage.state(self.mean_of_damage(), load, at, force, curvature, profile))
    }

    /// Its laws of damage, where the rate of one of them depends on the amplitude.
    pub(crate) fn clipped_damage(&self) -> Option<&Damage> {
        let damage = self.damage.as_deref();
        damage.filter(|damage| damage.depends_on_amplitude())
    }
}

/// Where the energy of a wave's own geometry comes to a point of the rail, at an angle of the place of wear \[rad\].
pub(crate) fn later_of_wave(lag: f64) -> Complex64 {
    /// Share of the angle that the energy lags by at constant slip speed, fitted to transient half-spaces.
    const SHARE: f64 = 0.75;
    Complex64::new(1.0, SHARE * lag).inv()
}

/// What the wave's own geometry does at a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WaveState {
    /// κ/Δ \[1/m\].
    pub curvature_per_metre: f64,
    /// Φ \[-\].
    pub share: f64,
    /// c₀κ \[-\], along and across the rail: what it adds to the creepage.
    pub creepage: [Complex64; 2],
    /// c₀κ of the spin \[1/m\].
    pub spin: Complex64,
}

/// What forces and energies do under one input.
#[derive(Clone, Copy, Default)]
pub(crate) struct Derivative {
    /// Creep force along and across the rail.
    pub(crate) force: [Complex64; 2],
    /// Energy left on a metre of rail at the wheel.
    pub(crate) energy: Complex64,
    /// Energy left at a point of the rail, as the law of wear takes it.
    pub(crate) at_rail: Complex64,
    /// Energy left at a point of the rail, as it is dissipated.
    pub(crate) dissipated: Complex64,
    /// Energy at a point of the rail that wears as much as all damages whose rate does not depend on the amplitude.
    pub(crate) growth: Complex64,
    /// The demand u.
    pub(crate) demand: Complex64,
}

/// What the forces and the energy of a contact answer to at one wavelength; nothing where it does not tell it.
#[derive(Clone, Copy)]
pub(crate) struct Derivatives {
    pub(crate) by_load: Derivative,
    pub(crate) by_creepage: [Derivative; 2],
    pub(crate) by_spin: Derivative,
    /// By the profile under the contact \[m\], at constant load and slip speed.
    pub(crate) by_profile: Derivative,
    /// The share of the profile that presses.
    pub(crate) pressed: f64,
}

impl Derivatives {
    /// Change each.
    fn each(&mut self, mut change: impl FnMut(&mut Derivative)) {
        change(&mut self.by_load);
        self.by_creepage.iter_mut().for_each(&mut change);
        change(&mut self.by_spin);
        change(&mut self.by_profile);
    }
}

/// What a shift of the contact on the wheel does, per metre to the right.
#[derive(Clone, Copy, Default)]
pub(super) struct ByShift {
    /// Longitudinal creepage \[1/m\].
    pub(super) creepage: f64,
    /// Spin \[1/m²\].
    pub(super) spin: f64,
    /// Force on the rail along the plane of the mean state \[N/m\], beside the creep force.
    pub(super) lateral_force: f64,
    /// Force on the rail along its normal \[N/m\], beside the normal force.
    pub(super) normal_force: f64,
}
