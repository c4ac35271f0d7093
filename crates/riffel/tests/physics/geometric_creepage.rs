//! Creepage by a contact that moves across the profiles, in the loop on all axes.

use std::f64::consts::TAU;
use std::sync::Arc;

use approx::assert_relative_eq;
use proptest::prelude::*;
use riffel::contact::{Conformity, MovingContact, ShiftEffects};
use riffel::feedback::{Contact, Loop, LoopState};
use riffel::receptance::Uncoupled;
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{Complex64, Rail};

use crate::general_loop::{AMPLITUDE, close, contact, rolling, wheel};

const ANGLE: f64 = 0.05;
const RADIUS: f64 = 0.46;

/// A wheel that yields on all axes, on a track that yields downward and across.
fn at(contact: Contact, wavelength: f64, speed: f64) -> LoopState {
    let mass = |mass: f64| Some(Arc::new(RigidMass::new(mass).unwrap()) as _);
    let track = Uncoupled { longitudinal: None, lateral: mass(60.0), vertical: mass(90.0) };
    let wheels = Uncoupled {
        longitudinal: Some(Arc::new(RigidInertia::new(40.0, RADIUS).unwrap())),
        lateral: mass(700.0),
        vertical: mass(400.0),
    };
    let general = Loop::new(Arc::new(track), Arc::new(wheels), vec![contact], AMPLITUDE);
    general.unwrap().at(wavelength, speed)
}

fn moving(along: Motion<()>, lateral: f64, geometry: Option<MovingContact>) -> Contact {
    Contact { angle: ANGLE, moving: geometry, ..contact(0.0, rolling(1e-3, lateral), [along, Motion::Compliant(())]) }
}

/// Profiles of a rail of 0.3 m and a wheel of 0.5 m, and a ripple of some cross slope.
fn geometry(cross_slope: f64) -> MovingContact {
    of_profiles(Conformity::new(0.3, Some(0.5)).unwrap(), cross_slope)
}

/// Creepage by the rolling radius alone.
fn of_profiles(profiles: Conformity, cross_slope: f64) -> MovingContact {
    MovingContact { profiles, rolling_radius: RADIUS, cross_slope, effects: ShiftEffects::ROLLING_RADIUS }
}

proptest! {
    /// What comes out satisfies the equations as models of the field print them: the creepage along the rail is that of the
    /// motion, −iω u/V, and that of the rolling radius where the contact is, on the right rail and on the left one.
    #[test]
    fn the_state_satisfies_the_equations(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, cross_slope in -80.0..80.0f64, left: bool, held: bool,
    ) {
        let along = if held { Motion::Held } else { Motion::Compliant(()) };
        let (rail, outward) = if left { (Rail::Left, -1.0) } else { (Rail::Right, 1.0) };
        let contact = Contact { rail, ..moving(along, 2e-3 * outward, Some(geometry(cross_slope))) };
        let state = at(contact.clone(), wavelength, speed);
        let [found] = &state.contacts[..] else { panic!() };
        let moved: [Complex64; 3] = std::array::from_fn(|row| {
            let columns = 0..3;
            columns.map(|column| {
                let both = state.track_receptance[row][column] + state.wheel_receptance[row][column];
                both * found.force[column]
            }).sum()
        });
        close(found.force[2] / contact.stiffness + moved[2], AMPLITUDE.into());
        let per_displacement = Complex64::new(0.0, -TAU / wavelength);
        close(found.creepage[1], per_displacement * moved[1]);

        let profiles = Conformity::new(0.3, Some(0.5)).unwrap();
        // To the right: the wheel against the rail, and the cross slope of the ripple as roll.
        let (shift, roll) = (-moved[1], outward * cross_slope * AMPLITUDE);
        let creep = |shift: f64, roll: f64| {
            outward * profiles.longitudinal_creepage(ANGLE, RADIUS, roll, shift)
        };
        let by_geometry = Complex64::new(creep(shift.re, roll), creep(shift.im, 0.0));
        let by_motion = if held { Complex64::ZERO } else { per_displacement * moved[0] };
        let whole = by_geometry.norm() + by_motion.norm();
        prop_assert!((found.creepage[0] - by_geometry - by_motion).norm() <= 1e-11 * whole);

        let response = contact.rolling.response(wavelength);
        let lateral = response.by_lateral.unwrap();
        let of = |by_load: Complex64, by_along: Complex64, by_across: Complex64| {
            by_load * found.force[2] + by_along * found.creepage[0] + by_across * found.creepage[1]
        };
        for axis in 0..2 {
            let by_creepage = [response.by_longitudinal.force[axis], lateral.force[axis]];
            let expected = of(response.by_load.force[axis], by_creepage[0], by_creepage[1]);
            // Terms cancel: to rounding of the largest, and of the shift beside a displacement.
            let terms = [
                response.by_load.force[axis] * found.force[2],
                by_creepage[0] * found.creepage[0],
                by_creepage[1] * found.creepage[1],
            ];
            let whole: f64 = terms.iter().map(|term| term.norm()).sum();
            prop_assert!((found.force[axis] - expected).norm() <= 1e-10 * whole);
        }
        let energy = of(response.by_load.energy, response.by_longitudinal.energy, lateral.energy);
        prop_assert!((found.energy - energy).norm() <= 1e-11 * energy.norm());
        // The two ways to the growth rate, by the state and by the equations of the row.
        assert_relative_eq!(state.growth_rate, found.growth_rate.unwrap(), max_relative = 1e-9);
    }
}

/// A contact that stays is one whose profiles have no slope or whose wheel turns freely; mirrored on the
/// other rail it grows alike.
#[test]
fn a_contact_that_stays_creeps_by_motion_alone() {
    let growth = |contact: Contact| at(contact, 0.06, 20.0).growth_rate;
    let compliant = Motion::Compliant(());
    let stays = growth(moving(compliant.clone(), 2e-3, None));
    let level = |moving| Contact { angle: 0.0, ..self::moving(compliant.clone(), 2e-3, moving) };
    // One equation more: to rounding.
    let [flat, level] = [Some(geometry(20.0)), None].map(|moving| growth(level(moving)));
    assert_relative_eq!(flat, level, max_relative = 1e-12);
    let free = |geometry| growth(moving(Motion::Free, 2e-3, geometry));
    assert_relative_eq!(free(Some(geometry(20.0))), free(None), max_relative = 1e-12);
    let right = moving(compliant, 2e-3, Some(geometry(20.0)));
    let left = Contact { rail: Rail::Left, ..moving(Motion::Compliant(()), -2e-3, Some(geometry(20.0))) };
    assert!((growth(right.clone()) / stays - 1.0).abs() > 1e-2);
    assert_relative_eq!(growth(left), growth(right), max_relative = 1e-12);
}

/// A wheelset that turns evenly creeps along the rail by geometry alone, in phase with the ripple: half the radius of
/// the head, half the creepage.
#[test]
fn an_evenly_turning_wheel_creeps_as_the_ripple_slopes() {
    let along = |rail_radius: f64| {
        let cone = Conformity::new(rail_radius, None).unwrap();
        let contact = Contact {
            angle: ANGLE,
            moving: Some(of_profiles(cone, 20.0)),
            ..contact(0.0, rolling(1e-3, 0.0), [Motion::Held, Motion::Held])
        };
        let track = Uncoupled::default();
        let general = Loop::new(Arc::new(track), Arc::new(wheel(400.0, 40.0)), vec![contact], AMPLITUDE);
        general.unwrap().at(0.06, 20.0).contacts[0].creepage[0]
    };
    let expected = ANGLE.sin() / RADIUS * 0.3 * 20.0 * AMPLITUDE;
    close(along(0.3), expected.into());
    close(along(0.15), (0.5 * expected).into());
}
