//! Wheelsets by their modes and a residual.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use proptest::prelude::*;
use riffel::wheelset::{
    ElasticMode, FlexibleWheelset, ModalWheelset, RigidWheelset, Wheelset, passivity_error, reciprocity_error,
};

use super::{CONTACTS, uniform, wheels_and_boxes};

/// A uniform axle with two wheels and boxes at its ends, without loss.
pub(super) fn plain() -> FlexibleWheelset {
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    FlexibleWheelset::new(uniform(207e9, 0.16, 2.0), discs, CONTACTS).unwrap()
}

/// The modes of a flexible wheelset up to a frequency \[Hz\] as those of a finite-element model, shapes multiplied by a
/// factor.
fn elastic_modes(wheelset: &FlexibleWheelset, highest: f64, factor: f64) -> Vec<ElasticMode> {
    let mut modes = Vec::new();
    for mode in wheelset.natural_modes(TAU * highest).unwrap() {
        let motions = [-0.75, 0.75].map(|place| mode.motion_at(place));
        let shape: Vec<f64> = motions.iter().flat_map(|motion| motion.below(0.46)).collect();
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
            modes.push(ElasticMode { shape: [left, 0.0, 0.0, right, 0.0, 0.0], ..elastic });
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
        let residual = std::array::from_fn(|i| std::array::from_fn(|j| (whole[i][j] - known[i][j]).re));
        let modal = modal.with_residual(residual).unwrap();
        for frequency in [5.0, 60.0, 100.0, 150.0, 230.0, 300.0, 500.0, 700.0] {
            let w = TAU * frequency;
            let (got, expected) = (modal.receptances(w), exact.receptances(w));
            let largest = expected.iter().flatten().map(|h| h.norm()).fold(0.0, f64::max);
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
    let h = ModalWheelset::new(None, vec![mode]).unwrap().receptances(500.0);
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
    let told = ElasticMode { shape, generalised_mass: 600.0, ..mode };
    assert!(ModalWheelset::new(Some(rigid), vec![told]).is_ok());
    for wrong in [
        ElasticMode { angular_frequency: 0.0, ..mode },
        ElasticMode { damping_ratio: 1.0, ..mode },
        ElasticMode { damping_ratio: f64::NAN, ..mode },
        ElasticMode { generalised_mass: 0.0, ..mode },
        ElasticMode { shape: [f64::INFINITY; 6], ..mode },
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
