use super::*;
use crate::fixtures::{layer, sheared as beam, steel};
use crate::receptance::{
    Bar, ContactPoint, EulerBernoulliBeam, FloquetWaves, MovingLoadOnSupports, PeriodicTrack, SpatialRail, Structure,
    Support, Twist, TwistSection,
};
use crate::{Direction, Rail};

const SPACING: f64 = 0.6;

/// 60E1 that bends both ways and twists, on two layers of viscous loss downward and one across.
fn track(twists: bool) -> SpatialTrack {
    track_of(twists, beam(5.127e-6, 2e3))
}

fn track_of(twists: bool, across: Beam) -> SpatialTrack {
    let section = TwistSection {
        torsion_constant: 2.212e-6,
        polar_second_moment: 3.55e-5,
        warping_constant: 2.161e-8,
        centroid_height: 0.033,
        foot_depth: 0.048,
        foot_width: 0.15,
        shear_modulus: 79.6e9,
        density: 7850.0,
    };
    let rail = SpatialRail {
        lateral: Some(across),
        twist: twists.then(|| {
            let twist = Twist::new(steel(), section);
            twist.and_then(|twist| twist.with_loss_factor(0.02)).unwrap()
        }),
        longitudinal: Some(Bar::new(steel(), 7.67e-3, 60.2).unwrap()),
        ..beam(3.04e-5, 3e3).into()
    };
    let down = Support::two_layer(layer(300e6, 40e3), 150.0, layer(80e6, 80e3)).unwrap();
    let sideways = Support::one_layer(layer(40e6, 25e3));
    let supports = Supports { vertical: Some(down), lateral: Some(sideways), longitudinal: Some(sideways) };
    let contact = ContactPoint { height: 0.124, lateral_offset: 0.010 };
    SpatialTrack::discrete(rail, supports, SPACING).unwrap().with_contact(Rail::Right, contact)
}

fn places(along: f64) -> [Place; 3] {
    Direction::ALL.map(|direction| Place { along, rail: Rail::Right, direction })
}

/// Downward it is the moving load of one axis, to the quadratures of both.
#[test]
fn downward_it_is_the_load_of_one_axis() {
    let spatial = track(true);
    let support = spatial.supports().vertical.unwrap();
    let rail = PeriodicTrack::new(spatial.rail().vertical, support, SPACING).unwrap();
    let one = MovingLoadOnSupports::new(&rail, 40.0).unwrap();
    let all = SpatialMovingLoad::new(&spatial, 40.0).unwrap();
    let down = [places(0.0)[2]];
    let without_offset = spatial.with_contact(Rail::Right, ContactPoint::default());
    let middle = SpatialMovingLoad::new(&without_offset, 40.0).unwrap();
    for hertz in [0.0, 60.0, 400.0, 1040.0, 2100.0] {
        let expected = one.harmonics(TAU * hertz, 4).unwrap();
        let got = middle.harmonics(TAU * hertz, &down, 4).unwrap();
        for n in -4..=4 {
            let got = got.at(n).unwrap()[0];
            let difference = (got - expected.at(n)).norm() / expected.at(0).norm();
            assert!(difference < 3e-5, "{hertz} Hz, {n}: {difference:e}");
        }
    }
    // The offset adds the twist.
    let with_offset = all.harmonics(TAU * 400.0, &down, 1).unwrap();
    let without = middle.harmonics(TAU * 400.0, &down, 1).unwrap();
    assert!(with_offset.at(0).unwrap()[0] != without.at(0).unwrap()[0]);
}

/// Loads that hardly move are loads at rest at each place, to the share of |n| > 12, which falls like n⁻² where the rail
/// shears, and along the rail to what even supports miss.
#[test]
fn slow_loads_are_loads_at_rest() {
    for (twists, hertz) in [(false, 150.0), (false, 430.0), (true, 60.0), (true, 900.0)] {
        let track = track(twists);
        let moving = SpatialMovingLoad::new(&track, 0.05).unwrap();
        let both: Vec<Place> = [0.0, -1.3].into_iter().flat_map(places).collect();
        let harmonics = moving.harmonics(TAU * hertz, &both, 12).unwrap();
        let place = 0.13;
        let there = both.iter().map(|at| Place { along: at.along + place, ..*at });
        let there: Vec<Place> = there.collect();
        let mut expected = vec![Complex64::ZERO; 36];
        track.receptance_matrix(TAU * hertz, 0.0, &there, &mut expected);
        let at = |n: isize, entry: usize| harmonics.at(n).unwrap()[entry];
        let sideways = Complex64::new(40e6, TAU * hertz * 25e3);
        for row in 0..6 {
            for column in 0..6 {
                let entry = row * 6 + column;
                let sum: Complex64 =
                    (-12..=12).map(|n| at(n, entry) * Complex64::cis(TAU * n as f64 * place / SPACING)).sum();
                let size = (expected[row * 7].norm() * expected[column * 7].norm()).sqrt();
                let error = (sum - expected[entry]).norm() / size;
                let left = match row % 3 == 0 {
                    true => 3.0 * sideways.norm() * SPACING / (12.0 * 207e9 * 7.67e-3),
                    false => 1e-3 + 30.0 * at(12, entry).norm() / size,
                };
                assert!(error < left, "{twists} {hertz} Hz, {row} {column}: {error:e} {left:e}");
            }
        }
    }
}

/// Ĥ_n(ω) from ξ_b to ξ_a is Ĥ₋ₙ(ω + nΩ) from −ξ_a to −ξ_b.
#[test]
fn reciprocal() {
    let moving = SpatialMovingLoad::new(&track(true), 40.0).unwrap();
    let both: Vec<Place> = [0.0, -2.5].into_iter().flat_map(places).collect();
    let mirrored: Vec<Place> = [0.0, 2.5].into_iter().flat_map(places).collect();
    let passing = TAU * 40.0 / SPACING;
    for hertz in [190.0, 1020.0] {
        let w = TAU * hertz;
        let here = moving.harmonics(w, &both, 2).unwrap();
        for n in -2..=2 {
            let w = w + n as f64 * passing;
            let other = moving.harmonics(w, &mirrored, 2).unwrap();
            let (got, other) = (here.at(n).unwrap(), other.at(-n).unwrap());
            for row in 0..6 {
                for column in 0..6 {
                    // Along the rail nothing moves.
                    if row % 3 == 0 && column % 3 == 0 {
                        continue;
                    }
                    let own = |index: usize| here.at(0).unwrap()[index * 7].norm();
                    let size = (own(row) * own(column)).sqrt();
                    let difference = (got[row * 6 + column] - other[column * 6 + row]).norm();
                    let error = difference / size;
                    assert!(error < 1e-5, "{hertz} {n} {row} {column}: {error:e}");
                }
            }
        }
    }
}

/// The moving load from loads at rest, as in one axis: ∫∫ H(x₀ + ξ_a + Vs, x₀; ω) e^{i(ω − ω')s} ds dω/2π is the answer at a
/// to an impulse at ξ_b = 0, for the head across the track at the wheel and at another one behind it.
// Long: sums 720 000 receptances between loads at rest, the independent side of the comparison.
#[test]
fn moving_loads_from_loads_at_rest() {
    // Without shear H has no kink at the force, and the integral over ω converges fast.
    let bending = EulerBernoulliBeam::new(steel(), 5.127e-6, 60.2).unwrap();
    let bending = Beam::from(bending).with_damping(6e3).unwrap();
    let track = track_of(true, bending);
    let (speed, place, w) = (60.0, 0.17, TAU * 700.0);
    let moving = SpatialMovingLoad::new(&track, speed).unwrap();
    let lateral = |along| places(along)[1];
    let both = [lateral(0.0), lateral(-1.1)];
    let harmonics = moving.answers_to_impulses(w, &both, 12).unwrap();
    let (dw, dt) = (10.0, 5e-4);
    for (to, along) in [(0, 0.0), (1, -1.1)] {
        let expected: Complex64 = (-12..=12)
            .map(|n| {
                let entry = harmonics.at(n).unwrap()[2 * to];
                entry * Complex64::cis(TAU * n as f64 * place / SPACING)
            })
            .sum();
        let mut sum = Complex64::ZERO;
        for i in -200..=200 {
            let shift = f64::from(i) * dw;
            let from = lateral(place);
            let places: Vec<Place> = (-450..=450).map(|j| lateral(place + along + speed * f64::from(j) * dt)).collect();
            for (place, j) in places.iter().zip(-450..) {
                let turn = Complex64::from_polar(dt * dw / TAU, shift * f64::from(j) * dt);
                sum += turn * track.cross_receptance(w + shift, 0.0, *place, from);
            }
        }
        let at_rest = track.cross_receptance(w, 0.0, lateral(place + along), lateral(place));
        let size = track.cross_receptance(w, 0.0, lateral(place), lateral(place)).norm();
        let error = (sum - expected).norm() / size;
        assert!((at_rest - expected).norm() > 0.02 * size);
        assert!(error < 5e-3, "{to}: {error:e}");
    }
}

/// Along the rail places of a bay differ from even supports by some κd/(12EA).
#[test]
fn stretch_hardly_feels_places() {
    let bar = Bar::new(steel(), 7.67e-3, 60.2).unwrap();
    for hertz in [20.0, 300.0, 2500.0] {
        let w = TAU * hertz;
        let stiffness = Support::one_layer(layer(40e6, 25e3)).dynamic_stiffness(w);
        let discrete = FloquetWaves::new(&bar.waves(w, Complex64::ZERO), stiffness, SPACING);
        let even = bar.point_receptance(w, stiffness / SPACING);
        for place in [0.0, 0.15, 0.3] {
            let error = (discrete.receptance(place, place) / even - 1.0).norm();
            let share = (stiffness * SPACING).norm() / (12.0 * 207e9 * 7.67e-3);
            assert!(error < 3.0 * share, "{hertz} Hz {place}: {error:e}");
        }
    }
}

#[test]
fn even_supports_and_supercritical_speeds_are_refused() {
    let track = track(false);
    let even = track.spread(SPACING).unwrap();
    assert!(SpatialMovingLoad::new(&even, 20.0).is_err());
    let fast = SpatialMovingLoad::new(&track, 2e3).unwrap_err();
    assert!(fast.to_string().contains("critical speed"), "{fast}");
}
