//! A contact among those of the loop.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use num_complex::Complex64;

use crate::contact::{ContactDerivative, MovingContact};
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
    /// How it moves across the profiles; none where it stays.
    pub moving: Option<MovingContact>,
    /// Phase between dissipation at the wheel and at a point of the rail.
    pub place_of_wear: PlaceOfWear,
    /// Law of wear.
    pub wear: EnergyWear,
}

impl Contact {
    /// Its axes as places, along, across and down.
    pub(super) fn places(&self, along: f64) -> [Place; 3] {
        Direction::ALL.map(|direction| Place {
            along,
            rail: self.rail,
            direction,
        })
    }

    /// The phase of the profile under it, relative to that under the first wheel.
    pub(super) fn phase(&self, wavenumber: f64) -> Complex64 {
        Complex64::cis(wavenumber * self.along)
    }

    /// Its profile over that of the rail under study, or that one where its own rail is smooth.
    pub(super) fn profile_or_one(&self) -> f64 {
        if self.profile == 0.0 {
            1.0
        } else {
            self.profile
        }
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

    /// Turn the rows of three axes from those of the track to those of the contact,
    /// u_t = u_y cos γ ∓ u_z sin γ and u_n = u_z cos γ ± u_y sin γ, upper sign on the right rail.
    pub(super) fn turn(&self, lateral: &mut Complex64, vertical: &mut Complex64) {
        let (sine, cosine) = match self.rail {
            Rail::Right => self.angle.sin_cos(),
            Rail::Left => (-self.angle).sin_cos(),
        };
        (*lateral, *vertical) = (
            *lateral * cosine - *vertical * sine,
            *vertical * cosine + *lateral * sine,
        );
    }

    /// `Ok` if its numbers are those of a contact, and its creep forces answer to all that moves.
    pub(super) fn check(&self) -> Result<(), Error> {
        /// Any: whether a response is told does not depend on the wavelength.
        const WAVELENGTH: f64 = 0.1;
        Error::unless_positive("stiffness of a contact", self.stiffness, "N/m")?;
        if !(0.0..FRAC_PI_2).contains(&self.angle) {
            return Err(Error::OutOfRange {
                quantity: "contact angle",
                value: self.angle,
                unit: "rad",
                rule: "must be zero or more, and less than a right angle",
            });
        }
        let held = matches!(self.motion[1], Motion::Held);
        if !held && self.rolling.response(WAVELENGTH).by_lateral.is_none() {
            return Err(Error::NoResponse {
                creepage: "lateral creepage",
            });
        }
        Ok(())
    }

    /// The derivatives of its forces and its energy at one wavelength.
    pub(super) fn derivatives(&self, wavelength: f64) -> Derivatives {
        /// What a creepage that is held does.
        const NOTHING: ContactDerivative = ContactDerivative {
            force: [Complex64::ZERO; 2],
            energy: Complex64::ZERO,
            energy_at_rail: None,
            error: None,
        };
        let response = self.rolling.response(wavelength);
        Derivatives {
            by_spin: response.by_spin.unwrap_or(NOTHING),
            by_load: response.by_load,
            by_creepage: [
                response.by_longitudinal,
                response.by_lateral.unwrap_or(NOTHING),
            ],
        }
    }
}

/// What the forces and the energy of a contact answer to at one wavelength.
#[derive(Clone, Copy)]
pub(super) struct Derivatives {
    pub(super) by_load: ContactDerivative,
    pub(super) by_creepage: [ContactDerivative; 2],
    /// Nothing where the contact does not tell it.
    pub(super) by_spin: ContactDerivative,
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
