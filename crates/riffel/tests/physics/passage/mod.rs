//! A wheel in time against the linear loop, closed forms and balances.

mod many;
mod transient_contact;

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use riffel::contact::{CreepLaw, JohnsonVermeulen, MeanState, QuasiStatic, ShenHedrickElkins};
use riffel::feedback::OneWheel;
use riffel::passage::{ContactInTime, ImpulseResponse, PassageModel, Settled, Sinusoid, StructuresInTime};
use riffel::receptance::{Beam, ContinuousTrack, Layer, ShearSection, Support};
use riffel::roughness::Profile;
use riffel::wheelset::{RigidInertia, RigidMass};
use riffel::{Carter3d, Complex64, DissipationPhase, Error, HertzContact, LoopState, PlaceOfWear, Receptance};

use crate::fixtures::{hertz, layer, one_wheel, rail, steel};
use crate::paper::free_beam;

const RADIUS: f64 = 0.46;
const MASS: f64 = 350.0;

fn timoshenko() -> Beam {
    let shear =
        ShearSection { area: 7.13e-3, shear_coefficient: 0.4, shear_modulus: steel().shear_modulus(), density: 7850.0 };
    Beam::timoshenko(steel(), 2.35e-5, 56.0, shear).unwrap()
}

/// Two layers: stiffness and damping of pad and ballast.
fn support(pad: [f64; 2], ballast: [f64; 2]) -> Support {
    let [pad, ballast] = [pad, ballast].map(|[stiffness, damping]| layer(stiffness, damping));
    let support = Support::two_layer(pad, 110.0, ballast).unwrap();
    support.per_metre(0.7).unwrap()
}

fn two_layers() -> Arc<dyn Receptance> {
    let support = support([80e6, 20e3], [60e6, 30e3]);
    Arc::new(ContinuousTrack::new(Beam::from(rail()), support))
}

/// The linear loop and the same wheel in time.
fn both(
    track: Arc<dyn Receptance>,
    law: impl Fn(HertzContact) -> Arc<dyn CreepLaw>,
    ratio: f64,
    speed: f64,
    amplitude: f64,
) -> (OneWheel, PassageModel) {
    let hertz = hertz();
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
        contact: Arc::new(contact),
        place_of_wear: PlaceOfWear::new(DissipationPhase::None, 0.0, ratio),
        amplitude,
        ..one_wheel(track, hertz, 0.4, ratio)
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
    let profile = Sinusoid { amplitude, wavelength };
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
        Arc::new(ContinuousTrack::new(Beam::from(rail()), Support::one_layer(Layer::new(60e6, 10e3).unwrap()))),
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
        assert!((mean.tangential_force.re / model.contacts[0].mean.forces.longitudinal - 1.0).abs() < 1e-8);
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
    let [coarse, half, fine] = [32, 64, 1024].map(|steps| settle(&model, 20e-6, 0.03, steps).harmonics[1]);
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
        let profile = Sinusoid { amplitude, wavelength };
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
    let heights = (0..64 * 300).map(|index| amplitude * (TAU * f64::from(index) / 64.0).cos()).collect();
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
    assert!(matches!(model.pass(&short, spacing), Err(Error::ProfileTooShort { .. })));
}
