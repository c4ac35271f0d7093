//! What the shape of a wave itself does in a loop.

use std::sync::Arc;

use proptest::prelude::*;
use riffel::contact::{
    Carter3d, CreepLaw, Creepages, CurvatureFilter, FullSliding, MeanState, QuasiStatic, SpringDashpot, WaveGeometry,
    WavePatch,
};
use riffel::feedback::{Contact, OneWheel};
use riffel::growth::RowEvaluator;
use riffel::receptance::Uncoupled;
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Complex64, DissipationPhase, EnergyWear, Error, HertzContact, Loop, PlaceOfWear, Rail, Receptance, RollingContact,
};

use crate::fixtures;
use crate::paper::{close, free_beam, hertz_on_wave as hertz, law_on_wave as law};

const RADIUS: f64 = 0.46;
const LOAD: f64 = 50e3;
const FRICTION: f64 = 0.4;
const AMPLITUDE: f64 = 1e-6;

fn rolling(ratio: f64) -> QuasiStatic<Carter3d> {
    let mean = MeanState::TractiveRatio(ratio);
    let rolling = QuasiStatic::new(law(0.0).unwrap(), LOAD, mean).unwrap();
    rolling.on_waves(law).unwrap()
}

fn patch() -> WavePatch {
    WavePatch::Ellipse(Arc::new(CurvatureFilter::of(&hertz(0.0).unwrap()).unwrap()))
}

fn wave(patch: WavePatch) -> Option<WaveGeometry> {
    Some(WaveGeometry::new(RADIUS, patch).unwrap())
}

fn one_wheel(ratio: f64, phase: DissipationPhase, inertia: f64) -> OneWheel {
    let hertz = fixtures::hertz();
    OneWheel {
        rotation: Motion::compliant(RigidInertia::new(inertia, RADIUS).unwrap()),
        contact: Arc::new(rolling(ratio)),
        place_of_wear: PlaceOfWear::new(phase, hertz.semi_axis_longitudinal(), ratio),
        wave: wave(patch()),
        ..fixtures::one_wheel(free_beam(), hertz, FRICTION, ratio)
    }
}

/// e₁/(e₀Δ) at the rail point \[1/m\].
fn per_metre(feedback: &Loop, wavelength: f64, speed: f64) -> Complex64 {
    let energy = feedback.at(wavelength, speed).contacts[0].energy_at_rail;
    energy / feedback.steady().energy_per_metre() / AMPLITUDE
}

/// Free beam, `lag`: τ, λ, V, whether Φ is one and the approach unfiltered, P₁, Q₁, ξ₁, e₁ at the wheel and e₁/e₀ at the rail
/// per metre, and the same without the term: two formulas elsewhere that agree to 1e-11.
#[expect(clippy::type_complexity, reason = "a row of a table")]
const POINTS: [(f64, f64, f64, bool, [f64; 2], [f64; 2], [f64; 2], [f64; 2], [f64; 2], [f64; 2]); 2] = [
    (
        0.1,
        0.0557,
        30.0,
        true,
        [-298525593.8565502, 611267041.0247707],
        [-9945668.595460556, 10652041.067246048],
        [0.6219601089810677, -0.746392881999582],
        [-1171.163344546026, 1093.8245821780247],
        [-496.61968043455533, 4931.487226795102],
        [-7323.438299493787, 5760.178965325751],
    ),
    (
        0.95,
        0.03,
        15.0,
        false,
        [-220681165.8152674, 387523790.2536285],
        [-63824458.15162523, 122028881.12139842],
        [56.71280334485113, -10.319215751103968],
        [793899.9393805928, 346245.4582896368],
        [10193.361005800041, 1585.9929294543906],
        [-5862.179073296662, 7723.004253071612],
    ),
];

#[test]
fn points_of_the_paper_with_waves() {
    for (ratio, wavelength, speed, point, load, force, creepage, energy, rail, without) in POINTS {
        let complex = |[re, im]: [f64; 2]| Complex64::new(re, im);
        let mut joints = one_wheel(ratio, DissipationPhase::Lag, 27.7725);
        if point {
            joints.wave = wave(WavePatch::Point);
        }
        // The approach of a patch is that by sin(ka)/(ka) of the profile; the loop is linear in it.
        let k = std::f64::consts::TAU / wavelength;
        let z = k * hertz(0.0).unwrap().semi_axis_longitudinal();
        let pressed = if point { 1.0 } else { z.sin() / z };
        let with = joints.close().unwrap();
        let plain = with.clone().without_wave_geometry();
        let both = |of: &dyn Fn(&Loop) -> Complex64| (of(&with) - of(&plain) + pressed * of(&plain)) / AMPLITUDE;
        let at = |feedback: &Loop| feedback.at(wavelength, speed);
        close(both(&|loops| at(loops).normal_force()), complex(load), 1e-10);
        close(both(&|loops| at(loops).tangential_force()), complex(force), 1e-10);
        close(both(&|loops| at(loops).creepage()), complex(creepage), 1e-10);
        close(both(&|loops| at(loops).contacts[0].energy), complex(energy), 1e-10);
        let rail_of = |feedback: &Loop| per_metre(feedback, wavelength, speed) * AMPLITUDE;
        close(both(&rail_of), complex(rail), 1e-10);
        close(pressed * per_metre(&plain, wavelength, speed), complex(without), 1e-10);
        let wave = at(&with).contacts[0].wave.unwrap();
        assert!((at(&with).slip() + wave.creepage[0] - at(&with).creepage()).norm() < 1e-18);
    }
    let state = one_wheel(0.1, DissipationPhase::None, 27.7725).close().unwrap();
    let wave = state.at(0.0557, 30.0).contacts[0].wave.unwrap();
    assert!((wave.share - 0.9539254886578009).abs() < 1e-12);
    assert!((wave.curvature_per_metre / 5583.694274647061 - 1.0).abs() < 1e-12);
}

/// A constant load, by a track that gives way without end: what is left is the wave's own. I_w → 0: constant force,
/// e₁/e₀ = σκ; I_w → ∞: constant slip speed, (1 + g(1 − σ))κ.
#[test]
fn limits_of_the_inertia() {
    const SIGMA: f64 = 0.600_973_506_259_902_3;
    for ratio in [0.1, 0.5, 0.9] {
        let rolling = rolling(ratio);
        let (steady, response) = (rolling.steady(), rolling.response(0.05));
        let (creepage, force) = (steady.creepages.longitudinal, steady.forces.longitudinal);
        let g = creepage * response.by_longitudinal.force[0].re / force;
        for (inertia, exact) in [(1e-9, SIGMA), (1e12, 1.0 + g * (1.0 - SIGMA))] {
            let mut joints = one_wheel(ratio, DissipationPhase::None, inertia);
            joints.wheel = Arc::new(Yielding);
            joints.wave = wave(WavePatch::Point);
            let feedback = joints.close().unwrap();
            let k = std::f64::consts::TAU / 0.0557;
            let share = per_metre(&feedback, 0.0557, 30.0) / (RADIUS * k * k);
            close(share, exact.into(), 1e-7);
        }
        for (rotation, exact) in [(Motion::Free, SIGMA), (Motion::Held, 1.0 + g * (1.0 - SIGMA))] {
            let mut joints = one_wheel(ratio, DissipationPhase::None, 1.0);
            (joints.rotation, joints.wheel) = (rotation, Arc::new(Yielding));
            let feedback = joints.close().unwrap();
            let kappa = feedback.at(0.0557, 30.0).contacts[0].wave.unwrap().curvature_per_metre;
            close(per_metre(&feedback, 0.0557, 30.0) / kappa, exact.into(), 1e-9);
        }
    }
}

/// A wheel that no force reaches.
struct Yielding;

impl Receptance for Yielding {
    fn receptance(&self, _: f64, _: f64) -> Complex64 {
        Complex64::new(1e9, 0.0)
    }
}

/// −F_ξ ξ₀σ of a law in creepages over ab·C_ii, σ of the paper's law.
#[test]
fn curvature_of_a_scaled_law() {
    for ratio in [0.01, 0.1, 0.5, 0.9, 0.99] {
        let rolling = rolling(ratio);
        let (steady, response) = (rolling.steady(), rolling.response(0.05));
        let by_creepage = response.by_longitudinal.force[0].re;
        let creepage = steady.creepages.longitudinal;
        // At constant slip speed.
        let exact = by_creepage * creepage * (1.0 - 0.600_973_506_259_902_3);
        let got = response.by_curvature.unwrap().force[0].re;
        assert!((got - exact).abs() < 1e-11 * FRICTION * LOAD, "{ratio}: {got} {exact}");
    }
}

/// Cubic along (C₁₁ξ, C₂₂η), with coefficients that go by powers of the ratio of the axes.
struct Elliptic(HertzContact);

impl CreepLaw for Elliptic {
    fn friction(&self) -> f64 {
        FRICTION
    }
    fn forces(&self, load: f64, creepages: Creepages) -> riffel::contact::CreepForces {
        let ratio = self.0.axis_ratio() / 2f64.powf(2.0 / 3.0);
        let along = 4.745 * ratio.powf(0.4) * creepages.longitudinal;
        let across = 4.1 * ratio.powf(0.3) * creepages.lateral;
        let (size, limit) = (along.hypot(across), FRICTION * load);
        let shear = 207e9 / 2.6;
        let area = self.0.semi_axis_longitudinal() * self.0.semi_axis_lateral();
        let u = (shear * area * size / (3.0 * limit)).min(1.0);
        let force = limit * (1.0 - (1.0 - u).powi(3)) / size;
        riffel::contact::CreepForces { longitudinal: force * along, lateral: force * across }
    }
    fn derivatives(&self, load: f64, at: Creepages) -> riffel::contact::CreepDerivatives {
        let ratio = self.0.axis_ratio() / 2f64.powf(2.0 / 3.0);
        let coefficients = [4.745 * ratio.powf(0.4), 4.1 * ratio.powf(0.3)];
        let v = [coefficients[0] * at.longitudinal, coefficients[1] * at.lateral];
        let (size, limit) = (v[0].hypot(v[1]), FRICTION * load);
        let shear = 207e9 / 2.6;
        let area = self.0.semi_axis_longitudinal() * self.0.semi_axis_lateral();
        let u = (shear * area * size / (3.0 * limit)).min(1.0);
        let (force, slope) = (limit * (1.0 - (1.0 - u).powi(3)) / size, 3.0 * limit * (1.0 - u).powi(2) * u / size);
        let by = |along: usize| {
            let of = |axis: usize| {
                let own = if axis == along { force } else { 0.0 };
                coefficients[along] * (own + (slope - force) * v[axis] * v[along] / size.powi(2))
            };
            riffel::contact::CreepForces { longitudinal: of(0), lateral: of(1) }
        };
        let by_load = (force - slope) / load;
        riffel::contact::CreepDerivatives {
            by_normal_force: riffel::contact::CreepForces { longitudinal: by_load * v[0], lateral: by_load * v[1] },
            by_longitudinal: by(0),
            by_lateral: by(1),
        }
    }
    fn limit(&self, _: f64) -> riffel::contact::ForceLimit {
        riffel::contact::ForceLimit::None
    }
}

/// Creepages in any direction: force and energy by curvature at constant slip speed, in closed form elsewhere, to 1e-9 of
/// friction and of energy. Slopes by creepage are differences there: in 40 digits the third force is 3560.384 830 954 309.
#[test]
fn creepages_in_any_direction() {
    for (longitudinal, lateral, force, energy) in [
        (0.0005, 0.0, [1471.7037870241252, 0.0], 1.370903249121823),
        (0.001, 0.002, [1651.8086160886005, 3584.5705988322147], 1.3123877541326459),
        (0.0, 0.004, [0.0, 3560.3848386017485], 1.2050213676878878),
    ] {
        let mean = MeanState::Creepages(Creepages { longitudinal, lateral, spin: 0.0 });
        let rolling = QuasiStatic::new(Elliptic(hertz(0.0).unwrap()), LOAD, mean).unwrap();
        let rolling = rolling.on_waves(|curvature| hertz(curvature).map(Elliptic)).unwrap();
        let by = rolling.response(0.05).by_curvature.unwrap();
        for (got, exact) in by.force.into_iter().zip(force) {
            assert!((got.re - exact).abs() < 1e-9 * FRICTION * LOAD, "{got} {exact}");
        }
        let ratio = by.energy.re / rolling.steady().energy_per_metre();
        assert!((ratio - energy).abs() < 1e-9, "{ratio} {energy}");
        if longitudinal == 0.0 {
            let off = by.force[1].re - 3_560.384_830_954_309;
            assert!(off.abs() < 1e-11 * FRICTION * LOAD, "{off}");
        }
    }
}

/// The wave of a contact that slides everywhere, along it or across.
fn sliding(longitudinal: f64, lateral: f64, motion: [Motion<()>; 2]) -> Contact {
    let hertz = hertz(0.0).unwrap();
    let law = |_| FullSliding::new(FRICTION);
    let mean = MeanState::Creepages(Creepages { longitudinal, lateral, spin: 0.0 });
    let rolling = QuasiStatic::new(law(0.0).unwrap(), LOAD, mean).unwrap();
    Contact {
        along: 0.0,
        rail: Rail::Right,
        angle: 0.0,
        profile: 1.0,
        stiffness: hertz.stiffness(),
        rolling: Arc::new(rolling.on_waves(law).unwrap()),
        motion,
        moving: None,
        place_of_wear: PlaceOfWear::new(DissipationPhase::Lag, hertz.semi_axis_longitudinal(), 1.0),
        wave: Some(WaveGeometry::new(RADIUS, patch()).unwrap().sliding(&hertz)),
        wear: EnergyWear::new(2.5e-9, 7850.0, hertz.semi_axis_lateral()).unwrap(),
        damage: None,
    }
}

proptest! {
    /// Under a constant load full sliding damps every wave, by R k²Φ in phase with it, whatever holds the wheel.
    #[test]
    fn full_sliding_under_constant_load_damps(
        wavelength in 0.004..0.5f64, speed in 1.0..80.0f64, direction in 0.0..std::f64::consts::TAU,
        mass in 1.0..1e3f64, inertia in 0.1..300.0f64, motions in (0..2usize, 0..2usize),
    ) {
        let motion = |kind: usize| [Motion::Compliant(()), Motion::Held][kind].clone();
        let contact = sliding(0.03 * direction.cos(), 0.03 * direction.sin(), [motion(motions.0), motion(motions.1)]);
        let track = Uncoupled { vertical: Some(Arc::new(Yielding)), ..Uncoupled::default() };
        let wheel = Uncoupled {
            longitudinal: Some(Arc::new(RigidInertia::new(inertia, RADIUS).unwrap())),
            lateral: Some(Arc::new(RigidMass::new(mass).unwrap())),
            vertical: Some(Arc::new(RigidMass::new(mass).unwrap())),
        };
        let kappa = contact.wave.as_ref().unwrap().curvature(std::f64::consts::TAU / wavelength);
        let feedback = Loop::new(Arc::new(track), Arc::new(wheel), vec![contact], AMPLITUDE).unwrap();
        let state = feedback.at(wavelength, speed);
        prop_assert!(state.growth_rate < 0.0);
        let got = per_metre(&feedback, wavelength, speed);
        prop_assert!((got - kappa).norm() < 1e-6 * kappa, "{got} {kappa}");
    }

    /// The general equations are the closed form, and maps are the points, with springs and without.
    #[test]
    fn all_paths_agree(
        wavelength in 0.02..0.2f64, speed in 5.0..60.0f64, ratio in 0.05..0.95f64, kind in 0..3usize, late: bool,
    ) {
        let mut joints = one_wheel(ratio, DissipationPhase::Lag, 27.7725);
        if late {
            joints.contact = Arc::new(SpringDashpot::new(rolling(ratio), hertz(0.0).unwrap()));
        }
        joints.rotation = [joints.rotation.clone(), Motion::Held, Motion::Free][kind].clone();
        let closed = joints.clone().close().unwrap();
        let contact = closed.contacts()[0].clone();
        // Nothing moves across, but nothing holds the wheel there.
        let contact = Contact { motion: [contact.motion[0].clone(), Motion::Compliant(())], ..contact };
        let wheels = Uncoupled {
            longitudinal: Some(Arc::new(RigidInertia::new(27.7725, RADIUS).unwrap())),
            lateral: None,
            vertical: Some(joints.wheel.clone()),
        };
        let track = Uncoupled { vertical: Some(joints.track.clone()), ..Uncoupled::default() };
        let general = Loop::new(Arc::new(track), Arc::new(wheels), vec![contact], AMPLITUDE).unwrap();
        prop_assert!(closed.is_along_one_axis() && !general.is_along_one_axis());
        let (one, other) = (closed.at(wavelength, speed), general.at(wavelength, speed));
        close(other.contacts[0].energy, one.contacts[0].energy, 1e-11);
        close(other.contacts[0].energy_at_rail, one.contacts[0].energy_at_rail, 1e-11);
        prop_assert_eq!(other.contacts[0].wave, one.contacts[0].wave);
        for feedback in [&closed, &general] {
            let mut row = [Complex64::ZERO; 3];
            RowEvaluator::new(feedback, &[wavelength, 0.05, 0.06]).evaluate(speed, &mut row);
            close(row[0], one.normalized_dissipation, 1e-10);
            let growth = feedback.complex_growth_rate(wavelength, speed).re;
            prop_assert!((growth - one.growth_rate).abs() < 1e-10 * one.normalized_dissipation.norm() * feedback.growth_rate_per_dissipation().abs());
        }
    }

    /// Every wheel meets its own wave: a second wheel far behind on the same rail, or the opposite rail in antiphase, has the same.
    #[test]
    fn each_contact_has_its_own_wave(wavelength in 0.02..0.2f64, speed in 5.0..60.0f64, distance in 1.0..3.0f64) {
        let closed = one_wheel(0.3, DissipationPhase::Lag, 27.7725).close().unwrap();
        let first = closed.contacts()[0].clone();
        let contacts = vec![
            first.clone(),
            Contact { along: -distance, ..first.clone() },
            Contact { rail: Rail::Left, profile: -1.0, ..first.clone() },
            Contact { rail: Rail::Left, along: -distance, profile: 0.0, ..first },
        ];
        let joints = one_wheel(0.3, DissipationPhase::Lag, 27.7725);
        let track = Uncoupled { vertical: Some(Arc::new(Yielding)), ..Uncoupled::default() };
        let wheels = Uncoupled {
            longitudinal: Some(Arc::new(RigidInertia::new(27.7725, RADIUS).unwrap())),
            lateral: None,
            vertical: Some(joints.wheel),
        };
        let feedback = Loop::new(Arc::new(track), Arc::new(wheels), contacts, AMPLITUDE).unwrap();
        let state = feedback.at(wavelength, speed);
        let first = state.contacts[0].energy_at_rail;
        for contact in &state.contacts[1..3] {
            close(contact.energy_at_rail, first, 1e-6);
        }
        prop_assert!(state.contacts[3].energy_at_rail.norm() < 1e-6 * first.norm());
        prop_assert_eq!(state.contacts[3].wave.unwrap().creepage[0].norm(), 0.0);
    }
}

/// A contact that does not tell its response to curvature has no part for the wave.
#[test]
fn a_response_is_asked_for() {
    let mut joints = one_wheel(0.1, DissipationPhase::Lag, 27.0);
    let mean = MeanState::TractiveRatio(0.1);
    joints.contact = Arc::new(QuasiStatic::new(law(0.0).unwrap(), LOAD, mean).unwrap());
    let error = joints.close().err().unwrap();
    assert!(matches!(error, Error::NoResponse { .. }), "{error}");
}

/// A wheel of n waves has the wavenumber n/R, and n²/R of κ per metre of its radius: printed 490, 870 and 1960 per metre.
#[test]
fn waves_of_a_wheel_have_the_same_curvature() {
    let wave = WaveGeometry::new(RADIUS, WavePatch::Point).unwrap();
    for (order, printed) in [(15.0, 490.0), (20.0, 870.0), (30.0, 1960.0)] {
        let per_metre = wave.curvature(order / RADIUS);
        assert!((per_metre / printed - 1.0).abs() < 3e-3, "{per_metre}");
        assert!((per_metre * RADIUS / (order * order) - 1.0).abs() < 1e-12);
    }
}
