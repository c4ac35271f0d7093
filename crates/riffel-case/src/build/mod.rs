//! From checked keys to the physics: every joint of the loop built.

mod contact;
mod creep_laws;
mod track;
mod validity;
use std::sync::Arc;

use riffel::contact::MeanRolling;
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Axis, Carter3d, Direction, EnergyWear, FeedbackLoop, HertzContact, Loop, PlaceOfWear,
    Receptance,
};
use riffel_keys::{CaseError, Remark};

pub use creep_laws::CreepLaws;

use crate::checked_keys::CheckedKeys;
use crate::file::{DissipationPhase, Rotation};
use crate::track::Track;

/// What is built of the keys of a case.
pub(crate) struct BuiltCase {
    pub(crate) feedback: Loop,
    pub(crate) track: Track,
    pub(crate) hertz: HertzContact,
    pub(crate) steady: MeanRolling,
    pub(crate) carter: Option<Carter3d>,
    pub(crate) wavelength: Axis,
    pub(crate) speed: Axis,
    pub(crate) remarks: Vec<Remark>,
}

impl CheckedKeys {
    /// The loop of the case, and what goes with it.
    pub(crate) fn build(&self) -> Result<BuiltCase, CaseError> {
        let file = &self.file;
        if let Some(key) = self.general_key() {
            return Err(self.text.keys.invalid(
                key,
                "asks for the loop on all axes, but Riffel computes that of one wheel along the rail",
                "",
            ));
        }
        let steel = self.steel()?;

        let hertz = self.hertz(steel)?;
        let contact = self.contact(hertz)?;
        let steady = contact.rolling.steady();

        let (wavelength, speed) = self.window()?;
        let track = self.track(Direction::Vertical)?;
        let mass = self.required("wheel.mass", file.wheel.mass)?;
        let wheel = RigidMass::new(mass.si());
        let mut wheel: Arc<dyn Receptance> = Arc::new(self.physics("wheel.mass", wheel)?);
        if let Some(given) = &self.given.wheel {
            wheel = given.receptance.clone();
        }
        let place_of_wear = PlaceOfWear::new(
            match file.contact.dissipation_phase {
                DissipationPhase::Lag => riffel::DissipationPhase::Lag,
                DissipationPhase::Lead => riffel::DissipationPhase::Lead,
                DissipationPhase::None => riffel::DissipationPhase::None,
            },
            hertz.semi_axis_longitudinal(),
            steady.tractive_ratio(),
        );
        let wear = EnergyWear::new(
            file.wear.coefficient.si(),
            file.wear.density.si(),
            hertz.semi_axis_lateral(),
        );
        let feedback = Loop::from(FeedbackLoop {
            track: track.receptance.clone(),
            wheel,
            contact_stiffness: hertz.stiffness(),
            contact: contact.rolling,
            rotation: self.rotation(hertz.rolling_radius())?,
            rolling_radius: hertz.rolling_radius(),
            place_of_wear,
            wear: self.physics("wear", wear)?,
            amplitude: file.corrugation.amplitude.si(),
        });
        let mut remarks = self.text.remarks.clone();
        remarks.extend(track.remarks.iter().cloned());
        remarks.extend(
            self.given
                .wheel
                .iter()
                .flat_map(|given| given.remarks.clone()),
        );
        let axes = [wavelength, speed];
        remarks.extend(validity::remarks(self, &track, &feedback, hertz, axes));
        Ok(BuiltCase {
            feedback,
            track,
            hertz,
            steady,
            carter: contact.carter,
            wavelength,
            speed,
            remarks,
        })
    }

    fn rotation(&self, radius: f64) -> Result<Motion, CaseError> {
        let wheel = &self.file.wheel;
        // Filled in above; the mass it may come from is checked.
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
