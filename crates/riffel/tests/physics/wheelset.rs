//! Wheelsets: rigid, elastic, and what they must have in common.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use proptest::prelude::*;
use riffel::receptance::{MeasuredReceptance, Structure};
use riffel::wheelset::{
    Axle, ContactGeometry, ContactReceptances, CoupledInertia, Disc, ElasticMode, FlexibleWheelset,
    MeasuredEntry, MeasuredWheelset, ModalWheelset, ModeName, NaturalMode, Port, RigidBody,
    RigidMotion, RigidWheelset, Segment, Suspension, Wheelset, passivity_error, reciprocity_error,
};
use riffel::{Complex64, Direction, ElasticMaterial, Place, Rail};

const DENSITY: f64 = 7850.0;
const CONTACTS: ContactGeometry = ContactGeometry {
    contact_spacing: 1.5,
    rolling_radius: 0.46,
};

fn steel(youngs_modulus: f64) -> ElasticMaterial {
    ElasticMaterial::new(youngs_modulus, 0.3).unwrap()
}

fn disc(position: f64, mass: f64, polar_inertia: f64, diametral_inertia: f64) -> Disc {
    Disc {
        position,
        mass,
        polar_inertia,
        diametral_inertia,
        coupled: None,
    }
}

fn uniform(youngs_modulus: f64, diameter: f64, length: f64) -> Axle {
    let segment = Segment { length, diameter };
    Axle::new(steel(youngs_modulus), DENSITY, vec![segment])
        .and_then(|axle| axle.with_shear_coefficient(0.9))
        .unwrap()
}

/// Two wheels over the contacts and axle boxes at the ends of an axle of 2 m.
fn wheels_and_boxes(wheel: [f64; 3], axle_box: f64) -> Vec<Disc> {
    let [mass, polar, diametral] = wheel;
    [-0.75, 0.75]
        .map(|place| disc(place, mass, polar, diametral))
        .into_iter()
        .chain([-1.0, 1.0].map(|place| disc(place, axle_box, 0.0, 0.0)))
        .collect()
}

fn hertz(modes: &[NaturalMode], wanted: impl Fn(&ModeName) -> bool) -> Vec<f64> {
    let modes = modes.iter().filter(|mode| wanted(&mode.name));
    modes.map(|mode| mode.angular_frequency / TAU).collect()
}

/// Seven wheelsets against finite elements, to the digits of that table. Of its brake discs and gear it gives mass and
/// polar inertia; half of that is the diametral one of a thin disc.
#[test]
fn natural_frequencies_of_seven_wheelsets() {
    const WHEEL: [f64; 3] = [350.0, 27.77, 14.5];
    let brakes = |mass: f64, polar: f64, places: &[f64]| -> Vec<Disc> {
        let brake = |&place: &f64| disc(place, mass, polar, 0.5 * polar);
        places.iter().map(brake).collect()
    };
    type Row<'a> = (f64, [f64; 3], f64, Vec<Disc>, &'a [f64], &'a [f64]);
    let rows: [Row; 7] = [
        (
            0.16,
            WHEEL,
            0.0,
            vec![],
            &[97.2, 203.4, 414.1, 859.0],
            &[78.6, 1067.5],
        ),
        (
            0.16,
            WHEEL,
            80.0,
            vec![],
            &[86.4, 188.6, 406.0, 699.0],
            &[78.6, 1067.5],
        ),
        (
            0.15,
            [300.0, 21.0, 11.0],
            60.0,
            vec![],
            &[85.0, 187.3, 391.0],
            &[79.4, 1067.6],
        ),
        (
            0.16,
            WHEEL,
            80.0,
            brakes(100.0, 4.5, &[0.0, -0.35, 0.35]),
            &[71.1, 171.3, 306.9],
            &[77.2, 227.3, 395.0, 522.0],
        ),
        (
            0.16,
            WHEEL,
            80.0,
            brakes(110.0, 5.5, &[-0.35, 0.35]),
            &[75.6, 171.7, 339.8],
            &[76.9, 261.1, 360.0],
        ),
        (
            0.16,
            WHEEL,
            80.0,
            brakes(150.0, 12.0, &[0.4]),
            &[78.8, 178.4, 342.0],
            &[76.4, 225.9, 1395.0],
        ),
        (
            0.18,
            [400.0, 35.0, 18.5],
            100.0,
            vec![],
            &[97.0, 212.3, 454.0],
            &[88.5, 1069.0],
        ),
    ];
    for (diameter, wheel, axle_box, brakes, bending, torsion) in rows {
        let mut discs = wheels_and_boxes(wheel, axle_box);
        discs.extend(brakes);
        let wheelset =
            FlexibleWheelset::new(uniform(207e9, diameter, 2.0), discs, CONTACTS).unwrap();
        let modes = wheelset.natural_modes(TAU * 2000.0).unwrap();
        let bent = hertz(&modes, |name| matches!(name, ModeName::Bending { .. }));
        for (index, (got, expected)) in bent.iter().zip(bending).enumerate() {
            // Those of the table are of one program, its elements 25 mm long: they tell on the higher modes.
            let tolerance = if index < 2 { 1e-3 } else { 5e-3 };
            assert_relative_eq!(*got, *expected, max_relative = tolerance);
        }
        let twisted = hertz(&modes, |name| matches!(name, ModeName::Torsion { .. }));
        for (got, expected) in twisted.iter().zip(torsion) {
            assert_relative_eq!(*got, *expected, max_relative = 1e-3);
        }
    }
}

/// Discs between the wheels bring a torsion of their own, and nothing else does below 1 kHz.
#[test]
fn torsion_of_discs_against_wheels_is_named() {
    let names = |discs: Vec<Disc>| -> Vec<String> {
        let wheelset = FlexibleWheelset::new(uniform(207e9, 0.16, 2.0), discs, CONTACTS).unwrap();
        let modes = wheelset.natural_modes(TAU * 500.0).unwrap();
        modes.iter().map(|mode| mode.name.to_string()).collect()
    };
    let plain = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    assert_eq!(
        names(plain.clone()),
        [
            "first torsion",
            "first symmetric bending",
            "first antisymmetric bending",
            "second symmetric bending",
        ]
    );
    let brakes = [-0.35, 0.35].map(|place| disc(place, 110.0, 5.5, 2.75));
    assert_eq!(
        names([plain, brakes.to_vec()].concat()),
        [
            "first symmetric bending",
            "first torsion",
            "first antisymmetric bending",
            "second torsion (discs against wheels)",
            "second symmetric bending",
            "third torsion (discs against each other)",
        ]
    );
}

/// Two wheels at the ends of a shaft: antisymmetric torsion κ tan κ = ρJs/I, symmetric tan κ = −(I/ρJs)κ, κ = ωs/c.
/// To the accuracy of the frequencies; 78.75 and 1067.39 Hz.
#[test]
fn torsion_of_two_wheels_on_a_shaft() {
    let (half, inertia, diameter) = (0.75, 27.77, 0.16);
    let wheels = [-half, half].map(|place| disc(place, 350.0, inertia, 14.5));
    let axle = uniform(207e9, diameter, 2.0 * half);
    let wheelset = FlexibleWheelset::new(axle, wheels.to_vec(), CONTACTS).unwrap();
    let modes = wheelset.natural_modes(TAU * 6000.0).unwrap();
    let twisted = hertz(&modes, |name| matches!(name, ModeName::Torsion { .. }));
    assert!((twisted[0] - 78.75).abs() < 0.005, "{}", twisted[0]);
    assert!((twisted[1] - 1067.39).abs() < 0.005, "{}", twisted[1]);

    let ratio = DENSITY * PI * diameter.powi(4) / 32.0 * half / inertia;
    let speed = (steel(207e9).shear_modulus() / DENSITY).sqrt();
    for (index, got) in twisted.iter().enumerate() {
        let phase = TAU * got * half / speed;
        // Near their roots these change as κ does, or faster.
        let (error, slope) = if index % 2 == 0 {
            let tangent = phase.tan();
            (
                phase * tangent - ratio,
                tangent + phase * (1.0 + tangent * tangent),
            )
        } else {
            let tangent = phase.tan();
            (
                tangent + phase / ratio,
                1.0 + tangent * tangent + ratio.recip(),
            )
        };
        assert!((error / slope / phase).abs() < 1e-9, "{index}: {error}");
    }
    assert_eq!(twisted.len(), 6);
}

/// Point receptances of the second of the seven wheelsets at its right contact, loss factor 0.01, to the accuracy of the
/// finite elements they come from. Their axle does not stretch, which leaves yy out.
#[test]
fn point_receptances_of_a_wheelset_with_axle_boxes() {
    let axle = uniform(207e9, 0.16, 2.0).with_loss_factor(0.01).unwrap();
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    let wheelset = FlexibleWheelset::new(axle, discs, CONTACTS).unwrap();
    // Real parts of xx, zz, zy.
    let rows = [
        (50.0, 3e-4, [-2.859e-8, -1.670e-8, 5.375e-9]),
        (100.0, 3e-4, [-3.848e-8, -4.019e-9, 2.939e-9]),
        (150.0, 5e-4, [-1.157e-8, -1.497e-9, 2.409e-9]),
        (200.0, 2e-3, [-7.130e-9, -1.934e-9, -4.469e-9]),
        (500.0, 2e-3, [-9.783e-10, -2.083e-10, -3.295e-10]),
    ];
    for (frequency, tolerance, expected) in rows {
        let h = wheelset.receptances(TAU * frequency);
        let got = [h[3][3].re, h[5][5].re, h[5][4].re];
        for (got, expected) in got.into_iter().zip(expected) {
            assert_relative_eq!(got, expected, max_relative = tolerance);
        }
    }
}

/// The first case of those with a suspension in the loop of one rigid wheelset, 200 Hz, a contact angle of 5°: track axes
/// from contact axes, to the digits given.
#[test]
fn rigid_wheelset_on_its_suspension() {
    let body = RigidBody {
        mass: 1100.0,
        roll_inertia: 620.0,
        spin_inertia: 85.0,
    };
    let suspension = Suspension::new([12e6, 6e6, 1.1e6], [8e3, 5e3, 20e3], 2.0).unwrap();
    let wheelset = RigidWheelset::new(body, CONTACTS)
        .unwrap()
        .with_suspension(suspension);
    let h = wheelset.receptances(1256.6370614359173);
    let (sine, cosine) = 5f64.to_radians().sin_cos();
    let axes = [[1.0, 0.0, 0.0], [0.0, cosine, -sine], [0.0, sine, cosine]];
    let expected = [
        [
            (-2.7488163937221852e-09, -1.9244127462272765e-11),
            (0.0, 0.0),
            (0.0, 0.0),
        ],
        [
            (0.0, 0.0),
            (-8.595603881383616e-10, -1.8721178687399376e-11),
            (3.7766891062940137e-10, 2.0532174385233848e-11),
        ],
        [
            (0.0, 0.0),
            (3.7766891062940137e-10, 2.0532174385233848e-11),
            (-1.0863777009320146e-09, -4.2856278692880904e-11),
        ],
    ];
    for (row, expected) in axes.iter().zip(expected) {
        for (column, (re, im)) in axes.iter().zip(expected) {
            let mut got = Complex64::ZERO;
            for i in 0..3 {
                for j in 0..3 {
                    got += row[i] * h[3 + i][3 + j] * column[j];
                }
            }
            let expected = Complex64::new(re, im);
            assert!(
                (got - expected).norm() < 1e-14 * h[3][3].norm(),
                "{got} {expected}"
            );
        }
    }
}

/// Free and rigid: −(1/ω²)(1/M ± s²/J) and what goes with it.
#[test]
fn rigid_wheelset_without_suspension() {
    let body = RigidBody {
        mass: 1100.0,
        roll_inertia: 620.0,
        spin_inertia: 85.0,
    };
    let h = RigidWheelset::new(body, CONTACTS)
        .unwrap()
        .receptances(100.0);
    let (s, radius, w2) = (0.75, 0.46, 1e4);
    let expect = |got: Complex64, expected: f64| {
        assert_relative_eq!(got.re, expected / w2, max_relative = 1e-14);
        assert_eq!(got.im, 0.0);
    };
    let roll = s * s / 620.0;
    let spin = radius * radius / 85.0;
    expect(h[5][5], -1.0 / 1100.0 - roll);
    expect(h[5][2], -1.0 / 1100.0 + roll);
    expect(h[3][3], -1.0 / 1100.0 - roll - spin);
    expect(h[3][0], -1.0 / 1100.0 + roll - spin);
    expect(h[4][1], -1.0 / 1100.0 - radius * radius / 620.0);
    expect(h[5][4], radius * s / 620.0);
    expect(h[2][1], -radius * s / 620.0);
}

#[derive(Debug, Clone)]
struct Built {
    segments: Vec<Segment>,
    discs: Vec<Disc>,
    youngs_modulus: f64,
    loss_factor: f64,
    suspension: Option<Suspension>,
}

impl Built {
    fn wheelset(&self) -> FlexibleWheelset {
        let axle = Axle::new(steel(self.youngs_modulus), DENSITY, self.segments.clone())
            .and_then(|axle| axle.with_loss_factor(self.loss_factor))
            .unwrap();
        let free = FlexibleWheelset::new(axle, self.discs.clone(), CONTACTS).unwrap();
        match self.suspension {
            Some(suspension) => free.with_suspension(suspension).unwrap(),
            None => free,
        }
    }

    /// The same, left and right exchanged.
    fn mirrored(&self) -> Self {
        let mut mirrored = self.clone();
        mirrored.segments.reverse();
        for disc in &mut mirrored.discs {
            disc.position = -disc.position;
        }
        mirrored
    }

    /// The left half of it, and its mirror image on the right.
    fn symmetric(&self) -> Self {
        let mut symmetric = self.clone();
        symmetric.segments.extend(self.mirrored().segments);
        let length: f64 = symmetric
            .segments
            .iter()
            .map(|segment| segment.length)
            .sum();
        for segment in &mut symmetric.segments {
            segment.length *= 2.2 / length;
        }
        symmetric.discs.extend(self.mirrored().discs);
        symmetric
    }
}

fn a_disc() -> impl Strategy<Value = Disc> {
    let coupled =
        (0.1..30.0f64, 1e4..1e8f64, 0.0..1e4f64).prop_map(|(inertia, stiffness, damping)| {
            CoupledInertia {
                polar_inertia: inertia,
                stiffness,
                damping,
            }
        });
    (
        (-1.0..1.0f64, 0.0..400.0f64),
        (0.0..40.0f64, 0.0..20.0f64),
        prop::option::weighted(0.3, coupled),
    )
        .prop_map(
            |((position, mass), (polar_inertia, diametral_inertia), coupled)| Disc {
                position,
                mass,
                polar_inertia,
                diametral_inertia,
                coupled,
            },
        )
}

/// From a plain thin axle to a stepped thick one; loss may be nil.
fn built() -> impl Strategy<Value = Built> {
    let segment =
        (0.02..1.0f64, 0.1..0.3f64).prop_map(|(length, diameter)| Segment { length, diameter });
    let suspension = (
        prop::array::uniform3(0.0..2e7f64),
        prop::array::uniform3(0.0..3e4f64),
        1.0..2.2f64,
    )
        .prop_map(|(stiffness, damping, spacing)| {
            Suspension::new(stiffness, damping, spacing).unwrap()
        });
    (
        prop::collection::vec(segment, 1..7),
        prop::collection::vec(a_disc(), 0..5),
        prop_oneof![Just(0.0), 1e-3..0.02f64],
        prop::option::of(suspension),
    )
        .prop_map(|(mut segments, mut discs, loss_factor, suspension)| {
            let length: f64 = segments.iter().map(|segment| segment.length).sum();
            for segment in &mut segments {
                segment.length *= 2.2 / length;
            }
            discs.extend([-0.75, 0.75].map(|place| disc(place, 330.0, 38.0, 20.0)));
            Built {
                segments,
                discs,
                youngs_modulus: 207e9,
                loss_factor,
                suspension,
            }
        })
}

/// √(H_ii H_jj) \[m/N\].
fn size(h: &ContactReceptances, i: usize, j: usize) -> f64 {
    (h[i][i] * h[j][j]).norm().sqrt()
}

proptest! {
    /// Nothing comes out that did not go in, whatever sits on the axle. Rounding of the largest entry.
    #[test]
    fn flexible_wheelsets_are_passive(built in built(), frequency in 1.0..6000.0f64) {
        let h = built.wheelset().receptances(TAU * frequency);
        let (error, port) = passivity_error(&h);
        prop_assert!(error < 1e-11, "{error} {port:?}");
    }

    /// The mirror image of a wheelset answers as the wheelset in a mirror, though it is computed from the other end: what
    /// goes from left to right goes from right to left. Off resonances without loss to 1e-8.
    #[test]
    fn flexible_wheelsets_are_reciprocal(built in built(), frequency in 1.0..6000.0f64) {
        let w = TAU * frequency;
        let built = Built { loss_factor: built.loss_factor.max(1e-3), ..built };
        let (h, image) = (built.wheelset().receptances(w), built.mirrored().wheelset().receptances(w));
        prop_assert_eq!(reciprocity_error(&h).0, 0.0);
        let sign = |port: usize| if port % 3 == 1 { -1.0 } else { 1.0 };
        for i in 0..6 {
            for j in 0..6 {
                let expected = sign(i) * sign(j) * image[(i + 3) % 6][(j + 3) % 6];
                prop_assert!((h[i][j] - expected).norm() <= 1e-8 * size(&h, i, j), "{} {}", h[i][j], expected);
            }
        }
    }

    /// On an axle symmetric about its middle loads alike on both sides excite only motion alike on both sides, and opposite
    /// ones only opposite motion: x and z equal with y opposite, or the other way round.
    #[test]
    fn symmetric_axles_keep_symmetry(built in built(), frequency in 1.0..6000.0f64) {
        let built = Built { loss_factor: built.loss_factor.max(1e-3), ..built.symmetric() };
        let h = built.wheelset().receptances(TAU * frequency);
        for from in 0..3 {
            for at in 0..3 {
                let sign = if (at == 1) == (from == 1) { 1.0 } else { -1.0 };
                // Both wheels of a pattern of loads move as its mirror image does.
                prop_assert!((h[at][from] - sign * h[at + 3][from + 3]).norm() <= 1e-8 * size(&h, at, from));
                prop_assert!((h[at][from + 3] - sign * h[at + 3][from]).norm() <= 1e-8 * size(&h, at, from));
            }
        }
    }

    /// An axle that hardly gives is a rigid body. The elastic part left is 1e-5 at 500 Hz.
    #[test]
    fn stiff_axles_are_rigid(built in built(), frequency in 1.0..500.0f64) {
        let mut built = Built { youngs_modulus: 207e16, loss_factor: 0.0, ..built.symmetric() };
        for segment in &mut built.segments {
            segment.diameter = segment.diameter.max(0.15);
        }
        for disc in &mut built.discs {
            disc.coupled = None;
        }
        let flexible = built.wheelset();
        let free = RigidWheelset::new(flexible.rigid_body(), CONTACTS).unwrap();
        let rigid = match built.suspension {
            Some(suspension) => free.with_suspension(suspension),
            None => free,
        };
        let w = TAU * frequency;
        let (got, expected) = (flexible.receptances(w), rigid.receptances(w));
        // On a suspension an entry may pass through zero.
        let free = free.receptances(w);
        for i in 0..6 {
            for j in 0..6 {
                let size = size(&free, i, j).max(size(&expected, i, j));
                prop_assert!(
                    (got[i][j] - expected[i][j]).norm() <= 1e-4 * size,
                    "{i} {j}: {} {}", got[i][j], expected[i][j]
                );
            }
        }
    }

    /// Where an axle is cut makes no difference, to 20 kHz.
    #[test]
    fn cuts_do_not_matter(built in built(), frequency in 1.0..20_000.0f64, cuts in 2..9usize) {
        let built = Built { loss_factor: built.loss_factor.max(1e-3), ..built };
        let mut cut = built.clone();
        cut.segments = built.segments.iter()
            .flat_map(|segment| {
                let piece = Segment { length: segment.length / cuts as f64, ..*segment };
                std::iter::repeat_n(piece, cuts)
            })
            .collect();
        let w = TAU * frequency;
        let (got, expected) = (cut.wheelset().receptances(w), built.wheelset().receptances(w));
        for i in 0..6 {
            for j in 0..6 {
                prop_assert!((got[i][j] - expected[i][j]).norm() <= 1e-8 * size(&expected, i, j));
            }
        }
    }

    /// Near a natural frequency without loss (ω_n² − ω²)H is the product of the mode's displacements at the contacts, of a
    /// generalised mass of 1 kg. The rest of the receptance tells by the distance, 1e-5, over that of the next mode; a mode
    /// that hardly moves the contacts leaves nothing but that, 1e-8 of a wheelset of a kilogram.
    #[test]
    fn modes_are_those_of_the_receptances(built in built()) {
        let built = Built { loss_factor: 0.0, suspension: None, ..built };
        let discs = built.discs.iter().map(|disc| Disc { coupled: None, ..*disc }).collect();
        let wheelset = Built { discs, ..built }.wheelset();
        // Neighbours of the last one are known too.
        let (highest, beyond) = (TAU * 1500.0, TAU * 1600.0);
        let modes = wheelset.natural_modes(beyond).unwrap();
        let frequencies: Vec<f64> = modes.iter().map(|mode| mode.angular_frequency).collect();
        for mode in modes.iter().filter(|mode| mode.angular_frequency < highest) {
            let natural = mode.angular_frequency;
            let apart = frequencies.iter()
                .filter(|&&other| other != natural)
                .map(|other| (other / natural - 1.0).abs())
                .fold(1.0, f64::min);
            if apart < 1e-2 {
                continue;
            }
            let shape: Vec<f64> = [-0.75, 0.75].into_iter()
                .flat_map(|place| mode.motion_at(place).below(0.46))
                .collect();
            let [below, above] = [1.0 - 1e-5, 1.0 + 1e-5].map(|factor| {
                let w = natural * factor;
                let detuning = natural * natural - w * w;
                wheelset.receptances(w).map(|row| row.map(|h| detuning * h.re))
            });
            for i in 0..6 {
                for j in 0..6 {
                    // Horizontal bending is the same mode again, and torsion and stretch are in one plane of the contact only.
                    if (i % 3 == 0) != (j % 3 == 0) || (i % 3 == 0 && mode.multiplicity() == 2) {
                        continue;
                    }
                    let residue = 0.5 * (below[i][j] + above[i][j]);
                    let scale = shape.iter().map(|phi| phi * phi).sum::<f64>();
                    prop_assert!(
                        (residue - shape[i] * shape[j]).abs() <= 1e-4 * scale + 1e-8,
                        "{} {i} {j}: {residue} {}", mode.name, shape[i] * shape[j]
                    );
                }
            }
        }
    }
}

/// A stiff frame and a soft suspension: five motions of the rigid wheelset at the frequencies of its springs, each with its
/// name. The axle gives way by less than 1 %.
#[test]
fn motions_on_the_suspension_are_named() {
    let (stiffness, spacing) = ([3e6, 2e6, 1e6], 2.0);
    let suspension = Suspension::new(stiffness, [1e3; 3], spacing).unwrap();
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    let wheelset = FlexibleWheelset::new(uniform(207e9, 0.16, 2.0), discs, CONTACTS)
        .and_then(|wheelset| wheelset.with_suspension(suspension))
        .unwrap();
    let body = wheelset.rigid_body();
    let modes = wheelset.natural_modes(TAU * 60.0).unwrap();
    let expected = |motion| match motion {
        RigidMotion::Longitudinal => 2.0 * stiffness[0] / body.mass,
        RigidMotion::Lateral => 2.0 * stiffness[1] / body.mass,
        RigidMotion::Bounce => 2.0 * stiffness[2] / body.mass,
        RigidMotion::Roll => 2.0 * stiffness[2] / body.roll_inertia,
        RigidMotion::Yaw => 2.0 * stiffness[0] / body.roll_inertia,
    };
    let mut motions = Vec::new();
    for mode in &modes {
        let ModeName::RigidBody(motion) = mode.name else {
            panic!("{}", mode.name);
        };
        assert_relative_eq!(
            mode.angular_frequency.powi(2),
            expected(motion),
            max_relative = 0.05
        );
        motions.push(motion.to_string());
    }
    motions.sort();
    assert_eq!(
        motions,
        ["bounce", "lateral", "longitudinal", "roll", "yaw"]
    );
}

/// Wheelsets at two places do not feel each other, and answer alike.
#[test]
fn wheelsets_stand_alone() {
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    let wheelset = FlexibleWheelset::new(uniform(207e9, 0.16, 2.0), discs, CONTACTS).unwrap();
    let place = |along, rail| Place {
        along,
        rail,
        direction: Direction::Vertical,
    };
    let h = wheelset.receptances(500.0);
    let cross = |at, from| wheelset.cross_receptance(500.0, 30.0, at, from);
    for along in [0.0, -2.5] {
        assert_eq!(
            cross(place(along, Rail::Left), place(along, Rail::Right)),
            h[2][5]
        );
    }
    assert_eq!(
        cross(place(0.0, Rail::Left), place(-2.5, Rail::Left)),
        Complex64::ZERO
    );
    // All places at once.
    let places: Vec<Place> = [0.0, -2.5]
        .into_iter()
        .flat_map(|along| [place(along, Rail::Left), place(along, Rail::Right)])
        .collect();
    let mut matrix = [Complex64::ZERO; 16];
    wheelset.receptance_matrix(500.0, 30.0, &places, &mut matrix);
    for (i, &at) in places.iter().enumerate() {
        for (j, &from) in places.iter().enumerate() {
            assert_eq!(matrix[4 * i + j], cross(at, from));
        }
    }
    assert_eq!(Port::new(Rail::Right, Direction::Vertical).index(), 5);
    for (index, port) in Port::ALL.into_iter().enumerate() {
        assert_eq!(port.index(), index);
    }
}

#[test]
fn refuses_what_is_no_wheelset() {
    let axle = || uniform(207e9, 0.16, 1.6);
    let wheels = || {
        [-0.75, 0.75]
            .map(|place| disc(place, 350.0, 27.77, 14.5))
            .to_vec()
    };
    let message = |discs: Vec<Disc>, contacts| {
        FlexibleWheelset::new(axle(), discs, contacts)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        message(vec![disc(0.9, 80.0, 0.0, 0.0)], CONTACTS),
        "position of a disc is 0.9 m, but must lie on the axle, at most half its length from its middle"
    );
    let wide = ContactGeometry {
        contact_spacing: 1.7,
        ..CONTACTS
    };
    assert_eq!(
        message(wheels(), wide),
        "contact spacing is 1.7 m, but must not exceed the length of the axle"
    );
    let negative = Disc {
        mass: -1.0,
        ..wheels()[0]
    };
    assert_eq!(
        message(vec![negative], CONTACTS),
        "mass of a disc is -1 kg, but must be finite and not negative"
    );
    let wheelset = FlexibleWheelset::new(axle(), wheels(), CONTACTS).unwrap();
    let far = Suspension::new([1e6; 3], [0.0; 3], 2.0).unwrap();
    assert!(wheelset.clone().with_suspension(far).is_err());
    assert!(wheelset.natural_modes(TAU * 20e3).is_err());
    assert!(wheelset.natural_modes(f64::NAN).is_err());
    assert!(Axle::new(steel(207e9), DENSITY, vec![]).is_err());
    assert!(axle().with_shear_coefficient(1.2).is_err());
}

/// A uniform axle with two wheels and boxes at its ends, without loss.
fn plain() -> FlexibleWheelset {
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    FlexibleWheelset::new(uniform(207e9, 0.16, 2.0), discs, CONTACTS).unwrap()
}

/// The modes of a flexible wheelset up to a frequency \[Hz\] as those of a finite-element model, shapes multiplied by a
/// factor.
fn elastic_modes(wheelset: &FlexibleWheelset, highest: f64, factor: f64) -> Vec<ElasticMode> {
    let mut modes = Vec::new();
    for mode in wheelset.natural_modes(TAU * highest).unwrap() {
        let motions = [-0.75, 0.75].map(|place| mode.motion_at(place));
        let shape: Vec<f64> = motions
            .iter()
            .flat_map(|motion| motion.below(0.46))
            .collect();
        let elastic = ElasticMode {
            angular_frequency: mode.angular_frequency,
            damping_ratio: 0.0,
            generalised_mass: factor * factor,
            shape: std::array::from_fn(|port| factor * shape[port]),
        };
        modes.push(elastic);
        if mode.multiplicity() == 2 {
            // The horizontal plane, where what was u_z is u_x.
            let [left, right] = motions.map(|motion| factor * motion.displacement[2]);
            modes.push(ElasticMode {
                shape: [left, 0.0, 0.0, right, 0.0, 0.0],
                ..elastic
            });
        }
    }
    modes
}

/// All modes to 2 kHz and the residual of the others at 50 Hz give the exact receptances to 2e-4 of the largest one below
/// 700 Hz: the residual grows by (f/f_n)² on the way to the first mode left out, at 2.5 kHz.
#[test]
fn modes_and_residual_are_the_flexible_wheelset() {
    let exact = plain();
    let rigid = RigidWheelset::new(exact.rigid_body(), CONTACTS).unwrap();
    for factor in [1.0, 30.0] {
        let modes = elastic_modes(&exact, 2000.0, factor);
        let modal = ModalWheelset::new(Some(rigid), modes).unwrap();
        let w = TAU * 50.0;
        let (whole, known) = (exact.receptances(w), modal.receptances(w));
        let residual =
            std::array::from_fn(|i| std::array::from_fn(|j| (whole[i][j] - known[i][j]).re));
        let modal = modal.with_residual(residual).unwrap();
        for frequency in [5.0, 60.0, 100.0, 150.0, 230.0, 300.0, 500.0, 700.0] {
            let w = TAU * frequency;
            let (got, expected) = (modal.receptances(w), exact.receptances(w));
            let largest = expected
                .iter()
                .flatten()
                .map(|h| h.norm())
                .fold(0.0, f64::max);
            for i in 0..6 {
                for j in 0..6 {
                    let error = (got[i][j] - expected[i][j]).norm() / largest;
                    assert!(error < 2e-4, "{frequency} {i} {j}: {error:e}");
                }
            }
        }
    }
}

proptest! {
    /// A sum of modes is reciprocal and passive.
    #[test]
    fn modal_wheelsets_are_passive(
        modes in prop::collection::vec(
            (10.0..2e4f64, 0.0..0.1f64, prop::array::uniform6(-0.1..0.1f64)), 0..8,
        ),
        w in 10.0..2e4f64,
    ) {
        let modes = modes.into_iter().map(|(angular_frequency, damping_ratio, shape)| ElasticMode {
            angular_frequency, damping_ratio, generalised_mass: 1.0, shape,
        });
        let h = ModalWheelset::new(None, modes.collect()).unwrap().receptances(w);
        prop_assert_eq!(reciprocity_error(&h).0, 0.0);
        prop_assert!(passivity_error(&h).0 < 1e-14);
    }
}

/// Resonance of one mode: H = φ²/(2iζω_n²).
#[test]
fn a_mode_resonates_by_its_damping() {
    let mode = ElasticMode {
        angular_frequency: 500.0,
        damping_ratio: 0.01,
        generalised_mass: 4.0,
        shape: [0.0, 0.0, 0.2, 0.0, 0.0, -0.1],
    };
    let h = ModalWheelset::new(None, vec![mode])
        .unwrap()
        .receptances(500.0);
    let expected = 0.2 * -0.1 / (4.0 * 2.0 * 0.01 * 500.0 * 500.0);
    assert_relative_eq!(h[2][5].im, -expected, max_relative = 1e-14);
    assert!(h[2][5].re.abs() < 1e-14 * expected.abs());
}

#[test]
fn refuses_modes_that_are_not_normalised() {
    let mode = ElasticMode {
        angular_frequency: 500.0,
        damping_ratio: 0.01,
        generalised_mass: 1.0,
        shape: [0.0, 0.0, 0.04, 0.0, 0.0, 0.04],
    };
    let rigid = RigidWheelset::new(plain().rigid_body(), CONTACTS).unwrap();
    let message = |wrong: ElasticMode| {
        let error = ModalWheelset::new(Some(rigid), vec![mode, wrong]).unwrap_err();
        error.to_string()
    };
    assert!(ModalWheelset::new(Some(rigid), vec![mode]).is_ok());
    // The greatest displacement is one.
    let shape = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
    assert_eq!(
        message(ElasticMode { shape, ..mode }),
        "a mode moves a contact as less than a 500th of the wheelset's mass would: give its generalised mass, or a \
         shape in 1/√kg (value number 2)"
    );
    let told = ElasticMode {
        shape,
        generalised_mass: 600.0,
        ..mode
    };
    assert!(ModalWheelset::new(Some(rigid), vec![told]).is_ok());
    for wrong in [
        ElasticMode {
            angular_frequency: 0.0,
            ..mode
        },
        ElasticMode {
            damping_ratio: 1.0,
            ..mode
        },
        ElasticMode {
            damping_ratio: f64::NAN,
            ..mode
        },
        ElasticMode {
            generalised_mass: 0.0,
            ..mode
        },
        ElasticMode {
            shape: [f64::INFINITY; 6],
            ..mode
        },
    ] {
        assert!(message(wrong).ends_with("(value number 2)"));
    }
    let modal = ModalWheelset::new(Some(rigid), vec![mode]).unwrap();
    let mut residual = [[0.0; 6]; 6];
    residual[2][5] = 1e-10;
    assert!(modal.clone().with_residual(residual).is_err());
    residual[5][2] = 1e-10;
    assert!(modal.with_residual(residual).is_ok());
}

/// A flexible wheelset as a measurement of it: on its lines the same, elsewhere near, outside not a number.
#[test]
fn measured_wheelset_is_what_was_measured() {
    let axle = uniform(207e9, 0.16, 2.0).with_loss_factor(0.05).unwrap();
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    let source = FlexibleWheelset::new(axle, discs, CONTACTS).unwrap();
    let lines: Vec<f64> = (0..200).map(|line| 100.0 * 1.02f64.powi(line)).collect();
    let table = |i: usize, j: usize, sign: f64| {
        let values = lines.iter().map(|&w| sign * source.receptances(w)[i][j]);
        MeasuredReceptance::new(&lines, values.collect()).unwrap()
    };
    let entry = |i: usize, j: usize, sign: f64| MeasuredEntry {
        at: Port::ALL[i],
        from: Port::ALL[j],
        receptance: table(i, j, sign),
    };
    // The right wheel whole, and one entry across; zy given one way only.
    let entries = || {
        vec![
            entry(3, 3, 1.0),
            entry(4, 4, 1.0),
            entry(5, 5, 1.0),
            entry(5, 4, 1.0),
            entry(3, 0, 1.0),
        ]
    };
    let measured = MeasuredWheelset::new(entries()).unwrap();
    let w = lines[77];
    let (got, expected) = (measured.receptances(w), source.receptances(w));
    for (i, j) in [(3, 3), (4, 4), (5, 5), (5, 4), (4, 5), (3, 0), (0, 3)] {
        assert!(
            (got[i][j] - expected[i][j]).norm() < 1e-12 * expected[i][j].norm(),
            "{i} {j}"
        );
    }
    assert_eq!(got[0][0], Complex64::ZERO);
    assert!(measured.receptances(99.0)[5][5].is_nan());
    assert_eq!(measured.reciprocity_violation(), None);
    // An entry across without those of the other wheel cannot be.
    let violation = measured.passivity_violation().unwrap();
    assert!(violation.ports[0].direction == Direction::Longitudinal);

    let one_wheel = entries()[..4].to_vec();
    let passive = MeasuredWheelset::new(one_wheel.clone()).unwrap();
    assert!(
        passive
            .passivity_violation()
            .is_none_or(|violation| violation.size < 1e-12)
    );
    let both = MeasuredWheelset::from_one_wheel(
        Rail::Right,
        one_wheel
            .iter()
            .map(|entry| {
                (
                    entry.at.direction,
                    entry.from.direction,
                    entry.receptance.clone(),
                )
            })
            .collect(),
    )
    .unwrap();
    let got = both.receptances(w);
    for (i, j) in [(0, 0), (1, 1), (2, 2), (2, 1), (5, 4)] {
        assert!(
            (got[i][j] - expected[i][j]).norm() < 1e-12 * expected[i][j].norm(),
            "{i} {j}"
        );
    }

    // Measured both ways, once with the wrong sign of an axis.
    let crossed = [entries(), vec![entry(4, 5, -1.0)]].concat();
    let violation = MeasuredWheelset::new(crossed)
        .unwrap()
        .reciprocity_violation()
        .unwrap();
    assert_relative_eq!(violation.size, 2.0, max_relative = 1e-12);
    assert_eq!(violation.ports, [Port::ALL[5], Port::ALL[4]]);
    let wrong = MeasuredWheelset::new(vec![entry(5, 5, -1.0)])
        .unwrap()
        .passivity_violation();
    assert_eq!(wrong.unwrap().ports, [Port::ALL[5]; 2]);

    let twice = [entries(), vec![entry(5, 4, 1.0)]].concat();
    assert!(MeasuredWheelset::new(twice).is_err());
    assert!(MeasuredWheelset::new(vec![]).is_err());
}

/// Two absorbers of one frequency on one wheel: against each other they swing while the wheel stands still, a mode that has
/// no node to be seen at. It is counted, and no shape is without a number.
#[test]
fn equal_absorbers_are_counted() {
    let coupled = CoupledInertia {
        polar_inertia: 4.0,
        stiffness: 4.0 * 700f64.powi(2),
        damping: 0.0,
    };
    let absorber = Disc {
        coupled: Some(coupled),
        ..disc(0.75, 0.0, 0.0, 0.0)
    };
    let count = |absorbers: Vec<Disc>| {
        let discs = [wheels_and_boxes([350.0, 27.77, 14.5], 80.0), absorbers].concat();
        let axle = uniform(207e9, 0.16, 2.0);
        let wheelset = FlexibleWheelset::new(axle, discs, CONTACTS).unwrap();
        let modes = wheelset.natural_modes(TAU * 500.0).unwrap();
        for mode in &modes {
            let shape = [-0.75, 0.0, 0.75].map(|place| mode.motion_at(place).below(0.46));
            assert!(
                shape.iter().flatten().all(|value| value.is_finite()),
                "{}",
                mode.name
            );
        }
        hertz(&modes, |name| matches!(name, ModeName::Torsion { .. }))
    };
    assert_eq!(count(vec![]).len(), 1);
    assert_eq!(count(vec![absorber]).len(), 2);
    let both = count(vec![absorber; 2]);
    assert_eq!(both.len(), 3);
    assert_relative_eq!(both[1], 700.0 / TAU, max_relative = 1e-12);
}
