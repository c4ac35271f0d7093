//! The contacts of a case in time.

use riffel::Rail;
use riffel::feedback::Contact;
use riffel::passage::{ContactInTime, DamageInTime, TransientContact, WaveInTime};
use riffel_keys::{CaseError, Message, say};

use crate::Case;
use crate::build::CreepInTime;
use crate::file::{ContactDynamics, Rotation};
use crate::keys::general_keys::{ContactKeys, GeneralKeys};
use crate::parts::wheelset::CaseWheelset;

/// Most contacts that are followed in time.
const MOST_CONTACTS: usize = 8;

/// The contacts of the loop, that under study first.
pub(super) fn contacts_in_time(case: &Case) -> Result<Vec<ContactInTime>, CaseError> {
    let keys = case.keys.general()?;
    let contacts = case.feedback.contacts().iter();
    contacts
        .map(|contact| match &keys {
            None => one_contact_in_time(case, contact),
            Some(keys) => contact_of_loop_in_time(case, contact, keys),
        })
        .collect()
}

/// The contact of one wheel along one axis.
fn one_contact_in_time(case: &Case, of_loop: &Contact) -> Result<ContactInTime, CaseError> {
    let (keys, friction) = (&case.keys, case.steady.friction);
    let CreepInTime { law, late, wave } = match &case.law {
        Some(law) => CreepInTime { law: law.clone(), late: None, wave: None },
        None => keys.exact_in_time(case.hertz, friction)?,
    };
    let contact = ContactInTime::of_one_wheel(case.steady, case.hertz.stiffness(), law);
    let contact = keys.physics("contact", contact)?;
    let even = case.file.wheel.rotation() == Rotation::ConstantCreepage;
    Ok(ContactInTime {
        wave: wave.or_else(|| WaveInTime::of(of_loop)),
        late,
        held: [even, contact.held[1]],
        damage: DamageInTime::of(&case.feedback, of_loop),
        ..contact
    })
}

fn contact_of_loop_in_time(case: &Case, contact: &Contact, keys: &GeneralKeys) -> Result<ContactInTime, CaseError> {
    let side = keys_of_side(keys, contact.rail);
    let steel = case.keys.steel()?;
    let hertz = case.keys.hertz_of(steel, side)?;
    let Some(law) = case.keys.creep_law(hertz, side.friction)? else {
        let message = say!(quasi_static_in_time);
        return Err(case.refuse("contact.creep_law", message));
    };
    let in_time = ContactInTime::new(contact, law);
    Ok(ContactInTime { damage: DamageInTime::of(&case.feedback, contact), ..case.keys.physics("contact", in_time)? })
}

/// `Ok` if the loop of the case can be followed through time.
pub(super) fn check_in_time(case: &Case) -> Result<(), CaseError> {
    let refuse = |key: &str, message: Message| Err(case.refuse(key, message));
    let on_all_axes = !case.feedback.is_along_one_axis();
    let contacts = case.feedback.contacts();
    if contacts.len() > MOST_CONTACTS {
        let message = say!(the_case_has_contacts_but_a, count = contacts.len(), most_contacts = MOST_CONTACTS);
        return refuse("train.wheels", message);
    }
    if on_all_axes && case.keys.given.track.is_some() {
        let message = say!(track_of_all_frequencies_in_time);
        return refuse("track", message);
    }
    if case.keys.given.wheel.is_some() {
        let message = say!(rigid_wheel_in_time);
        return refuse("wheel", message);
    }
    if matches!(case.wheelset.as_deref(), Some(CaseWheelset::Measured(_))) {
        let message = say!(wheelset_of_all_frequencies_in_time);
        return refuse("wheelset.model", message);
    }
    match case.file.contact.response {
        ContactDynamics::SpringDashpot => {
            let message = say!(no_spring_dashpot_in_time);
            return refuse("contact.response", message);
        }
        ContactDynamics::NonSteady if on_all_axes => {
            let message = "on all axes a passage in time takes a contact that answers at once, `contact.response` = \"quasi-static\"";
            return refuse("contact.response", message.into());
        }
        _ => {}
    }
    if contacts.iter().any(|contact| contact.moving.is_some()) {
        let message = say!(contacts_at_rest_in_time);
        return refuse("contact.conformity", message);
    }
    if case.wheelset.is_none() && case.file.wheel.rotation() == Rotation::ConstantTangentialForce {
        let message = say!(no_constant_force_in_time);
        return refuse("wheel.rotation", message);
    }
    Ok(())
}

/// The contact of the half-space to roll element by element, on `contact.grid` elements or one more; over the true gap of a wave where
/// its geometry has a part.
pub fn transient_contact(case: &Case) -> TransientContact {
    let grid = usize::try_from(case.file.contact.grid).unwrap_or(usize::MAX);
    TransientContact {
        hertz: case.hertz,
        friction: case.steady.friction,
        across: grid.next_multiple_of(2),
        over_true_gap: case.file.contact.wave_geometry == Some(true),
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
    use crate::ask;
    use crate::fixtures::{case, trailer};

    /// Wheels on all axes pass discrete supports, but do not come to rest on them.
    // Long: fits a rail on discrete supports in time on all axes.
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
        let passage = ask::in_time(&case, 20.0).unwrap();
        assert_eq!(passage.structures.support_spacing(), Some(0.6));
        let Err(error) = ask::in_time_without_profile(&case, 20.0) else {
            panic!("a smooth rail on supports was taken");
        };
        assert!(error.to_string().contains("never come to rest"), "{error}");
    }

    /// A slab with direct fastenings, whose rail loses little, once swung up by a response that was free above 3.5 kHz.
    // Long: fits the answer to an impulse of a rail on discrete fastenings.
    #[test]
    fn a_rail_of_little_loss_comes_to_rest() -> Result<(), CaseError> {
        let model = ask::in_time(&Case::parse("metro", crate::METRO_CASE, &[])?, 22.0)?;
        assert!(model.memory().is_ok_and(|memory| memory < 10.0));
        Ok(())
    }

    #[test]
    fn what_is_not_followed_through_time_is_refused() {
        let even = ["wheel.rotation=constant-creepage", "contact.creep_law=polach"];
        assert!(ask::in_time(&case(NOMINAL_CASE, &even), 30.0).is_ok());
        let nominal = |rotation| case(NOMINAL_CASE, &[rotation]);
        for (case, words) in [
            (nominal("wheel.rotation=constant-tangential-force"), "leaves the rail"),
            (nominal("contact.response=spring-dashpot"), "small oscillations only"),
            (trailer(&["contact.response=spring-dashpot"]), "small oscillations only"),
            (trailer(&["train.wheels=[0, 2, 4, 6, 8]"]), "10 contacts"),
        ] {
            let Err(error) = ask::in_time(&case, 15.0) else {
                panic!("{words} was taken");
            };
            assert!(error.to_string().contains(words), "{error}");
        }
    }
}
