//! Contacts of wheels and rails under load.

use approx::assert_relative_eq;
use riffel::HertzContact;
use riffel::contact::HalfSpace;

use super::*;
use crate::fixtures::steel;
use crate::profile::{ContactSurface, NominalProfile, Profile, Track, Wheels};

const RAIL_RADIUS: f64 = 0.3;

/// A cylinder, with a flange far off, on the arc of a circle.
fn circles() -> WheelsetOnTrack {
    let points = |range: std::ops::RangeInclusive<i32>, height: fn(f64) -> f64| -> Vec<[f64; 2]> {
        let point = |x: f64| [x, height(x)];
        range.map(|index| point(1e-3 * f64::from(index))).collect()
    };
    let wheel = points(-65..=40, |x| -11.0 * (x + 0.035).min(0.0).powi(2));
    let rail = points(-16..=30, |x| (RAIL_RADIUS * RAIL_RADIUS - x * x).sqrt() - RAIL_RADIUS);
    let [wheel, rail] = [wheel, rail].map(|points| Profile::through(&points).unwrap());
    WheelsetOnTrack {
        wheels: Wheels::new([&wheel, &wheel], [0.46; 2], 1.36, -0.07).unwrap(),
        track: Track::new([&rail, &rail], 1.435, 3e-4, 0.0).unwrap(),
    }
}

fn nominal() -> WheelsetOnTrack {
    let profile = |name: &str| NominalProfile::named(name).unwrap().profile();
    let (wheel, rail) = (profile("S1002"), profile("60E1"));
    WheelsetOnTrack {
        wheels: Wheels::new([&wheel, &wheel], [0.46; 2], 1.36, -0.07).unwrap(),
        track: Track::new([&rail, &rail], 1.435, 0.014, 0.025).unwrap(),
    }
}

/// Constant curvatures: the gap is theirs, and the contact that of Hertz. Tolerances: elements, 48 across a box of 1.2
/// patches; the area is a staircase; strips of the spline's arc.
#[test]
fn a_wheel_of_circles_is_that_of_hertz() {
    let wheelset = circles();
    let contact = wheelset.contact(0.0, 0.0).unwrap();
    let exact = HertzContact::exact(steel(), 0.46, RAIL_RADIUS, 50e3).unwrap();
    for rail in Rail::BOTH {
        let loaded = wheelset.under_load(&contact, rail, steel(), 50e3, ContactSurface::Flat, 48).unwrap();
        for (x, y) in [(3e-3, 0.0), (0.0, 4e-3), (-2e-3, 3e-3)] {
            let parabola = x * x / 0.92 + 0.5 * y * y / RAIL_RADIUS;
            assert_relative_eq!(loaded.gap().at(x, y), parabola, max_relative = 3e-4);
        }
        let state = loaded.state();
        assert_relative_eq!(state.load(), 50e3, max_relative = 1e-12);
        assert_relative_eq!(state.approach(), exact.approach(), max_relative = 5e-4);
        assert_relative_eq!(state.peak_pressure(), exact.peak_pressure(), max_relative = 3e-3);
        assert_relative_eq!(loaded.stiffness().unwrap(), exact.stiffness(), max_relative = 3e-3);
        let area = std::f64::consts::PI * exact.semi_axis_longitudinal() * exact.semi_axis_lateral();
        assert_relative_eq!(state.contact_area(), area, max_relative = 0.03);
        let [a, b] = loaded.equivalent_semi_axes();
        assert_relative_eq!(a, exact.semi_axis_longitudinal(), max_relative = 3e-3);
        assert_relative_eq!(b, exact.semi_axis_lateral(), max_relative = 3e-3);
        assert_relative_eq!(loaded.hertz().unwrap().approach(), exact.approach(), max_relative = 1e-3);
        assert!(loaded.centre_of_pressure().iter().all(|place| place.abs() < 1e-6));
        // 2b over the radius of the rail, less the elements at the rim.
        let turn = 2.0 * exact.semi_axis_lateral() / RAIL_RADIUS;
        assert_relative_eq!(loaded.inclination().unwrap(), turn, max_relative = 0.06);
    }
}

/// On the ellipse the patch rolls as [`HalfSpace`] does. 1.5 % of μP: both of first order in their elements, whose edges
/// are other staircases.
#[test]
fn an_ellipse_rolls_as_a_half_space() {
    let wheelset = circles();
    let contact = wheelset.contact(0.0, 0.0).unwrap();
    let loaded = wheelset.under_load(&contact, Rail::Right, steel(), 50e3, ContactSurface::Flat, 40).unwrap();
    let hertz = HertzContact::exact(steel(), 0.46, RAIL_RADIUS, 50e3).unwrap();
    let half_space = HalfSpace::new(hertz, 0.3, 40).unwrap();
    for creepages in [Creepages::longitudinal(1e-3), Creepages { longitudinal: -6e-4, lateral: 5e-4, spin: 0.4 }] {
        let (forces, moment) = loaded.roll(creepages, |_, _| 0.3).unwrap();
        let other = half_space.roll_with(creepages).unwrap();
        let of_grid = other.forces();
        let off = (forces.longitudinal - of_grid.longitudinal).hypot(forces.lateral - of_grid.lateral);
        assert!(off < 0.015 * 15e3, "{forces:?} {of_grid:?}");
        assert!((moment - other.spin_moment()).abs() < 0.5, "{moment} {}", other.spin_moment());
    }
    // Full sliding takes the friction of each place: half of it on one side.
    let halved = |_: f64, y: f64| if y < 0.0 { 0.15 } else { 0.3 };
    let (forces, _) = loaded.roll(Creepages::longitudinal(0.05), halved).unwrap();
    assert_relative_eq!(forces.longitudinal, 0.225 * 50e3, max_relative = 5e-3);
}

/// The mirrored wheelset presses and rolls as the wheelset does, mirrored.
#[test]
fn contact_under_load_is_symmetric() {
    let wheelset = nominal();
    let (shift, yaw) = (2.3e-3, 0.004);
    let one = wheelset.contact(shift, yaw).unwrap();
    let other = wheelset.contact(-shift, -yaw).unwrap();
    let one = wheelset.under_load(&one, Rail::Right, steel(), 60e3, ContactSurface::Flat, 32).unwrap();
    let other = wheelset.under_load(&other, Rail::Left, steel(), 60e3, ContactSurface::Flat, 32).unwrap();
    assert_relative_eq!(one.state().approach(), other.state().approach(), max_relative = 1e-9);
    assert_relative_eq!(one.gap().on_track()[1], -other.gap().on_track()[1], max_relative = 1e-9);
    assert!((one.gap().on_track()[0] - other.gap().on_track()[0]).abs() < 1e-9);
    assert_relative_eq!(one.centre_of_pressure()[1], -other.centre_of_pressure()[1], max_relative = 1e-6);
    let creepages = Creepages { longitudinal: 5e-4, lateral: 4e-4, spin: 0.2 };
    let mirrored = Creepages { longitudinal: 5e-4, lateral: -4e-4, spin: -0.2 };
    let (right, right_moment) = one.roll(creepages, |_, _| 0.35).unwrap();
    let (left, left_moment) = other.roll(mirrored, |_, _| 0.35).unwrap();
    assert_relative_eq!(right.longitudinal, left.longitudinal, max_relative = 1e-4);
    assert_relative_eq!(right.lateral, -left.lateral, max_relative = 1e-4);
    assert_relative_eq!(right_moment, -left_moment, max_relative = 1e-3);
}

/// Kik & Piotrowski beside the exact contact on S1002 and 60E1 at 60 kN, by which nothing was chosen: on one place of the
/// head to 4 % of the approach, 21 % of the peak pressure, 11 % of the area (measured: 3.6, 20.0, 10.6); Hertz there up to 25 %
/// of the pressure. At 5 mm the exact patch reaches over two places, and the fast one meets its approach in the first alone: 24 %.
#[test]
fn fast_patch_beside_the_exact_one() {
    let wheelset = nominal();
    let limits = |millimetre: i32| match millimetre {
        5 => [0.25, 0.46, 0.11],
        1 => [0.04, 0.21, 0.11],
        _ => [0.035, 0.09, 0.06],
    };
    for millimetre in [-6, -4, -1, 1, 3, 5] {
        let contact = wheelset.contact(1e-3 * f64::from(millimetre), 0.0).unwrap();
        let loaded = wheelset.under_load(&contact, Rail::Right, steel(), 60e3, ContactSurface::Flat, 32).unwrap();
        let (exact, fast) = (loaded.state(), loaded.fast());
        let errors = [
            fast.approach / exact.approach() - 1.0,
            fast.peak_pressure() / exact.peak_pressure() - 1.0,
            fast.contact_area() / exact.contact_area() - 1.0,
        ];
        for (error, limit) in errors.iter().zip(limits(millimetre)) {
            assert!(error.abs() < limit, "{millimetre} mm: {errors:?}");
        }
        // It is not the exact one in disguise.
        assert!(errors[0] < -0.02 && errors[1] < -0.05, "{millimetre} mm: {errors:?}");
    }
}

#[test]
fn loads_and_grids_that_cannot_be_are_refused() {
    let wheelset = circles();
    let contact = wheelset.contact(0.0, 0.0).unwrap();
    for (load, elements) in [(0.0, 48), (-1.0, 48), (f64::NAN, 48), (50e3, 8), (50e3, 500)] {
        let loaded = wheelset.under_load(&contact, Rail::Left, steel(), load, ContactSurface::Flat, elements);
        assert!(matches!(loaded.err(), Some(ProfileError::Contact(_))), "{load} {elements}");
    }
}

/// On a rail of 300 mm both surfaces agree to the square of the inclination at the edge, 0.017 rad.
#[test]
fn a_curved_surface_that_turns_little_is_flat() {
    let wheelset = circles();
    let contact = wheelset.contact(0.0, 0.0).unwrap();
    let [flat, curved] = [ContactSurface::Flat, ContactSurface::Curved]
        .map(|surface| wheelset.under_load(&contact, Rail::Right, steel(), 50e3, surface, 32).unwrap());
    assert_relative_eq!(curved.state().load(), 50e3, max_relative = 1e-9);
    for (one, other) in [
        (flat.state().approach(), curved.state().approach()),
        (flat.state().peak_pressure(), curved.state().peak_pressure()),
        (flat.stiffness().unwrap(), curved.stiffness().unwrap()),
        (flat.equivalent_semi_axes()[1], curved.equivalent_semi_axes()[1]),
    ] {
        assert_relative_eq!(one, other, max_relative = 1e-3);
    }
}

/// Slip on the curved surface is that of a wheel that turns about its axle, by cross products in the contact plane with x
/// along, y to the right and z into the rail. 1e-9 of 1/r: chords of the surface.
#[test]
fn slip_on_the_curved_surface_is_that_of_rigid_bodies() {
    let wheelset = nominal();
    let contact = wheelset.contact(-4e-3, 0.0).unwrap();
    for rail in Rail::BOTH {
        let loaded = wheelset.under_load(&contact, rail, steel(), 80e3, ContactSurface::Curved, 16).unwrap();
        let side = rail.sign();
        let (sine, cosine) = loaded.gap.contact_angle().sin_cos();
        let radius = loaded.rolling_radius;
        // Axle to the right, and down.
        let axle = [0.0, cosine, side * sine];
        let down = [0.0, -side * sine, cosine];
        let creepages = Creepages { spin: -side * sine / radius, ..Creepages::default() };
        let [_, [low, high]] = loaded.ends();
        assert!(loaded.inclination().unwrap() > 0.02);
        for (x, y) in [(3e-3, low), (-2e-3, high), (0.0, 0.5 * (low + high))] {
            let place = loaded.surface.at(y);
            let from_centre = [x + radius * down[0], place.y + radius * down[1], place.depth + radius * down[2]];
            let turning = [
                axle[1] * from_centre[2] - axle[2] * from_centre[1],
                axle[2] * from_centre[0] - axle[0] * from_centre[2],
                axle[0] * from_centre[1] - axle[1] * from_centre[0],
            ];
            let slip = [1.0 - turning[0] / radius, -turning[1] / radius, -turning[2] / radius];
            let (rise, across) = place.inclination.sin_cos();
            let expected = [slip[0], across * slip[1] - side * rise * slip[2]];
            let found = loaded.rigid_slip(creepages, x, y);
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9, "{found} {expected}");
            }
            // Far from nothing.
            assert!(expected.iter().any(|slip| slip.abs() > 1e-6));
        }
    }
}

/// The mirrored wheelset on the curved surface.
#[test]
fn the_curved_surface_is_symmetric() {
    let wheelset = nominal();
    let one = wheelset.contact(-3e-3, 0.002).unwrap();
    let other = wheelset.contact(3e-3, -0.002).unwrap();
    let pressed = |contact: &WheelsetContact, rail| {
        wheelset.under_load(contact, rail, steel(), 60e3, ContactSurface::Curved, 24).unwrap()
    };
    let (one, other) = (pressed(&one, Rail::Right), pressed(&other, Rail::Left));
    assert_relative_eq!(one.state().approach(), other.state().approach(), max_relative = 1e-9);
    assert_relative_eq!(one.centre_of_pressure()[1], -other.centre_of_pressure()[1], epsilon = 1e-9);
    let creepages = |side: f64| Creepages { longitudinal: 5e-4, lateral: side * 4e-4, spin: side * 0.2 };
    let (right, right_moment) = one.roll(creepages(1.0), |_, _| 0.35).unwrap();
    let (left, left_moment) = other.roll(creepages(-1.0), |_, _| 0.35).unwrap();
    assert_relative_eq!(right.longitudinal, left.longitudinal, max_relative = 1e-4);
    assert_relative_eq!(right.lateral, -left.lateral, max_relative = 1e-4);
    assert_relative_eq!(right_moment, -left_moment, max_relative = 1e-3);
}
