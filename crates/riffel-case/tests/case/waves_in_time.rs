//! The shape of waves in time, by the keys of a case.

use std::f64::consts::TAU;

use riffel::Complex64;
use riffel::passage::{Evolution, EvolutionStep, Sinusoid};
use riffel::roughness::Profile;
use riffel_case::{Case, NOMINAL_CASE, ask};

use crate::{case, trailer};

/// Largest difference of the first harmonics of forces and creepages over waves of an amplitude \[m\] at any contact from those of the linear loop, over the
/// largest of its kind, and what the shape of the waves makes of it.
fn off(case: &Case, amplitude: f64, wavelength: f64, speed: f64) -> [f64; 2] {
    let profile = Sinusoid { amplitude, wavelength };
    let settled = ask::in_time(case, speed).unwrap().settle(profile, 256).unwrap();
    let plain = case.feedback.clone().without_wave_geometry();
    let plain = plain.without_normal_direction().at(wavelength, speed);
    let linear = case.feedback.at(wavelength, speed);
    let scale = amplitude / case.feedback.amplitude();
    let mut most = [[0f64; 3]; 2];
    for (index, settled) in settled.iter().enumerate() {
        let first = &settled.harmonics[1];
        let of = |state: &riffel::LoopState| {
            let contact = &state.contacts[index];
            [contact.force.to_vec(), contact.creepage.to_vec()]
                .map(|values| values.into_iter().map(|value| scale * value).collect::<Vec<_>>())
        };
        let got: [Vec<Complex64>; 2] = [
            vec![first.tangential_force, first.lateral_force, first.normal_force],
            vec![first.creepage, first.lateral_creepage],
        ];
        for (kind, (got, (linear, plain))) in got.iter().zip(of(&linear).iter().zip(of(&plain))).enumerate() {
            for ((got, linear), plain) in got.iter().zip(linear).zip(plain) {
                let [off, by_shape, size] = &mut most[kind];
                *off = off.max((got - linear).norm());
                *by_shape = by_shape.max((plain - linear).norm());
                *size = size.max(linear.norm());
            }
        }
    }
    [0, 1].map(|of| most.iter().map(|kind| kind[of] / kind[2]).fold(0.0, f64::max))
}

/// First harmonics with the shape of the waves under every contact that can be followed in time, and with normal forces that turn with them; of a
/// contact that answers late the filters leave 10⁻⁴.
// Long: follows waves in time under eight contacts until they settle.
#[test]
fn shapes_of_waves_are_those_of_the_linear_loop() {
    let waves = "contact.wave_geometry=true";
    let (turned, climbing) = ("wheel.normal_direction=true", "wheelset.normal_direction=true");
    let late = ["contact.response=non-steady", "contact.grid=16"];
    let slips = NOMINAL_CASE.replace("tractive_ratio = 0.1", "creepage = \"2 %\"");
    let sliding = "contact.creep_law=full-sliding";
    let slides_across = ["contact.creepage={longitudinal=\"1 %\", lateral=\"2 %\"}", sliding];
    let antiphase = "wheelset.opposite_rail=antiphase";
    let two = ["wheelset.opposite_rail=absent", "train.wheels=[0, 2.1]"];
    for (case, wavelength, speed) in [
        (case(NOMINAL_CASE, &[waves, turned]), 0.0557, 30.0),
        (case(NOMINAL_CASE, &[turned]), 0.03, 10.0),
        (case(NOMINAL_CASE, &[&late[..], &[waves, turned]].concat()), 0.04, 30.0),
        (case(NOMINAL_CASE, &[&late[..], &[waves]].concat()), 0.08, 30.0),
        (case(&slips, &[sliding, waves]), 0.04, 20.0),
        (trailer(&[antiphase, waves, climbing]), 0.05, 20.0),
        (trailer(&[&two[..], &[waves, climbing]].concat()), 0.08, 15.0),
        (case(NOMINAL_CASE, &[&slides_across[..], &[waves]].concat()), 0.05, 20.0),
    ] {
        let [off, by_shape] = off(&case, 1e-6, wavelength, speed);
        assert!(off < 1e-3, "{wavelength} {speed}: {off:.1e}");
        assert!(by_shape > 0.01, "{wavelength} {speed}: {by_shape:.1e}");
    }
}

/// Growth of small waves without a shape is that of the linear loop; the fit of the structures and the step leave 10⁻⁴.
// Long: follows waves in time on three structures until they settle.
#[test]
fn small_waves_are_those_of_the_linear_loop() {
    let lone = ["contact.creepage={longitudinal=\"0.1 %\", lateral=\"0.3 %\"}", "contact.creep_law=polach"];
    let antiphase = ["wheelset.opposite_rail=antiphase", "contact.contact_angle=\"5 deg\""];
    for (case, wavelength, speed) in [
        (case(NOMINAL_CASE, &lone), 0.12, 15.0),
        (trailer(&antiphase), 0.05, 20.0),
        (trailer(&["wheelset.opposite_rail=absent", "train.wheels=[0, 2.1]"]), 0.03, 12.0),
    ] {
        let [off, _] = off(&case, 1e-8, wavelength, speed);
        assert!(off < 3e-4, "{wavelength} {speed}: {off:.1e}");
    }
}

/// Rate at which passages of a case let a wave of 50 mm grow at first, and the linear loop with the shape of the wave and without.
fn grown(case: &Case, speed: f64) -> (f64, [riffel::LoopState; 2]) {
    let (waves, length, count) = (50, 2.5, 2500);
    let wavelength = length / f64::from(waves);
    let height = |index: i32| 0.1e-6 * (TAU * f64::from(waves * index) / f64::from(count)).cos();
    let heights = (0..count).map(height).collect();
    let profile = Profile::new(0.0, length / f64::from(count), heights).unwrap();
    let wheel = ask::passing_wheel(case, speed).unwrap();
    let step = EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: 5e-4 };
    let mut evolution = Evolution::new(&profile);
    let amplitude = |evolution: &Evolution| evolution.waves()[waves as usize - 1].1.norm();
    let before = amplitude(&evolution);
    evolution.advance(&[&wheel], &step, u64::MAX).unwrap();
    let rate = (amplitude(&evolution) / before).ln() / evolution.passages() as f64;
    let linear = case.feedback.at(wavelength, speed);
    let plain = case.feedback.clone().without_wave_geometry();
    let plain = plain.without_normal_direction().at(wavelength, speed);
    (rate, [linear, plain])
}

/// Flow and wear by regime over passages take the patch of the wave as the linear loop does, to what the march leaves of the parts.
#[test]
fn damage_of_shaped_waves_is_linear_damage() {
    let common = [
        "contact.wave_geometry=true",
        "track.model=two-layer",
        "track.preset=bhaskar-inferred",
        "corrugation.amplitude=0.1 um",
    ];
    let flow =
        ["damage.laws=[\"flow\"]", "damage.shear_yield=\"100 MPa\"", "damage.flow={ depth=\"1 nm\", exponent=1 }"];
    let regime = ["wear.law=usfd", "wear.spread=3"];
    for keys in [&flow[..], &regime] {
        let case = case(NOMINAL_CASE, &[&common[..], keys].concat());
        let (rate, [linear, plain]) = grown(&case, 25.0);
        let size = linear.growth_rate.abs().max(plain.growth_rate.abs());
        let off = (rate - linear.growth_rate) / size;
        assert!(off.abs() < 5e-3, "{rate:e} {:e}", linear.growth_rate);
        assert!((linear.growth_rate - plain.growth_rate).abs() > 0.05 * size);
    }
}

/// Growth of a wave over passages is that of the linear loop with its shape and with normal forces that turn with it, under contacts that
/// answer at once, late, and that slide everywhere: Heun's steps, those of the march and the filters leave 2·10⁻³ of the parts that make it.
#[test]
fn growth_of_shaped_waves_is_linear_growth() {
    const SPEED: f64 = 25.0;
    let (waves, turned) = ("contact.wave_geometry=true", "wheel.normal_direction=true");
    let (late, grid) = ("contact.response=non-steady", "contact.grid=16");
    let slips = NOMINAL_CASE.replace("tractive_ratio = 0.1", "creepage = \"2 %\"");
    // A track that forgets.
    let track = ["track.model=two-layer", "track.preset=bhaskar-inferred", "corrugation.amplitude=0.1 um"];
    for (text, keys) in [
        (NOMINAL_CASE, &[waves, turned][..]),
        (NOMINAL_CASE, &[waves, turned, late, grid]),
        (&slips, &[waves, turned, "contact.creep_law=full-sliding"]),
    ] {
        let case = case(text, &[&track, keys].concat());
        let (rate, [linear, plain]) = grown(&case, SPEED);
        // The shape takes most of it away.
        let [energy, part] = [&linear, &plain].map(|state| state.contacts[0].energy_at_rail);
        let size = energy.norm().max(part.norm());
        let off = (rate / linear.growth_rate - 1.0).abs() * energy.re.abs() / size;
        assert!(off < 2e-3, "{rate:e} for {:e}", linear.growth_rate);
    }
}
