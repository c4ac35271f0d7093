//! A contact that moves across the profiles: its plane, its spin, and the rail that rolls under it.

use std::f64::consts::TAU;
use std::sync::Arc;

use approx::assert_relative_eq;
use proptest::prelude::*;
use riffel::contact::{Conformity, MovingContact, ShiftEffects};
use riffel::feedback::{Contact, Loop, LoopState};
use riffel::receptance::{
    Beam, ContactPoint, EulerBernoulliBeam, Layer, SpatialRail, SpatialTrack, Structure, Support, Supports, Twist,
    TwistSection, Uncoupled,
};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{Complex64, Direction, ElasticMaterial, Place, Rail};

use crate::general_loop::{AMPLITUDE, close, contact, rolling};

const RADIUS: f64 = 0.46;
const RAIL: f64 = 0.3;
const WHEEL: f64 = 0.35;

/// Two circles in the plane across the track, in the axes t and n of the contact before anything moves: the rail rolls about the
/// point where it is touched, the wheel shifts and touches again.
struct TwoCircles {
    /// Where they touch.
    contact: [f64; 2],
    /// The normal into the rail there.
    normal: [f64; 2],
    /// Where the point of the wheel has gone that touched before.
    wheel: [f64; 2],
}

impl TwoCircles {
    fn new(roll: f64, shift: f64) -> Self {
        let rail = [-RAIL * roll.sin(), RAIL * roll.cos()];
        // The centre of the wheel lies deeper, as far from that of the rail as the radii differ.
        let across = shift - rail[0];
        let apart = WHEEL - RAIL;
        let wheel = [shift, rail[1] + (apart * apart - across * across).sqrt()];
        let normal = [0, 1].map(|axis| (wheel[axis] - rail[axis]) / apart);
        Self { contact: [0, 1].map(|axis| rail[axis] - RAIL * normal[axis]), normal, wheel: [shift, wheel[1] - WHEEL] }
    }
}

/// Place, plane, radius, spin, force and moment of two circles, against the formulas of the loop by central differences.
#[test]
fn two_circles() {
    let profiles = Conformity::new(RAIL, Some(WHEEL)).unwrap();
    let (load, lateral, angle) = (60e3, -18e3, 0.35_f64);
    // On the right rail the axle lies along y = t cos γ + n sin γ, and down is −t sin γ + n cos γ.
    let (sine, cosine) = angle.sin_cos();
    let numbers = |roll: f64, shift: f64| {
        let at = TwoCircles::new(roll, shift);
        let tangent = [at.normal[1], -at.normal[0]];
        let force = [0, 1].map(|axis| load * at.normal[axis] + lateral * tangent[axis]);
        let on_wheel = [0, 1].map(|axis| at.contact[axis] - at.wheel[axis]);
        let radius = RADIUS - sine * on_wheel[0] + cosine * on_wheel[1];
        [
            at.contact[0],
            on_wheel[0],
            -radius / RADIUS,
            -(cosine * at.normal[0] + sine * at.normal[1]) / RADIUS,
            force[0],
            force[1],
            at.contact[0] * force[1] - at.contact[1] * force[0],
        ]
    };
    for (roll, shift) in [(1.0, 0.0), (0.0, 1.0), (0.3, -0.7)] {
        const STEP: f64 = 1e-6;
        let [before, after] = [-STEP, STEP].map(|step| numbers(step * roll, step * shift));
        let found: Vec<f64> =
            (before.iter().zip(after)).map(|(before, after)| (after - before) / (2.0 * STEP)).collect();
        // The roll of the wheel against the rail is minus that of the rail.
        let on_rail = profiles.shift_on_rail(-roll, shift);
        let on_wheel = profiles.shift_on_wheel(-roll, shift);
        let turn = on_wheel / WHEEL;
        let expected = [
            on_rail,
            on_wheel,
            profiles.longitudinal_creepage(angle, RADIUS, -roll, shift),
            cosine * turn / RADIUS,
            -load * turn,
            lateral * turn,
            load * on_rail,
        ];
        for (found, expected) in found.iter().zip(expected) {
            // Of the differences: the square of the step, and rounding over it.
            assert_relative_eq!(*found, expected, max_relative = 1e-7, epsilon = 1e-8);
        }
        assert!((turn - (roll + on_rail / RAIL)).abs() < 1e-14);
    }
}

/// On a rail that twists the roll by forces and by a moment is what receptances change by as the wheel touches higher, H_yy by
/// 2 (H_vθ + h H_θθ), or further out, H_zz by 2 e H_θθ; on even supports and on discrete ones, at one wheel and between two.
#[test]
fn the_roll_of_a_rail_is_that_of_its_levers() {
    let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
    let beam = |moment| Beam::from(EulerBernoulliBeam::new(steel, moment, 60.21).unwrap());
    let section = TwistSection {
        torsion_constant: 2.21e-6,
        polar_second_moment: 3.55e-5,
        warping_constant: 2.16e-8,
        centroid_height: 0.033,
        foot_depth: 0.048,
        foot_width: 0.15,
        shear_modulus: steel.shear_modulus(),
        density: 7850.0,
    };
    let rail = SpatialRail {
        lateral: Some(beam(5.123e-6)),
        twist: Some(Twist::new(steel, section).unwrap()),
        ..beam(3.0383e-5).into()
    };
    let layer = |stiffness| {
        let layer = Layer::new(stiffness, 0.0).and_then(|layer| layer.with_loss_factor(0.2));
        Some(Support::one_layer(layer.unwrap()))
    };
    let supports = Supports { vertical: layer(120e6), lateral: layer(40e6), longitudinal: None };
    let discrete = SpatialTrack::discrete(rail, supports, 0.6).unwrap();
    let even = SpatialTrack::continuous(rail, supports.per_metre(0.6).unwrap());
    let (height, offset) = (0.12, 0.015);
    for track in [discrete, even] {
        for hertz in [120.0, 700.0] {
            let w = TAU * hertz;
            let alongs = [0.2, -1.9];
            let at = |height: f64, lateral_offset: f64| {
                let point = ContactPoint { height, lateral_offset };
                track.with_contact(Rail::Right, point)
            };
            let entry = |track: &SpatialTrack, direction, to: usize, from: usize| {
                let [to, from] = [to, from].map(|place| Place { along: alongs[place], rail: Rail::Right, direction });
                track.cross_receptance(w, 0.0, to, from)
            };
            let mut rolls = [Complex64::ZERO; 16];
            let places = alongs.map(|along| (along, Rail::Right));
            at(height, offset).roll_matrix(w, 0.0, &places, &mut rolls);
            // Receptances are squares of the levers, so that differences have no error but rounding.
            const STEP: f64 = 0.05;
            for (to, from) in [(0, 0), (1, 0), (0, 1)] {
                let higher = [-STEP, STEP].map(|step| entry(&at(height + step, offset), Direction::Lateral, to, from));
                let further =
                    [-STEP, 0.0, STEP].map(|step| entry(&at(height, offset + step), Direction::Vertical, to, from));
                let expected = [
                    Complex64::ZERO,
                    (higher[1] - higher[0]) / (4.0 * STEP),
                    (further[2] - further[0]) / (4.0 * STEP),
                    (further[2] - 2.0 * further[1] + further[0]) / (2.0 * STEP * STEP),
                ];
                let between = |to: usize, from: usize| rolls[8 * to + 4 * from..][..4].iter();
                // Between two places the lever of either end counts.
                let both = between(to, from).zip(between(from, to));
                let means = both.map(|(there, back)| 0.5 * (there + back));
                for (found, expected) in means.zip(expected) {
                    assert!(
                        (found - expected).norm() <= 1e-7 * expected.norm(),
                        "{hertz} Hz, {to} {from}: {found} {expected}"
                    );
                }
            }
        }
    }
}

/// A rail of one mass and one inertia, touched above and beside its axis.
struct RollingRail;

impl RollingRail {
    const MASS: f64 = 60.0;
    const INERTIA: f64 = 0.4;
    const HEIGHT: f64 = 0.12;
    const OFFSET: f64 = 0.01;

    fn translation(w: f64) -> Complex64 {
        (-Self::MASS * w * w + Complex64::new(60e6, 6e6)).inv()
    }

    fn rotation(w: f64) -> Complex64 {
        (-Self::INERTIA * w * w + Complex64::new(2e5, 2e4)).inv()
    }

    fn lever(direction: Direction) -> f64 {
        match direction {
            Direction::Longitudinal => 0.0,
            Direction::Lateral => Self::HEIGHT,
            Direction::Vertical => Self::OFFSET,
        }
    }
}

impl Structure for RollingRail {
    fn cross_receptance(&self, w: f64, _speed: f64, at: Place, from: Place) -> Complex64 {
        if at.rail != from.rail || at.along != from.along {
            return Complex64::ZERO;
        }
        let levers = Self::lever(at.direction) * Self::lever(from.direction);
        let both = at.direction == from.direction && at.direction != Direction::Longitudinal;
        let translation = if both { Self::translation(w) } else { Complex64::ZERO };
        translation + Self::rotation(w) * levers
    }

    fn roll_matrix(&self, w: f64, _: f64, places: &[(f64, Rail)], matrix: &mut [Complex64]) {
        let rotation = Self::rotation(w);
        let rows = matrix.chunks_exact_mut(4 * places.len());
        for (row, at) in rows.zip(places) {
            for (entries, from) in row.chunks_exact_mut(4).zip(places) {
                entries.fill(Complex64::ZERO);
                if at == from {
                    for (entry, direction) in entries.iter_mut().zip(Direction::ALL) {
                        *entry = rotation * Self::lever(direction);
                    }
                    entries[3] = rotation;
                }
            }
        }
    }
}

fn state(contacts: Vec<Contact>, wavelength: f64, speed: f64) -> LoopState {
    let wheels = Uncoupled {
        longitudinal: Some(Arc::new(RigidInertia::new(40.0, RADIUS).unwrap())),
        lateral: Some(Arc::new(RigidMass::new(700.0).unwrap())),
        vertical: Some(Arc::new(RigidMass::new(400.0).unwrap())),
    };
    let general = Loop::new(Arc::new(RollingRail), Arc::new(wheels), contacts, AMPLITUDE);
    general.unwrap().at(wavelength, speed)
}

fn moving(rail: Rail, angle: f64, cross_slope: f64, effects: ShiftEffects) -> Contact {
    let moving = MovingContact {
        profiles: Conformity::new(RAIL, Some(WHEEL)).unwrap(),
        rolling_radius: RADIUS,
        cross_slope,
        effects,
    };
    Contact {
        rail,
        angle,
        moving: Some(moving),
        ..contact(0.0, rolling(1e-3, 2e-3 * rail.sign()), [Motion::Compliant(()), Motion::Compliant(())])
    }
}

proptest! {
    /// What comes out satisfies the equations of the moving contact, written down apart, with every choice of effects.
    #[test]
    fn the_state_satisfies_the_equations_of_a_moving_contact(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, cross_slope in -60.0..60.0f64, angle in 0.0..0.7f64, left: bool,
        on in proptest::array::uniform4(proptest::bool::ANY),
    ) {
        let effects = ShiftEffects {
            rolling_radius: on[0], contact_angle: on[1], spin: on[2], rail_roll: on[3],
        };
        let rail = if left { Rail::Left } else { Rail::Right };
        let contact = moving(rail, angle, cross_slope, effects);
        let state = state(vec![contact.clone()], wavelength, speed);
        let [found] = &state.contacts[..] else { panic!() };
        let steady = contact.rolling.steady();
        let w = TAU * speed / wavelength;
        let one = |effect: bool| if effect { 1.0 } else { 0.0 };

        // Displacements of the rail against the wheel, of the forces in the axes of the mean state and of the moment.
        let (sine, cosine) = (rail.sign() * angle.sin(), angle.cos());
        let levers = [
            0.0,
            RollingRail::HEIGHT * cosine - RollingRail::OFFSET * sine,
            RollingRail::HEIGHT * sine + RollingRail::OFFSET * cosine,
        ];
        let rotation = RollingRail::rotation(w) * one(on[3]);
        let moment = found.shift * steady.normal_force;
        let both = |row: usize, column: usize| {
            state.track_receptance[row][column] + state.wheel_receptance[row][column]
        };
        // y_w = y + u_t needs u_t, which needs the turn β = y_w/R_t: a line in y_w.
        let displacement = |axis: usize, on_wheel: Complex64| {
            let turn = on_wheel * one(on[1]) / WHEEL;
            let forces = [
                found.force[0],
                found.force[1] - turn * steady.normal_force,
                found.force[2] + turn * steady.forces.lateral,
            ];
            let by_forces = (0..3).map(|column| both(axis, column) * forces[column]);
            by_forces.sum::<Complex64>() + rotation * levers[axis] * moment
        };
        let per_displacement = Complex64::new(0.0, -TAU / wavelength);
        let across = found.creepage[1] / per_displacement;
        let on_wheel = found.shift + across;
        let largest = across.norm() + found.shift.norm();
        prop_assert!((displacement(1, on_wheel) - across).norm() < 1e-9 * largest);
        let turn = on_wheel * one(on[1]) / WHEEL;
        let forces = [
            found.force[0],
            found.force[1] - turn * steady.normal_force,
            found.force[2] + turn * steady.forces.lateral,
        ];
        let roll = rotation * (levers[1] * forces[1] + levers[2] * forces[2] + moment);
        let profiles = Conformity::new(RAIL, Some(WHEEL)).unwrap();
        let slope = rail.sign() * cross_slope * AMPLITUDE;
        let shift = (slope - roll + across / WHEEL) * profiles.relative_radius();
        prop_assert!((shift - found.shift).norm() < 1e-9 * (largest + slope.abs()));
        close(found.force[2] / contact.stiffness + displacement(2, on_wheel), AMPLITUDE.into());
        let by_radius = rail.sign() * angle.sin() / RADIUS * on_wheel * one(on[0]);
        let along = per_displacement * displacement(0, on_wheel) + by_radius;
        prop_assert!((along - found.creepage[0]).norm() < 1e-9 * (along.norm() + by_radius.norm()));
        let spin = angle.cos() / (RADIUS * WHEEL) * on_wheel * one(on[2]);
        prop_assert!((spin - found.spin).norm() <= 1e-9 * spin.norm());

        let response = contact.rolling.response(wavelength);
        let (by_lateral, by_spin) = (response.by_lateral.unwrap(), response.by_spin.unwrap());
        let inputs = [
            (response.by_load, found.force[2]),
            (response.by_longitudinal, found.creepage[0]),
            (by_lateral, found.creepage[1]),
            (by_spin, found.spin),
        ];
        for axis in 0..2 {
            let creep: Complex64 = inputs.iter().map(|(by, input)| by.force[axis] * input).sum();
            let whole: f64 = inputs.iter().map(|(by, input)| (by.force[axis] * input).norm()).sum();
            prop_assert!((creep - found.force[axis]).norm() < 1e-9 * whole);
        }
        let energy: Complex64 = inputs.iter().map(|(by, input)| by.energy * input).sum();
        prop_assert!((energy - found.energy).norm() <= 1e-9 * energy.norm());
        // The two ways to the growth rate, by the state and by the equations of the row.
        assert_relative_eq!(state.growth_rate, found.growth_rate.unwrap(), max_relative = 1e-8);
    }
}

/// Mirrored on the other rail a moving contact grows alike, and wheels far apart grow as one each.
#[test]
fn a_moving_contact_has_a_mirror_image() {
    let alone = |contact: Contact| state(vec![contact], 0.06, 20.0).growth_rate;
    let right = alone(moving(Rail::Right, 0.05, 20.0, ShiftEffects::ALL));
    // The offset of the rail is to the right on both: turned over it is the other side of the head.
    let level = |rail| alone(moving(rail, 0.0, 0.0, ShiftEffects::ALL));
    assert!(level(Rail::Right).is_finite() && level(Rail::Left).is_finite());
    let behind = |along: f64| Contact { along, ..moving(Rail::Right, 0.05, 20.0, ShiftEffects::ALL) };
    // This rail answers at one place alone.
    let two = state(vec![behind(0.0), behind(-2.0)], 0.06, 20.0).growth_rate;
    assert_relative_eq!(two, right, max_relative = 1e-9);
}
