//! One wheel of a case in time, along one axis.

use std::sync::Arc;

use riffel::contact::CreepLaw;
use riffel::passage::{HertzSpring, ImpulseResponse, PassageModel, TransientContact, Turning};
use riffel_keys::CaseError;

use crate::Case;
use crate::build::CreepInTime;
use crate::file::{ContactDynamics, Rotation};

impl Case {
    /// Wheel, track and contact of the case in time, at a speed \[m/s\].
    ///
    /// # Errors
    /// [`CaseError`] where the case has what is not followed through time: several contacts or axes, a spring and a dashpot in
    /// the contact, a wheel or a track that is not a model, a track that is not causal.
    pub fn passage(&self, speed: f64) -> Result<PassageModel, CaseError> {
        self.passage_on(&self.contact_in_time()?, speed)
    }

    /// The creep law of the case, and what it makes of the past, for passages at any speed.
    pub(crate) fn contact_in_time(&self) -> Result<CreepInTime, CaseError> {
        self.check_in_time()?;
        let (keys, friction) = (&self.keys, self.steady.friction);
        // The paper's law does without Kalker's coefficients, which have a table that ends.
        let law = match self.carter {
            Some(carter) => Some(Arc::new(carter) as Arc<dyn CreepLaw>),
            None => keys.creep_law(self.hertz, friction)?,
        };
        match law {
            Some(law) => Ok(CreepInTime { law, late: None }),
            None => keys.exact_in_time(self.hertz, friction),
        }
    }

    /// The contact of the half-space to roll element by element, on `contact.grid` elements or one more.
    pub fn transient_contact(&self) -> TransientContact {
        let grid = usize::try_from(self.file.contact.grid).unwrap_or(usize::MAX);
        TransientContact {
            hertz: self.hertz,
            friction: self.steady.friction,
            across: grid.next_multiple_of(2),
        }
    }

    pub(super) fn passage_on(
        &self,
        contact: &CreepInTime,
        speed: f64,
    ) -> Result<PassageModel, CaseError> {
        let (keys, wheel) = (&self.keys, &self.file.wheel);
        let key = match self.keys.given.track {
            Some(_) => "receptance of the track",
            None => "track.model",
        };
        let response = match self.track.support_spacing() {
            Some(_) => ImpulseResponse::over_supports(&self.moving_load_on_supports(speed)?),
            None => ImpulseResponse::of(&*self.track.receptance, speed),
        };
        let normal_force = self.hertz.normal_force();
        let mass = keys.required("wheel.mass", wheel.mass)?.si();
        let inertia = keys.required("wheel.inertia", wheel.inertia)?.si();
        Ok(PassageModel {
            track: keys.physics(key, response)?,
            wheel_mass: mass,
            spring: keys.physics(
                "contact",
                HertzSpring::new(normal_force, self.hertz.stiffness()),
            )?,
            law: contact.law.clone(),
            late: contact.late.clone(),
            contact_filter: None,
            turning: match wheel.rotation() {
                Rotation::ConstantCreepage => Turning::Held,
                _ => Turning::Inertia {
                    inertia,
                    rolling_radius: self.hertz.rolling_radius(),
                },
            },
            mean: self.steady,
            speed,
        })
    }

    /// `Ok` if the case is one wheel with longitudinal creepage.
    fn check_in_time(&self) -> Result<(), CaseError> {
        let refuse = |key: &str, message: &str| Err(self.refuse(key, message));
        let file = &self.file;
        if self.feedback.longitudinal().is_none() {
            let key = match (&file.wheelset, &file.train) {
                (Some(_), _) => "wheelset",
                (None, Some(_)) => "train",
                (None, None) => "contact.creepage",
            };
            let message = format!(
                "`{key}` makes this a loop on all axes or of several wheels, but a passage in time takes one wheel of \
                 [wheel] with longitudinal creepage"
            );
            return refuse(key, &message);
        }
        if self.keys.given.wheel.is_some() {
            let message = "a passage in time takes the rigid wheel of [wheel], not a receptance that is given for it";
            return refuse("wheel", message);
        }
        if file.contact.response == ContactDynamics::SpringDashpot {
            let message = "`contact.response` is \"spring-dashpot\", which is known for small oscillations only; for a passage in \
                           time choose \"quasi-static\" or \"non-steady\"";
            return refuse("contact.response", message);
        }
        if file.wheel.rotation() == Rotation::ConstantTangentialForce {
            let message = "`wheel.rotation` is \"constant-tangential-force\", but where the wheel leaves the rail no \
                           creepage keeps the force; choose \"inertia\" or \"constant-creepage\"";
            return refuse("wheel.rotation", message);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NOMINAL_CASE;

    fn passage(overrides: &[&str]) -> Result<PassageModel, CaseError> {
        let overrides: Vec<String> = overrides.iter().map(|&key| key.to_owned()).collect();
        Case::parse("nominal", NOMINAL_CASE, &overrides)?.passage(30.0)
    }

    /// A slab with direct fastenings, whose rail loses little, once swung up by a response that was free above 3.5 kHz.
    #[test]
    fn a_rail_of_little_loss_comes_to_rest() -> Result<(), CaseError> {
        let model = Case::parse("metro", crate::METRO_CASE, &[])?.passage(22.0)?;
        assert!(model.memory().is_ok_and(|memory| memory < 10.0));
        Ok(())
    }

    #[test]
    fn what_is_not_followed_through_time_is_refused() {
        assert!(passage(&[]).is_ok());
        assert!(
            passage(&[
                "wheel.rotation=constant-creepage",
                "contact.creep_law=polach"
            ])
            .is_ok()
        );
        for (overrides, words) in [
            (
                &["wheel.rotation=constant-tangential-force"][..],
                "leaves the rail",
            ),
            (
                &["contact.response=spring-dashpot"],
                "small oscillations only",
            ),
            (&["train.wheels=[0, 2.5]"], "one wheel"),
        ] {
            let Err(error) = passage(overrides) else {
                panic!("{overrides:?} was taken");
            };
            assert!(error.to_string().contains(words), "{error}");
        }
    }
}
