//! Rails that move along, across and down, on every support.

use std::f64::consts::TAU;

use proptest::prelude::*;
use riffel::receptance::{
    Bar, Beam, ContactPoint, ContinuousTrack, CrossReceptance, EulerBernoulliBeam, Layer,
    PeriodicTrack, ResonanceKind, ShearSection, SpatialRail, SpatialTrack, Structure, Support,
    Supports, Twist, TwistSection,
};
use riffel::{Complex64, Direction, ElasticMaterial, Place, Rail};

const MASS: f64 = 60.2;

fn steel() -> ElasticMaterial {
    ElasticMaterial::new(210e9, 0.3).unwrap()
}

fn beam(second_moment: f64, shear_coefficient: f64, loss_factor: f64) -> Beam {
    let shear = ShearSection {
        area: 7.67e-3,
        shear_coefficient,
        shear_modulus: 80.769e9,
        density: 7850.0,
    };
    Beam::timoshenko(steel(), second_moment, MASS, shear)
        .and_then(|beam| beam.with_loss_factor(loss_factor))
        .unwrap()
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
        twist: Some(
            Twist::new(steel(), section)
                .and_then(|twist| twist.with_loss_factor(loss_factor))
                .unwrap(),
        ),
        longitudinal: Some(
            Bar::new(steel(), 7.67e-3, MASS)
                .and_then(|bar| bar.with_loss_factor(loss_factor))
                .unwrap(),
        ),
    }
}

fn layer(stiffness: f64, loss_factor: f64) -> Layer {
    Layer::new(stiffness, 0.0)
        .and_then(|layer| layer.with_loss_factor(loss_factor))
        .unwrap()
}

/// Pads on a slab, across the track and along it a third as stiff as downward.
fn on_slab(vertical: f64, loss_factor: f64) -> Supports {
    let support = |stiffness| Some(Support::one_layer(layer(stiffness, loss_factor)));
    Supports {
        vertical: support(vertical),
        lateral: support(vertical / 3.0),
        longitudinal: support(vertical / 3.0),
    }
}

fn place(along: f64, direction: Direction) -> Place {
    Place {
        along,
        rail: Rail::Right,
        direction,
    }
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

/// From a light rail on soft pads to a heavy one on stiff ones; loss may be nil, the foot or the centroid at the shear
/// centre, and warping left out.
#[derive(Debug, Clone, Copy)]
struct Random {
    section: TwistSection,
    contact: ContactPoint,
    rail_loss: f64,
    spacing: f64,
    pad: [f64; 3],
    pad_loss: f64,
    sleeper: f64,
    ballast: [f64; 3],
    ballast_loss: f64,
    angular_frequency: f64,
    places: [f64; 2],
}

fn random() -> impl Strategy<Value = Random> {
    let length = |range: std::ops::Range<f64>| prop_oneof![Just(0.0), range];
    (
        (
            (1e-6..4e-6, 2e-5..5e-5, prop_oneof![Just(0.0), 1e-9..5e-8]),
            (length(0.02..0.05), length(0.02..0.08), 0.1..0.16),
            (-0.03..0.03, 0.08..0.14),
            prop_oneof![Just(0.0), 0.001..0.05],
        ),
        (
            0.4..1.0,
            (3e7..2e9, 1e7..2e8, 1e7..2e8),
            0.01..0.5,
            30.0..200.0,
            (1e7..3e8, 1e7..3e8, 1e7..3e8),
            0.01..2.0,
        ),
        (125.0..31_000.0, (-2.0..3.0, -2.0..3.0)),
    )
        .prop_map(|(rail, support, load)| Random {
            section: TwistSection {
                torsion_constant: rail.0.0,
                polar_second_moment: rail.0.1,
                warping_constant: rail.0.2,
                centroid_height: rail.1.0,
                foot_depth: rail.1.1,
                foot_width: rail.1.2,
                ..section()
            },
            contact: ContactPoint {
                lateral_offset: rail.2.0,
                height: rail.2.1,
            },
            rail_loss: rail.3,
            spacing: support.0,
            pad: support.1.into(),
            pad_loss: support.2,
            sleeper: support.3,
            ballast: support.4.into(),
            ballast_loss: support.5,
            angular_frequency: load.0,
            places: load.1.into(),
        })
}

impl Random {
    fn supports(&self, two_layers: bool) -> Supports {
        let support = |direction: usize| {
            let pad = layer(self.pad[direction], self.pad_loss);
            let ballast = layer(self.ballast[direction], self.ballast_loss);
            if two_layers {
                Support::two_layer(pad, self.sleeper, ballast).ok()
            } else {
                Some(Support::one_layer(pad))
            }
        };
        Supports {
            vertical: support(0),
            lateral: support(1),
            longitudinal: support(2),
        }
    }

    fn rail(&self) -> SpatialRail {
        rail(self.section, self.rail_loss)
    }

    fn tracks(&self) -> Vec<SpatialTrack> {
        let mut tracks = vec![SpatialTrack::free(self.rail())];
        for two_layers in [false, true] {
            let supports = self.supports(two_layers);
            tracks.push(SpatialTrack::continuous(
                self.rail(),
                supports.per_metre(self.spacing).unwrap(),
            ));
            tracks.push(SpatialTrack::discrete(self.rail(), supports, self.spacing).unwrap());
        }
        let contact = |track: SpatialTrack| track.with_contact(Rail::Right, self.contact);
        tracks.into_iter().map(contact).collect()
    }
}

/// The least pivot of a real symmetric matrix, all of whose pivots are positive if the matrix is positive definite.
fn least_pivot(mut matrix: Vec<Vec<f64>>) -> f64 {
    let count = matrix.len();
    let mut least = f64::INFINITY;
    for pivot in 0..count {
        let (above, below) = matrix.split_at_mut(pivot + 1);
        let above = &above[pivot];
        least = least.min(above[pivot]);
        for row in below {
            let factor = row[pivot] / above[pivot];
            for (entry, pivot) in row.iter_mut().zip(above) {
                *entry -= factor * pivot;
            }
        }
    }
    least
}

proptest! {
    /// A force here moves the rail there as a force there moves it here, whatever their axes; each bay is like the next,
    /// and the matrix is made of its entries. Errors are relative to the point receptances of both places.
    #[test]
    fn reciprocal_and_periodic(random in random()) {
        let (w, [a, b]) = (random.angular_frequency, random.places);
        for track in random.tracks() {
            let places = places(&[a, b]);
            let entries = matrix(&track, w, &places);
            let own = |index: usize| entries[7 * index].norm();
            for (row, &at) in places.iter().enumerate() {
                for (column, &from) in places.iter().enumerate() {
                    let tolerance = 1e-11 * (own(row) * own(column)).sqrt();
                    let entry = entries[6 * row + column];
                    let is = |other: Complex64| (other - entry).norm() <= tolerance;
                    prop_assert!(is(track.cross_receptance(w, 0.0, at, from)));
                    prop_assert!(is(track.cross_receptance(w, 0.0, from, at)));
                    let next = |place: Place| Place { along: place.along + random.spacing, ..place };
                    prop_assert!(is(track.cross_receptance(w, 0.0, next(at), next(from))));
                    // Supports are symmetric: mirror the track at one of them.
                    let mirrored = |place: Place| Place { along: -place.along, ..place };
                    prop_assert!(is(track.cross_receptance(w, 0.0, mirrored(at), mirrored(from))));
                    let other = Place { rail: Rail::Left, ..from };
                    prop_assert_eq!(track.cross_receptance(w, 0.0, at, other), Complex64::ZERO);
                }
            }
        }
    }

    /// No pattern of forces at two contacts takes energy out of the track: −Im H is positive semidefinite, here by its
    /// pivots after a rounding is added to each port in units of its own receptance.
    #[test]
    fn passive(random in random()) {
        let w = random.angular_frequency;
        for track in random.tracks() {
            let places = places(&random.places);
            let entries = matrix(&track, w, &places);
            let scaled = |row: usize, column: usize| {
                let scale = (entries[7 * row].norm() * entries[7 * column].norm()).sqrt();
                -entries[6 * row + column].im / scale + if row == column { 1e-10 } else { 0.0 }
            };
            let scaled = (0..6).map(|row| (0..6).map(|column| scaled(row, column)).collect());
            let least = least_pivot(scaled.collect());
            prop_assert!(least > 0.0, "{least}");
        }
    }

    /// Without twist, and on the two axes that do not feel it, the track is those of one axis, bit for bit at one place.
    #[test]
    fn single_axes_are_the_tracks_of_one_axis(random in random()) {
        let (w, [a, b]) = (random.angular_frequency, random.places);
        let bending = SpatialRail { twist: None, ..random.rail() };
        let supports = random.supports(true);
        let spread = supports.per_metre(random.spacing).unwrap();
        for is_discrete in [false, true] {
            let axis = |rail: Beam, discrete: Option<Support>, even: Option<Support>| -> Box<dyn CrossReceptance> {
                if is_discrete {
                    Box::new(PeriodicTrack::new(rail, discrete.unwrap(), random.spacing).unwrap().at(a))
                } else {
                    Box::new(ContinuousTrack::new(rail, even.unwrap()))
                }
            };
            let lateral = axis(bending.lateral.unwrap(), supports.lateral, spread.lateral);
            let vertical = axis(bending.vertical, supports.vertical, spread.vertical);
            let track = if is_discrete {
                SpatialTrack::discrete(bending, supports, random.spacing).unwrap()
            } else {
                SpatialTrack::continuous(bending, spread)
            };
            let track = track.with_contact(Rail::Right, random.contact);
            for (direction, axis) in [(Direction::Lateral, lateral), (Direction::Vertical, vertical)] {
                let between = |at, from| track.cross_receptance(w, 0.0, place(at, direction), place(from, direction));
                prop_assert_eq!(between(a, a), axis.receptance(w, 0.0));
                prop_assert_eq!(between(b, a), axis.cross_receptance(w, a, b));
            }
            prop_assert_eq!(point(&track, w)[1][2], Complex64::ZERO);
        }
    }

    /// A rail that cannot twist bends alone: of GJ → ∞ what is left of the twist is 1e-6 of its compliance.
    #[test]
    fn rigid_in_torsion_is_the_beam(random in random()) {
        let w = random.angular_frequency;
        let stiff = TwistSection {
            torsion_constant: 1e14 * random.section.torsion_constant,
            warping_constant: 0.0,
            centroid_height: 0.0,
            ..random.section
        };
        let supports = random.supports(true).per_metre(random.spacing).unwrap();
        let twisting = SpatialTrack::continuous(rail(stiff, random.rail_loss), supports)
            .with_contact(Rail::Right, random.contact);
        let bending = SpatialRail { twist: None, ..random.rail() };
        let bending = SpatialTrack::continuous(bending, supports);
        let (got, expected) = (point(&twisting, w), point(&bending, w));
        for axis in 0..3 {
            let (got, expected) = (got[axis][axis], expected[axis][axis]);
            prop_assert!((got - expected).norm() < 1e-5 * expected.norm(), "{got} {expected}");
        }
    }

    /// Supports close together are spread evenly: the distance goes with the square of the spacing, in units of the
    /// length over which the stiffest pads hold a shaft, 60 mm.
    #[test]
    fn fine_spacing_is_continuous(random in random()) {
        let w = random.angular_frequency.min(6000.0);
        let random = Random { pad_loss: 0.3, ballast_loss: 0.3, rail_loss: 0.05, ..random };
        for two_layers in [false, true] {
            let spread = random.supports(two_layers).per_metre(random.spacing).unwrap();
            let contact = |track: SpatialTrack| track.with_contact(Rail::Right, random.contact);
            let even = point(&contact(SpatialTrack::continuous(random.rail(), spread)), w);
            let errors = [0.02, 0.01].map(|spacing| {
                let share = spread.per_metre(1.0 / spacing).unwrap();
                let discrete = SpatialTrack::discrete(random.rail(), share, spacing).unwrap();
                let discrete = point(&contact(discrete), w);
                let mut largest = 0f64;
                for (row, (discrete, even_row)) in discrete.iter().zip(&even).enumerate() {
                    for (column, (discrete, entry)) in discrete.iter().zip(even_row).enumerate() {
                        let scale = (even[row][row].norm() * even[column][column].norm()).sqrt();
                        largest = largest.max((discrete - entry).norm() / scale);
                    }
                }
                largest
            });
            prop_assert!(errors[1] < 5e-3, "{errors:?}");
            // A quarter, and rounding.
            prop_assert!(errors[1] < 0.3 * errors[0] + 1e-9, "{errors:?}");
        }
    }

    /// Weak supports leave the free rail, anywhere in the bay: they take 1e-3 N/m of some 1e7 N/m, and there are some
    /// hundred in reach.
    #[test]
    fn no_support_is_the_free_rail(random in random()) {
        let w = random.angular_frequency.max(600.0);
        let rail = rail(random.section, 0.01);
        let contact = |track: SpatialTrack| track.with_contact(Rail::Right, random.contact);
        let free = contact(SpatialTrack::free(rail));
        let weak = contact(SpatialTrack::discrete(rail, on_slab(1e-3, 0.1), random.spacing).unwrap());
        let places = places(&random.places);
        let (got, expected) = (matrix(&weak, w, &places), matrix(&free, w, &places));
        for row in 0..6 {
            for column in 0..6 {
                let scale = (expected[7 * row].norm() * expected[7 * column].norm()).sqrt();
                let (got, expected) = (got[6 * row + column], expected[6 * row + column]);
                prop_assert!((got - expected).norm() < 2e-7 * scale, "{got} {expected}");
            }
        }
    }

    /// A contact at another point of the section: the receptances of v and θ taken from three points give those of a
    /// fourth.
    #[test]
    fn contacts_move_with_the_section(random in random()) {
        let w = random.angular_frequency;
        for track in random.tracks() {
            let at = |height, lateral_offset| {
                let contact = ContactPoint { height, lateral_offset };
                point(&track.with_contact(Rail::Right, contact), w)
            };
            let ContactPoint { height: h, lateral_offset: e } = random.contact;
            let (middle, above, beside) = (at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0));
            let (v, w) = (middle[1][1], middle[2][2]);
            let twist = beside[2][2] - w;
            let mixed = beside[1][2];
            let scale = v.norm() + twist.norm() * h * h;
            let close = |a: Complex64, b: Complex64| (a - b).norm() <= 1e-12 * (scale + w.norm() + twist.norm());
            prop_assert!(close(above[1][1], v + 2.0 * mixed + twist));
            let moved = at(h, e);
            prop_assert!(close(moved[1][1], v + 2.0 * h * mixed + h * h * twist));
            prop_assert!(close(moved[2][2], w + e * e * twist));
            prop_assert!(close(moved[1][2], e * (mixed + h * twist)));
            prop_assert_eq!(moved[0][0], middle[0][0]);
            prop_assert_eq!((moved[0][1], moved[2][0]), (Complex64::ZERO, Complex64::ZERO));
        }
    }
}

/// UIC60 on pads of 120 and 40 MN/m every 0.6 m, spread evenly, without sleepers: receptance of the running surface 91 mm
/// above the centroid, and of its twist, with warping and without, computed independently from the stiffness
/// matrix of a section with its shear centre below its centroid; four digits, phases to 0.1°.
#[test]
fn rail_head_on_even_pads() {
    let supports = on_slab(120e6, 0.2).per_metre(0.6).unwrap();
    let track = |warping_constant: f64| {
        let section = TwistSection {
            warping_constant,
            ..section()
        };
        let contact = ContactPoint {
            height: 0.091 + section.centroid_height,
            lateral_offset: 0.01,
        };
        SpatialTrack::continuous(rail(section, 0.02), supports).with_contact(Rail::Right, contact)
    };
    let close = |got: Complex64, (size, degrees): (f64, f64), hertz: f64| {
        // Half of the last digit, with a rounding of the parameters.
        assert!(
            (got.norm() / size - 1.0).abs() < 6e-4,
            "{hertz} Hz: {got:e}"
        );
        let turn = (got / Complex64::from_polar(size, degrees.to_radians())).arg();
        assert!(turn.to_degrees().abs() < 0.11, "{hertz} Hz: {got:e}");
    };
    for (hertz, without, with, mixed) in [
        (
            100.0,
            (1.585e-7, -43.9),
            (1.527e-7, -45.3),
            (6.993e-9, -42.9),
        ),
        (
            200.0,
            (2.768e-8, -110.1),
            (2.818e-8, -120.2),
            (1.011e-9, -72.3),
        ),
        (
            300.0,
            (1.768e-8, -84.3),
            (1.582e-8, -100.5),
            (1.681e-9, -54.4),
        ),
        (
            500.0,
            (1.058e-8, -94.1),
            (8.779e-9, -118.8),
            (8.255e-10, -85.5),
        ),
        (
            1000.0,
            (5.095e-9, -92.5),
            (3.198e-9, -125.6),
            (3.898e-10, -88.0),
        ),
        (
            1500.0,
            (3.379e-9, -91.8),
            (1.756e-9, -127.4),
            (2.589e-10, -88.7),
        ),
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
    let supports = Supports {
        lateral: Some(ballast),
        ..on_slab
    };
    let found = named(SpatialTrack::continuous(
        rail,
        supports.per_metre(0.6).unwrap(),
    ));
    let kinds: Vec<ResonanceKind> = found.iter().map(|&(kind, _)| kind).collect();
    assert_eq!(
        kinds,
        [
            ResonanceKind::LateralCutOn,
            ResonanceKind::LateralCutOn,
            ResonanceKind::RollCutOn
        ]
    );
    assert!(named(SpatialTrack::free(rail)).is_empty());
}

/// The undamped rail answers without bound at each cut-on of its waves, on one layer and on two: a millionth above, its
/// waves are 1e-3/m long or longer.
#[test]
fn cut_on_frequencies_are_peaks() {
    let ballast = Support::two_layer(layer(40e6, 0.0), 150.0, layer(35e6, 0.0)).unwrap();
    let one = on_slab(120e6, 0.0);
    let two = Supports {
        lateral: Some(ballast),
        ..one
    };
    for supports in [one, two] {
        let supports = supports.per_metre(0.6).unwrap();
        let track = SpatialTrack::continuous(rail(section(), 0.0), supports);
        let track = track.with_contact(
            Rail::Right,
            ContactPoint {
                height: 0.124,
                lateral_offset: 0.0,
            },
        );
        for (kind, w) in track.lateral_resonances() {
            let near = point(&track, w * (1.0 + 1e-8))[1][1].norm();
            let beside = point(&track, w * (1.0 + 1e-2))[1][1].norm();
            assert!(
                near > 100.0 * beside,
                "{kind} {} Hz: {near:e} {beside:e}",
                w / TAU
            );
        }
    }
}

/// Supports without loss, ten thousand times as stiff across as downward: roundings of the stiff one are not taken for
/// a loss of the soft one, which would turn waves round.
#[test]
fn stiff_supports_across_do_not_turn_waves_round() {
    let rail = rail(section(), 0.0);
    let supports = Supports {
        lateral: Some(Support::one_layer(layer(5e10, 0.0))),
        ..on_slab(5e6, 0.0)
    };
    for track in [
        SpatialTrack::continuous(rail, supports.per_metre(0.6).unwrap()),
        SpatialTrack::discrete(rail, supports, 0.6).unwrap(),
    ] {
        let track = track.with_contact(
            Rail::Right,
            ContactPoint {
                height: 0.124,
                lateral_offset: 0.0,
            },
        );
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
    let held_down = Supports {
        lateral: None,
        ..supports
    };
    let error = sentence(SpatialTrack::discrete(rail, held_down, 0.6).unwrap_err());
    assert!(
        error.contains("lateral stiffness of the supports"),
        "{error}"
    );
    let thin = TwistSection {
        warping_constant: 1e-14,
        ..section()
    };
    let thin = SpatialRail {
        twist: Some(Twist::new(steel(), thin).unwrap()),
        ..rail
    };
    let error = sentence(SpatialTrack::discrete(thin, supports, 0.6).unwrap_err());
    assert!(error.contains("warping constant"), "{error}");
    for (name, wrong) in [
        (
            "torsion constant",
            TwistSection {
                torsion_constant: 0.0,
                ..section()
            },
        ),
        (
            "polar second moment",
            TwistSection {
                polar_second_moment: -1.0,
                ..section()
            },
        ),
        (
            "warping constant",
            TwistSection {
                warping_constant: -1.0,
                ..section()
            },
        ),
        (
            "foot width",
            TwistSection {
                foot_width: 0.0,
                ..section()
            },
        ),
        (
            "foot depth",
            TwistSection {
                foot_depth: f64::NAN,
                ..section()
            },
        ),
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
    let contact = ContactPoint {
        height: 0.124,
        lateral_offset: 0.01,
    };
    let tracks = |loss_factor: f64| -> Vec<SpatialTrack> {
        let rail = rail(section(), loss_factor);
        let one = on_slab(120e6, loss_factor);
        let on_ballast = |pad, ballast| {
            Support::two_layer(layer(pad, loss_factor), 150.0, layer(ballast, loss_factor)).ok()
        };
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
