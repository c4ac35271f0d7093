//! Responses at many wavelengths.

use super::every_direction::{derivatives, oblique};
use super::{contact, hertz};
use crate::contact::half_space::*;

const ALONG: OscillatingCreepages = OscillatingCreepages::Longitudinal;

/// A table that was made for one wavelength says the same, bit for bit, as one that was made for a wide window.
#[test]
fn table_of_the_response_does_not_depend_on_its_window() {
    let contact = contact(16);
    let state = contact.roll_at_tractive_ratio(0.2).unwrap();
    let table = |from, to| crate::contact::NonSteady::new(&contact, &state, ALONG, from, to, 1e-4).unwrap();
    let wide = table(0.02, 0.1);
    for wavelength in [0.02, 0.0311, 0.055, 0.1] {
        for other in [table(wavelength, wavelength), table(0.6 * wavelength, 1.7 * wavelength)] {
            assert_eq!(
                crate::RollingContact::response(&other, wavelength),
                crate::RollingContact::response(&wide, wavelength)
            );
        }
    }
}

/// The table between its nodes, at places that are none of those it was checked at.
#[test]
fn table_of_the_response() {
    let contact = contact(16);
    let state = contact.roll_at_tractive_ratio(0.2).unwrap();
    let to = |tolerance| crate::contact::NonSteady::new(&contact, &state, ALONG, 0.02, 0.1, tolerance).unwrap();
    for tolerance in [1e-2, 1e-4] {
        let table = to(tolerance);
        for wavelength in [0.02, 0.0213, 0.037, 0.0771, 0.1] {
            let (got, expected) =
                (crate::RollingContact::response(&table, wavelength), contact.response(&state, wavelength).unwrap());
            let (rail, expected_rail) = (
                [got.by_load.at_rail(0.0), got.by_longitudinal.at_rail(0.0)],
                [expected.by_load.at_rail(0.0), expected.by_longitudinal.at_rail(0.0)],
            );
            for (got, expected) in [
                (got.by_load.force[0], expected.by_load.force[0]),
                (got.by_longitudinal.force[0], expected.by_longitudinal.force[0]),
                (rail[0], expected_rail[0]),
                (rail[1], expected_rail[1]),
            ] {
                assert!((got - expected).norm() < 2.0 * tolerance * expected.norm(), "{wavelength}");
            }
        }
    }
    let table = to(1e-4);
    assert!(crate::RollingContact::response(&table, 0.01).by_load.force[0].is_nan());
}

/// Where short waves do not converge, the longer ones are those of a table that never asked for them.
#[test]
fn table_begins_where_it_converges() {
    let contact = contact(16);
    let state = contact.roll_at_tractive_ratio(0.5).unwrap();
    // Of the order of what the iteration leaves of short waves.
    let from = |shortest| crate::contact::NonSteady::new(&contact, &state, ALONG, shortest, 0.5, 3e-6).unwrap();
    let table = from(0.01);
    let known = crate::RollingContact::known_from(&table);
    assert!((0.011..0.1).contains(&known), "{known}");
    let other = from(1.5 * known);
    for wavelength in [1.5 * known, 0.2, 0.5] {
        let [one, other] = [&table, &other].map(|it| crate::RollingContact::response(it, wavelength));
        assert_eq!(one, other);
    }
    assert!(crate::RollingContact::response(&table, 0.9 * known).by_load.force[0].is_nan());
}

/// Many wavelengths at once say what each says alone, but for the residual of 1e-5 that both leave, and cost less than
/// a fifth of it.
// Long: solves the contact at forty wavelengths one by one, with which the sweep is compared.
#[test]
fn sweep_is_what_each_wavelength_says() {
    use super::influence::CONVOLUTIONS;
    let contact = contact(24);
    let state = contact.roll_with(oblique()).unwrap();
    let a = hertz().semi_axis_longitudinal();
    let count = 40;
    let wavelengths: Vec<f64> =
        (0..count).map(|index| 2.0 * a * 50.0_f64.powf(f64::from(index) / f64::from(count - 1))).collect();
    let before = CONVOLUTIONS.get();
    let told = std::cell::Cell::new(0);
    let progress = || told.set(told.get() + 1);
    let swept = contact.responses(&state, &wavelengths, OscillatingCreepages::All, progress);
    assert_eq!(told.get(), wavelengths.len());
    let between = CONVOLUTIONS.get();
    assert_eq!(swept.len(), wavelengths.len());
    let alone = wavelengths.iter().map(|&wavelength| contact.response(&state, wavelength).unwrap());
    for (swept, alone) in swept.into_iter().zip(alone) {
        for (swept, alone) in derivatives(swept.unwrap()).iter().zip(derivatives(alone)) {
            let size = alone.force[0].norm().hypot(alone.force[1].norm());
            for part in 0..2 {
                assert!((swept.force[part] - alone.force[part]).norm() < 1e-4 * size);
            }
            let size = alone.energy.norm().max(alone.at_rail(0.0).norm());
            assert!((swept.energy - alone.energy).norm() < 1e-4 * size);
            assert!((swept.at_rail(0.0) - alone.at_rail(0.0)).norm() < 1e-4 * size);
        }
    }
    let (sweep, each) = (between - before, CONVOLUTIONS.get() - between);
    assert!(5 * sweep < each, "{sweep} {each}");
}

#[test]
fn outside_in_takes_each_once() {
    for count in 0..20 {
        let mut order = super::outside_in(count);
        assert!(count < 3 || order[..2] == [0, count - 1]);
        order.sort_unstable();
        assert_eq!(order, (0..count).collect::<Vec<_>>());
    }
}
