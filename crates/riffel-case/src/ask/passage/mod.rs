//! The wheels of a case in time.

pub(super) mod contacts;
mod structures;
mod viscous_layers;

use riffel::passage::{ContactInTime, PassageModel, PassingWheel, StructuresInTime, WearOfPassages};
use riffel_keys::CaseError;

use crate::Case;
use crate::ask;
use crate::file::TrackModel;
use contacts::{check_in_time, contacts_in_time};
use structures::{natural_frequencies_of_wheels, one_wheel_in_time, structures_in_time};
use viscous_layers::{largest_loss_of_layers, with_viscous_layers};

/// A case on its way into time, as far as the speed has no part in it.
pub(crate) struct CaseInTime<'a> {
    case: &'a Case,
    contacts: Vec<ContactInTime>,
    /// Of the wheels \[rad/s\].
    natural_frequencies: Vec<f64>,
    /// Track and wheels at all speeds, where they are known.
    structures: Option<StructuresInTime>,
}

/// Wheels, track and contacts of the case in time, at a speed \[m/s\].
///
/// # Errors
/// [`CaseError`] where the case has what is not followed through time, such as a track that is not causal, and where the
/// loop is unstable without any profile.
pub fn in_time(case: &Case, speed: f64) -> Result<PassageModel, CaseError> {
    let wheels = wheels_in_time(case)?;
    // It takes a tenth of the time of a fit.
    wheels.check_stable(speed)?;
    wheels.at(speed)
}

/// Model of the case in time, stable or not.
///
/// # Errors
/// Errors of [`in_time`], but for the last, and discrete supports.
pub fn in_time_without_profile(case: &Case, speed: f64) -> Result<PassageModel, CaseError> {
    if case.track.support_spacing().is_some() {
        let message = "on a smooth rail, wheels on discrete supports never come to rest, so that their limit cycle is not told from what \
                       supports do: choose \"two-layer\", \"one-layer\" or \"free-beam\"";
        return Err(case.refuse("track.model", message));
    }
    wheels_in_time(case)?.at(speed)
}

/// The wheels of [`in_time`] as those that wear the rail, the only ones and always under traction.
///
/// # Errors
/// Errors of [`in_time`], and a motion that forgets nothing in two seconds.
pub fn passing_wheel(case: &Case, speed: f64) -> Result<PassingWheel, CaseError> {
    wheels_in_time(case)?.passing_wheel(speed)
}

/// What of it does not depend on the speed, checked: the exact theory takes seconds.
pub(crate) fn wheels_in_time(case: &Case) -> Result<CaseInTime<'_>, CaseError> {
    check_in_time(case)?;
    Ok(CaseInTime {
        case,
        contacts: contacts_in_time(case)?,
        natural_frequencies: natural_frequencies_of_wheels(case)?,
        structures: None,
    })
}

/// Loss factor of a layer from which no causal track comes near: a search for one takes seconds.
const NEVER_CAUSAL: f64 = 0.5;

impl CaseInTime<'_> {
    /// Case in time with all that any speed needs: the structures if the track does not depend on the speed, whose fit takes seconds.
    pub(crate) fn at_any_speed(self) -> Result<Self, CaseError> {
        /// Any.
        const SPEED: f64 = 20.0;
        let structures = match self.case.file.track.model {
            TrackModel::MovingBeam => None,
            model if model.is_periodic() => None,
            _ => Some(self.structures(SPEED)?),
        };
        Ok(Self { structures, ..self })
    }

    /// Track and wheels at a speed \[m/s\].
    fn structures(&self, speed: f64) -> Result<StructuresInTime, CaseError> {
        if let Some(structures) = &self.structures {
            return Ok(structures.clone());
        }
        // What has no causal track, for its loss factors, has dashpots in their place.
        let viscous = || -> Option<StructuresInTime> {
            let (viscous, share) = with_viscous_layers(self.case)?;
            let structures = self.structures_of(&viscous, speed).ok()?;
            Some(structures.with_share_cut(share))
        };
        let lossy = largest_loss_of_layers(self.case) >= NEVER_CAUSAL;
        if let Some(structures) = lossy.then(viscous).flatten() {
            return Ok(structures);
        }
        self.structures_of(self.case, speed).or_else(|error| viscous().ok_or(error))
    }

    fn structures_of(&self, case: &Case, speed: f64) -> Result<StructuresInTime, CaseError> {
        match case.feedback.is_along_one_axis() {
            true => one_wheel_in_time(case, speed),
            false => structures_in_time(case, speed, &self.natural_frequencies),
        }
    }

    /// `Ok` if waves of a profile settle at a speed \[m/s\].
    fn check_stable(&self, speed: f64) -> Result<(), CaseError> {
        if let Some(stability) = ask::stability(self.case, speed)
            && let Some(frequency) = stability.frequency
        {
            let at = format!(" near {frequency:.0} Hz");
            let message = format!(
                "at {speed} m/s the loop is unstable without any profile, an oscillation{at} grows of itself, so that no wave of \
                 a profile settles; `riffel simulate --smooth` follows it to its limit cycle"
            );
            return Err(self.case.refuse("contact.creepage", &message));
        }
        Ok(())
    }

    fn at(&self, speed: f64) -> Result<PassageModel, CaseError> {
        Ok(PassageModel {
            structures: self.structures(speed)?,
            contacts: self.contacts.clone(),
            contact_filter: None,
            speed,
        })
    }

    pub(crate) fn passing_wheel(&self, speed: f64) -> Result<PassingWheel, CaseError> {
        self.check_stable(speed)?;
        let model = self.at(speed)?;
        let first = &self.case.feedback.contacts()[0];
        Ok(PassingWheel {
            memory: self.case.keys.physics("track", model.memory())?,
            model,
            wear: WearOfPassages {
                wear: first.wear,
                place: first.place_of_wear,
                shortest: 2.0 * self.case.hertz.semi_axis_longitudinal(),
            },
            share: 1.0,
            traction_share: 1.0,
        })
    }
}
