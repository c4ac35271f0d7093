//! Rails that move along, across and down, on every support.

mod reciprocity;

use std::f64::consts::TAU;

use riffel::receptance::{
    Bar, Beam, ContactPoint, EulerBernoulliBeam, Layer, ResonanceKind, ShearSection, SpatialRail, SpatialTrack,
    Structure, Support, Supports, Twist, TwistSection,
};
use riffel::{Complex64, Direction, ElasticMaterial, Place, Rail};

use reciprocity::least_pivot;

const MASS: f64 = 60.2;

fn steel() -> ElasticMaterial {
    ElasticMaterial::new(210e9, 0.3).unwrap()
}

fn beam(second_moment: f64, shear_coefficient: f64, loss_factor: f64) -> Beam {
    let shear = ShearSection { area: 7.67e-3, shear_coefficient, shear_modulus: 80.769e9, density: 7850.0 };
    Beam::timoshenko(steel(), second_moment, MASS, shear).and_then(|beam| beam.with_loss_factor(loss_factor)).unwrap()
}

/// UIC60 of Kostovasilis, Thompson & Hussein (2017), without loss.
fn section() -> TwistSection {
    TwistSection {
        torsion_constant: 2.212e-6,
        polar_second_moment: 3.55e-5,
        warping_constant: 2.161e-8,
        centroid_height: 0.033,
        foot_depth: 0.048,
        foot_width: 0.15,
        shear_modulus: 80.769e9,
        density: 7850.0,
    }
}

fn rail(section: TwistSection, loss_factor: f64) -> SpatialRail {
    SpatialRail {
        vertical: beam(3.037e-5, 0.393, loss_factor),
        lateral: Some(beam(5.127e-6, 0.538, loss_factor)),
        twist: Some(Twist::new(steel(), section).and_then(|twist| twist.with_loss_factor(loss_factor)).unwrap()),
        longitudinal: Some(Bar::new(steel(), 7.67e-3, MASS).and_then(|bar| bar.with_loss_factor(loss_factor)).unwrap()),
    }
}

fn layer(stiffness: f64, loss_factor: f64) -> Layer {
    Layer::new(stiffness, 0.0).and_then(|layer| layer.with_loss_factor(loss_factor)).unwrap()
}

/// Pads on a slab, across the track and along it a third as stiff as downward.
fn on_slab(vertical: f64, loss_factor: f64) -> Supports {
    let support = |stiffness| Some(Support::one_layer(layer(stiffness, loss_factor)));
    Supports { vertical: support(vertical), lateral: support(vertical / 3.0), longitudinal: support(vertical / 3.0) }
}

fn place(along: f64, direction: Direction) -> Place {
    Place { along, rail: Rail::Right, direction }
}

fn places(alongs: &[f64]) -> Vec<Place> {
    let axes = |&along: &f64| Direction::ALL.map(|direction| place(along, direction));
    alongs.iter().flat_map(axes).collect()
}

fn matrix(track: &SpatialTrack, w: f64, places: &[Place]) -> Vec<Complex64> {
    let mut matrix = vec![Complex64::ZERO; places.len() * places.len()];
    track.receptance_matrix(w, 0.0, places, &mut matrix);
    matrix
}

fn point(track: &SpatialTrack, w: f64) -> [[Complex64; 3]; 3] {
    let entries = matrix(track, w, &places(&[0.0]));
    std::array::from_fn(|row| std::array::from_fn(|column| entries[3 * row + column]))
}

/// UIC60 on pads of 120 and 40 MN/m every 0.6 m, spread evenly, without sleepers: receptance of the running surface 91 mm
/// above the centroid, and of its twist, with warping and without, computed independently from the stiffness
/// matrix of a section with its shear centre below its centroid; four digits, phases to 0.1°.
#[test]
fn rail_head_on_even_pads() {
    let supports = on_slab(120e6, 0.2).per_metre(0.6).unwrap();
    let track = |warping_constant: f64| {
        let section = TwistSection { warping_constant, ..section() };
        let contact = ContactPoint { height: 0.091 + section.centroid_height, lateral_offset: 0.01 };
        SpatialTrack::continuous(rail(section, 0.02), supports).with_contact(Rail::Right, contact)
    };
    let close = |got: Complex64, (size, degrees): (f64, f64), hertz: f64| {
        // Half of the last digit, with a rounding of the parameters.
        assert!((got.norm() / size - 1.0).abs() < 6e-4, "{hertz} Hz: {got:e}");
        let turn = (got / Complex64::from_polar(size, degrees.to_radians())).arg();
        assert!(turn.to_degrees().abs() < 0.11, "{hertz} Hz: {got:e}");
    };
    for (hertz, without, with, mixed) in [
        (100.0, (1.585e-7, -43.9), (1.527e-7, -45.3), (6.993e-9, -42.9)),
        (200.0, (2.768e-8, -110.1), (2.818e-8, -120.2), (1.011e-9, -72.3)),
        (300.0, (1.768e-8, -84.3), (1.582e-8, -100.5), (1.681e-9, -54.4)),
        (500.0, (1.058e-8, -94.1), (8.779e-9, -118.8), (8.255e-10, -85.5)),
        (1000.0, (5.095e-9, -92.5), (3.198e-9, -125.6), (3.898e-10, -88.0)),
        (1500.0, (3.379e-9, -91.8), (1.756e-9, -127.4), (2.589e-10, -88.7)),
    ] {
        let w = TAU * hertz;
        let matrix = point(&track(0.0), w);
        close(matrix[1][1], without, hertz);
        close(matrix[1][2], mixed, hertz);
        close(point(&track(2.161e-8), w)[1][1], with, hertz);
    }
}

/// Named frequencies of UIC60 with its mass at the centroid: cut-on on even pads, and pinned-pinned at 0.6 m.
#[test]
fn lateral_resonances_have_names() {
    let on_slab = on_slab(120e6, 0.2);
    let named = |track: SpatialTrack| -> Vec<(ResonanceKind, f64)> {
        let found = track.lateral_resonances().into_iter();
        found.map(|(kind, w)| (kind, w / TAU)).collect()
    };
    let rail = rail(section(), 0.02);
    let found = named(SpatialTrack::discrete(rail, on_slab, 0.6).unwrap());
    for ((kind, hertz), (expected_kind, expected)) in found.iter().zip([
        (ResonanceKind::LateralCutOn, 102.3),
        (ResonanceKind::RollCutOn, 302.4),
        (ResonanceKind::LateralPinnedPinned, 555.0),
    ]) {
        assert_eq!(*kind, expected_kind);
        assert!((hertz - expected).abs() < 0.05, "{kind} {hertz}");
    }
    let vertical = rail.vertical.pinned_pinned_frequency(0.6, 1) / TAU;
    assert!((vertical - 1063.6).abs() < 0.05, "{vertical}");
    let slender = EulerBernoulliBeam::new(steel(), 5.127e-6, MASS).unwrap();
    let slender = Beam::from(slender).pinned_pinned_frequency(0.6, 1) / TAU;
    assert!((slender - 583.5).abs() < 0.05, "{slender}");

    // On sleepers the rail moves with them and against them.
    let ballast = Support::two_layer(layer(40e6, 0.2), 150.0, layer(35e6, 1.0)).unwrap();
    let supports = Supports { lateral: Some(ballast), ..on_slab };
    let found = named(SpatialTrack::continuous(rail, supports.per_metre(0.6).unwrap()));
    let kinds: Vec<ResonanceKind> = found.iter().map(|&(kind, _)| kind).collect();
    assert_eq!(kinds, [ResonanceKind::LateralCutOn, ResonanceKind::LateralCutOn, ResonanceKind::RollCutOn]);
    assert!(named(SpatialTrack::free(rail)).is_empty());
}

/// The undamped rail answers without bound at each cut-on of its waves, on one layer and on two: a millionth above, its
/// waves are 1e-3/m long or longer.
#[test]
fn cut_on_frequencies_are_peaks() {
    let ballast = Support::two_layer(layer(40e6, 0.0), 150.0, layer(35e6, 0.0)).unwrap();
    let one = on_slab(120e6, 0.0);
    let two = Supports { lateral: Some(ballast), ..one };
    for supports in [one, two] {
        let supports = supports.per_metre(0.6).unwrap();
        let track = SpatialTrack::continuous(rail(section(), 0.0), supports);
        let track = track.with_contact(Rail::Right, ContactPoint { height: 0.124, lateral_offset: 0.0 });
        for (kind, w) in track.lateral_resonances() {
            let near = point(&track, w * (1.0 + 1e-8))[1][1].norm();
            let beside = point(&track, w * (1.0 + 1e-2))[1][1].norm();
            assert!(near > 100.0 * beside, "{kind} {} Hz: {near:e} {beside:e}", w / TAU);
        }
    }
}

/// Supports without loss, ten thousand times as stiff across as downward: roundings of the stiff one are not taken for
/// a loss of the soft one, which would turn waves round.
#[test]
fn stiff_supports_across_do_not_turn_waves_round() {
    let rail = rail(section(), 0.0);
    let supports = Supports { lateral: Some(Support::one_layer(layer(5e10, 0.0))), ..on_slab(5e6, 0.0) };
    for track in [
        SpatialTrack::continuous(rail, supports.per_metre(0.6).unwrap()),
        SpatialTrack::discrete(rail, supports, 0.6).unwrap(),
    ] {
        let track = track.with_contact(Rail::Right, ContactPoint { height: 0.124, lateral_offset: 0.0 });
        for hertz in 5..2000 {
            let h = point(&track, TAU * f64::from(hertz))[1][1];
            assert!(h.im <= 1e-9 * h.norm(), "{hertz} Hz: {h:e}");
        }
    }
}

/// Bad input is refused in a sentence.
#[test]
fn refuses_what_is_no_track() {
    let rail = rail(section(), 0.0);
    let supports = on_slab(120e6, 0.2);
    assert!(SpatialTrack::discrete(rail, supports, 0.0).is_err());
    let sentence = |error: riffel::Error| error.to_string();
    let held_down = Supports { lateral: None, ..supports };
    let error = sentence(SpatialTrack::discrete(rail, held_down, 0.6).unwrap_err());
    assert!(error.contains("lateral stiffness of the supports"), "{error}");
    let thin = TwistSection { warping_constant: 1e-14, ..section() };
    let thin = SpatialRail { twist: Some(Twist::new(steel(), thin).unwrap()), ..rail };
    let error = sentence(SpatialTrack::discrete(thin, supports, 0.6).unwrap_err());
    assert!(error.contains("warping constant"), "{error}");
    for (name, wrong) in [
        ("torsion constant", TwistSection { torsion_constant: 0.0, ..section() }),
        ("polar second moment", TwistSection { polar_second_moment: -1.0, ..section() }),
        ("warping constant", TwistSection { warping_constant: -1.0, ..section() }),
        ("foot width", TwistSection { foot_width: 0.0, ..section() }),
        ("foot depth", TwistSection { foot_depth: f64::NAN, ..section() }),
    ] {
        let error = sentence(Twist::new(steel(), wrong).unwrap_err());
        assert!(error.contains(name), "{error}");
    }
}

/// A track without any loss, free, on even and on discrete supports, up to 5 kHz: its waves carry energy away from the
/// force, and are the limit of those of a vanishing loss. A loss factor of 1e-9 moves the receptance by 1e-9 times the
/// sharpness of what is near: by more than 1e-5 only within 1e-4 of a band edge or a pinned-pinned frequency.
#[test]
fn lossless_waves_leave_the_force() {
    let contact = ContactPoint { height: 0.124, lateral_offset: 0.01 };
    let tracks = |loss_factor: f64| -> Vec<SpatialTrack> {
        let rail = rail(section(), loss_factor);
        let one = on_slab(120e6, loss_factor);
        let on_ballast =
            |pad, ballast| Support::two_layer(layer(pad, loss_factor), 150.0, layer(ballast, loss_factor)).ok();
        let two = Supports {
            vertical: on_ballast(120e6, 50e6),
            lateral: on_ballast(40e6, 35e6),
            longitudinal: on_ballast(40e6, 35e6),
        };
        let mut tracks = vec![SpatialTrack::free(rail)];
        for supports in [one, two] {
            let spread = supports.per_metre(0.6).unwrap();
            tracks.push(SpatialTrack::continuous(rail, spread));
            tracks.push(SpatialTrack::discrete(rail, supports, 0.6).unwrap());
        }
        let touched = |track: SpatialTrack| track.with_contact(Rail::Right, contact);
        tracks.into_iter().map(touched).collect()
    };
    let (mut points, mut moved) = (0, 0);
    for (track, lossy) in tracks(0.0).iter().zip(&tracks(1e-9)) {
        let mut hertz = 5.0;
        while hertz < 5e3 {
            hertz *= 1.001;
            let places = places(&[0.1, 1.5]);
            let h = matrix(track, TAU * hertz, &places);
            let with_loss = matrix(lossy, TAU * hertz, &places);
            let scaled = |row: usize, column: usize| {
                let scale = (h[7 * row].norm() * h[7 * column].norm()).sqrt();
                -h[6 * row + column].im / scale + if row == column { 1e-9 } else { 0.0 }
            };
            let scaled = (0..6).map(|row| (0..6).map(|column| scaled(row, column)).collect());
            let least = least_pivot(scaled.collect());
            assert!(least > 0.0, "{hertz} Hz: {least:e}");
            points += 1;
            let largest = |row: usize| h[7 * row].norm();
            let differ = (0..36).any(|index| {
                let scale = (largest(index / 6) * largest(index % 6)).sqrt();
                (h[index] - with_loss[index]).norm() > 1e-5 * scale
            });
            moved += usize::from(differ);
        }
    }
    assert!(1000 * moved < points, "{moved} of {points}");
}
