//! The joints of the loop of one wheel along one axis.

use std::sync::Arc;

use super::{Contact, Loop};
use crate::contact::WaveGeometry;
use crate::receptance::Uncoupled;
use crate::wheelset::Motion;
use crate::{EnergyWear, Error, PlaceOfWear, Rail, Receptance, RollingContact};

/// One wheel, whose loop along one axis is that of Afferrante and Ciavarella (2009).
#[derive(Clone)]
pub struct OneWheel {
    /// Receptance of the track at the contact, downward.
    pub track: Arc<dyn Receptance>,
    /// Receptance of the wheel at the contact, downward.
    pub wheel: Arc<dyn Receptance>,
    /// How the surface of the wheel moves along the rail under the tangential force: its rotation.
    pub rotation: Motion,
    /// Linearised stiffness of the contact k_H \[N/m\].
    pub contact_stiffness: f64,
    /// Steady rolling and its linear response.
    pub contact: Arc<dyn RollingContact>,
    /// Phase between dissipation at the wheel and at a point of the rail.
    pub place_of_wear: PlaceOfWear,
    /// The geometry of the waves on the rail; `None` if that has no part in the loop.
    pub wave: Option<WaveGeometry>,
    /// Law of wear.
    pub wear: EnergyWear,
    /// Amplitude Δ of the profile \[m\].
    pub amplitude: f64,
}

impl Loop {
    /// The loop of one wheel [along one axis](Self::is_along_one_axis) with another rotation of it; any other as it is.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn with_rotation(self, rotation: Motion) -> Result<Self, Error> {
        let Some(closed) = self.closed_form() else {
            return Ok(self);
        };
        let contact = closed.contact.clone();
        let turned = OneWheel {
            track: closed.track.clone(),
            wheel: closed.wheel.clone(),
            rotation,
            contact_stiffness: contact.stiffness,
            contact: contact.rolling,
            place_of_wear: contact.place_of_wear,
            wave: contact.wave,
            wear: contact.wear,
            amplitude: closed.amplitude,
        };
        let turned = Self { normal_direction: self.normal_direction, ..turned.close()? };
        Ok(turned.with_damage(|_| contact.damage.clone()))
    }
}

impl OneWheel {
    /// The loop closed.
    ///
    /// # Errors
    /// Errors of [`Loop::new`].
    pub fn close(self) -> Result<Loop, Error> {
        let along = match self.rotation {
            Motion::Compliant(_) => Motion::Compliant(()),
            Motion::Held => Motion::Held,
            Motion::Free => Motion::Free,
        };
        let contact = Contact {
            along: 0.0,
            rail: Rail::Right,
            angle: 0.0,
            profile: 1.0,
            stiffness: self.contact_stiffness,
            rolling: self.contact,
            motion: [along, Motion::Held],
            moving: None,
            place_of_wear: self.place_of_wear,
            wave: self.wave,
            wear: self.wear,
            damage: None,
        };
        let track = Uncoupled { vertical: Some(self.track), ..Uncoupled::default() };
        let wheel = Uncoupled {
            longitudinal: match self.rotation {
                Motion::Compliant(rotation) => Some(rotation),
                Motion::Held | Motion::Free => None,
            },
            lateral: None,
            vertical: Some(self.wheel),
        };
        Loop::new(Arc::new(track), Arc::new(wheel), vec![contact], self.amplitude)
    }
}
