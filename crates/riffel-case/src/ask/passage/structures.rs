//! Track and wheels of a case in time.

use std::f64::consts::TAU;

use riffel::Error;
use riffel::feedback::Contact;
use riffel::passage::{ImpulseResponse, StructuresInTime};
use riffel::receptance::SpatialMovingLoad;
use riffel::wheelset::RigidMass;
use riffel_keys::{CaseError, number, say};

use crate::Case;
use crate::ask;
use crate::ask::discrete_supports::moving_load_on_supports;

/// Structures of one wheel along one axis.
pub(super) fn one_wheel_in_time(case: &Case, speed: f64) -> Result<StructuresInTime, CaseError> {
    let (keys, wheel) = (&case.keys, &case.file.wheel);
    let key = match case.keys.given.track {
        Some(_) => "receptance of the track",
        None => "track.model",
    };
    let response = match case.track.support_spacing() {
        Some(_) => ImpulseResponse::over_supports(&moving_load_on_supports(case, speed)?),
        None => ImpulseResponse::of(&*case.track.receptance, speed),
    };
    let mass = RigidMass::new(keys.required("wheel.mass", wheel.mass)?.si());
    let inertia = keys.required("wheel.inertia", wheel.inertia)?.si();
    let inertia = keys.turning_wheel(inertia, case.hertz.rolling_radius())?;
    let mass = keys.physics("wheel.mass", mass)?;
    let response = keys.physics(key, response)?;
    let structures = StructuresInTime::of_one_wheel(response, &mass, Some(&inertia));
    Ok(match wheel.normal_direction {
        true => structures.with_normal_direction(&mass),
        false => structures,
    })
}

/// Track and wheels of a loop on all axes.
pub(super) fn structures_in_time(
    case: &Case,
    speed: f64,
    natural_frequencies: &[f64],
) -> Result<StructuresInTime, CaseError> {
    let feedback = &case.feedback;
    let structures = match case.spatial_track {
        Some(track) if track.support_spacing().is_some() => {
            let track = SpatialMovingLoad::new(&track, speed);
            let track = case.keys.physics("track.model", track)?;
            StructuresInTime::over_supports(feedback, &track, natural_frequencies)
        }
        _ => StructuresInTime::of(feedback, speed, natural_frequencies),
    };
    let furthest = feedback.contacts().iter().map(|contact| -contact.along);
    let furthest = furthest.fold(0.0, f64::max);
    if let Err(Error::NotCausal { share, .. }) = structures
        && furthest > 0.0
        && wheel_alone_is_causal(case, speed, natural_frequencies)
    {
        let per_cent = 100.0 * share.sqrt();
        let message = say!(the_waves_that_run_along_this, furthest, per_cent = number(format_args!("{per_cent:.1}")));
        return Err(case.refuse("train.wheels", &message));
    }
    case.keys.physics("track.model", structures)
}

/// Whether the first wheel by itself could be followed.
fn wheel_alone_is_causal(case: &Case, speed: f64, natural_frequencies: &[f64]) -> bool {
    let contacts = case.feedback.contacts().iter();
    let first: Vec<Contact> = contacts.filter(|contact| contact.along == 0.0).cloned().collect();
    let alone = case.feedback.clone().with_contacts(first);
    alone.is_ok_and(|alone| StructuresInTime::of(&alone, speed, natural_frequencies).is_ok())
}

/// Of the wheelset \[rad/s\], as far as its receptances are followed.
pub(super) fn natural_frequencies_of_wheels(case: &Case) -> Result<Vec<f64>, CaseError> {
    let Some(wheelset) = &case.wheelset else {
        return Ok(Vec::new());
    };
    let modes = ask::wheelset_modes(case, wheelset, StructuresInTime::KNOWN)?;
    let mut frequencies: Vec<f64> = modes.iter().map(|mode| TAU * mode.frequency).collect();
    // Bending in either plane has the same.
    frequencies.dedup_by(|later, earlier| *later - *earlier < 1e-3 * *earlier);
    Ok(frequencies)
}
