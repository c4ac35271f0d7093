//! The loop of several contacts on all axes, against its special cases.

use std::sync::Arc;

use approx::assert_relative_eq;
use proptest::prelude::*;
use riffel::contact::{Carter3d, Creepages, MeanState, QuasiStatic, SpringDashpot};
use riffel::feedback::{Comb, Contact, ContactState, OneWheel};
use riffel::growth::RowEvaluator;
use riffel::receptance::{Beam, ContinuousTrack, EulerBernoulliBeam, Layer, Structure, Support, Uncoupled};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Complex64, DissipationPhase, EnergyWear, Error, HertzContact, Loop, Place, PlaceOfWear, Rail, Receptance,
    RollingContact,
};

use crate::fixtures::steel;

pub(crate) const AMPLITUDE: f64 = 20e-6;
const RADIUS: f64 = 0.46;

pub(crate) fn hertz() -> HertzContact {
    HertzContact::new(steel(), RADIUS, 0.3, 60e3).unwrap()
}

/// The paper's law, which is alike in all directions, answering late.
pub(crate) fn rolling(longitudinal: f64, lateral: f64) -> Arc<dyn RollingContact> {
    let law = Carter3d::new(hertz(), 0.35).unwrap();
    let mean = MeanState::Creepages(Creepages { longitudinal, lateral, spin: 0.0 });
    Arc::new(SpringDashpot::new(QuasiStatic::new(law, 60e3, mean).unwrap(), hertz()))
}

fn track() -> Arc<dyn Receptance> {
    let rail = Beam::from(EulerBernoulliBeam::new(steel(), 3e-5, 60.0).unwrap());
    let pad = Layer::new(200e6, 30e3).unwrap();
    Arc::new(ContinuousTrack::new(rail, Support::one_layer(pad)))
}

fn place_of_wear() -> PlaceOfWear {
    PlaceOfWear::new(DissipationPhase::Lag, hertz().semi_axis_longitudinal(), 0.3)
}

fn wear() -> EnergyWear {
    EnergyWear::new(1e-9, 7850.0, hertz().semi_axis_lateral()).unwrap()
}

pub(crate) fn contact(along: f64, rolling: Arc<dyn RollingContact>, motion: [Motion<()>; 2]) -> Contact {
    Contact {
        along,
        rail: Rail::Right,
        angle: 0.0,
        profile: 1.0,
        stiffness: hertz().stiffness(),
        rolling,
        motion,
        moving: None,
        wave: None,
        place_of_wear: place_of_wear(),
        wear: wear(),
        damage: None,
    }
}

fn vertical(structure: Arc<dyn Receptance>) -> Uncoupled {
    Uncoupled { vertical: Some(structure), ..Uncoupled::default() }
}

pub(crate) fn wheel(mass: f64, inertia: f64) -> Uncoupled {
    Uncoupled {
        longitudinal: Some(Arc::new(RigidInertia::new(inertia, RADIUS).unwrap())),
        lateral: None,
        vertical: Some(Arc::new(RigidMass::new(mass).unwrap())),
    }
}

fn general(wheels: impl Structure + 'static, contacts: Vec<Contact>) -> Loop {
    let track = Arc::new(vertical(track()));
    Loop::new(track, Arc::new(wheels), contacts, AMPLITUDE).unwrap()
}

pub(crate) fn close(got: Complex64, expected: Complex64) {
    assert!((got - expected).norm() <= 1e-12 * expected.norm(), "{got} {expected}");
}

proptest! {
    /// One wheel and one axis: the closed form, in all three kinds of motion. The tolerance is that of the condition of
    /// three equations scaled by their rows.
    #[test]
    fn one_wheel_and_one_axis_is_the_closed_form(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, creepage in 1e-4..4e-3f64, kind in 0..3usize,
    ) {
        let inertia = 40.0;
        let motion = [
            Motion::compliant(RigidInertia::new(inertia, RADIUS).unwrap()), Motion::Held, Motion::Free,
        ];
        let constraint = [Motion::Compliant(()), Motion::Held, Motion::Free];
        let closed = OneWheel {
            track: track(),
            wheel: Arc::new(RigidMass::new(400.0).unwrap()),
            contact_stiffness: hertz().stiffness(),
            contact: rolling(creepage, 0.0),
            rotation: motion[kind].clone(),
            wave: None,
            place_of_wear: place_of_wear(),
            wear: wear(),
            amplitude: AMPLITUDE,
        };
        // Nothing moves across, but nothing holds the wheel there: three equations.
        let motion = [constraint[kind].clone(), Motion::Compliant(())];
        let contact = contact(0.0, rolling(creepage, 0.0), motion);
        let general = general(wheel(400.0, inertia), vec![contact]);
        let closed = closed.close().unwrap();
        assert!(closed.is_along_one_axis() && !general.is_along_one_axis());
        let (state, expected) = (general.at(wavelength, speed).contacts[0], closed.at(wavelength, speed));
        close(state.force[2], expected.normal_force());
        if kind != 2 {
            close(state.force[0], expected.tangential_force());
        } else {
            assert_eq!(state.force[0], Complex64::ZERO);
        }
        close(state.creepage[0], expected.creepage());
        close(state.energy_at_rail * speed, expected.dissipation_at_rail);
        // The real part may be small beside the whole.
        let whole = expected.dissipation_at_rail.norm() / speed * wear().depth_per_energy() / AMPLITUDE;
        assert_relative_eq!(state.growth_rate.unwrap(), expected.growth_rate, epsilon = 1e-12 * whole);
    }

    /// A law that is alike in all directions: turning the creepage by 90°, with the receptances along and across
    /// exchanged, leaves the growth.
    #[test]
    fn growth_turns_with_the_creepage(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, along in 1e-4..3e-3f64, across in 1e-4..3e-3f64,
    ) {
        let compliant = || [Motion::Compliant(()), Motion::Compliant(())];
        let [one, other]: [Arc<dyn Receptance>; 2] = [
            Arc::new(RigidInertia::new(40.0, RADIUS).unwrap()),
            Arc::new(RigidMass::new(700.0).unwrap()),
        ];
        let wheel = |longitudinal: &Arc<dyn Receptance>, lateral: &Arc<dyn Receptance>| Uncoupled {
            longitudinal: Some(longitudinal.clone()),
            lateral: Some(lateral.clone()),
            vertical: Some(Arc::new(RigidMass::new(400.0).unwrap())),
        };
        let at = |wheel: Uncoupled, rolling: Arc<dyn RollingContact>| -> ContactState {
            general(wheel, vec![contact(0.0, rolling, compliant())]).at(wavelength, speed).contacts[0]
        };
        let straight = at(wheel(&one, &other), rolling(along, across));
        let turned = at(wheel(&other, &one), rolling(across, along));
        close(turned.force[0], straight.force[1]);
        close(turned.force[1], straight.force[0]);
        close(turned.energy_at_rail, straight.energy_at_rail);
    }

    /// Wheels that do not feel each other grow the rail as each would alone, whatever their distance.
    #[test]
    fn wheels_that_do_not_feel_each_other_wear_alike(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, distance in 0.5..20.0f64,
    ) {
        let contact = |along: f64| {
            contact(along, rolling(1e-3, 0.0), [Motion::Compliant(()), Motion::Held])
        };
        let loop_of = |contacts| general(wheel(400.0, 40.0), contacts).at(wavelength, speed).contacts;
        let alone = loop_of(vec![contact(0.0)])[0];
        let both = loop_of(vec![contact(0.0), contact(-distance)]);
        for state in both {
            assert_relative_eq!(
                state.growth_rate.unwrap(), alone.growth_rate.unwrap(), max_relative = 1e-9
            );
        }
    }
}

/// Wheels on one axle that share their rotation: antiphase profiles would turn it apart, equal ones turn it as one wheel
/// of half its inertia.
struct SharedAxle {
    inertia: f64,
}

impl Structure for SharedAxle {
    fn cross_receptance(&self, w: f64, speed: f64, at: Place, from: Place) -> Complex64 {
        use riffel::Direction::{Longitudinal, Vertical};
        match (at.direction, from.direction) {
            (Longitudinal, Longitudinal) => RigidInertia::new(self.inertia, RADIUS).unwrap().receptance(w, speed),
            (Vertical, Vertical) if at == from => RigidMass::new(400.0).unwrap().receptance(w, speed),
            _ => Complex64::ZERO,
        }
    }
}

/// Wavelengths solved side by side do not feel each other: a row is its points, in all kinds of motion, for any number of
/// wavelengths, and under a wavelength with which the receptance is no number.
#[test]
fn a_row_is_its_points() {
    /// A rail that answers along all axes, and to no frequency above a limit.
    struct Limited(f64);

    impl Structure for Limited {
        fn cross_receptance(&self, w: f64, _: f64, at: Place, from: Place) -> Complex64 {
            if w > self.0 {
                return Complex64::new(f64::NAN, f64::NAN);
            }
            let decay = Complex64::new(-0.4, -1.3) * (at.along - from.along).abs();
            let direct = if at.direction == from.direction { 1.0 } else { 0.2 };
            Complex64::new(1e-6, -4e-7) / w * direct * decay.exp()
        }
    }

    let speed = 20.0;
    let side = |along, rail, motion| Contact { rail, ..contact(along, rolling(6e-4, 4e-4), motion) };
    let contacts = vec![
        side(0.0, Rail::Right, [Motion::Compliant(()), Motion::Compliant(())]),
        side(0.0, Rail::Left, [Motion::Free, Motion::Compliant(())]),
        side(-2.5, Rail::Right, [Motion::Held, Motion::Compliant(())]),
        side(-2.5, Rail::Left, [Motion::Compliant(()), Motion::Free]),
    ];
    for comb in [Comb::Resolved, Comb::Mean] {
        for count in [1, 3, 4, 9] {
            let wavelengths: Vec<f64> = (0..count).map(|index| 0.03 + 0.011 * index as f64).collect();
            let limit = std::f64::consts::TAU * speed / 0.035;
            let feedback =
                Loop::new(Arc::new(Limited(limit)), Arc::new(wheel(400.0, 40.0)), contacts.clone(), AMPLITUDE);
            let feedback = feedback.unwrap().with_comb(comb);
            let mut row = vec![Complex64::ZERO; count];
            RowEvaluator::new(&feedback, &wavelengths).evaluate(speed, &mut row);
            assert!(row[0].is_nan());
            for (value, &wavelength) in row.iter().zip(&wavelengths).skip(1) {
                let growth = value.re * feedback.growth_rate_per_dissipation();
                let expected = feedback.at(wavelength, speed).growth_rate;
                assert_relative_eq!(growth, expected, max_relative = 1e-12);
                let rail = feedback.at(wavelength, speed).contacts;
                let mean = (rail[0].growth_rate.unwrap() + rail[2].growth_rate.unwrap()) / 2.0;
                assert_relative_eq!(growth, mean, max_relative = 1e-12);
            }
        }
    }
}

#[test]
fn two_wheels_on_one_axle_turn_as_one_of_half_its_inertia() {
    let side = |rail| Contact { rail, ..contact(0.0, rolling(1e-3, 0.0), [Motion::Compliant(()), Motion::Held]) };
    let axle = general(SharedAxle { inertia: 80.0 }, vec![side(Rail::Left), side(Rail::Right)]);
    let single = general(wheel(400.0, 40.0), vec![side(Rail::Right)]);
    let (both, single) = (axle.at(0.05, 30.0), single.at(0.05, 30.0).contacts[0]);
    for state in both.contacts {
        close(state.force[0], single.force[0]);
        close(state.energy_at_rail, single.energy_at_rail);
    }
}

/// A contact that knows nothing of lateral creepage cannot be let go laterally.
#[test]
fn a_response_that_is_not_told_is_asked_for() {
    struct Silent(Arc<dyn RollingContact>);
    impl RollingContact for Silent {
        fn steady(&self) -> riffel::contact::MeanRolling {
            self.0.steady()
        }
        fn response(&self, wavelength: f64) -> riffel::contact::ContactResponse {
            riffel::contact::ContactResponse { by_lateral: None, ..self.0.response(wavelength) }
        }
    }
    let silent = |lateral| {
        let contact = contact(0.0, Arc::new(Silent(rolling(1e-3, 0.0))), [Motion::Held, lateral]);
        let (track, wheel) = (vertical(track()), wheel(400.0, 40.0));
        Loop::new(Arc::new(track), Arc::new(wheel), vec![contact], AMPLITUDE)
    };
    let error = silent(Motion::Free).err().unwrap();
    assert!(matches!(error, Error::NoResponse { .. }), "{error}");
    assert!(silent(Motion::Held).is_ok());
}

/// A wheel that answers across the rail to a vertical force and back, by a mode of 400 Hz that both share.
struct SharedMode {
    share: f64,
    loss_factor: f64,
}

impl Structure for SharedMode {
    fn cross_receptance(&self, w: f64, _: f64, at: Place, from: Place) -> Complex64 {
        use riffel::Direction::{Lateral, Vertical};
        let mode = |hertz: f64| {
            let of = std::f64::consts::TAU * hertz;
            (300.0 * (of * of * Complex64::new(1.0, self.loss_factor) - w * w)).inv()
        };
        let shape = |place: Place| match place.direction {
            Lateral => 1.0,
            Vertical => self.share,
            _ => 0.0,
        };
        let vertical = match (at.direction, from.direction) {
            (Vertical, Vertical) => mode(40.0),
            _ => Complex64::ZERO,
        };
        shape(at) * shape(from) * mode(400.0) + vertical
    }
}

/// Falling friction: F = μ(c) P along the slip.
struct Falling(f64);

impl RollingContact for Falling {
    fn steady(&self) -> riffel::contact::MeanRolling {
        rolling(0.0, 1e-3).steady()
    }

    fn response(&self, wavelength: f64) -> riffel::contact::ContactResponse {
        let mut response = rolling(0.0, 1e-3).response(wavelength);
        let lateral = response.by_lateral.as_mut().unwrap();
        lateral.force = [Complex64::ZERO, self.0.into()];
        response.by_load.force = [Complex64::ZERO, Complex64::new(0.35, 0.0)];
        response
    }
}

/// One lateral mode m(ω₀² − ω²) against a slope C of friction: 1 + (iω/V) C H = 0. It grows where friction falls more
/// steeply than the loss damps, C/V < −2ζω₀m, at its frequency; with the vertical axis in it by μ alone, the roots do not
/// move.
#[test]
fn falling_friction_squeals_where_it_outweighs_the_loss() {
    let speed = 10.0;
    let w = std::f64::consts::TAU * 400.0;
    // 2ζ = 0.02 of the mode.
    let limit = -0.02 * w * 300.0 * speed;
    for (slope, roots) in [(0.9 * limit, 0), (1.1 * limit, 2), (1e5, 0)] {
        let contact = contact(0.0, Arc::new(Falling(slope)), [Motion::Held, Motion::Compliant(())]);
        let squeal = general(SharedMode { share: 0.0, loss_factor: 0.02 }, vec![contact]);
        let stability = squeal.stability(speed, 1.0, 1e5).unwrap();
        assert_eq!(stability.unstable_roots, roots, "{slope}");
        if let Some(frequency) = stability.frequency {
            assert!((frequency / 400.0 - 1.0).abs() < 0.02, "{frequency}");
        }
    }
}

/// The root of m(s² + ω₀²(1 + iη)) + sC/V = 0 in closed form, near the imaginary axis and up to a seventh of its frequency beside it, to 1e-6.
#[test]
fn a_root_that_grows_fast_is_found() {
    let (speed, mass, loss_factor) = (10.0, 300.0, 0.02);
    let w = std::f64::consts::TAU * 400.0;
    for times in [1.05, 2.0, 8.0, 15.0] {
        let slope = -times * loss_factor * w * mass * speed;
        let damping = Complex64::from(slope / speed);
        let stiffness = mass * w * w * Complex64::new(1.0, loss_factor);
        let root = (damping * damping - 4.0 * mass * stiffness).sqrt();
        let roots = [root, -root].map(|root| (root - damping) / (2.0 * mass));
        let expected = roots.into_iter().find(|root| root.im > 0.0).unwrap();
        let motion = [Motion::Held, Motion::Compliant(())];
        let contact = contact(0.0, Arc::new(Falling(slope)), motion);
        let share = 0.0;
        let squeal = general(SharedMode { share, loss_factor }, vec![contact]);
        let stability = squeal.stability(speed, 1.0, 1e5).unwrap();
        let [found] = stability.roots[..] else {
            panic!("{stability:?}");
        };
        let growth = found.growth_rate / expected.re - 1.0;
        let frequency = std::f64::consts::TAU * found.frequency / expected.im - 1.0;
        assert!(growth.abs() < 1e-6 && frequency.abs() < 1e-6, "{times}: {growth:e} {frequency:e}");
    }
}

/// A wheel that answers across the rail a second later: 1 + C e^{−iωT}, whose phase turns for ever.
struct Echo;

impl Structure for Echo {
    fn cross_receptance(&self, w: f64, _: f64, at: Place, from: Place) -> Complex64 {
        let both = [at, from].map(|place| place.direction == riffel::Direction::Lateral);
        match both {
            [true, true] => Complex64::new(0.0, -w).exp() / Complex64::new(0.0, w),
            _ => Complex64::ZERO,
        }
    }
}

/// A phase that jumps, at a mode without loss, or that turns on and on ends the search, and is told.
#[test]
fn a_phase_that_cannot_be_followed_is_given_up() {
    let mode = |loss_factor| SharedMode { share: 0.0, loss_factor };
    fn stability(wheel: impl Structure + 'static, slope: f64) -> Result<riffel::feedback::Stability, Error> {
        let contact = contact(0.0, Arc::new(Falling(slope)), [Motion::Held, Motion::Compliant(())]);
        general(wheel, vec![contact]).stability(10.0, 1.0, 1e5)
    }
    let refusals = [stability(mode(0.0), -1e5), stability(mode(1e-14), -1e5), stability(Echo, 100.0)];
    for refusal in refusals {
        assert!(matches!(refusal, Err(Error::NotConverged { .. })), "{refusal:?}");
    }
}

/// Full sliding at constant friction, F = μP: the loop is 1/k_H + H_zz + μ H_zy = 0, which holds the mode by
/// share² + μ share. It is passive where that is positive, and without a receptance between normal and tangent; where it is
/// negative the track feeds the mode, more than so small a loss takes.
#[test]
fn constant_friction_needs_a_coupling_of_modes() {
    let stability = |share: f64| {
        let contact = contact(0.0, Arc::new(Falling(0.0)), [Motion::Held, Motion::Compliant(())]);
        let mode = SharedMode { share, loss_factor: 1e-4 };
        let coupled = general(mode, vec![contact]);
        coupled.stability(10.0, 1.0, 1e5).unwrap().unstable_roots
    };
    assert_eq!(stability(0.0), 0);
    assert_eq!(stability(0.5), 0);
    assert_eq!(stability(-0.5), 0);
    assert_eq!(stability(-0.175), 2);
}
