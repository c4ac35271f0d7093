//! Every rail on every support.

use std::f64::consts::TAU;

use proptest::prelude::*;
use riffel::receptance::{
    Bar, Beam, ContinuousTrack, CrossReceptance, EulerBernoulliBeam, FreeBeam, Layer, PeriodicTrack, ShearSection,
    Support, Waveguide,
};
use riffel::{Complex64, ElasticMaterial, Receptance};

/// From a light rail on soft pads to a heavy one on stiff ones; loss may be nil.
#[derive(Debug, Clone, Copy)]
struct Track {
    second_moment: f64,
    mass_per_length: f64,
    shear_coefficient: f64,
    loss_factor: f64,
    spacing: f64,
    pad: Layer,
    sleeper: f64,
    ballast: Layer,
    angular_frequency: f64,
    /// Two places along the rail.
    places: (f64, f64),
}

fn layer(stiffness: std::ops::Range<f64>) -> impl Strategy<Value = Layer> {
    (stiffness, 1e3..2e5, 0.0..0.5).prop_map(|(stiffness, damping, loss)| {
        Layer::new(stiffness, damping).and_then(|layer| layer.with_loss_factor(loss)).unwrap()
    })
}

fn track() -> impl Strategy<Value = Track> {
    (
        (3e-6..4e-5, 40.0..75.0, 0.3..0.6, prop_oneof![Just(0.0), 0.001..0.05]),
        (0.5..1.0, layer(3e7..2e9), 30.0..200.0, layer(1e7..3e8)),
        (125.0..31_000.0, (-2.0..3.0, -2.0..3.0)),
    )
        .prop_map(|(rail, support, load)| Track {
            second_moment: rail.0,
            mass_per_length: rail.1,
            shear_coefficient: rail.2,
            loss_factor: rail.3,
            spacing: support.0,
            pad: support.1,
            sleeper: support.2,
            ballast: support.3,
            angular_frequency: load.0,
            places: load.1,
        })
}

impl Track {
    fn steel() -> ElasticMaterial {
        ElasticMaterial::new(210e9, 0.3).unwrap()
    }

    fn bending(&self) -> Beam {
        EulerBernoulliBeam::new(Self::steel(), self.second_moment, self.mass_per_length)
            .map(Beam::from)
            .and_then(|beam| beam.with_loss_factor(self.loss_factor))
            .unwrap()
    }

    fn shearing(&self) -> Beam {
        self.of_area(self.mass_per_length / 7850.0)
    }

    /// A Timoshenko rail of the cross-section A \[m²\], its mass per length that of the track.
    fn of_area(&self, area: f64) -> Beam {
        let shear = ShearSection {
            area,
            shear_coefficient: self.shear_coefficient,
            shear_modulus: 80e9,
            density: self.mass_per_length / area,
        };
        Beam::timoshenko(Self::steel(), self.second_moment, self.mass_per_length, shear)
            .and_then(|beam| beam.with_loss_factor(self.loss_factor))
            .unwrap()
    }

    fn bar(&self) -> Bar {
        Bar::new(Self::steel(), self.mass_per_length / 7850.0, self.mass_per_length)
            .and_then(|bar| bar.with_loss_factor(self.loss_factor))
            .unwrap()
    }

    fn supports(&self) -> [Support; 2] {
        [Support::one_layer(self.pad), Support::two_layer(self.pad, self.sleeper, self.ballast).unwrap()]
    }

    /// A rail on every support, continuous and discrete.
    fn on_every_support<R: Waveguide + Copy + 'static>(&self, rail: R) -> Vec<Box<dyn CrossReceptance>> {
        let mut tracks: Vec<Box<dyn CrossReceptance>> = vec![Box::new(ContinuousTrack::free(rail))];
        for support in self.supports() {
            let spread = support.per_metre(self.spacing).unwrap();
            tracks.push(Box::new(ContinuousTrack::new(rail, spread)));
            let discrete = PeriodicTrack::new(rail, support, self.spacing).unwrap();
            tracks.push(Box::new(discrete.at(self.places.0)));
        }
        tracks
    }

    fn all(&self) -> Vec<Box<dyn CrossReceptance>> {
        let mut tracks = self.on_every_support(self.bending());
        tracks.extend(self.on_every_support(self.shearing()));
        tracks.extend(self.on_every_support(self.bar()));
        tracks
    }
}

fn close(a: Complex64, b: Complex64, tolerance: f64) -> bool {
    (a - b).norm() <= tolerance * b.norm()
}

proptest! {
    /// A force here moves the rail there as a force there moves it here; each bay is like the next.
    /// The distance in bays is rounded alike only when the places are: some roundings times the
    /// phase αx of the wave, up to 1e3.
    #[test]
    fn reciprocal_and_periodic(track in track()) {
        let (w, (a, b)) = (track.angular_frequency, track.places);
        for structure in track.all() {
            let there = structure.cross_receptance(w, a, b);
            prop_assert!(close(structure.cross_receptance(w, b, a), there, 1e-9), "{there}");
            let d = track.spacing;
            prop_assert!(close(structure.cross_receptance(w, a + d, b + d), there, 1e-9), "{there}");
            // Supports are symmetric: mirror the track at one of them.
            prop_assert!(close(structure.cross_receptance(w, -a, -b), there, 1e-9), "{there}");
        }
    }

    /// No place of any track gives energy away. A lossless rail at rest on nothing that moves has
    /// Im H = 0 in a stop band, to rounding.
    #[test]
    fn passive(track in track()) {
        for structure in track.all() {
            let h = structure.receptance(track.angular_frequency, 0.0);
            prop_assert!(h.im <= 1e-12 * h.norm(), "{h}");
            prop_assert!(h.is_finite());
        }
    }

    /// Passive down to 0.01 Hz with and without any loss; rounding alone is left.
    #[test]
    fn passive_at_low_frequency(track in track(), decade in -2.0..2.0f64, lossless in any::<bool>()) {
        let track = if lossless {
            let elastic = |layer: Layer| {
                Layer::new(Support::one_layer(layer).dynamic_stiffness(1.0).re, 0.0).unwrap()
            };
            Track { pad: elastic(track.pad), ballast: elastic(track.ballast), loss_factor: 0.0, ..track }
        } else {
            track
        };
        for structure in track.all() {
            let h = structure.receptance(TAU * 10f64.powf(decade), 0.0);
            prop_assert!(h.im <= 1e-13 * h.norm(), "{h}");
            prop_assert!(h.is_finite());
        }
    }

    /// The receptance under the load is the cross receptance of a place with itself.
    #[test]
    fn point_receptance_is_a_cross_receptance(track in track()) {
        let (w, x) = (track.angular_frequency, track.places.0);
        for structure in track.all() {
            let point = structure.receptance(w, 0.0);
            prop_assert!(close(structure.cross_receptance(w, x, x), point, 1e-9), "{point}");
        }
    }

    /// A stiffness per metre in ever more supports is the continuous track; the difference
    /// falls as the square of the spacing. Loss keeps resonances, where a small shift is a large
    /// difference, away.
    #[test]
    fn ever_closer_supports_are_continuous(track in track()) {
        let w = track.angular_frequency.min(6000.0);
        let lossy = |layer: Layer| layer.with_loss_factor(0.3).unwrap();
        let track = Track { pad: lossy(track.pad), ballast: lossy(track.ballast), ..track };
        let rail = track.shearing().with_loss_factor(0.05).unwrap();
        for support in track.supports() {
            let support = support.per_metre(track.spacing).unwrap();
            let even = ContinuousTrack::new(rail, support).receptance(w, 0.0);
            let errors = [0.02, 0.01].map(|spacing| {
                // Per support what is per metre, times the spacing.
                let share = support.per_metre(1.0 / spacing).unwrap();
                let discrete = PeriodicTrack::new(rail, share, spacing).unwrap();
                (discrete.receptance(w, 0.0) - even).norm() / even.norm()
            });
            prop_assert!(errors[1] < 1e-3, "{errors:?}");
            // A quarter, and rounding.
            prop_assert!(errors[1] < 0.3 * errors[0] + 1e-9, "{errors:?}");
        }
    }

    /// A weak support leaves the free rail, anywhere in the bay.
    #[test]
    fn no_support_is_the_free_rail(track in track()) {
        let w = track.angular_frequency.max(600.0);
        let nearly_nothing = Support::one_layer(Layer::new(1e-3, 0.0).unwrap());
        let rail = track.shearing().with_loss_factor(0.01).unwrap();
        let free = ContinuousTrack::free(rail);
        let discrete = PeriodicTrack::new(rail, nearly_nothing, track.spacing).unwrap();
        let (a, b) = track.places;
        let (h, expected) = (discrete.cross_receptance(w, a, b), free.cross_receptance(w, a, b));
        // 2e-8: the supports take 1e-3 N/m of some 1e8 N/m, and there are some hundred in reach.
        prop_assert!((h - expected).norm() < 2e-8 * free.receptance(w, 0.0).norm(), "{h} {expected}");
    }

    /// A slender rail bends as Euler and Bernoulli say: shear and rotary inertia enter as (αr)²E/κG with
    /// the radius of gyration r² = I/A. A section 10⁸ times as large of the same I and mass leaves some
    /// 1e-8, which a resonance with a loss factor of 1e-3 may enlarge a thousandfold.
    #[test]
    fn slender_timoshenko_is_euler(track in track()) {
        let track = Track { loss_factor: track.loss_factor.max(1e-3), ..track };
        let slender = track.of_area(1e8 * track.mass_per_length / 7850.0);
        let w = track.angular_frequency;
        let pairs = track.on_every_support(slender).into_iter();
        for (shearing, bending) in pairs.zip(track.on_every_support(track.bending())) {
            let (h, expected) = (shearing.receptance(w, 0.0), bending.receptance(w, 0.0));
            prop_assert!(close(h, expected, 1e-4), "{h} {expected}");
        }
    }

    /// The general beam without foundation, shear and loss is equation (23).
    #[test]
    fn free_beam_is_equation_23(track in track()) {
        let rail = EulerBernoulliBeam::new(Track::steel(), track.second_moment, track.mass_per_length).unwrap();
        let w = track.angular_frequency;
        let general = ContinuousTrack::free(Beam::from(rail)).receptance(w, 0.0);
        prop_assert!(close(general, FreeBeam::new(rail).receptance(w, 0.0), 1e-14));
    }

    /// The displacement a wave ahead of the force carries: the sum over the waves is the closed form.
    #[test]
    fn waves_sum_to_the_point_receptance(track in track()) {
        let w = track.angular_frequency;
        for support in track.supports() {
            let even = ContinuousTrack::new(track.shearing(), support.per_metre(0.6).unwrap());
            let sum: Complex64 = even.waves(w).as_slice().iter().map(|wave| wave.amplitude).sum();
            prop_assert!(close(sum, even.receptance(w, 0.0), 1e-9));
        }
    }

    /// Floquet waves decay away from the force.
    #[test]
    fn floquet_waves_decay(track in track()) {
        for support in track.supports() {
            let discrete = PeriodicTrack::new(track.shearing(), support, track.spacing).unwrap();
            let waves = discrete.floquet_waves(track.angular_frequency);
            prop_assert_eq!(waves.multipliers().count(), 2);
            for multiplier in waves.multipliers() {
                prop_assert!(multiplier.norm() <= 1.0 + 1e-12, "{multiplier}");
            }
        }
    }
}

/// A static force on a Winkler beam (1867): H(0) = 1/(2√2 (EI)^{1/4} k^{3/4}) with two springs in
/// series, and on a bar on springs 1/(2√(EA k)).
#[test]
fn static_limits() {
    let (pad, ballast) = (Layer::new(4e8, 9e4).unwrap(), Layer::new(1e8, 9e4).unwrap());
    let support = Support::two_layer(pad, 150.0, ballast).unwrap();
    let rail = EulerBernoulliBeam::new(Track::steel(), 2.35e-5, 56.0).unwrap();
    let winkler = 1.0 / (8f64.sqrt() * (210e9f64 * 2.35e-5).powf(0.25) * 0.8e8f64.powf(0.75));
    let h = ContinuousTrack::new(Beam::from(rail), support).receptance(1e-4, 0.0);
    assert!((h.re / winkler - 1.0).abs() < 1e-9);
    let bar = Bar::new(Track::steel(), 7.1e-3, 56.0).unwrap();
    let h = ContinuousTrack::new(bar, support).receptance(1e-4, 0.0);
    let expected = 0.5 / (210e9f64 * 7.1e-3 * 0.8e8).sqrt();
    assert!((h.re / expected - 1.0).abs() < 1e-9);
}

/// Rail 60E1 on the supports of the book, with loss and without, against the sums over free waves in arithmetic
/// of 60 digits: the errors of the closed form in double precision are those of rounding at every frequency.
#[test]
fn discrete_supports_to_all_digits() {
    let shear = ShearSection { area: 7.67e-3, shear_coefficient: 0.393, shear_modulus: 80.769e9, density: 7850.0 };
    let track = |rail_loss, pad_loss, ballast_loss| {
        let rail = Beam::timoshenko(Track::steel(), 3.0383e-5, 60.21, shear)
            .and_then(|rail| rail.with_loss_factor(rail_loss))
            .unwrap();
        let layer =
            |stiffness, loss| Layer::new(stiffness, 0.0).and_then(|layer| layer.with_loss_factor(loss)).unwrap();
        let support = Support::two_layer(layer(3e8, pad_loss), 162.0, layer(5e7, ballast_loss));
        PeriodicTrack::new(rail, support.unwrap(), 0.6).unwrap()
    };
    let (lossless, lossy) = (track(0.0, 0.0, 0.0), track(0.02, 0.25, 1.0));
    for (track, hertz, place, re, im) in [
        (lossless, 0.01, 0.0, 9.494_530_657_381_507e-9, 0.0),
        (lossless, 0.01, 0.2, 9.799_846_021_742_235e-9, 0.0),
        (lossless, 0.3, 0.0, 9.494_620_289_498_101e-9, 0.0),
        (lossless, 20.0, 0.2, 1.022_095_067_762_959_6e-8, 0.0),
        (lossless, 70.0, 0.0, 2.661_532_235_399_541e-8, 0.0),
        (lossy, 0.01, 0.0, 6.565_788_489_359_175e-9, -3.682_325_886_094_505e-9),
        (lossy, 0.3, 0.2, 6.895_765_761_549_572e-9, -3.622_128_249_429_054_8e-9),
        (lossy, 20.0, 0.0, 6.610_060_501_700_776e-9, -3.902_925_410_913_177e-9),
        (lossy, 70.0, 0.2, 5.970_393_841_894_004e-9, -7.075_484_250_366_051e-9),
        (lossy, 120.0, 0.0, -5.582_538_286_717_421e-10, -5.869_513_919_231_657e-9),
        (lossy, 480.0, 0.2, 2.879_280_738_560_350_3e-9, -4.756_068_748_207_64e-9),
        (lossy, 2000.0, 0.2, -7.847_597_514_761_838e-11, -2.967_256_978_982_218e-10),
    ] {
        let h = track.at(place).receptance(TAU * hertz, 0.0);
        let expected = Complex64::new(re, im);
        let error = (h - expected).norm() / expected.norm();
        assert!(error < 3e-14, "{hertz} Hz at {place} m: {h}, error {error:e}");
    }
}

/// A lossless rail up to 5 kHz, where the second wave of the beam cuts on: finite, passive, and continuous from one frequency to the
/// next, which a wave taken in the wrong direction would not be.
#[test]
fn lossless_rail_stays_well_conditioned() {
    let shear = ShearSection { area: 7.67e-3, shear_coefficient: 0.393, shear_modulus: 80.769e9, density: 7850.0 };
    let rail = Beam::timoshenko(Track::steel(), 3.037e-5, 60.2, shear).unwrap();
    let (pad, ballast) = (Layer::new(2.8e8, 6.3e4).unwrap(), Layer::new(1.8e8, 8.2e4).unwrap());
    let support = Support::two_layer(pad, 110.0, ballast).unwrap();
    let track = PeriodicTrack::new(rail, support, 0.7).unwrap();
    for position in [0.0, 0.2, 0.35] {
        let track = track.at(position);
        let at = |hertz: f64| track.receptance(TAU * hertz, 0.0);
        let mut before = at(5.0);
        let mut hertz = 5.0;
        while hertz < 5e3 {
            hertz *= 1.001;
            let h = at(hertz);
            assert!(h.is_finite() && h.im <= 1e-12 * h.norm(), "{hertz} Hz {h}");
            // Pinned-pinned resonances of a rail without loss are sharp, all others are not.
            let pinned = (1..9).any(|n| {
                let w = rail.pinned_pinned_frequency(0.7, n);
                (hertz * TAU / w - 1.0).abs() < 0.02
            });
            assert!(pinned || (h - before).norm() < 0.05 * before.norm(), "{hertz} Hz {h}");
            before = h;
        }
    }
}
