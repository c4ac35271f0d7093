//! Wear in proportion to the normal force: which waves of a surface grow under a mass on a spring.

use std::f64::consts::PI;
use std::sync::Arc;

use proptest::prelude::*;
use riffel::contact::{LoadWear, MeanState, QuasiStatic};
use riffel::feedback::OneWheel;
use riffel::receptance::RigidGround;
use riffel::wheelset::{Motion, RigidMass, SprungMass};
use riffel::{Carter3d, Loop, Receptance};

use crate::fixtures::{hertz, one_wheel};

/// A wheel on rigid ground on the spring of its contact.
fn on_rigid_ground(wheel: impl Receptance + 'static, stiffness: f64) -> Loop {
    let hertz = hertz();
    let law = Carter3d::new(hertz, 0.4).unwrap();
    let rolling = QuasiStatic::new(law, 50e3, MeanState::TractiveRatio(0.3)).unwrap();
    // The patch takes no part, so neither does the reading of its phase.
    OneWheel {
        wheel: Arc::new(wheel),
        contact_stiffness: stiffness,
        contact: Arc::new(LoadWear::new(Arc::new(rolling))),
        rotation: Motion::Held,
        ..one_wheel(Arc::new(RigidGround), hertz, 0.4, 0.3)
    }
    .close()
    .unwrap()
}

proptest! {
    /// Washboard: without damping growth if and only if ω < ω₀ = √(k/m), so for all waves longer than V/f₀.
    #[test]
    fn a_road_grows_below_the_resonance_of_the_sprung_mass(
        mass in 200.0..20e3f64, resonance in 0.5..5.0f64, ratio in 0.05..20.0f64, speed in 3.0..40.0f64,
    ) {
        prop_assume!((ratio - 1.0).abs() > 1e-6);
        let stiffness = mass * (2.0 * PI * resonance).powi(2);
        let sprung = SprungMass::new(mass, stiffness, 0.0).unwrap();
        prop_assert!((sprung.natural_frequency() / resonance - 1.0).abs() < 1e-12);
        // Ground and tyre do not yield: the spring of the mass is the only one.
        let road = on_rigid_ground(sprung, f64::MAX);
        let growth = road.at(speed / (ratio * resonance), speed).growth_rate;
        prop_assert_eq!(growth > 0.0, ratio < 1.0, "{}", growth);
    }

    /// The force on the road, Both et al. (2001): −mω²(k + iωc)/(k − mω² + iωc) h.
    #[test]
    fn the_sprung_mass_presses_as_published(
        mass in 200.0..20e3f64, stiffness in 1e4..1e6f64, damping in 0.0..1e5f64, frequency in 0.1..50.0f64,
    ) {
        let sprung = SprungMass::new(mass, stiffness, damping).unwrap();
        let w = 2.0 * PI * frequency;
        let spring = riffel::Complex64::new(stiffness, w * damping);
        let published = -mass * w * w * spring / (spring - mass * w * w);
        let got = sprung.receptance(w, 1.0).inv();
        prop_assert!((got - published).norm() < 1e-9 * published.norm());
    }

    /// Contact resonance: growth if and only if ω < ω_c = √(k_H/m), Re P₁/Δ = −k_H ω²/(ω_c² − ω²).
    #[test]
    fn a_disc_grows_below_its_contact_resonance(
        mass in 5.0..1000.0f64, stiffness in 1e8..3e9f64, ratio in 0.05..20.0f64,
    ) {
        prop_assume!((ratio - 1.0).abs() > 1e-6);
        let disc = on_rigid_ground(RigidMass::new(mass).unwrap(), stiffness);
        let resonance = (stiffness / mass).sqrt();
        let w = ratio * resonance;
        let state = disc.at(2.0 * PI * 10.0 / w, 10.0);
        let expected = -stiffness * w * w / (resonance * resonance - w * w) * disc.amplitude();
        // Near the resonance two numbers that differ by 1e-6 of themselves are subtracted.
        prop_assert!((state.normal_force().re / expected - 1.0).abs() < 1e-8);
        prop_assert_eq!(state.growth_rate > 0.0, ratio < 1.0);
    }
}

/// The mean wear is that of the contact that creeps, and a wave of the force takes its share of it.
#[test]
fn a_wave_of_the_force_takes_its_share_of_the_mean_wear() {
    let disc = on_rigid_ground(RigidMass::new(350.0).unwrap(), 1e9);
    let state = disc.at(0.1, 10.0);
    let share = state.dissipation_at_rail / state.mean_dissipation;
    let load = state.normal_force() / 50e3;
    assert!((share - load).norm() < 1e-14 * load.norm());
}

#[test]
fn a_sprung_mass_needs_a_spring() {
    assert!(SprungMass::new(1000.0, 0.0, 0.0).is_err());
    assert!(SprungMass::new(1000.0, 1e5, -1.0).is_err());
}
