//! Contacts that answer late.

use std::f64::consts::TAU;
use std::sync::Arc;

use riffel::Error;
use riffel::contact::{CreepLaw, HalfSpace, HalfSpaceCurve, NonSteady, OscillatingCreepages};
use riffel::feedback::OneWheel;
use riffel::passage::{
    Evolution, EvolutionStep, LateContact, PassingWheel, Sinusoid, TransientContact, WearOfPassages,
};
use riffel::roughness::Profile;

use super::{at, both, carter, settle, two_layers};
use crate::fixtures;

/// A contact that answers late, by the exact theory: over waves as short as two semi-axes the first harmonics are those of the
/// linear loop with the table of that contact, and growth is its growth rate.
#[test]
fn a_late_contact_is_that_of_the_linear_loop() {
    let hertz = fixtures::hertz();
    let a = hertz.semi_axis_longitudinal();
    let contact = HalfSpace::new(hertz, 0.4, 24).unwrap();
    let state = contact.roll_at_tractive_ratio(0.4).unwrap();
    let law = Arc::new(HalfSpaceCurve::new(&contact, &state).unwrap());
    let table = NonSteady::new(&contact, &state, OscillatingCreepages::Longitudinal, 1.01 * a, 100.0 * a, 1e-4);
    let table = Arc::new(table.unwrap());
    let late = LateContact::new(&*table, &*law, a, [1.01 * a, 100.0 * a]).unwrap();
    let (feedback, model) = both(two_layers(), |_| law.clone(), 0.4, 30.0, 1e-7);
    let feedback = OneWheel { contact: table.clone(), ..feedback };
    let mut model = model;
    model.contacts[0].mean = riffel::RollingContact::steady(&*table);
    model.contacts[0].late = Some(Arc::new(late));
    for wavelength in [0.06, 5.0 * a, 2.0 * a] {
        let linear = at(&feedback, wavelength, 30.0);
        let first = settle(&model, 1e-7, wavelength, 512).harmonics[1];
        for (got, expected) in [
            (first.normal_force, linear.normal_force()),
            (first.tangential_force, linear.tangential_force()),
            (first.creepage, linear.creepage()),
        ] {
            let error = (got - expected).norm() / expected.norm();
            assert!(error < 1e-3, "{wavelength}: {got} {expected} {error:e}");
        }
    }
    let wheel = PassingWheel {
        memory: model.memory().unwrap(),
        model,
        wear: WearOfPassages { wear: feedback.wear, place: feedback.place_of_wear, shortest: a },
        share: 1.0,
        traction_share: 1.0,
    };
    let step = EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: 2e-4 };
    let (length, count) = (1.2, 6000);
    let lines = [20usize, 60];
    let heights = (0..count).map(|index| {
        let share = f64::from(index) / f64::from(count);
        let waves = lines.iter().map(|&line| (TAU * share * line as f64).cos());
        1e-7 * waves.sum::<f64>()
    });
    let ring = Profile::new(0.0, length / f64::from(count), heights.collect()).unwrap();
    let mut rail = Evolution::new(&ring);
    rail.advance(&[&wheel], &step, 1).unwrap();
    for line in lines {
        let change = rail.waves()[line - 1].1 / 1e-7 - 1.0;
        let linear = at(&feedback, length / line as f64, 30.0);
        let expected = -feedback.wear.depth_per_energy() * linear.dissipation_at_rail / (30.0 * feedback.amplitude);
        let error = (change - expected).norm() / expected.norm();
        assert!(error < 2e-3, "{line}: {change} {expected} {error:e}");
    }
}

/// The exact contact followed element by element, where the load swings by a sixth: its first harmonics are those of the linear loop
/// with the table of that contact, but for the elements, two in a hundred (where it swings by less, its edge moves by less than an element, and
/// errors reach a fifth of the harmonics).
// Long: follows the exact contact element by element until waves settle, the independent side of the comparison.
#[test]
fn transient_contact_at_small_amplitude() {
    let hertz = fixtures::hertz();
    let a = hertz.semi_axis_longitudinal();
    let contact = HalfSpace::new(hertz, 0.4, 32).unwrap();
    let state = contact.roll_at_tractive_ratio(0.4).unwrap();
    let law: Arc<dyn CreepLaw> = Arc::new(HalfSpaceCurve::new(&contact, &state).unwrap());
    let table = NonSteady::new(&contact, &state, OscillatingCreepages::Longitudinal, 1.01 * a, 100.0 * a, 1e-4);
    let (feedback, model) = both(two_layers(), |_| law.clone(), 0.4, 30.0, 1.0);
    let feedback = OneWheel { contact: Arc::new(table.unwrap()), ..feedback };
    let profile = Sinusoid { amplitude: 20e-6, wavelength: 0.06 };
    let contact = TransientContact { hertz, friction: 0.4, across: 32, over_true_gap: false };
    let linear = at(&feedback, profile.wavelength, 30.0);
    let got = model.settle_transient(profile, 256, contact).unwrap();
    let first = got.settled.harmonics[1];
    for (got, expected, limit) in [
        (first.normal_force, linear.normal_force(), 1e-3),
        (first.tangential_force, linear.tangential_force(), 0.02),
        (first.creepage, linear.creepage(), 0.02),
        (got.energy_at_rail[1], linear.dissipation_at_rail / 30.0, 0.02),
    ] {
        let error = (got / profile.amplitude - expected).norm() / expected.norm();
        assert!(error < limit, "{got} {expected} {error:e}");
    }
    // A wheel under a constant torque keeps the mean creep force, and an inertia no energy.
    let [mean, ..] = got.settled.harmonics;
    assert!((mean.tangential_force.re / 8000.0 - 1.0).abs() < 1e-4);
    let work = 8000.0 * mean.creepage.re;
    assert!((got.energy_at_rail[0].re / work - 1.0).abs() < 0.02);
}

/// A wheel that leaves the rail rolls on without creep force, and begins again without tractions.
#[test]
fn transient_contact_that_is_lost() {
    let (_, model) = both(two_layers(), carter, 0.4, 30.0, 1.0);
    let profile = Sinusoid { amplitude: 200e-6, wavelength: 0.055 };
    let contact = TransientContact { hertz: fixtures::hertz(), friction: 0.4, across: 16, over_true_gap: false };
    let got = model.settle_transient(profile, 256, contact).unwrap().settled;
    assert!(got.contact_loss > 0.05);
    for instant in &got.wave {
        assert!(instant.tangential_force.abs() <= 0.4 * instant.normal_force);
    }
    for (across, wavelength) in [(16, 0.01), (17, 0.055)] {
        let contact = TransientContact { across, ..contact };
        let profile = Sinusoid { amplitude: 1e-6, wavelength };
        let refused = model.settle_transient(profile, 256, contact);
        assert!(matches!(refused, Err(Error::OutOfRange { .. })));
    }
}
