//! Random tracks are reciprocal, periodic and passive.

use std::sync::Arc;

use proptest::prelude::*;
use riffel::receptance::{
    Beam, ContactPoint, ContinuousTrack, CrossReceptance, PeriodicTrack, RememberingTrack, SpatialRail, SpatialTrack,
    Structure, Support, Supports, TrackMemory, TwistSection,
};
use riffel::{Complex64, Direction, Place, Rail};

use super::{layer, matrix, on_slab, place, places, point, rail, section};

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
        (0.4..1.0, (3e7..2e9, 1e7..2e8, 1e7..2e8), 0.01..0.5, 30.0..200.0, (1e7..3e8, 1e7..3e8, 1e7..3e8), 0.01..2.0),
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
            contact: ContactPoint { lateral_offset: rail.2.0, height: rail.2.1 },
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
    pub(super) fn supports(&self, two_layers: bool) -> Supports {
        let support = |direction: usize| {
            let pad = layer(self.pad[direction], self.pad_loss);
            let ballast = layer(self.ballast[direction], self.ballast_loss);
            if two_layers { Support::two_layer(pad, self.sleeper, ballast).ok() } else { Some(Support::one_layer(pad)) }
        };
        Supports { vertical: support(0), lateral: support(1), longitudinal: support(2) }
    }

    pub(super) fn rail(&self) -> SpatialRail {
        rail(self.section, self.rail_loss)
    }

    fn tracks(&self) -> Vec<SpatialTrack> {
        let mut tracks = vec![SpatialTrack::free(self.rail())];
        for two_layers in [false, true] {
            let supports = self.supports(two_layers);
            tracks.push(SpatialTrack::continuous(self.rail(), supports.per_metre(self.spacing).unwrap()));
            tracks.push(SpatialTrack::discrete(self.rail(), supports, self.spacing).unwrap());
        }
        let contact = |track: SpatialTrack| track.with_contact(Rail::Right, self.contact);
        tracks.into_iter().map(contact).collect()
    }
}

/// The least pivot of a real symmetric matrix, all of whose pivots are positive if the matrix is positive definite.
pub(super) fn least_pivot(mut matrix: Vec<Vec<f64>>) -> f64 {
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

fn bits(numbers: &[Complex64]) -> Vec<[u64; 2]> {
    numbers.iter().map(|number| [number.re.to_bits(), number.im.to_bits()]).collect()
}

proptest! {
    /// A force here moves the rail there as a force there moves it here, whatever their axes; each bay is like the next,
    /// and the matrix is made of its entries. Errors are relative to the point receptances of both places.
    /// What a track remembers of another point of contact is what it answers, to the last bit.
    #[test]
    fn remembers_what_it_answers(random in random()) {
        let w = random.angular_frequency;
        let frequencies = [w, 1.1 * w, 0.7 * w];
        let places: Vec<Place> = Rail::BOTH.into_iter().flat_map(|rail| {
            let places = places(&random.places);
            places.into_iter().map(move |place| Place { rail, ..place })
        }).collect();
        let rolling: Vec<(f64, Rail)> = places.iter().step_by(3).map(|place| (place.along, place.rail)).collect();
        for track in random.tracks() {
            let memory = Arc::new(TrackMemory::default());
            for offset in [0.0, 0.01, 0.0] {
                let point = ContactPoint { lateral_offset: offset, ..random.contact };
                let track = track.with_contact(Rail::Left, point);
                let remembering = RememberingTrack::new(track, memory.clone());
                let size = places.len() * places.len();
                let mut matrices = [(); 2].map(|()| vec![Complex64::ZERO; frequencies.len() * size]);
                track.receptance_matrices(&frequencies, 20.0, &places, &mut matrices[0]);
                remembering.receptance_matrices(&frequencies, 20.0, &places, &mut matrices[1]);
                prop_assert_eq!(bits(&matrices[0]), bits(&matrices[1]));
                let mut rolls = [(); 2].map(|()| vec![Complex64::ZERO; 4 * rolling.len() * rolling.len()]);
                track.roll_matrix(w, 20.0, &rolling, &mut rolls[0]);
                remembering.roll_matrix(w, 20.0, &rolling, &mut rolls[1]);
                prop_assert_eq!(bits(&rolls[0]), bits(&rolls[1]));
                let [at, from] = [places[1], places[5]];
                let [own, other] = [&track as &dyn Structure, &remembering].map(|track| track.cross_receptance(w, 20.0, at, from));
                prop_assert_eq!(bits(&[own]), bits(&[other]));
            }
        }
    }

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
