//! The wheels of a case on all axes in time.

use std::f64::consts::TAU;

use riffel::Rail;
use riffel::feedback::{Contact, GeneralLoop};
use riffel::passage::{ContactInTime, GeneralPassage, HertzSpring, StructuresInTime};
use riffel::wheelset::Motion;
use riffel_keys::CaseError;

use crate::Case;
use crate::file::{ContactDynamics, Rotation};
use crate::general_keys::{ContactKeys, GeneralKeys};
use crate::wheelset::CaseWheelset;

impl Case {
    /// Wheels, track and contacts of a case with a loop on all axes in time, at a speed \[m/s\]; none for a case of one wheel
    /// and longitudinal creepage, which [`passage`](Self::passage) follows.
    ///
    /// # Errors
    /// [`CaseError`] where the case has what is not followed through time on all axes: discrete supports, a contact that
    /// answers late or by the exact theory, geometric creepage, receptances that are measured, a track that is not causal.
    pub fn general_passage(&self, speed: f64) -> Result<Option<GeneralPassage>, CaseError> {
        let (Some(feedback), Some(keys)) = (self.feedback.general(), self.keys.general()?) else {
            return Ok(None);
        };
        self.check_general_in_time(feedback)?;
        let natural = self.natural_frequencies_of_wheels()?;
        let structures = StructuresInTime::of(feedback, speed, &natural);
        let contacts = feedback.contacts().iter();
        let contacts = contacts.map(|contact| self.contact_of_loop_in_time(contact, &keys));
        Ok(Some(GeneralPassage {
            contacts: contacts.collect::<Result<_, _>>()?,
            structures: self.keys.physics("track.model", structures)?,
            speed,
        }))
    }

    fn contact_of_loop_in_time(
        &self,
        contact: &Contact,
        keys: &GeneralKeys,
    ) -> Result<ContactInTime, CaseError> {
        let side = keys_of_side(keys, contact.rail);
        let steel = self.keys.steel()?;
        let hertz = self
            .keys
            .hertz_of(steel, side.transverse_radius, side.normal_load)?;
        let law = self.keys.creep_law(hertz, side.friction)?;
        let Some(law) = law else {
            let message = "on all axes a passage in time takes a creep law that is a formula or \"fastsim\": the exact theory is \
                           followed along the rail alone";
            return Err(self.refuse("contact.creep_law", message));
        };
        let mean = contact.rolling.steady();
        let spring = HertzSpring::new(mean.normal_force, contact.stiffness);
        Ok(ContactInTime {
            spring: self.keys.physics("contact", spring)?,
            law,
            mean,
            along: contact.along,
            profile: contact.profile,
            held: contact
                .motion
                .each_ref()
                .map(|motion| matches!(motion, Motion::Held)),
        })
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
        if self.track.support_spacing().is_some() {
            let message = "a passage in time on all axes, or of several wheels, takes a track that is even along the rail: choose \
                           \"two-layer\", \"one-layer\" or \"free-beam\"";
            return refuse("track.model", message);
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
        if feedback.contacts().iter().any(|contact| contact.geometry.is_some()) {
            let message = "a passage in time takes contacts that stay where they are on the profiles; leave it out";
            return refuse("contact.conformity", message);
        }
        if self.wheelset.is_none() && self.file.wheel.rotation() == Rotation::ConstantTangentialForce
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
    use riffel::passage::Sinusoid;

    const TRAILER: &str = include_str!("../../../cases/wheelset-metro-trailer.toml");

    /// Largest difference of the first harmonics of forces and creepages at any contact from those of the linear loop, each
    /// over the largest of its kind.
    fn off(case: &Case, wavelength: f64, speed: f64) -> Result<f64, CaseError> {
        let passage = case.general_passage(speed)?.unwrap();
        eprintln!(
            "share {:.2e} largest {:.2e}",
            passage.structures.share_cut(),
            passage.structures.largest_error()
        );
        let amplitude = 1e-8;
        let profile = Sinusoid {
            amplitude,
            wavelength,
        };
        let settled = passage.settle(profile, 512).unwrap();
        let linear = case.feedback.general().unwrap().at(wavelength, speed);
        let scale = amplitude / case.feedback.amplitude();
        let mut worst = 0f64;
        let mut largest = [0f64; 2];
        for contact in &linear.contacts {
            for force in contact.force {
                largest[0] = largest[0].max(scale * force.norm());
            }
            for creepage in contact.creepage {
                largest[1] = largest[1].max(scale * creepage.norm());
            }
        }
        for (contact, settled) in linear.contacts.iter().zip(&settled) {
            let first = &settled.harmonics[1];
            let [along, across, normal] = contact.force;
            for (got, want) in [
                (first.normal_force, normal),
                (first.tangential_force, along),
                (first.lateral_force, across),
            ] {
                worst = worst.max((got - scale * want).norm() / largest[0]);
                eprintln!("  {got:.4} {:.4}", scale * want);
            }
            let got = [first.creepage, first.lateral_creepage];
            for (got, want) in got.into_iter().zip(contact.creepage) {
                worst = worst.max((got - scale * want).norm() / largest[1]);
            }
        }
        Ok(worst)
    }

    fn case(text: &str, overrides: &[&str]) -> Case {
        let overrides: Vec<String> = overrides.iter().map(|&key| key.to_owned()).collect();
        Case::parse("case", text, &overrides).unwrap()
    }

    #[test]
    fn small_waves_are_those_of_the_linear_loop() -> Result<(), CaseError> {
        let creepage = "contact.creepage={longitudinal=\"0.1 %\", lateral=\"0.3 %\"}";
        let law = "contact.creep_law=\"polach\"";
        let on_slab = ["track.model=one-layer", law];
        let cases = [
            ("lone", case(NOMINAL_CASE, &[creepage, law])),
            ("trailer", case(TRAILER, &on_slab)),
            (
                "antiphase",
                case(
                    TRAILER,
                    &[on_slab[0], law, "wheelset.opposite_rail=antiphase", "contact.contact_angle=\"5 deg\""],
                ),
            ),
            (
                "absent",
                case(TRAILER, &[on_slab[0], law, "wheelset.opposite_rail=absent"]),
            ),
            (
                "two wheels",
                case(
                    TRAILER,
                    &[on_slab[0], law, "wheelset.opposite_rail=absent", "train.wheels=[0, 2.1]"],
                ),
            ),
        ];
        for (name, case) in cases {
            for (wavelength, speed) in [(0.05, 20.0), (0.12, 15.0), (0.03, 12.0)] {
                let begin = std::time::Instant::now();
                match off(&case, wavelength, speed) {
                    Ok(off) => eprintln!("{name} {wavelength} {speed}: {off:.2e} {:?}", begin.elapsed()),
                    Err(error) => eprintln!("{name}: {error}"),
                }
            }
        }
        Ok(())
    }
}
