//! From checked keys to the physics: every joint of the loop built.

mod contact;
mod creep_laws;
mod general;
mod track;
pub(crate) mod validity;
mod wheelset;

use std::sync::Arc;

use riffel::contact::MeanRolling;
use riffel::feedback::OneWheel;
use riffel::receptance::{ResonanceKind, SpatialTrack};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Axis, Carter3d, Direction, ElasticMaterial, EnergyWear, HertzContact, Loop, PlaceOfWear,
    Receptance, WearRegimes,
};
use riffel_keys::{CaseError, Message};

pub(crate) use contact::{CreepInTime, mean_key};
pub use creep_laws::CreepLaws;
pub(crate) use wheelset::disc;

use crate::checked_keys::CheckedKeys;
use crate::file::{DissipationPhase, Rotation, WearLaw};
use crate::track::Track;
use crate::wheelset::CaseWheelset;

/// What is built of the keys of a case.
pub(crate) struct BuiltCase {
    pub(crate) feedback: Loop,
    pub(crate) track: Track,
    pub(crate) hertz: HertzContact,
    pub(crate) steady: MeanRolling,
    pub(crate) carter: Option<Carter3d>,
    pub(crate) wheelset: Option<Arc<CaseWheelset>>,
    pub(crate) spatial_track: Option<SpatialTrack>,
    pub(crate) lateral_resonances: Vec<(ResonanceKind, f64)>,
    pub(crate) wavelength: Axis,
    pub(crate) speed: Axis,
    pub(crate) remarks: Vec<Message>,
}

/// A loop with its contact under study.
struct ClosedLoop {
    feedback: Loop,
    hertz: HertzContact,
    steady: MeanRolling,
    carter: Option<Carter3d>,
    wheelset: Option<Arc<CaseWheelset>>,
    spatial_track: Option<SpatialTrack>,
    lateral_resonances: Vec<(ResonanceKind, f64)>,
    remarks: Vec<Message>,
}

impl CheckedKeys {
    /// The loop of the case, and what goes with it.
    pub(crate) fn build(&self) -> Result<BuiltCase, CaseError> {
        let (wavelength, speed) = self.window()?;
        let (track, closed) = self.close()?;
        let ClosedLoop {
            feedback,
            hertz,
            steady,
            carter,
            wheelset,
            spatial_track,
            lateral_resonances,
            remarks: of_loop,
        } = closed;
        let mut remarks = self.text.remarks.clone();
        remarks.extend(track.remarks.iter().cloned());
        remarks.extend(of_loop);
        let axes = [wavelength, speed];
        remarks.extend(validity::remarks(
            self,
            &track,
            wheelset.as_deref(),
            &feedback,
            hertz,
            axes,
        ));
        Ok(BuiltCase {
            feedback,
            track,
            hertz,
            steady,
            carter,
            wheelset,
            spatial_track,
            lateral_resonances,
            wavelength,
            speed,
            remarks,
        })
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
    fn longitudinal_loop(
        &self,
        steel: ElasticMaterial,
        track: &Track,
    ) -> Result<ClosedLoop, CaseError> {
        let hertz = self.hertz(steel)?;
        let contact = self.contact(hertz)?;
        let steady = contact.rolling.steady();
        let (wheel, remarks) = self.wheel()?;
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
        Ok(ClosedLoop {
            feedback: self.physics("contact", feedback.close())?,
            hertz,
            steady,
            carter: contact.carter,
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

    /// Wear under a contact; on the rail that is not under study a band may be narrower than the contact, which has no part in growth.
    fn wear(
        &self,
        hertz: HertzContact,
        steady: &MeanRolling,
        studied: bool,
    ) -> Result<EnergyWear, CaseError> {
        let wear = &self.file.wear;
        let density = wear.density.si();
        let map = &self.file.map.speed;
        let middle = 0.5 * (map.min.si() + map.max.si());
        let regimes = match wear.law {
            WearLaw::TgammaArea => Some(WearRegimes::TgammaArea),
            WearLaw::ArchardMap => Some(WearRegimes::ArchardMap {
                speed: wear.speed.map_or(middle, |speed| speed.si()),
            }),
            WearLaw::Energy => None,
        };
        let law = match regimes {
            None => {
                let b = hertz.semi_axis_lateral();
                let law = EnergyWear::new(wear.coefficient.si(), density, b);
                self.physics("wear", law)?
            }
            Some(regimes) => {
                let dry = wear.natural_lubrication.map_or(1.0, |factor| factor.si());
                let law = regimes.wear(&hertz, steady, density, dry);
                self.physics("wear.law", law)?
            }
        };
        match wear.band_width {
            Some(width) if studied || width.si() >= 2.0 * hertz.semi_axis_lateral() => {
                self.physics("wear.band_width", law.over_band(width.si()))
            }
            _ => Ok(law),
        }
    }

    fn rotation(&self, radius: f64) -> Result<Motion, CaseError> {
        let wheel = &self.file.wheel;
        // Filled in with the keys; the mass it may come from is checked.
        let inertia = self.required("wheel.inertia", wheel.inertia)?.si();
        Ok(match wheel.rotation() {
            Rotation::Inertia => {
                let rigid = RigidInertia::new(inertia, radius);
                Motion::compliant(self.physics("wheel.inertia", rigid)?)
            }
            Rotation::ConstantTangentialForce => Motion::Free,
            Rotation::ConstantCreepage => Motion::Held,
        })
    }
}
