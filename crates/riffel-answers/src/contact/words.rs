//! The contact of a case in words.

use riffel::contact::KalkerCoefficients;
use riffel_case::SteadyContact;
use riffel_case::file::CreepLawName;
use riffel_keys::{Message, fixed, say};

use super::RollingTheories;
use crate::answer::titled;

/// The ellipse, the mean state and what the table after them shows.
pub(super) fn introduction(theories: &RollingTheories, has_response: bool) -> Vec<Message> {
    let hertz = &theories.hertz;
    let KalkerCoefficients { c11, c22, c23, c33 } = theories.laws.kalker;
    let mut lines = vec![
        titled(theories.contact.file.title.as_ref(), say!(contact_title)),
        say!(
            ellipse_of_contact,
            along = fixed(2e3 * hertz.semi_axis_longitudinal(), 2),
            across = fixed(2e3 * hertz.semi_axis_lateral(), 2),
            approach = fixed(1e6 * hertz.approach(), 1)
        ),
        say!(
            pressure_and_stiffness,
            pressure = fixed(1e-6 * hertz.peak_pressure(), 0),
            stiffness = fixed(1e-6 * hertz.stiffness(), 0)
        ),
        say!(kalker_coefficients, c11 = fixed(c11, 3), c22 = fixed(c22, 3), c23 = fixed(c23, 3), c33 = fixed(c33, 3)),
    ];
    match theories.along_rail() {
        true => lines.push(say!(
            mean_state_along_rail,
            ratio = fixed(theories.exact_tractive_ratio(), 3),
            creepage = fixed(100.0 * theories.state.creepage(), 4)
        )),
        false => lines.extend(steady(theories)),
    }
    lines.extend((!has_response).then(|| say!(no_slope_near_full_slip)));
    lines.push(say!(tractive_ratio_over_creepage));
    lines
}

/// Steady rolling about a table of creepages: by the law of the case, and by the exact one.
fn steady(theories: &RollingTheories) -> Vec<Message> {
    let exact = SteadyContact::exact(&theories.half_space, &theories.state);
    let mut steady = vec![(&exact, CreepLawName::HALF_SPACE)];
    if theories.contact.law.is_some() {
        steady.insert(0, (&theories.steady, theories.contact.creep_law()));
    }
    let nothing = || Message::verbatim("");
    let lines = steady.into_iter().map(|(steady, law)| {
        let forces = steady.rolling.forces;
        say!(
            mean_state_by_law,
            law = law.name(),
            along = fixed(1e-3 * forces.longitudinal, 3),
            across = fixed(1e-3 * forces.lateral, 3),
            ratio = fixed(steady.rolling.tractive_ratio(), 3),
            moment =
                (steady.spin_moment).map_or_else(nothing, |moment| say!(with_spin_moment, moment = fixed(moment, 2))),
            energy = (steady.energy_per_metre())
                .map_or_else(nothing, |energy| say!(with_energy_per_metre, energy = fixed(energy, 2)))
        )
    });
    lines.collect()
}
