//! Random flexible wheelsets give no energy away and are reciprocal.

use std::f64::consts::TAU;

use proptest::prelude::*;
use riffel::wheelset::{
    Axle, ContactReceptances, CoupledInertia, Disc, FlexibleWheelset, RigidWheelset, Segment, Suspension, Wheelset,
    WheelsetWithHubs, passivity_error, reciprocity_error,
};

use super::{CONTACTS, DENSITY, disc, steel};

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

    /// Wheelset with left and right exchanged.
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
        let length: f64 = symmetric.segments.iter().map(|segment| segment.length).sum();
        for segment in &mut symmetric.segments {
            segment.length *= 2.2 / length;
        }
        symmetric.discs.extend(self.mirrored().discs);
        symmetric
    }
}

fn a_disc() -> impl Strategy<Value = Disc> {
    let coupled = (0.1..30.0f64, 1e4..1e8f64, 0.0..1e4f64).prop_map(|(inertia, stiffness, damping)| CoupledInertia {
        polar_inertia: inertia,
        stiffness,
        damping,
    });
    ((-1.0..1.0f64, 0.0..400.0f64), (0.0..40.0f64, 0.0..20.0f64), prop::option::weighted(0.3, coupled)).prop_map(
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
    let segment = (0.02..1.0f64, 0.1..0.3f64).prop_map(|(length, diameter)| Segment { length, diameter });
    let suspension = (prop::array::uniform3(0.0..2e7f64), prop::array::uniform3(0.0..3e4f64), 1.0..2.2f64)
        .prop_map(|(stiffness, damping, spacing)| Suspension::new(stiffness, damping, spacing).unwrap());
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
            Built { segments, discs, youngs_modulus: 207e9, loss_factor, suspension }
        })
}

/// √(H_ii H_jj) \[m/N\].
pub(super) fn size(h: &ContactReceptances, i: usize, j: usize) -> f64 {
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

    /// At a low frequency a wheelset moves as its free masses and inertias do, off the middle of the axle, too.
    #[test]
    fn slow_wheelsets_move_freely(built in built()) {
        const SLOW: f64 = 0.1;
        let held_but_along = Suspension::new([0.0, 6e6, 1.1e6], [0.0, 5e3, 20e3], 2.0).unwrap();
        for suspension in [None, Some(held_but_along)] {
            let wheelset = Built { suspension, ..built.clone() }.wheelset();
            let (free, h) = (wheelset.free_at_contacts(), wheelset.receptances(SLOW));
            let largest = free.iter().flatten().fold(0f64, |most, value| most.max(value.abs()));
            let (hubs, forward) = (wheelset.free_hubs(), wheelset.hubs(SLOW));
            let of_hubs = hubs.iter().flatten().zip(forward.iter().flatten());
            for (free, h) in free.iter().flatten().zip(h.iter().flatten()).chain(of_hubs) {
                prop_assert!((free + SLOW * SLOW * h.re).abs() < 1e-3 * largest, "{} {}", free, h);
            }
        }
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
