//! Wheels on all axes in time, against the track fitted by itself, the linear loop and another way to integrate.

use std::f64::consts::TAU;
use std::sync::Arc;

use riffel::contact::{
    CreepEllipse, CreepLaw, Creepages, CurvatureFilter, FallingFriction, KalkerCoefficients, MeanState, Polach,
    QuasiStatic, SlopeReduction, WaveGeometry, WavePatch,
};
use riffel::feedback::{Contact, Loop};
use riffel::passage::{
    ContactInTime, Evolution, EvolutionStep, ImpulseResponse, Outcome, PassageModel, PassingWheel, Sinusoid,
    StructuresInTime, WearOfPassages,
};
use riffel::receptance::{
    Beam, ContinuousTrack, EulerBernoulliBeam, Layer, SpatialRail, SpatialTrack, Structure, Support, Supports,
    Uncoupled,
};
use riffel::roughness::Profile;
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{Carter3d, Complex64, DissipationPhase, PlaceOfWear, Receptance, RollingContact};

use crate::general_loop::{contact, hertz, wheel};

const RADIUS: f64 = 0.46;
const MASS: f64 = 500.0;
const INERTIA: f64 = 40.0;
const SPEED: f64 = 25.0;

fn rail() -> Beam {
    let steel = hertz().material();
    Beam::from(EulerBernoulliBeam::new(steel, 3e-5, 60.0).unwrap())
}

fn pads() -> Support {
    Support::one_layer(Layer::new(200e6, 30e3).unwrap())
}

fn track() -> Arc<dyn Receptance> {
    Arc::new(ContinuousTrack::new(rail(), pads()))
}

fn in_time(feedback: &Loop, law: &Arc<dyn CreepLaw>, speed: f64) -> PassageModel {
    let contacts = feedback.contacts().iter();
    let contacts = contacts.map(|contact| ContactInTime::new(contact, law.clone()).unwrap());
    PassageModel {
        contacts: contacts.collect(),
        structures: StructuresInTime::of(feedback, speed, &[]).unwrap(),
        contact_filter: None,
        speed,
    }
}

/// One wheel along one axis, its track fitted by itself and together with the wheel, over waves of 90 µm, where the wheel nearly leaves or leaves the
/// rail: harmonics to 3·10⁻⁵ of the first, which the fits leave.
#[test]
fn one_wheel_along_one_axis_is_the_same() {
    let law: Arc<dyn CreepLaw> = Arc::new(Carter3d::new(hertz(), 0.35).unwrap());
    let mean = MeanState::TractiveRatio(0.4);
    let rolling = QuasiStatic::new(law.clone(), 60e3, mean).unwrap();
    let mean = rolling.steady();
    let track = track();
    let response = ImpulseResponse::of(&*track, SPEED).unwrap();
    let (mass, inertia) = (RigidMass::new(MASS).unwrap(), RigidInertia::new(INERTIA, RADIUS).unwrap());
    let one = PassageModel {
        structures: StructuresInTime::of_one_wheel(response, &mass, Some(&inertia)),
        contacts: vec![ContactInTime::of_one_wheel(mean, hertz().stiffness(), law.clone()).unwrap()],
        contact_filter: None,
        speed: SPEED,
    };
    let vertical = Uncoupled { vertical: Some(track), ..Uncoupled::default() };
    let motion = [Motion::Compliant(()), Motion::Held];
    let general = Loop::new(
        Arc::new(vertical),
        Arc::new(wheel(MASS, INERTIA)),
        vec![contact(0.0, Arc::new(rolling), motion)],
        1e-6,
    );
    let all = in_time(&general.unwrap(), &law, SPEED);
    let profile = Sinusoid { amplitude: 90e-6, wavelength: 0.03 };
    let expected = one.settle(profile, 256).unwrap().swap_remove(0);
    let got = all.settle(profile, 256).unwrap().swap_remove(0);
    assert!(expected.normal_force[0] < 0.2 * 60e3, "{:?}", expected.normal_force);
    let close = |got: Complex64, expected: Complex64, first: Complex64| {
        assert!((got - expected).norm() < 3e-5 * first.norm(), "{got} {expected}");
    };
    let firsts = expected.harmonics[1];
    for (got, expected) in got.harmonics.iter().zip(&expected.harmonics) {
        close(got.normal_force, expected.normal_force, firsts.normal_force);
        close(got.tangential_force, expected.tangential_force, firsts.tangential_force);
        close(got.creepage, expected.creepage, firsts.creepage);
        close(got.dissipation, expected.dissipation, firsts.dissipation);
        assert!(got.lateral_force.norm() == 0.0);
    }
    // Of a profile as well, place by place.
    let heights = (0..16_000).map(|index| 10e-6 * (f64::from(index) * 0.1047).sin());
    let profile = Profile::new(0.0, 1e-3, heights.collect()).unwrap();
    let [one, all] = [one.pass(&profile, 5e-4), all.pass(&profile, 5e-4)].map(Result::unwrap);
    let pairs = one.contacts.iter().zip(&all.contacts).skip(3000);
    for (one, all) in pairs {
        assert!((one.normal_force - all.normal_force).abs() < 30.0);
    }
}

/// Two wheels on one rail that creep along and across it, and feel the waves' own geometry if asked to.
fn two_wheels(on_waves: bool) -> (Loop, Arc<dyn CreepLaw>) {
    let bent = |curvature: f64| {
        let hertz = hertz().with_longitudinal_radius(RADIUS / (1.0 + curvature))?;
        Carter3d::new(hertz, 0.35)
    };
    let law: Arc<dyn CreepLaw> = Arc::new(bent(0.0).unwrap());
    let mean = MeanState::Creepages(Creepages { longitudinal: 5e-4, lateral: 1e-3, spin: 0.0 });
    let rolling = QuasiStatic::new(law.clone(), 60e3, mean).unwrap();
    let rolling: Arc<dyn RollingContact> = Arc::new(rolling.on_waves(bent).unwrap());
    let patch = Arc::new(CurvatureFilter::of(&hertz()).unwrap());
    let wave = WaveGeometry::new(RADIUS, WavePatch::Ellipse(patch)).unwrap();
    let semi_axis = hertz().semi_axis_longitudinal();
    let place = PlaceOfWear::new(DissipationPhase::Lag, semi_axis, 0.4);
    let rails = SpatialRail { vertical: rail(), lateral: None, twist: None, longitudinal: None };
    let supports = Supports { vertical: Some(pads()), ..Supports::default() };
    let track = SpatialTrack::continuous(rails, supports);
    let wheels =
        TwoWheels(Uncoupled { lateral: Some(Arc::new(RigidMass::new(MASS).unwrap())), ..wheel(MASS, INERTIA) });
    let motion = [Motion::Compliant(()), Motion::Compliant(())];
    let contacts = [0.0, -1.3].map(|along| Contact {
        wave: on_waves.then(|| wave.clone()),
        place_of_wear: place,
        ..contact(along, rolling.clone(), motion.clone())
    });
    let feedback = Loop::new(Arc::new(track), Arc::new(wheels), contacts.to_vec(), 1e-7);
    (feedback.unwrap(), law)
}

/// Wheels that do not feel each other but through the rail.
struct TwoWheels(Uncoupled);

impl Structure for TwoWheels {
    fn cross_receptance(&self, w: f64, speed: f64, at: riffel::Place, from: riffel::Place) -> Complex64 {
        self.0.cross_receptance(w, speed, at, from)
    }
}

/// First harmonics over 1 µm are those of the linear loop with the waves' own geometry, of which they would lack a tenth without it.
#[test]
fn waves_bend_contacts_in_time() {
    let (feedback, law) = two_wheels(true);
    let model = in_time(&feedback, &law, SPEED);
    for wavelength in [0.03, 0.06, 0.11] {
        let (amplitude, scale) = (1e-6, 1e-6 / feedback.amplitude());
        let profile = Sinusoid { amplitude, wavelength };
        let linear = feedback.at(wavelength, SPEED);
        let plain = feedback.clone().without_wave_geometry().at(wavelength, SPEED);
        let settled = model.settle(profile, 512).unwrap();
        for (index, settled) in settled.iter().enumerate() {
            let first = &settled.harmonics[1];
            let of = |state: &riffel::LoopState| {
                let contact = &state.contacts[index];
                let [along, across] = contact.force[..2] else { panic!("three axes") };
                let values = [along, across, contact.creepage[0], contact.creepage[1], contact.energy];
                values.map(|value| scale * value)
            };
            let got = [
                first.tangential_force,
                first.lateral_force,
                first.creepage,
                first.lateral_creepage,
                first.dissipation,
            ];
            let mut most = 0f64;
            for ((got, expected), plain) in got.into_iter().zip(of(&linear)).zip(of(&plain)) {
                let off = (got - expected).norm() / expected.norm();
                assert!(off < 1e-3, "{wavelength} {index}: {got} {expected} {off:.1e}");
                most = most.max((plain - expected).norm() / expected.norm());
            }
            assert!(most > 0.1, "{wavelength} {index}: {most}");
        }
    }
}

/// Growth over passages of two wheels that answer each other through the rail is the mean growth of the linear loop: Heun's
/// steps leave 10⁻³ of it, the step of the march and the fit as much.
#[test]
fn growth_under_two_wheels_is_linear_growth() {
    for on_waves in [false, true] {
        growth_is_linear(two_wheels(on_waves));
    }
}

fn growth_is_linear((feedback, law): (Loop, Arc<dyn CreepLaw>)) {
    let model = in_time(&feedback, &law, SPEED);
    let first: &Contact = &feedback.contacts()[0];
    let (waves, length, count) = (50, 3.0, 3000);
    let wavelength = length / f64::from(waves);
    let heights = (0..count).map(|index| 0.1e-6 * (TAU * f64::from(waves * index) / f64::from(count)).cos());
    let profile = Profile::new(0.0, length / f64::from(count), heights.collect()).unwrap();
    let wheel = PassingWheel {
        memory: model.memory().unwrap(),
        model,
        wear: WearOfPassages { wear: first.wear, place: first.place_of_wear, shortest: 0.015 },
        share: 1.0,
        traction_share: 1.0,
    };
    let step = EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: 5e-4 };
    let mut evolution = Evolution::new(&profile);
    let amplitude = |evolution: &Evolution| evolution.waves()[waves as usize - 1].1.norm();
    let before = amplitude(&evolution);
    for _ in 0..2 {
        evolution.advance(&[&wheel], &step, u64::MAX).unwrap();
    }
    let rate = (amplitude(&evolution) / before).ln() / evolution.passages() as f64;
    let linear = feedback.at(wavelength, SPEED);
    let scale = linear.contacts[0].energy_at_rail.norm() / linear.contacts[0].energy_at_rail.re.abs();
    let error = (rate / linear.growth_rate - 1.0).abs() / scale;
    assert!(error < 5e-3, "{rate:e} for {:e}", linear.growth_rate);
}

/// Halving the step quarters what it changes: the error of first harmonics goes with its square.
#[test]
fn second_order_on_all_axes() {
    let (feedback, law) = two_wheels(false);
    let model = in_time(&feedback, &law, SPEED);
    let profile = Sinusoid { amplitude: 20e-6, wavelength: 0.07 };
    let [coarse, middle, fine] = [64, 128, 256].map(|steps| {
        let settled = model.settle(profile, steps).unwrap();
        settled[1].harmonics[1].lateral_force
    });
    let order = ((coarse - middle).norm() / (middle - fine).norm()).log2();
    assert!((order - 2.0).abs() < 0.1, "{order}");
}

/// A mass on a spring across the track under falling friction: frequency and range of its limit cycle are those of
/// Runge and Kutta's fourth-order method on the same equation, m u'' + c u' + k u = Q(η₀ − u'/V) − Q₀.
// Long: follows a mass until it swings evenly.
#[test]
fn limit_cycle_of_one_mass() {
    let (mass, natural) = (400.0, TAU * 120.0);
    let (stiffness, damping) = (mass * natural * natural, 2.0 * 0.01 * mass * natural);
    let speed = 12.0;
    let kalker = KalkerCoefficients::new(0.3, hertz().axis_ratio()).unwrap();
    let ellipse = CreepEllipse::new(hertz(), kalker);
    let falling = FallingFriction { static_friction: 0.4, limit_ratio: 0.4, decay: 2.0 };
    let polach = Polach::new(ellipse, falling, SlopeReduction::NONE, speed).unwrap();
    let law: Arc<dyn CreepLaw> = Arc::new(polach);
    let mean = Creepages { longitudinal: 0.0, lateral: 0.02, spin: 0.0 };
    let rolling = QuasiStatic::new(law.clone(), 60e3, MeanState::Creepages(mean)).unwrap();
    let motion = [Motion::Held, Motion::Compliant(())];
    let wheels = Uncoupled {
        lateral: Some(Arc::new(Oscillator([mass, damping, stiffness]))),
        vertical: Some(Arc::new(RigidMass::new(MASS).unwrap())),
        longitudinal: None,
    };
    let vertical = Uncoupled { vertical: Some(track()), ..Uncoupled::default() };
    let contacts = vec![contact(0.0, Arc::new(rolling), motion)];
    let feedback = Loop::new(Arc::new(vertical), Arc::new(wheels), contacts, 1e-6).unwrap();
    assert_eq!(feedback.stability(speed, 1.0, 1e4).unwrap().unstable_roots, 2);
    let motion = in_time(&feedback, &law, speed).on_smooth_rail(1.0, None).unwrap();
    assert_eq!(motion.outcome, Outcome::LimitCycle);

    let force = |speed_of_mass: f64| {
        let creepages = Creepages { lateral: mean.lateral - speed_of_mass / speed, ..mean };
        law.forces(60e3, creepages).lateral
    };
    let rest = force(0.0);
    let rate = |[place, moving]: [f64; 2]| {
        let pushed = force(moving) - rest;
        [moving, (pushed - damping * moving - stiffness * place) / mass]
    };
    let step = 2e-5;
    let on = |state: [f64; 2], by: [f64; 2], share: f64| [0, 1].map(|index| state[index] + share * step * by[index]);
    let mut state = [1e-5, 0.0];
    let (mut largest, mut crossings, mut range) = (0f64, Vec::new(), [f64::INFINITY, 0.0]);
    for index in 0..200_000 {
        let a = rate(state);
        let b = rate(on(state, a, 0.5));
        let c = rate(on(state, b, 0.5));
        let d = rate(on(state, c, 1.0));
        let mean = [0, 1].map(|index| (a[index] + 2.0 * (b[index] + c[index]) + d[index]) / 6.0);
        let next = on(state, mean, 1.0);
        if index > 150_000 {
            if state[0] < 0.0 && next[0] >= 0.0 {
                crossings.push(f64::from(index) - state[0] / (next[0] - state[0]));
            }
            let creepage = 0.02 - next[1] / speed;
            largest = largest.max(creepage);
            let force = force(next[1]);
            range = [range[0].min(force), range[1].max(force)];
        }
        state = next;
    }
    let periods = (crossings.len() - 1) as f64;
    let frequency = periods / ((crossings[crossings.len() - 1] - crossings[0]) * step);
    let swing = motion.contacts[0];
    let close = |got: f64, expected: f64| {
        assert!((got / expected - 1.0).abs() < 2e-3, "{got} for {expected}");
    };
    close(motion.frequency.unwrap(), frequency);
    close(swing.lateral_creepage[1], largest);
    close(swing.lateral_force[0], range[0]);
    close(swing.lateral_force[1], range[1]);
    assert!(swing.stick > 0.05 && swing.stick < 0.9);
}

/// H = 1/(k + iωc − mω²).
struct Oscillator([f64; 3]);

impl Receptance for Oscillator {
    fn receptance(&self, w: f64, _: f64) -> Complex64 {
        let Self([mass, damping, stiffness]) = self;
        Complex64::new(stiffness - mass * w * w, damping * w).inv()
    }
}
