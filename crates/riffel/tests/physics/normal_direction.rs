//! What the direction of the normal force on a wave does in a loop.

use std::sync::Arc;

use proptest::prelude::*;
use riffel::contact::{CurvatureFilter, MeanState, QuasiStatic, WaveGeometry, WavePatch};
use riffel::feedback::{Contact, NormalDirection, OneWheel};
use riffel::growth::RowEvaluator;
use riffel::receptance::{Structure, Uncoupled};
use riffel::wheelset::{
    Axle, ContactGeometry, Disc, FlexibleWheelset, Motion, RigidBody, RigidInertia, RigidMass, RigidWheelset, Segment,
    Wheelset, WheelsetWithHubs,
};
use riffel::{Complex64, ElasticMaterial, Loop, Rail, Receptance};

use crate::fixtures;
use crate::paper::{close, free_beam, law_on_wave as law};

const RADIUS: f64 = 0.46;
const LOAD: f64 = 50e3;
const MASS: f64 = 350.0;
const INERTIA: f64 = 27.7725;
const AMPLITUDE: f64 = 1e-6;

fn rigid(mass: f64) -> Arc<RigidMass> {
    Arc::new(RigidMass::new(mass).unwrap())
}

/// A wheel whose hub moves along the rail as a mass.
fn turning(mass: f64) -> RigidInertia {
    let turning = RigidInertia::new(INERTIA, RADIUS).unwrap();
    turning.with_moving_hub(mass).unwrap()
}

/// The paper's wheel on waves that have a geometry, or on none.
fn one_wheel(ratio: f64, on_waves: bool, mass: f64) -> OneWheel {
    let mean = MeanState::TractiveRatio(ratio);
    let rolling = QuasiStatic::new(law(0.0).unwrap(), LOAD, mean).unwrap();
    let patch = WavePatch::Ellipse(Arc::new(CurvatureFilter::of(&fixtures::hertz()).unwrap()));
    OneWheel {
        rotation: Motion::compliant(turning(mass)),
        contact: Arc::new(rolling.on_waves(law).unwrap()),
        wave: on_waves.then(|| WaveGeometry::new(RADIUS, patch).unwrap()),
        ..fixtures::one_wheel(free_beam(), fixtures::hertz(), 0.4, ratio)
    }
}

/// Loop of which the normal force is along the normal of the wave.
fn turned(ratio: f64, on_waves: bool, mass: f64) -> Loop {
    let feedback = one_wheel(ratio, on_waves, mass).close().unwrap();
    feedback.with_normal_direction(NormalDirection::Lone(rigid(mass)))
}

/// e₁/(e₀Δ) at the rail point \[1/m\] that the direction adds.
fn added(feedback: &Loop, wavelength: f64, speed: f64) -> f64 {
    let plain = feedback.clone().without_normal_direction();
    let [with, without] = [feedback, &plain].map(|feedback| {
        let energy = feedback.at(wavelength, speed).contacts[0].energy_at_rail;
        (energy / feedback.steady().energy_per_metre() / AMPLITUDE).re
    });
    with - without
}

/// Two digits of the theory, per metre of amplitude in braking; the term is the same with the geometry of the wave and without.
#[test]
fn its_size_is_that_of_the_theory() {
    for (ratio, wavelength, speed, mass, expected, digits) in [
        (0.1, 0.0557, 30.0, MASS, -990.0, 5.0),
        (0.1, 0.0557, 30.0, 1000.0, -370.0, 5.0),
        (0.95, 0.0557, 30.0, MASS, -44.0, 0.5),
        (0.95, 0.0557, 30.0, 1000.0, -15.0, 0.5),
        (0.1, 0.03, 10.0, MASS, -2800.0, 50.0),
        (0.1, 0.03, 10.0, 1000.0, -1200.0, 50.0),
    ] {
        for on_waves in [false, true] {
            let got = added(&turned(ratio, on_waves, mass), wavelength, speed);
            assert!((got - expected).abs() <= digits, "{got} {expected}");
        }
    }
}

/// A rail that is a free rod along itself, under a wheel that does not move so: −420, −24, −1200.
#[test]
fn a_rod_yields_under_it() {
    /// A rail of 56 kg/m and its steel.
    struct Rod;
    impl Receptance for Rod {
        fn receptance(&self, w: f64, _speed: f64) -> Complex64 {
            let wavenumber = w * (7850.0f64 / 207e9).sqrt();
            (Complex64::new(0.0, 2.0 * wavenumber * 207e9 * 56.0 / 7850.0)).inv()
        }
    }
    for (ratio, wavelength, speed, expected, digits) in
        [(0.1, 0.0557, 30.0, -420.0, 5.0), (0.95, 0.0557, 30.0, -24.0, 0.5), (0.1, 0.03, 10.0, -1200.0, 50.0)]
    {
        let joints = one_wheel(ratio, false, 1e12);
        let contacts = joints.clone().close().unwrap().contacts().to_vec();
        let track =
            Uncoupled { longitudinal: Some(Arc::new(Rod)), vertical: Some(joints.track), ..Uncoupled::default() };
        let wheels = Uncoupled {
            longitudinal: Some(Arc::new(turning(1e12))),
            vertical: Some(joints.wheel),
            ..Uncoupled::default()
        };
        let feedback = Loop::new(Arc::new(track), Arc::new(wheels), contacts, AMPLITUDE);
        let feedback = feedback.unwrap();
        let feedback = feedback.with_normal_direction(NormalDirection::Lone(rigid(1e12)));
        let got = added(&feedback, wavelength, speed);
        assert!((got - expected).abs() <= digits, "{got} {expected}");
    }
}

proptest! {
    /// Of a rigid wheel the slip is that of a mass which climbs, −P₀Δ/(MV²). The general equations are the closed form, and maps are the points.
    #[test]
    fn all_paths_agree(
        wavelength in 0.02..0.2f64, speed in 5.0..60.0f64, ratio in 0.05..0.95f64, mass in 50.0..2e3f64, kind in 0..3usize,
        on_waves: bool,
    ) {
        let mut joints = one_wheel(ratio, on_waves, mass);
        joints.rotation = [joints.rotation.clone(), Motion::Held, Motion::Free][kind].clone();
        let hubs = || NormalDirection::Lone(rigid(mass));
        let closed = joints.clone().close().unwrap().with_normal_direction(hubs());
        let contact = closed.contacts()[0].clone();
        // Nothing moves across, but nothing holds the wheel there.
        let contact = Contact { motion: [contact.motion[0].clone(), Motion::Compliant(())], ..contact };
        let wheels = Uncoupled {
            longitudinal: Some(Arc::new(turning(mass))),
            lateral: None,
            vertical: Some(joints.wheel.clone()),
        };
        let track = Uncoupled { vertical: Some(joints.track.clone()), ..Uncoupled::default() };
        let general = Loop::new(Arc::new(track), Arc::new(wheels), vec![contact], AMPLITUDE).unwrap();
        let general = general.with_normal_direction(hubs());
        prop_assert!(closed.is_along_one_axis() && !general.is_along_one_axis());
        let (one, other) = (closed.at(wavelength, speed), general.at(wavelength, speed));
        let (first, second) = (one.contacts[0], other.contacts[0]);
        close(second.energy, first.energy, 1e-10);
        close(second.energy_at_rail, first.energy_at_rail, 1e-10);
        if kind == 0 {
            let slip = -LOAD * AMPLITUDE / (mass * speed * speed);
            close(first.slip_by_direction.unwrap(), slip.into(), 1e-12);
            close(second.slip_by_direction.unwrap(), slip.into(), 1e-12);
        } else {
            // Nothing where the creepage is held, or follows the force.
            let plain = joints.close().unwrap().at(wavelength, speed);
            prop_assert_eq!(plain.normalized_dissipation, one.normalized_dissipation);
        }
        for feedback in [&closed, &general] {
            let mut row = [Complex64::ZERO; 3];
            RowEvaluator::new(feedback, &[wavelength, 0.05, 0.06]).evaluate(speed, &mut row);
            close(row[0], one.normalized_dissipation, 1e-9);
        }
    }

    /// Without a turn of the axle, a force on both hubs moves a flexible wheelset of stiff steel as the rigid one; and hubs are contacts of a
    /// wheel without a radius.
    #[test]
    fn hubs_move_as_sections_do(frequency in 20.0..300.0f64) {
        let contacts = ContactGeometry { contact_spacing: 1.5, rolling_radius: RADIUS };
        let stiff = ElasticMaterial::new(207e16, 0.3).unwrap();
        let axle = Axle::new(stiff, 7850.0, vec![Segment { length: 2.0, diameter: 0.16 }]).unwrap();
        let disc = |position| Disc {
            position, mass: 330.0, polar_inertia: 38.0, diametral_inertia: 20.0, coupled: None,
        };
        let flexible = FlexibleWheelset::new(axle, vec![disc(-0.75), disc(0.75)], contacts).unwrap();
        let rigid = RigidWheelset::new(flexible.rigid_body(), contacts).unwrap();
        let w = std::f64::consts::TAU * frequency;
        let (one, other) = (flexible.hubs(w), rigid.hubs(w));
        for (at, from) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            close(one[at][from], other[at][from], 1e-5);
        }
        let RigidBody { mass, .. } = rigid.body();
        close(other[0][0] + other[0][1], Complex64::from(-2.0 / (mass * w * w)), 1e-12);
        // A force at the contact turns the axle besides.
        let turn = -RADIUS * RADIUS / (rigid.body().spin_inertia * w * w);
        close(rigid.receptances(w)[3][0] - other[1][0], turn.into(), 1e-9);
    }

    /// Two wheels on a rigid axle under the same wave climb together: in phase each is a wheel of half the mass, and the opposite rail in
    /// antiphase yaws the axle.
    #[test]
    fn a_wheelset_climbs_as_a_whole(wavelength in 0.03..0.2f64, speed in 5.0..60.0f64, antiphase: bool, second: bool) {
        let joints = one_wheel(0.3, true, MASS);
        let first = joints.clone().close().unwrap().contacts()[0].clone();
        let profile = if antiphase { -1.0 } else { 1.0 };
        let mut contacts = vec![first.clone(), Contact { rail: Rail::Left, profile, ..first.clone() }];
        if second {
            contacts.extend(contacts.clone().into_iter().map(|contact| Contact { along: -40.0, ..contact }));
        }
        let geometry = ContactGeometry { contact_spacing: 1.5, rolling_radius: RADIUS };
        // Yaw moves a contact as half the mass does.
        let body = RigidBody { mass: 2.0 * MASS, roll_inertia: 2.0 * MASS * 0.75 * 0.75, spin_inertia: 2.0 * INERTIA };
        let wheelset = Arc::new(RigidWheelset::new(body, geometry).unwrap());
        let track = Arc::new(Uncoupled { vertical: Some(joints.track), ..Uncoupled::default() });
        let wheels: Arc<dyn Structure> = wheelset.clone();
        let feedback = Loop::new(track, wheels, contacts, AMPLITUDE).unwrap();
        let feedback = feedback.with_normal_direction(NormalDirection::OfWheelsets(wheelset));
        let state = feedback.at(wavelength, speed);
        let slip = -LOAD * AMPLITUDE / (MASS * speed * speed);
        for contact in &state.contacts {
            let phase = contact.slip_by_direction.unwrap().norm();
            prop_assert!((phase + slip).abs() < 1e-9 * phase);
        }
        close(state.contacts[0].slip_by_direction.unwrap(), slip.into(), 1e-9);
        if !antiphase {
            // Turning as one they are the lone wheel.
            let lone = turned(0.3, true, MASS).at(wavelength, speed);
            close(state.contacts[0].energy_at_rail, lone.contacts[0].energy_at_rail, 1e-9);
            let mut row = [Complex64::ZERO; 1];
            RowEvaluator::new(&feedback, &[wavelength]).evaluate(speed, &mut row);
            close(row[0], lone.normalized_dissipation, 1e-9);
        }
    }
}

/// A rigid wheel in time, from Newton's law alone: its centre follows the rail x(t), the normal force has the direction of the
/// normal of the wave there, brakes the hub and does not turn the wheel; the creep force brakes both. No formula of the loop goes in.
#[test]
fn newtons_law_has_it() {
    const SPEED: f64 = 20.0;
    const WAVELENGTH: f64 = 0.08;
    const STEPS: usize = 4000;
    const WAVES: usize = 400;
    // High enough to be told from rounding, low enough to be linear.
    let amplitude = 1e-7;
    let steady = one_wheel(0.3, false, MASS).close().unwrap();
    let steady = steady.steady();
    let [creepage, force] = [steady.creepages.longitudinal, steady.forces.longitudinal];
    let law = law(0.0).unwrap();
    let slope = {
        use riffel::contact::{CreepLaw, Creepages};
        let at = Creepages::longitudinal(creepage);
        law.derivatives(LOAD, at).by_longitudinal.longitudinal
    };
    let wavenumber = std::f64::consts::TAU / WAVELENGTH;
    let step = WAVELENGTH / SPEED / STEPS as f64;
    // Speeds of the hub and of the rim against it, beside the mean.
    let accelerate = |time: f64, [hub, rim]: [f64; 2]| {
        let slip = (hub - rim) / SPEED;
        let creep = force + slope * slip;
        let slope_of_rail = -wavenumber * amplitude * (wavenumber * SPEED * time).sin();
        // The drive holds the mean of both.
        let along = -LOAD * slope_of_rail - (creep - force);
        [along / MASS, (creep - force) * RADIUS * RADIUS / INERTIA]
    };
    let mut state = [0.0; 2];
    let mut harmonic = Complex64::ZERO;
    for index in 0..WAVES * STEPS {
        let time = index as f64 * step;
        let ahead = |by: [f64; 2], share: f64| [0, 1].map(|i| state[i] + share * step * by[i]);
        let one = accelerate(time, state);
        let two = accelerate(time + 0.5 * step, ahead(one, 0.5));
        let three = accelerate(time + 0.5 * step, ahead(two, 0.5));
        let four = accelerate(time + step, ahead(three, 1.0));
        state = [0, 1].map(|i| state[i] + step / 6.0 * (one[i] + 2.0 * two[i] + 2.0 * three[i] + four[i]));
        if index >= (WAVES - 1) * STEPS {
            let turn = Complex64::cis(-wavenumber * SPEED * (time + step));
            harmonic += 2.0 / STEPS as f64 * turn * (state[0] - state[1]) / SPEED;
        }
    }
    // What the oscillation of the load does comes on top of it in the loop.
    let with = turned(0.3, false, MASS);
    let plain = with.clone().without_normal_direction();
    let [with, plain] = [with, plain].map(|feedback| feedback.at(WAVELENGTH, SPEED).creepage());
    close(harmonic / amplitude, (with - plain) / AMPLITUDE, 1e-3);
}
