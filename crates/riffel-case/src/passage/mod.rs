//! The wheels of a case in time.

mod all_axes;
mod one_wheel;

use riffel::feedback::GeneralLoop;
use riffel::passage::{LoopInTime, PassingWheel, WearOfPassages};
use riffel::{Loop, PlaceOfWear};
use riffel_keys::CaseError;

use crate::Case;
use crate::build::CreepInTime;
use all_axes::AllAxes;

/// A case on its way into time, as far as the speed has no part in it.
pub(crate) struct CaseInTime<'a> {
    case: &'a Case,
    of_loop: OfLoop<'a>,
}

enum OfLoop<'a> {
    Longitudinal(CreepInTime),
    General(&'a GeneralLoop, Box<AllAxes>),
}

impl Case {
    /// Wheels, track and contacts of the case in time, at a speed \[m/s\].
    ///
    /// # Errors
    /// [`CaseError`] where the case has what is not followed through time, such as a track that is not causal, and where the
    /// loop is unstable without any profile.
    pub fn in_time(&self, speed: f64) -> Result<LoopInTime, CaseError> {
        let wheels = self.wheels_in_time()?;
        // It takes a tenth of the time of a fit.
        wheels.check_stable(speed)?;
        wheels.at(speed)
    }

    /// The same, stable or not.
    ///
    /// # Errors
    /// Those of [`in_time`](Self::in_time), but for the last, and discrete supports.
    pub fn in_time_without_profile(&self, speed: f64) -> Result<LoopInTime, CaseError> {
        if self.track.support_spacing().is_some() {
            let message = "on a smooth rail, wheels on discrete supports never come to rest, so that their limit cycle is not told from what \
                           supports do: choose \"two-layer\", \"one-layer\" or \"free-beam\"";
            return Err(self.refuse("track.model", message));
        }
        self.wheels_in_time()?.at(speed)
    }

    /// The wheels of [`in_time`](Self::in_time) as those that wear the rail, the only ones and always under traction.
    ///
    /// # Errors
    /// Those of [`in_time`](Self::in_time), and a motion that forgets nothing in two seconds.
    pub fn passing_wheel(&self, speed: f64) -> Result<PassingWheel, CaseError> {
        self.wheels_in_time()?.passing_wheel(speed)
    }

    /// What of it does not depend on the speed, checked: the exact theory takes seconds.
    pub(crate) fn wheels_in_time(&self) -> Result<CaseInTime<'_>, CaseError> {
        let of_loop = match (&self.feedback, self.keys.general()?) {
            (Loop::General(feedback), Some(keys)) => {
                let parts = self.all_axes_in_time(feedback, &keys)?;
                OfLoop::General(feedback, Box::new(parts))
            }
            _ => OfLoop::Longitudinal(self.contact_in_time()?),
        };
        Ok(CaseInTime {
            case: self,
            of_loop,
        })
    }
}

impl CaseInTime<'_> {
    /// The same with all that any speed needs.
    pub(crate) fn at_any_speed(self) -> Result<Self, CaseError> {
        let of_loop = match self.of_loop {
            OfLoop::General(feedback, parts) => {
                let parts = self.case.all_axes_at_any_speed(feedback, *parts)?;
                OfLoop::General(feedback, Box::new(parts))
            }
            longitudinal => longitudinal,
        };
        Ok(Self { of_loop, ..self })
    }

    /// `Ok` if waves of a profile settle at a speed \[m/s\].
    fn check_stable(&self, speed: f64) -> Result<(), CaseError> {
        if let Some(stability) = self.case.stability(speed)
            && stability.unstable_roots > 0
        {
            let at = stability.frequency.map_or(String::new(), |frequency| {
                format!(" near {frequency:.0} Hz")
            });
            let message = format!(
                "at {speed} m/s the loop is unstable without any profile, an oscillation{at} grows of itself, so that no wave of \
                 a profile settles; `riffel simulate --smooth` follows it to its limit cycle"
            );
            return Err(self.case.refuse("contact.creepage", &message));
        }
        Ok(())
    }

    fn at(&self, speed: f64) -> Result<LoopInTime, CaseError> {
        Ok(match &self.of_loop {
            OfLoop::Longitudinal(creep) => self.case.passage_on(creep, speed)?.into(),
            OfLoop::General(feedback, parts) => {
                self.case.all_axes_at(feedback, parts, speed)?.into()
            }
        })
    }

    pub(crate) fn passing_wheel(&self, speed: f64) -> Result<PassingWheel, CaseError> {
        self.check_stable(speed)?;
        let model = self.at(speed)?;
        let (wear, place): (_, PlaceOfWear) = match &self.case.feedback {
            Loop::Longitudinal(feedback) => (feedback.wear, feedback.place_of_wear),
            Loop::General(feedback) => {
                let first = &feedback.contacts()[0];
                (first.wear, first.place_of_wear)
            }
        };
        Ok(PassingWheel {
            memory: self.case.keys.physics("track", model.memory())?,
            model,
            wear: WearOfPassages {
                wear,
                place,
                shortest: 2.0 * self.case.hertz.semi_axis_longitudinal(),
            },
            share: 1.0,
            traction_share: 1.0,
        })
    }
}
