//! From checked keys to the physics: every joint of the loop built.

mod contact;
mod creep_laws;
mod damage;
mod general;
pub(crate) mod stability;
mod track;
pub(crate) mod validity;
mod wheelset;

use riffel_keys::{CaseError, Message, fixed, say};
use std::sync::Arc;

use riffel::contact::{CreepLaw, MeanRolling};
use riffel::feedback::{NormalDirection, OneWheel};
use riffel::receptance::{ResonanceKind, SpatialTrack};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Axis, Direction, ElasticMaterial, EnergyWear, HertzContact, Loop, PlaceOfWear, Receptance, WearCorners as Corners,
    WearRegimes,
};

pub(crate) use contact::{CreepInTime, mean_key};
pub use creep_laws::CreepLaws;

use crate::file::{DissipationPhase, Rotation, WearLaw};
use crate::keys::checked_keys::CheckedKeys;
use crate::parts::track::Track;
use crate::parts::wheelset::CaseWheelset;
use crate::parts::window::Window;

/// What is built of the keys of a case.
pub(crate) struct BuiltCase {
    pub(crate) track: Track,
    pub(crate) closed: ClosedLoop,
    pub(crate) wavelength: Axis,
    pub(crate) speed: Axis,
    pub(crate) remarks: Vec<Message>,
}

/// A loop with its contact under study.
pub(crate) struct ClosedLoop {
    pub(crate) feedback: Loop,
    pub(crate) hertz: HertzContact,
    pub(crate) steady: MeanRolling,
    pub(crate) law: Option<Arc<dyn CreepLaw>>,
    pub(crate) wheelset: Option<Arc<CaseWheelset>>,
    pub(crate) spatial_track: Option<SpatialTrack>,
    pub(crate) lateral_resonances: Vec<(ResonanceKind, f64)>,
    remarks: Vec<Message>,
}

impl CheckedKeys {
    /// The loop of the case, and what goes with it.
    pub(crate) fn build(&self) -> Result<BuiltCase, CaseError> {
        let (mut wavelength, speed) = self.window()?;
        let (track, closed) = self.close()?;
        let mut remarks = self.text.remarks.clone();
        let contacts = closed.feedback.contacts().iter();
        let known = contacts.map(|contact| contact.rolling.known_from());
        let known = known.fold(0.0, f64::max);
        if known > wavelength.min() {
            let from = Axis::new(known, wavelength.max(), wavelength.points());
            wavelength = self.physics("map.wavelength.max", from)?;
            remarks.push(say!(map_begins_where_contact_is_known, wavelength = fixed(1e3 * known, 1)));
        }
        remarks.extend(track.remarks.iter().cloned());
        remarks.extend(closed.remarks.iter().cloned());
        if self.window != Window::BesideAnother {
            let wheelset = closed.wheelset.as_deref();
            let (feedback, axes) = (&closed.feedback, [wavelength, speed]);
            remarks.extend(validity::remarks(self, &track, wheelset, feedback, closed.hertz, axes));
        }
        Ok(BuiltCase { track, closed, wavelength, speed, remarks })
    }

    /// The track and the loop on it, without a word on their validity.
    pub(crate) fn loop_and_track(&self) -> Result<(Loop, Track), CaseError> {
        let (track, closed) = self.close()?;
        Ok((closed.feedback, track))
    }

    fn close(&self) -> Result<(Track, ClosedLoop), CaseError> {
        let steel = self.steel()?;
        let track = self.track(Direction::Vertical)?;
        let closed = match self.general()? {
            Some(keys) => self.general_loop(&keys, steel, &track)?,
            None => self.longitudinal_loop(steel, &track)?,
        };
        Ok((track, closed))
    }

    /// The loop of one wheel and longitudinal creepage.
    fn longitudinal_loop(&self, steel: ElasticMaterial, track: &Track) -> Result<ClosedLoop, CaseError> {
        let hertz = self.hertz(steel)?;
        let contact = self.contact(hertz)?;
        let steady = contact.rolling.steady();
        let (wheel, mut remarks) = self.wheel()?;
        let damage = self.damage(hertz, &steady, track)?;
        remarks.extend(damage.iter().flat_map(|damage| self.damage_remarks(damage, &steady)));
        let feedback = OneWheel {
            track: track.receptance.clone(),
            wheel,
            contact_stiffness: hertz.stiffness(),
            contact: contact.rolling,
            rotation: self.rotation(hertz.rolling_radius())?,
            wave: self.wave(hertz)?,
            place_of_wear: self.place_of_wear(hertz, steady.tractive_ratio()),
            wear: self.wear(hertz, &steady, true)?,
            amplitude: self.file.corrugation.amplitude.si(),
        };
        let feedback = self.physics("contact", feedback.close())?;
        Ok(ClosedLoop {
            feedback: self.with_direction_of_lone_wheels(feedback)?.with_damage(|_| damage.clone()),
            hertz,
            steady,
            law: contact.law,
            wheelset: None,
            spatial_track: None,
            lateral_resonances: Vec::new(),
            remarks,
        })
    }

    /// A wheel alone, downward, and what should be known of it.
    fn wheel(&self) -> Result<(Arc<dyn Receptance>, Vec<Message>), CaseError> {
        let mass = self.required("wheel.mass", self.file.wheel.mass)?;
        let rigid = self.physics("wheel.mass", RigidMass::new(mass.si()))?;
        Ok(match &self.given.wheel {
            Some(given) => (given.receptance.clone(), given.remarks.clone()),
            None => (Arc::new(rigid), Vec::new()),
        })
    }

    fn place_of_wear(&self, hertz: HertzContact, tractive_ratio: f64) -> PlaceOfWear {
        let phase = match self.file.contact.dissipation_phase {
            DissipationPhase::Lag => riffel::DissipationPhase::Lag,
            DissipationPhase::Lead => riffel::DissipationPhase::Lead,
            DissipationPhase::None => riffel::DissipationPhase::None,
        };
        PlaceOfWear::new(phase, hertz.semi_axis_longitudinal(), tractive_ratio)
    }

    /// Widths \[m\] of the band of wear and of a contact that is wider than it.
    pub(crate) fn band_under_wider_contact(&self, hertz: HertzContact) -> Option<[f64; 2]> {
        let contact = 2.0 * hertz.semi_axis_lateral();
        let band = self.file.wear.band_width?.si();
        (band < contact).then_some([band, contact])
    }

    /// Wear under a contact. A band narrower than the contact is refused where the case gives that contact; where it follows from a
    /// curve, and on the rail that is not under study, wear comes off the contact's own width.
    fn wear(&self, hertz: HertzContact, steady: &MeanRolling, studied: bool) -> Result<EnergyWear, CaseError> {
        let wear = &self.file.wear;
        let density = wear.density.si();
        let map = &self.file.map.speed;
        let middle = 0.5 * (map.min.si() + map.max.si());
        let spread = wear.spread.map_or(0.0, |spread| spread.si());
        if wear.spread.is_some() && matches!(wear.law, WearLaw::Energy | WearLaw::ArchardMap) {
            return Err(self.text.keys.invalid(
                "wear.spread",
                say!(is_one_of_t_a_of),
                say!(it_belongs_to_wear_law_usfd),
            ));
        }
        let regimes = match wear.law {
            WearLaw::TgammaArea | WearLaw::UsfdSmooth => {
                Some(WearRegimes::TgammaArea { corners: Corners::Rounded, spread })
            }
            WearLaw::Usfd => Some(WearRegimes::TgammaArea { corners: Corners::Sharp, spread }),
            WearLaw::ArchardMap => {
                Some(WearRegimes::ArchardMap { speed: wear.speed.map_or(middle, |speed| speed.si()) })
            }
            WearLaw::Energy => None,
        };
        let lubrication = wear.natural_lubrication.map_or(1.0, |factor| factor.si());
        let law = match regimes {
            None => {
                let coefficient = wear.coefficient.si() / lubrication;
                let law = EnergyWear::new(coefficient, density, hertz.semi_axis_lateral());
                self.physics("wear", law)?
            }
            Some(regimes) => {
                let law = regimes.wear(&hertz, steady, density, lubrication);
                self.physics("wear.law", law)?
            }
        };
        let takes_its_width =
            (!studied || self.mean.wheel().is_some()) && self.band_under_wider_contact(hertz).is_some();
        match wear.band_width.filter(|_| !takes_its_width) {
            Some(width) => self.physics("wear.band_width", law.over_band(width.si())),
            None => Ok(law),
        }
    }

    fn rotation(&self, radius: f64) -> Result<Motion, CaseError> {
        let wheel = &self.file.wheel;
        // Filled in with the keys; the mass it may come from is checked.
        let inertia = self.required("wheel.inertia", wheel.inertia)?.si();
        Ok(match wheel.rotation() {
            Rotation::Inertia => Motion::compliant(self.turning_wheel(inertia, radius)?),
            Rotation::ConstantTangentialForce => Motion::Free,
            Rotation::ConstantCreepage => Motion::Held,
        })
    }

    /// A wheel without a partner that turns with an inertia \[kg m²\]; its hub moves along the rail where the normal force turns with the
    /// wave.
    pub(crate) fn turning_wheel(&self, inertia: f64, radius: f64) -> Result<RigidInertia, CaseError> {
        let rigid = RigidInertia::new(inertia, radius);
        let rigid = self.physics("wheel.inertia", rigid)?;
        match self.file.wheel.normal_direction {
            false => Ok(rigid),
            true => {
                let mass = self.required("wheel.mass", self.file.wheel.mass)?;
                self.physics("wheel.mass", rigid.with_moving_hub(mass.si()))
            }
        }
    }

    /// The loop of lone wheels, whose normal forces turn with the wave where the case says so.
    fn with_direction_of_lone_wheels(&self, feedback: Loop) -> Result<Loop, CaseError> {
        if !self.file.wheel.normal_direction {
            return Ok(feedback);
        }
        let mass = self.required("wheel.mass", self.file.wheel.mass)?;
        let hub = self.physics("wheel.mass", RigidMass::new(mass.si()))?;
        Ok(feedback.with_normal_direction(NormalDirection::Lone(Arc::new(hub))))
    }
}
