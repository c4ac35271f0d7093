use std::sync::Arc;

use riffel::contact::ContactFilter;
use riffel::feedback::OneWheel;
use riffel::receptance::{Beam, ContinuousTrack, EulerBernoulliBeam, Layer, PeriodicTrack};
use riffel::roughness::{Spectrum, ThirdOctave};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{DissipationPhase, ElasticMaterial, EnergyWear, HertzContact, PlaceOfWear};

use super::*;
use crate::fixtures;

const SPACING: f64 = 0.6;

fn rail() -> Beam {
    let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
    EulerBernoulliBeam::new(steel, 3.038e-5, 60.2).unwrap().into()
}

fn support(pad: f64) -> Support {
    let pad = Layer::new(pad, 0.0).unwrap().with_loss_factor(0.25).unwrap();
    let ballast = Layer::new(50e6, 0.0).unwrap().with_loss_factor(1.0).unwrap();
    Support::two_layer(pad, 150.0, ballast).unwrap()
}

fn even_track(pad: f64) -> ContinuousTrack {
    ContinuousTrack::new(rail(), support(pad).per_metre(SPACING).unwrap())
}

fn feedback(track: Arc<dyn riffel::Receptance>) -> Loop {
    let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
    let hertz = HertzContact::new(steel, 0.46, 0.3, 50e3).unwrap();
    OneWheel {
        wheel: Arc::new(RigidMass::new(600.0).unwrap()),
        rotation: Motion::compliant(RigidInertia::new(60.0, 0.46).unwrap()),
        place_of_wear: PlaceOfWear::new(DissipationPhase::Lag, 5e-3, 0.1),
        wear: EnergyWear::new(2.5e-9, 7850.0, 5e-3).unwrap(),
        ..fixtures::one_wheel(track, hertz, 0.4, 0.1)
    }
    .close()
    .unwrap()
}

fn excitation(level: f64) -> Excitation {
    let flat = Spectrum::new((-35..=0).map(|index| (ThirdOctave::new(index), level))).unwrap();
    Excitation::new(&flat, None, ContactFilter::new(5e-3, 5e-3).unwrap(), 40.0).unwrap()
}

fn source<'a>(feedback: &'a Loop, decay: RailDecay<'a>, pad: f64) -> RollingSource<'a> {
    RollingSource {
        feedback,
        decay,
        rail: OscillatingCylinder::of_rail(0.15, 76.7e-4).unwrap(),
        sleepers: Some(Sleepers { support: support(pad), face: Piston::new(0.3).unwrap(), spacing: SPACING }),
        wheel: OscillatingSphere::of_wheel(0.46, 0.135).unwrap(),
        wheel_modes: None,
        air: Air::default(),
    }
}

fn powers(source: &RollingSource<'_>, level: f64) -> Vec<SoundPower> {
    let excitation = excitation(level);
    FrequencyBand::all().filter_map(|band| source.power(&excitation, band).unwrap()).collect()
}

/// What rail and sleepers radiate comes out of what the force puts into the rail: in every band, on pads from soft to
/// stiff.
#[test]
fn no_more_is_radiated_than_put_in() {
    for pad in [60e6, 300e6, 1e9] {
        let track = even_track(pad);
        let feedback = feedback(Arc::new(even_track(pad)));
        let powers = powers(&source(&feedback, RailDecay::Track(&track), pad), 0.0);
        assert_eq!(powers.len(), 18);
        for power in powers {
            assert!(power.rail > 0.0 && power.sleepers > 0.0 && power.wheel > 0.0);
            assert!(power.rail + power.sleepers < 0.2 * power.into_rail, "{power:?}");
        }
    }
}

/// The model is linear: 10 dB of roughness are 10 dB of every part.
#[test]
fn sound_follows_roughness() {
    let track = even_track(300e6);
    let feedback = feedback(Arc::new(even_track(300e6)));
    let source = source(&feedback, RailDecay::Track(&track), 300e6);
    for (quiet, loud) in powers(&source, 0.0).iter().zip(powers(&source, 10.0)) {
        for (quiet, loud) in [(quiet.rail, loud.rail), (quiet.sleepers, loud.sleepers), (quiet.wheel, loud.wheel)] {
            assert!((loud / quiet - 10.0).abs() < 1e-9);
        }
    }
}

/// The decay rates of a track stand for the integral along it: they are that integral, for a force in the middle of the
/// first bay; 2 % of the band mean where the receptance varies over the band.
#[test]
fn decay_rates_stand_for_the_track() {
    let track = even_track(300e6);
    let feedback = feedback(Arc::new(even_track(300e6)));
    let by_track = powers(&source(&feedback, RailDecay::Track(&track), 300e6), 0.0);
    let rates = riffel::receptance::DecayRate::of_track(&track);
    let rates = FrequencyBand::all().zip(rates.iter().map(|rate| rate.decay_rate));
    let by_rates = powers(&source(&feedback, RailDecay::Rates { rates: rates.collect(), track: None }, 300e6), 0.0);
    for (track, rates) in by_track.iter().zip(by_rates) {
        let apart = 10.0 * (rates.rail / track.rail).log10();
        assert!(apart.abs() < 0.6, "{:?}: {apart} dB", track.band);
    }
}

/// Softer pads let the rail vibrate farther, and the sleepers less, at 1 kHz.
#[test]
fn pads_shift_sound_from_sleepers_to_rail() {
    let of = |pad: f64| {
        let track = even_track(pad);
        let feedback = feedback(Arc::new(even_track(pad)));
        let source = source(&feedback, RailDecay::Track(&track), pad);
        source.power(&excitation(0.0), FrequencyBand::new(30)).unwrap().unwrap()
    };
    let (soft, stiff) = (of(100e6), of(800e6));
    assert!(soft.rail > 1.5 * stiff.rail);
    assert!(soft.sleepers < 0.5 * stiff.sleepers);
}

/// Where supports are close together, discrete ones are as good as even ones.
#[test]
fn discrete_supports_close_together_are_even() {
    let spacing = 0.15;
    let share = |layer: f64| Layer::new(layer * spacing / SPACING, 0.0).unwrap();
    let pad = share(300e6).with_loss_factor(0.25).unwrap();
    let ballast = share(50e6).with_loss_factor(1.0).unwrap();
    let support = Support::two_layer(pad, 150.0 * spacing / SPACING, ballast).unwrap();
    let periodic = PeriodicTrack::new(rail(), support, spacing).unwrap();
    let even = even_track(300e6);
    let feedback = feedback(Arc::new(even_track(300e6)));
    let [periodic, even] = [RailDecay::Track(&periodic as &dyn CrossReceptance), RailDecay::Track(&even)]
        .map(|decay| powers(&source(&feedback, decay, 300e6), 0.0));
    for (periodic, even) in periodic.iter().zip(even) {
        // Grids of places reach 10 m here, 40 m there.
        if even.band <= FrequencyBand::new(28) {
            let apart = 10.0 * (periodic.rail / even.rail).log10();
            assert!(apart.abs() < 0.5, "{:?}: {apart} dB", even.band);
        }
    }
}

#[test]
fn bands_without_roughness_or_decay_are_left_out() {
    let feedback = feedback(Arc::new(even_track(300e6)));
    let one = source(&feedback, RailDecay::Rates { rates: vec![(FrequencyBand::new(30), 1.0)], track: None }, 300e6);
    assert_eq!(powers(&one, 0.0).len(), 1);
}
