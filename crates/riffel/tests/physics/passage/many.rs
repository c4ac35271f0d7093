//! Many passages over one wave: growth, flow and damage.

use std::f64::consts::TAU;
use std::sync::Arc;

use riffel::damage::{
    Bending, ClippedPower, Damage, DamageLaw, Demand, Fatigue, Flow, FlowAlong, Load, ShakedownLimit,
};
use riffel::passage::{DamageInTime, Evolution, EvolutionStep, PassageModel, PassingWheel, WearOfPassages};
use riffel::roughness::Profile;
use riffel::{DissipationPhase, Loop, PlaceOfWear, WearCorners, WearRegimes};

use super::{at, both, carter, free_beam, two_layers};
use crate::fixtures;

/// Growth of two waves over many passages is that of the linear loop, to 2·10⁻³: Heun's steps of 8 % leave half of it; also by a law
/// of wear with regimes, whose coefficient changes over the wave.
#[test]
fn growth_over_passages_is_linear_growth() {
    for (track, regimes) in [(two_layers(), false), (free_beam(), false), (two_layers(), true)] {
        let (mut feedback, model) = both(track, carter, 0.3, 30.0, 1e-6);
        if regimes {
            let hertz = fixtures::hertz();
            let corners = WearCorners::Rounded;
            let law = WearRegimes::TgammaArea { corners, spread: 0.5 };
            let wear = law.wear(&hertz, &feedback.contact.steady(), 7850.0, 1.0);
            feedback.wear = wear.unwrap();
        }
        let semi_axis = 6e-3;
        feedback.place_of_wear = PlaceOfWear::new(DissipationPhase::Lag, semi_axis, 0.3);
        let wear = WearOfPassages { wear: feedback.wear, place: feedback.place_of_wear, shortest: 2.0 * semi_axis };
        let (length, count) = (2.4, 2400);
        let heights = (0..count).map(|index| {
            let x = length * f64::from(index) / f64::from(count);
            0.1e-6 * (TAU * x / 0.06).cos() + 0.1e-6 * (TAU * x / 0.08 + 1.0).cos()
        });
        let profile = Profile::new(0.0, length / f64::from(count), heights.collect()).unwrap();
        let mut evolution = Evolution::new(&profile);
        let wheel = PassingWheel { memory: model.memory().unwrap(), model, wear, share: 1.0, traction_share: 1.0 };
        let step = EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: 1e-3 };
        let amplitude = |evolution: &Evolution, waves: usize| evolution.waves()[waves - 1].1.norm();
        let before = [40, 30].map(|waves| amplitude(&evolution, waves));
        for _ in 0..4 {
            evolution.advance(&[&wheel], &step, u64::MAX).unwrap();
        }
        let passages = evolution.passages() as f64;
        for (index, (waves, wavelength)) in [(40, 0.06), (30, 0.08)].into_iter().enumerate() {
            let rate = (amplitude(&evolution, waves) / before[index]).ln() / passages;
            let linear = at(&feedback, wavelength, 30.0);
            let scale = linear.dissipation_at_rail.norm() / linear.dissipation_at_rail.re.abs();
            let error = (rate / linear.growth_rate - 1.0).abs() / scale;
            assert!(error < 1e-2, "{wavelength}: {rate:e} for {:e}", linear.growth_rate);
        }
        assert!(evolution.mean_depth() > 0.0);
    }
}

/// A wheel of a model with the laws of damage of a loop, a ring of waves under it, and how many of them there are.
fn waves_under(
    model: &PassageModel,
    damaged: &Loop,
    wavelength: f64,
    amplitude: f64,
) -> (PassingWheel, Profile, usize) {
    let contact = &damaged.contacts()[0];
    let mut model = model.clone();
    model.contacts[0].damage = DamageInTime::of(damaged, contact);
    let wheel = PassingWheel {
        memory: model.memory().unwrap(),
        model,
        wear: WearOfPassages { wear: contact.wear, place: contact.place_of_wear, shortest: 0.01 },
        share: 1.0,
        traction_share: 1.0,
    };
    let (waves, count) = (6_u32, 1500_u32);
    let height = |index| {
        let x = f64::from(waves * index) / f64::from(count);
        amplitude * (TAU * x).cos()
    };
    let spacing = f64::from(waves) * wavelength / f64::from(count);
    let profile = Profile::new(0.0, spacing, (0..count).map(height).collect()).unwrap();
    (wheel, profile, 6)
}

/// Flow that hardens in time goes as r₀ (1 − G (1 − e^{−nH(1/D_h + G)})/(1/D_h + G)), to rest at r₀/(1 + D_h G), G = u₁/Δ: what a forecast
/// marches, to 0.5 %.
#[test]
fn flow_that_hardens_over_passages() {
    let (speed, wavelength, amplitude) = (14.0, 0.3, 2e-6);
    let pressure = fixtures::hertz().peak_pressure();
    let (feedback, model) = both(two_layers(), carter, 0.6, speed, amplitude);
    let feedback = feedback.close().unwrap();
    let steady = feedback.contacts()[0].rolling.steady();
    let limit = ShakedownLimit::Line;
    let at_unit = Demand::new(&steady, pressure, pressure, limit).unwrap();
    let demand = Demand::new(&steady, pressure, 0.75 * pressure * at_unit.value, limit).unwrap();
    let of = |hardening_depth| {
        let law = DamageLaw::Flow(Flow {
            depth: 1e-9,
            law: ClippedPower::new(1.0, 0.0),
            hardening_depth: Some(hardening_depth),
        });
        let damage = Arc::new(Damage::new(demand, vec![law]));
        feedback.clone().with_damage(|_| Some(damage.clone()))
    };
    let gain = of(1.0).at(wavelength, speed).contacts[0].damage.unwrap().demand;
    // Small, so that no other wave runs away.
    let hardening_depth = 0.15 / gain.norm();
    let (wheel, profile, waves) = waves_under(&model, &of(hardening_depth), wavelength, amplitude);
    let mut evolution = Evolution::new(&profile);
    let wave = |evolution: &Evolution| evolution.waves()[waves - 1].1;
    let before = wave(&evolution);
    let step = EvolutionStep { largest_change: 0.1, largest_step: 3e-3 };
    let along = hardening_depth.recip() + gain;
    let all = (4.0 * hardening_depth / 1e-9) as u64;
    while evolution.passages() < all {
        let most = all - evolution.passages();
        evolution.advance(&[&wheel], &step, most).unwrap();
        let passages = evolution.passages() as f64;
        let expected = 1.0 - gain / along * (1.0 - (-1e-9 * passages * along).exp());
        let found = wave(&evolution) / before;
        let error = (found - expected).norm() / expected.norm();
        assert!(error < 0.005, "{passages}: {found} {expected}");
    }
    let end = (1.0 + hardening_depth * gain).inv();
    let found = wave(&evolution) / before;
    assert!((found - end).norm() < 0.02 * end.norm(), "{found} {end}");
    assert!((end.norm() - 1.0).abs() > 0.1);
    // What has flowed everywhere uses the demand up.
    let mean = evolution.outflow().iter().sum::<f64>() / evolution.outflow().len() as f64;
    let used = mean / (hardening_depth * demand.excess());
    assert!((used - 1.0).abs() < 0.03, "{used}");
}

/// The laws of damage beside wear, one by one: growth of a wave over passages is that of the loop, of all that is linear to 1 % of the
/// law's own size, of what lies about its limit to 3 % by its first harmonic, as the wave's harmonics are left out there.
#[test]
fn laws_of_damage_over_passages_are_those_of_the_loop() {
    let (speed, wavelength, amplitude) = (20.0, 0.3, 2e-6);
    let hertz = fixtures::hertz();
    let (feedback, model) = both(two_layers(), carter, 0.6, speed, amplitude);
    let feedback = feedback.close().unwrap();
    let steady = feedback.contacts()[0].rolling.steady();
    let limit = ShakedownLimit::Line;
    let pressure = hertz.peak_pressure();
    let of_yield = |shear| Demand::new(&steady, pressure, shear, limit).unwrap();
    let with = |demand: Demand, law: DamageLaw| {
        let damage = Arc::new(Damage::new(demand, vec![law]));
        feedback.clone().with_damage(|_| Some(damage.clone()))
    };
    // Yield at which the mean state lies some share of its oscillation above the limit; without one well above.
    let at_unit = of_yield(pressure);
    let swing = |demand: Demand| {
        let state = feedback.at(wavelength, speed).contacts[0].force;
        demand.oscillation(state).norm()
    };
    let about = |share: f64| {
        let mut shear = pressure * at_unit.value;
        for _ in 0..20 {
            let demand = of_yield(shear);
            shear *= demand.value / (1.0 + share * swing(demand));
        }
        of_yield(shear)
    };
    let above = of_yield(0.8 * pressure * at_unit.value);
    let law = |exponent| ClippedPower::new(exponent, 0.0);
    let flow = |exponent| DamageLaw::Flow(Flow { depth: 1e-9, law: law(exponent), hardening_depth: None });
    let along = DamageLaw::FlowAlong(FlowAlong { area: 1e-10, law: law(1.0) });
    let load = DamageLaw::Load(Load { depth_per_force: 1e-15 });
    let (stiffness, foundation) = (207e9 * 2.35e-5, 30e6);
    let moment = Bending::moment_at_rest(50e3, stiffness, foundation);
    let bending = |limit: f64| {
        DamageLaw::Bending(Bending {
            limit: limit * moment,
            curvature: 1e-8,
            law: law(1.0),
            bending_stiffness: stiffness,
            foundation,
            mean_moment: moment,
        })
    };
    let mean = steady.energy_per_metre();
    let mut fatigue = Fatigue::new([0.2 * mean, 2.0 * mean, 3.0 * mean], 1e-5).unwrap();
    fatigue.loss = 1e-3;
    for (name, demand, law, tolerance) in [
        ("load", above, load, 0.01),
        ("flow", above, flow(1.0), 0.01),
        ("flow squared", above, flow(2.0), 0.01),
        ("flow along", above, along, 0.01),
        ("bending", above, bending(0.9), 0.01),
        ("fatigue", above, DamageLaw::Fatigue(fatigue), 0.01),
        ("flow half above", about(0.0), flow(1.0), 0.03),
        ("flow mostly below", about(-0.4), flow(1.0), 0.03),
        ("flow along mostly above", about(0.3), along, 0.03),
    ] {
        let damaged = with(demand, law);
        let (wheel, profile, waves) = waves_under(&model, &damaged, wavelength, amplitude);
        let mut evolution = Evolution::new(&profile);
        let amplitude = |evolution: &Evolution| evolution.waves()[waves - 1].1;
        let before = amplitude(&evolution);
        let step = EvolutionStep { largest_change: 0.004, largest_step: 1.5e-3 };
        evolution.advance(&[&wheel], &step, u64::MAX).unwrap();
        // exp(gn) of G = g + drift.
        let found = (amplitude(&evolution) / before).ln() / evolution.passages() as f64;
        let state = damaged.at(wavelength, speed);
        let damage = state.contacts[0].damage.unwrap();
        let expected = damage.growth();
        let error = (found - expected).norm() / expected.norm();
        assert!(error < tolerance, "{name}: {found:e} for {expected:e}, {error:e}");
        assert!((state.growth_rate - expected.re).abs() <= 1e-9 * expected.norm());
    }
}
