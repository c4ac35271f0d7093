//! The wheels of a case on all axes in time.

use std::f64::consts::TAU;

use riffel::feedback::{Contact, GeneralLoop};
use riffel::passage::{ContactInTime, GeneralPassage, StructuresInTime};
use riffel::receptance::SpatialMovingLoad;
use riffel::{Error, Rail};
use riffel_keys::CaseError;

use crate::Case;
use crate::file::{ContactDynamics, Rotation, TrackModel};
use crate::general_keys::{ContactKeys, GeneralKeys};
use crate::wheelset::CaseWheelset;

/// Most contacts that are followed in time.
const MOST_CONTACTS: usize = 8;

/// The parts of a loop on all axes in time that do not depend on the speed.
pub(super) struct AllAxes {
    contacts: Vec<ContactInTime>,
    natural_frequencies: Vec<f64>,
    /// Those of all speeds, where they are known.
    structures: Option<StructuresInTime>,
}

impl Case {
    /// The loop of a case on all axes in time.
    ///
    /// # Errors
    /// [`CaseError`] where the case has what is not followed through time on all axes: a contact that answers late or by the
    /// exact theory, geometric creepage, receptances that are measured.
    pub(super) fn all_axes_in_time(
        &self,
        feedback: &GeneralLoop,
        keys: &GeneralKeys,
    ) -> Result<AllAxes, CaseError> {
        self.check_general_in_time(feedback)?;
        let contacts = feedback.contacts().iter();
        let contacts = contacts.map(|contact| self.contact_of_loop_in_time(contact, keys));
        Ok(AllAxes {
            contacts: contacts.collect::<Result<_, _>>()?,
            natural_frequencies: self.natural_frequencies_of_wheels()?,
            structures: None,
        })
    }

    /// The same with the structures for all speeds, where the track does not ask for the speed: their fit takes seconds.
    pub(super) fn all_axes_at_any_speed(
        &self,
        feedback: &GeneralLoop,
        parts: AllAxes,
    ) -> Result<AllAxes, CaseError> {
        /// Any.
        const SPEED: f64 = 20.0;
        let structures = match self.file.track.model {
            TrackModel::MovingBeam => None,
            model if model.is_periodic() => None,
            _ => Some(self.structures_in_time(feedback, SPEED, &parts.natural_frequencies)?),
        };
        Ok(AllAxes {
            structures,
            ..parts
        })
    }

    /// The same at a speed \[m/s\].
    pub(super) fn all_axes_at(
        &self,
        feedback: &GeneralLoop,
        parts: &AllAxes,
        speed: f64,
    ) -> Result<GeneralPassage, CaseError> {
        Ok(GeneralPassage {
            contacts: parts.contacts.clone(),
            structures: match &parts.structures {
                Some(structures) => structures.clone(),
                None => self.structures_in_time(feedback, speed, &parts.natural_frequencies)?,
            },
            contact_filter: None,
            speed,
        })
    }

    fn structures_in_time(
        &self,
        feedback: &GeneralLoop,
        speed: f64,
        natural_frequencies: &[f64],
    ) -> Result<StructuresInTime, CaseError> {
        let structures = match self.spatial_track {
            Some(track) if track.support_spacing().is_some() => {
                let track = SpatialMovingLoad::new(&track, speed);
                let track = self.keys.physics("track.model", track)?;
                StructuresInTime::over_supports(feedback, &track, natural_frequencies)
            }
            _ => StructuresInTime::of(feedback, speed, natural_frequencies),
        };
        let furthest = feedback.contacts().iter().map(|contact| -contact.along);
        let furthest = furthest.fold(0.0, f64::max);
        if let Err(Error::NotCausal { share, .. }) = structures
            && furthest > 0.0
            && self.wheel_alone_is_causal(feedback, speed, natural_frequencies)
        {
            let per_cent = 100.0 * share.sqrt();
            let message = format!(
                "the waves that run along this rail over the {furthest} m from the first wheel to the last are not told by so few \
                 oscillations as are fitted in time, {per_cent:.1} % rms off; give fewer or nearer wheels, or a track that damps more"
            );
            return Err(self.refuse("train.wheels", &message));
        }
        self.keys.physics("track.model", structures)
    }

    /// Whether the first wheel by itself could be followed.
    fn wheel_alone_is_causal(
        &self,
        feedback: &GeneralLoop,
        speed: f64,
        natural_frequencies: &[f64],
    ) -> bool {
        let contacts = feedback.contacts().iter();
        let first: Vec<Contact> = contacts
            .filter(|contact| contact.along == 0.0)
            .cloned()
            .collect();
        let alone = feedback.clone().with_contacts(first);
        alone.is_ok_and(|alone| StructuresInTime::of(&alone, speed, natural_frequencies).is_ok())
    }

    fn contact_of_loop_in_time(
        &self,
        contact: &Contact,
        keys: &GeneralKeys,
    ) -> Result<ContactInTime, CaseError> {
        let side = keys_of_side(keys, contact.rail);
        let steel = self.keys.steel()?;
        let hertz = self.keys.hertz_of(steel, side)?;
        let law = self.keys.creep_law(hertz, side.friction)?;
        let Some(law) = law else {
            let message = "on all axes a passage in time takes a creep law that is a formula or \"fastsim\": the exact theory is \
                           followed along the rail alone";
            return Err(self.refuse("contact.creep_law", message));
        };
        self.keys
            .physics("contact", ContactInTime::new(contact, law))
    }

    /// Of the wheelset \[rad/s\], as far as its receptances are followed.
    fn natural_frequencies_of_wheels(&self) -> Result<Vec<f64>, CaseError> {
        let Some(wheelset) = &self.wheelset else {
            return Ok(Vec::new());
        };
        let modes = self.wheelset_modes(wheelset, StructuresInTime::KNOWN)?;
        let mut frequencies: Vec<f64> = modes.iter().map(|mode| TAU * mode.frequency).collect();
        // Bending in either plane has the same.
        frequencies.dedup_by(|later, earlier| *later - *earlier < 1e-3 * *earlier);
        Ok(frequencies)
    }

    /// `Ok` if the loop of the case can be followed through time.
    fn check_general_in_time(&self, feedback: &GeneralLoop) -> Result<(), CaseError> {
        let refuse = |key: &str, message: &str| Err(self.refuse(key, message));
        let contacts = feedback.contacts().len();
        if contacts > MOST_CONTACTS {
            let message = format!(
                "the case has {contacts} contacts, but a passage in time takes at most {MOST_CONTACTS}: the work of a step and of \
                 the fit goes with their square; choose fewer wheels, or wheelset.opposite_rail = \"absent\""
            );
            return refuse("train.wheels", &message);
        }
        if self.keys.given.track.is_some() || self.keys.given.wheel.is_some() {
            let message = "a passage in time needs all frequencies: a model of track and wheel in the place of receptances";
            return refuse("track", message);
        }
        if matches!(self.wheelset.as_deref(), Some(CaseWheelset::Measured(_))) {
            let message = "a passage in time needs all frequencies: a model of the wheelset, or its modes, in the place of measured \
                           receptances";
            return refuse("wheelset.model", message);
        }
        if self.file.contact.response != ContactDynamics::QuasiStatic {
            let message = "on all axes a passage in time takes a contact that answers at once, `contact.response` = \"quasi-static\"";
            return refuse("contact.response", message);
        }
        if feedback
            .contacts()
            .iter()
            .any(|contact| contact.moving.is_some())
        {
            let message = "a passage in time takes contacts that stay where they are on the profiles; leave it out";
            return refuse("contact.conformity", message);
        }
        if self.wheelset.is_none()
            && self.file.wheel.rotation() == Rotation::ConstantTangentialForce
        {
            let message = "`wheel.rotation` is \"constant-tangential-force\", but where the wheel leaves the rail no \
                           creepage keeps the force; choose \"inertia\" or \"constant-creepage\"";
            return refuse("wheel.rotation", message);
        }
        Ok(())
    }
}

/// The contact on a rail.
fn keys_of_side(keys: &GeneralKeys, rail: Rail) -> &ContactKeys {
    match &keys.opposite {
        Some(opposite) if rail != keys.rail => &opposite.contact,
        _ => &keys.contact,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NOMINAL_CASE;
    use riffel::Complex64;
    use riffel::passage::Sinusoid;

    const TRAILER: &str = include_str!("../../../../cases/wheelset-metro-trailer.toml");

    /// Largest difference of the first harmonics of forces and creepages at any contact from those of the linear loop, each
    /// over the largest of its kind.
    fn off(case: &Case, wavelength: f64, speed: f64) -> f64 {
        let amplitude = 1e-8;
        let profile = Sinusoid {
            amplitude,
            wavelength,
        };
        let passage = case.in_time(speed).unwrap();
        let settled = passage.settle(profile, 256).unwrap();
        let linear = case.feedback.general().unwrap().at(wavelength, speed);
        let scale = amplitude / case.feedback.amplitude();
        let [mut of_forces, mut of_creepages] = [Off::default(); 2];
        for (contact, settled) in linear.contacts.iter().zip(&settled) {
            let first = &settled.harmonics[1];
            let forces = [
                first.tangential_force,
                first.lateral_force,
                first.normal_force,
            ];
            let creepages = [first.creepage, first.lateral_creepage];
            of_forces.add(&forces, &contact.force.map(|force| scale * force));
            of_creepages.add(&creepages, &contact.creepage.map(|creep| scale * creep));
        }
        of_forces.relative().max(of_creepages.relative())
    }

    /// Largest difference and largest size.
    #[derive(Clone, Copy, Default)]
    struct Off([f64; 2]);

    impl Off {
        fn add(&mut self, got: &[Complex64], expected: &[Complex64]) {
            for (got, expected) in got.iter().zip(expected) {
                self.0[0] = self.0[0].max((got - expected).norm());
                self.0[1] = self.0[1].max(expected.norm());
            }
        }

        fn relative(&self) -> f64 {
            self.0[0] / self.0[1]
        }
    }

    fn case(text: &str, overrides: &[&str]) -> Case {
        let overrides: Vec<String> = overrides.iter().map(|&key| key.to_owned()).collect();
        Case::parse("case", text, &overrides).unwrap()
    }

    /// A flexible wheelset on a track whose layers are viscous, so that nothing of it is cut.
    fn trailer(overrides: &[&str]) -> Case {
        let viscous = [
            "track.model=one-layer",
            "track.pad.loss_factor=0",
            "track.pad.damping=20e3",
            "rail.loss_factor=0",
            "contact.creep_law=polach",
        ];
        case(TRAILER, &[&viscous, overrides].concat())
    }

    /// First harmonics of small waves at every contact, over the largest; the fit of the structures and the step leave
    /// 10⁻⁴.
    #[test]
    fn small_waves_are_those_of_the_linear_loop() {
        let lone = [
            "contact.creepage={longitudinal=\"0.1 %\", lateral=\"0.3 %\"}",
            "contact.creep_law=polach",
        ];
        let (antiphase, angle) = (
            "wheelset.opposite_rail=antiphase",
            "contact.contact_angle=\"5 deg\"",
        );
        let (absent, two) = ("wheelset.opposite_rail=absent", "train.wheels=[0, 2.1]");
        for (case, wavelength, speed) in [
            (case(NOMINAL_CASE, &lone), 0.12, 15.0),
            (trailer(&[antiphase, angle]), 0.05, 20.0),
            (trailer(&[absent, two]), 0.03, 12.0),
        ] {
            let off = off(&case, wavelength, speed);
            assert!(off < 3e-4, "{wavelength} {speed}: {off:.1e}");
        }
    }

    /// Wheels on all axes pass discrete supports, but do not come to rest on them.
    #[test]
    fn supports_pass_under_wheels_on_all_axes() {
        let supports = [
            "track.model=one-layer-periodic",
            "track.support_spacing=\"0.6 m\"",
            "track.pad={stiffness=\"120 MN/m\", damping=\"80 kNs/m\"}",
            "rail.loss_factor=0.02",
            "contact.creepage={longitudinal=\"0.1 %\", lateral=\"0.3 %\"}",
            "contact.creep_law=polach",
        ];
        let case = case(NOMINAL_CASE, &supports);
        assert_eq!(case.in_time(20.0).unwrap().support_spacing(), Some(0.6));
        let Err(error) = case.in_time_without_profile(20.0) else {
            panic!("a smooth rail on supports was taken");
        };
        assert!(error.to_string().contains("never come to rest"), "{error}");
    }

    #[test]
    fn what_is_not_followed_through_time_is_refused() {
        for (overrides, words) in [
            (&["contact.response=spring-dashpot"][..], "answers at once"),
            (&["train.wheels=[0, 2, 4, 6, 8]"], "10 contacts"),
        ] {
            let Err(error) = trailer(overrides).in_time(15.0) else {
                panic!("{overrides:?} was taken");
            };
            assert!(error.to_string().contains(words), "{error}");
        }
    }
}
