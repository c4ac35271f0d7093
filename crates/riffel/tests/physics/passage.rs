//! A wheel in time against the linear loop, closed forms and balances.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use riffel::contact::{
    CreepLaw, HalfSpace, HalfSpaceCurve, JohnsonVermeulen, MeanState, NonSteady,
    OscillatingCreepages, QuasiStatic, ShenHedrickElkins,
};
use riffel::damage::{
    Bending, ClippedPower, Damage, DamageLaw, Demand, Fatigue, Flow, FlowAlong, Load,
    ShakedownLimit,
};
use riffel::feedback::OneWheel;
use riffel::passage::{
    ContactInTime, DamageInTime, Evolution, EvolutionStep, ImpulseResponse, LateContact,
    PassageModel, PassingWheel, Settled, Sinusoid, StructuresInTime, TransientContact,
    WearOfPassages,
};
use riffel::receptance::{
    Beam, ContinuousTrack, EulerBernoulliBeam, FreeBeam, Layer, ShearSection, Support,
};
use riffel::roughness::Profile;
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Carter3d, Complex64, DissipationPhase, ElasticMaterial, EnergyWear, Error, HertzContact, Loop,
    LoopState, PlaceOfWear, Receptance, WearCorners, WearRegimes,
};

const RADIUS: f64 = 0.46;
const MASS: f64 = 350.0;

fn steel() -> ElasticMaterial {
    ElasticMaterial::new(207e9, 0.3).unwrap()
}

fn rail() -> EulerBernoulliBeam {
    EulerBernoulliBeam::new(steel(), 2.35e-5, 56.0).unwrap()
}

fn timoshenko() -> Beam {
    let shear = ShearSection {
        area: 7.13e-3,
        shear_coefficient: 0.4,
        shear_modulus: steel().shear_modulus(),
        density: 7850.0,
    };
    Beam::timoshenko(steel(), 2.35e-5, 56.0, shear).unwrap()
}

/// Two layers: stiffness and damping of pad and ballast.
fn support(pad: [f64; 2], ballast: [f64; 2]) -> Support {
    let layer = |[stiffness, damping]: [f64; 2]| Layer::new(stiffness, damping).unwrap();
    let support = Support::two_layer(layer(pad), 110.0, layer(ballast)).unwrap();
    support.per_metre(0.7).unwrap()
}

fn two_layers() -> Arc<dyn Receptance> {
    let support = support([80e6, 20e3], [60e6, 30e3]);
    Arc::new(ContinuousTrack::new(Beam::from(rail()), support))
}

fn free_beam() -> Arc<dyn Receptance> {
    Arc::new(FreeBeam::new(rail()))
}

/// The linear loop and the same wheel in time.
fn both(
    track: Arc<dyn Receptance>,
    law: impl Fn(HertzContact) -> Arc<dyn CreepLaw>,
    ratio: f64,
    speed: f64,
    amplitude: f64,
) -> (OneWheel, PassageModel) {
    let hertz = HertzContact::new(steel(), RADIUS, 0.23, 50e3).unwrap();
    let law = law(hertz);
    let mean = MeanState::TractiveRatio(ratio);
    let contact = QuasiStatic::new(law.clone(), 50e3, mean).unwrap();
    let mean = riffel::RollingContact::steady(&contact);
    let inertia = RigidInertia::reduced_inertia(MASS, RADIUS);
    let rotation = RigidInertia::new(inertia, RADIUS).unwrap();
    let wheel = RigidMass::new(MASS).unwrap();
    let response = ImpulseResponse::of(&*track, speed).unwrap();
    let in_time = ContactInTime::of_one_wheel(mean, hertz.stiffness(), law);
    let passage = PassageModel {
        structures: StructuresInTime::of_one_wheel(response, &wheel, Some(&rotation)),
        contacts: vec![in_time.unwrap()],
        contact_filter: None,
        speed,
    };
    let feedback = OneWheel {
        track,
        wheel: Arc::new(wheel),
        contact_stiffness: hertz.stiffness(),
        contact: Arc::new(contact),
        rotation: Motion::compliant(rotation),
        wave: None,
        place_of_wear: PlaceOfWear::new(DissipationPhase::None, 0.0, ratio),
        wear: EnergyWear::new(2.5e-9, 7850.0, hertz.semi_axis_lateral()).unwrap(),
        amplitude,
    };
    (feedback, passage)
}

fn at(feedback: &OneWheel, wavelength: f64, speed: f64) -> LoopState {
    feedback.clone().close().unwrap().at(wavelength, speed)
}

fn carter(hertz: HertzContact) -> Arc<dyn CreepLaw> {
    Arc::new(Carter3d::new(hertz, 0.4).unwrap())
}

fn settle(model: &PassageModel, amplitude: f64, wavelength: f64, steps: usize) -> Settled {
    let profile = Sinusoid {
        amplitude,
        wavelength,
    };
    model.settle(profile, steps).unwrap().swap_remove(0)
}

/// Causal tracks to 10⁻⁵ rms, with pads that let rail and sleeper ring as well.
#[test]
fn receptance_comes_back() {
    let ringing = support([280e6, 6e3], [180e6, 8e3]);
    let tracks: [Arc<dyn Receptance>; 5] = [
        two_layers(),
        free_beam(),
        Arc::new(ContinuousTrack::free(timoshenko())),
        Arc::new(ContinuousTrack::new(timoshenko(), ringing)),
        Arc::new(ContinuousTrack::new(
            Beam::from(rail()),
            Support::one_layer(Layer::new(60e6, 10e3).unwrap()),
        )),
    ];
    for (index, track) in tracks.iter().enumerate() {
        let response = ImpulseResponse::of(&**track, 30.0).unwrap();
        assert!(response.share_cut().sqrt() < 1e-5, "track {index}");
        for hertz in [20.0, 90.0, 431.0, 1234.5, 4999.0] {
            let exact = track.receptance(TAU * hertz, 30.0);
            let error = (response.receptance(TAU * hertz) - exact).norm() / exact.norm();
            assert!(error < 3e-5, "track {index} at {hertz} Hz: {error:e}");
        }
    }
}

/// H = c(iω)^{−3/2} is g = 2c√(t/π), over the times of the band.
#[test]
fn square_root_of_the_free_beam() {
    let response = ImpulseResponse::of(&*free_beam(), 30.0).unwrap();
    let c = free_beam().receptance(1.0, 0.0).norm();
    for decade in [-5.0, -4.5, -4.0, -3.0, -2.0, -1.0] {
        let time = 10f64.powf(decade);
        let exact = 2.0 * c * (time / PI).sqrt();
        let error = response.at(time) / exact - 1.0;
        assert!(error.abs() < 2e-5, "{time} s: {error:e}");
    }
}

/// What a loss factor cuts off grows with its square (0.04² : 0.02², less a little of the next order), and a large one is refused.
#[test]
fn a_loss_factor_is_not_causal() {
    let with = |loss: f64| {
        let layer = Layer::new(80e6, 20e3).unwrap().with_loss_factor(loss);
        let support = Support::one_layer(layer.unwrap()).per_metre(0.7).unwrap();
        ImpulseResponse::of(&ContinuousTrack::new(Beam::from(rail()), support), 30.0)
    };
    let shares = [0.02, 0.04].map(|loss| with(loss).unwrap().share_cut());
    assert!((shares[1] / shares[0] - 4.0).abs() < 0.4, "{shares:?}");
    assert!(matches!(with(0.5), Err(Error::NotCausal { .. })));
}

/// Every first harmonic of 0.1 µm is that of the linear loop to 2·10⁻⁴: 256 steps to a wave take half of it.
#[test]
fn small_amplitudes_are_the_linear_loop() {
    let amplitude = 1e-7;
    let laws: [fn(HertzContact) -> Arc<dyn CreepLaw>; 3] = [
        carter,
        |hertz| Arc::new(JohnsonVermeulen::new(ellipse(hertz), 0.4).unwrap()),
        |hertz| Arc::new(ShenHedrickElkins::new(ellipse(hertz), 0.4).unwrap()),
    ];
    for (track, law, ratio, speed, wavelength) in [
        (two_layers(), laws[0], 0.3, 30.0, 0.03),
        (two_layers(), laws[1], 0.7, 12.0, 0.06),
        (free_beam(), laws[2], 0.1, 33.0, 0.055),
        (free_beam(), laws[0], 0.3, 40.0, 0.05),
    ] {
        let (feedback, model) = both(track, law, ratio, speed, amplitude);
        let linear = at(&feedback, wavelength, speed);
        let settled = settle(&model, amplitude, wavelength, 256);
        let first = settled.harmonics[1];
        for (got, exact) in [
            (first.normal_force, linear.normal_force()),
            (first.tangential_force, linear.tangential_force()),
            (first.creepage, linear.creepage()),
            (first.dissipation * speed, linear.dissipation),
        ] {
            let error = (got - exact).norm() / exact.norm();
            assert!(error < 2e-4, "{got} for {exact}: {error:e}");
        }
        let mean = settled.harmonics[0];
        assert!((mean.normal_force.re / 50e3 - 1.0).abs() < 1e-8);
        assert!(
            (mean.tangential_force.re / model.contacts[0].mean.forces.longitudinal - 1.0).abs()
                < 1e-8
        );
    }
}

fn ellipse(hertz: HertzContact) -> riffel::contact::CreepEllipse {
    let kalker = riffel::contact::KalkerCoefficients::new(0.3, hertz.axis_ratio()).unwrap();
    riffel::contact::CreepEllipse::new(hertz, kalker)
}

/// Halving the step quarters the error, against 1024 steps to a wave, at an amplitude where Hertz hardens.
#[test]
fn second_order() {
    let (_, model) = both(two_layers(), carter, 0.3, 30.0, 1.0);
    let [coarse, half, fine] =
        [32, 64, 1024].map(|steps| settle(&model, 20e-6, 0.03, steps).harmonics[1]);
    let error = |of: &riffel::passage::Harmonic| (of.normal_force - fine.normal_force).norm();
    let ratio = error(&coarse) / error(&half);
    assert!((ratio - 4.0).abs() < 0.2, "{ratio}");
}

/// A wheel whose load is raised by a step comes to rest deeper by the static receptance of the track and the contact.
#[test]
fn comes_to_rest_on_a_step_of_the_rail() {
    let (_, model) = both(two_layers(), carter, 0.3, 30.0, 1.0);
    let mut march = model.march(5e-4).unwrap();
    let steps = (2.0 * 30.0 / 5e-4) as usize;
    for _ in 0..steps {
        march.advance(&[1e-5]);
    }
    let rest = march.now()[0];
    assert!((rest.normal_force / 50e3 - 1.0).abs() < 1e-9, "{rest:?}");
    assert!((rest.approach / model.contacts[0].spring.approach() - 1.0).abs() < 1e-9);
    assert!((rest.creepage / model.contacts[0].mean.creepages.longitudinal - 1.0).abs() < 1e-9);
}

/// Work that the profile does over a settled wave is what the track carries away, −½ Σ nω Im H |P_n|², with loss of
/// contact: to second order in the step, and to 10⁻⁶ of the work at 1024 steps.
#[test]
fn energy_over_a_wave() {
    let (feedback, model) = both(two_layers(), carter, 0.3, 30.0, 1.0);
    let wavelength = 0.03;
    let omega = TAU * 30.0 / wavelength;
    let miss = |steps: usize| {
        let settled = settle(&model, 60e-6, wavelength, steps);
        let force = |n: usize| {
            let terms = settled.wave.iter().enumerate().map(|(step, instant)| {
                let angle = TAU * ((n * (step + 1)) % steps) as f64 / steps as f64;
                Complex64::from_polar(2.0 / steps as f64, -angle) * instant.normal_force
            });
            terms.sum::<Complex64>()
        };
        // ½ Re(P₁* iωΔ) is the power of the profile.
        let profile = 0.5 * (force(1).conj() * Complex64::new(0.0, omega * 60e-6)).re;
        let track: f64 = (1..steps / 4)
            .map(|n| {
                let omega = omega * n as f64;
                -0.5 * omega * feedback.track.receptance(omega, 30.0).im * force(n).norm_sqr()
            })
            .sum();
        (track / profile - 1.0).abs()
    };
    let [coarse, fine] = [256, 1024].map(miss);
    assert!(fine < 1e-6 && fine < 0.1 * coarse, "{coarse:e} {fine:e}");
}

/// A constant torque works on the mean creepage alone: an inertia stores nothing, to what is left of settling.
#[test]
fn mean_dissipation_is_that_of_the_drive() {
    let (_, model) = both(two_layers(), carter, 0.3, 33.0, 1.0);
    for amplitude in [20e-6, 100e-6] {
        let mean = settle(&model, amplitude, 0.04, 256).harmonics[0];
        let drive = model.contacts[0].mean.forces.longitudinal * mean.creepage.re;
        let error = mean.dissipation.re / drive - 1.0;
        assert!(error.abs() < 1e-6, "{amplitude}: {error:e}");
    }
}

#[test]
fn refusals() {
    let (_, model) = both(two_layers(), carter, 0.3, 33.0, 1.0);
    let refused = |amplitude, wavelength, steps| {
        let profile = Sinusoid {
            amplitude,
            wavelength,
        };
        model.settle(profile, steps).unwrap_err().to_string()
    };
    assert!(refused(1e-5, 0.04, 8).contains("at least 20"));
    assert!(refused(-1e-5, 0.04, 64).contains("amplitude"));
    assert!(refused(2e-2, 0.02, 64).contains("in the air for 9"));
}

/// A long sinusoid rolled over once is the settled state from five metres on, to what the beginning leaves: 10⁻⁴ of the
/// first harmonic.
#[test]
fn a_passage_over_a_sinusoid_settles() {
    let (_, model) = both(two_layers(), carter, 0.3, 30.0, 1.0);
    let (amplitude, wavelength) = (20e-6, 0.05);
    let settled = settle(&model, amplitude, wavelength, 256);
    let spacing = wavelength / 64.0;
    let heights = (0..64 * 300)
        .map(|index| amplitude * (TAU * f64::from(index) / 64.0).cos())
        .collect();
    let profile = Profile::new(0.0, spacing, heights).unwrap();
    let passage = model.pass(&profile, spacing / 3.9).unwrap();
    assert_eq!(passage.step, spacing / 4.0);
    let first = settled.harmonics[1].normal_force.norm();
    let mut worst = 0f64;
    for (index, contact) in passage.contacts.iter().enumerate().skip(64 * 100) {
        // The crest is the last of a settled wave.
        let same = settled.wave[(4 * index + 255) % 256];
        worst = worst.max((contact.normal_force - same.normal_force).abs() / first);
    }
    assert!(worst < 1e-4, "{worst:e}");
    assert_eq!(passage.contact_loss, 0.0);
    let short = profile.between(0.0, 0.5).unwrap();
    assert!(matches!(
        model.pass(&short, spacing),
        Err(Error::ProfileTooShort { .. })
    ));
}

/// Growth of two waves over many passages is that of the linear loop, to 2·10⁻³: Heun's steps of 8 % leave half of it; also by a law
/// of wear with regimes, whose coefficient changes over the wave.
#[test]
fn growth_over_passages_is_linear_growth() {
    for (track, regimes) in [
        (two_layers(), false),
        (free_beam(), false),
        (two_layers(), true),
    ] {
        let (mut feedback, model) = both(track, carter, 0.3, 30.0, 1e-6);
        if regimes {
            let hertz = HertzContact::new(steel(), RADIUS, 0.23, 50e3).unwrap();
            let corners = WearCorners::Rounded;
            let law = WearRegimes::TgammaArea {
                corners,
                spread: 0.5,
            };
            let wear = law.wear(&hertz, &feedback.contact.steady(), 7850.0, 1.0);
            feedback.wear = wear.unwrap();
        }
        let semi_axis = 6e-3;
        feedback.place_of_wear = PlaceOfWear::new(DissipationPhase::Lag, semi_axis, 0.3);
        let wear = WearOfPassages {
            wear: feedback.wear,
            place: feedback.place_of_wear,
            shortest: 2.0 * semi_axis,
        };
        let (length, count) = (2.4, 2400);
        let heights = (0..count).map(|index| {
            let x = length * f64::from(index) / f64::from(count);
            0.1e-6 * (TAU * x / 0.06).cos() + 0.1e-6 * (TAU * x / 0.08 + 1.0).cos()
        });
        let profile = Profile::new(0.0, length / f64::from(count), heights.collect()).unwrap();
        let mut evolution = Evolution::new(&profile);
        let wheel = PassingWheel {
            memory: model.memory().unwrap(),
            model,
            wear,
            share: 1.0,
            traction_share: 1.0,
        };
        let step = EvolutionStep {
            largest_change: EvolutionStep::USUAL_CHANGE,
            largest_step: 1e-3,
        };
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
            assert!(
                error < 1e-2,
                "{wavelength}: {rate:e} for {:e}",
                linear.growth_rate
            );
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
        wear: WearOfPassages {
            wear: contact.wear,
            place: contact.place_of_wear,
            shortest: 0.01,
        },
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
    let pressure = HertzContact::new(steel(), RADIUS, 0.23, 50e3)
        .unwrap()
        .peak_pressure();
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
    let gain = of(1.0).at(wavelength, speed).contacts[0]
        .damage
        .unwrap()
        .demand;
    // Small, so that no other wave runs away.
    let hardening_depth = 0.15 / gain.norm();
    let (wheel, profile, waves) = waves_under(&model, &of(hardening_depth), wavelength, amplitude);
    let mut evolution = Evolution::new(&profile);
    let wave = |evolution: &Evolution| evolution.waves()[waves - 1].1;
    let before = wave(&evolution);
    let step = EvolutionStep {
        largest_change: 0.1,
        largest_step: 3e-3,
    };
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
    let hertz = HertzContact::new(steel(), RADIUS, 0.23, 50e3).unwrap();
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
    let flow = |exponent| {
        DamageLaw::Flow(Flow {
            depth: 1e-9,
            law: law(exponent),
            hardening_depth: None,
        })
    };
    let along = DamageLaw::FlowAlong(FlowAlong {
        area: 1e-10,
        law: law(1.0),
    });
    let load = DamageLaw::Load(Load {
        depth_per_force: 1e-15,
    });
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
        let step = EvolutionStep {
            largest_change: 0.004,
            largest_step: 1.5e-3,
        };
        evolution.advance(&[&wheel], &step, u64::MAX).unwrap();
        // exp(gn) of G = g + drift.
        let found = (amplitude(&evolution) / before).ln() / evolution.passages() as f64;
        let state = damaged.at(wavelength, speed);
        let damage = state.contacts[0].damage.unwrap();
        let expected = damage.growth();
        let error = (found - expected).norm() / expected.norm();
        assert!(
            error < tolerance,
            "{name}: {found:e} for {expected:e}, {error:e}"
        );
        assert!((state.growth_rate - expected.re).abs() <= 1e-9 * expected.norm());
    }
}

/// A contact that answers late, by the exact theory: over waves as short as two semi-axes the first harmonics are those of the
/// linear loop with the table of that contact, and growth is its growth rate.
#[test]
fn a_late_contact_is_that_of_the_linear_loop() {
    let hertz = HertzContact::new(steel(), RADIUS, 0.23, 50e3).unwrap();
    let a = hertz.semi_axis_longitudinal();
    let contact = HalfSpace::new(hertz, 0.4, 24).unwrap();
    let state = contact.roll_at_tractive_ratio(0.4).unwrap();
    let law = Arc::new(HalfSpaceCurve::new(&contact, &state).unwrap());
    let table = NonSteady::new(
        &contact,
        &state,
        OscillatingCreepages::Longitudinal,
        1.01 * a,
        100.0 * a,
        1e-4,
    );
    let table = Arc::new(table.unwrap());
    let late = LateContact::new(&*table, &*law, a, [1.01 * a, 100.0 * a]).unwrap();
    let (feedback, model) = both(two_layers(), |_| law.clone(), 0.4, 30.0, 1e-7);
    let feedback = OneWheel {
        contact: table.clone(),
        ..feedback
    };
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
        wear: WearOfPassages {
            wear: feedback.wear,
            place: feedback.place_of_wear,
            shortest: a,
        },
        share: 1.0,
        traction_share: 1.0,
    };
    let step = EvolutionStep {
        largest_change: EvolutionStep::USUAL_CHANGE,
        largest_step: 2e-4,
    };
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
        let expected = -feedback.wear.depth_per_energy() * linear.dissipation_at_rail
            / (30.0 * feedback.amplitude);
        let error = (change - expected).norm() / expected.norm();
        assert!(error < 2e-3, "{line}: {change} {expected} {error:e}");
    }
}

/// The exact contact followed element by element, where the load swings by a sixth: its first harmonics are those of the linear loop
/// with the table of that contact, but for the elements, two in a hundred (where it swings by less, its edge moves by less than an element, and
/// errors reach a fifth of the harmonics).
#[test]
fn transient_contact_at_small_amplitude() {
    let hertz = HertzContact::new(steel(), RADIUS, 0.23, 50e3).unwrap();
    let a = hertz.semi_axis_longitudinal();
    let contact = HalfSpace::new(hertz, 0.4, 32).unwrap();
    let state = contact.roll_at_tractive_ratio(0.4).unwrap();
    let law: Arc<dyn CreepLaw> = Arc::new(HalfSpaceCurve::new(&contact, &state).unwrap());
    let table = NonSteady::new(
        &contact,
        &state,
        OscillatingCreepages::Longitudinal,
        1.01 * a,
        100.0 * a,
        1e-4,
    );
    let (feedback, model) = both(two_layers(), |_| law.clone(), 0.4, 30.0, 1.0);
    let feedback = OneWheel {
        contact: Arc::new(table.unwrap()),
        ..feedback
    };
    let profile = Sinusoid {
        amplitude: 20e-6,
        wavelength: 0.06,
    };
    let contact = TransientContact {
        hertz,
        friction: 0.4,
        across: 32,
        over_true_gap: false,
    };
    let linear = at(&feedback, profile.wavelength, 30.0);
    let got = model.settle_transient(profile, 256, contact).unwrap();
    let first = got.settled.harmonics[1];
    for (got, expected, limit) in [
        (first.normal_force, linear.normal_force(), 1e-3),
        (first.tangential_force, linear.tangential_force(), 0.02),
        (first.creepage, linear.creepage(), 0.02),
        (
            got.energy_at_rail[1],
            linear.dissipation_at_rail / 30.0,
            0.02,
        ),
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
    let profile = Sinusoid {
        amplitude: 200e-6,
        wavelength: 0.055,
    };
    let contact = TransientContact {
        hertz: HertzContact::new(steel(), RADIUS, 0.23, 50e3).unwrap(),
        friction: 0.4,
        across: 16,
        over_true_gap: false,
    };
    let got = model
        .settle_transient(profile, 256, contact)
        .unwrap()
        .settled;
    assert!(got.contact_loss > 0.05);
    for instant in &got.wave {
        assert!(instant.tangential_force.abs() <= 0.4 * instant.normal_force);
    }
    for (across, wavelength) in [(16, 0.01), (17, 0.055)] {
        let contact = TransientContact { across, ..contact };
        let profile = Sinusoid {
            amplitude: 1e-6,
            wavelength,
        };
        let refused = model.settle_transient(profile, 256, contact);
        assert!(matches!(refused, Err(Error::OutOfRange { .. })));
    }
}
