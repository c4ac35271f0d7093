//! Rigid wheelsets, on their suspension and without.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use riffel::Complex64;
use riffel::wheelset::{FlexibleWheelset, ModeName, RigidBody, RigidMotion, RigidWheelset, Suspension, Wheelset};

use super::{CONTACTS, uniform, wheels_and_boxes};

/// The first case of those with a suspension in the loop of one rigid wheelset, 200 Hz, a contact angle of 5°: track axes
/// from contact axes, to the digits given.
#[test]
fn rigid_wheelset_on_its_suspension() {
    let body = RigidBody { mass: 1100.0, roll_inertia: 620.0, spin_inertia: 85.0 };
    let suspension = Suspension::new([12e6, 6e6, 1.1e6], [8e3, 5e3, 20e3], 2.0).unwrap();
    let wheelset = RigidWheelset::new(body, CONTACTS).unwrap().with_suspension(suspension);
    let h = wheelset.receptances(1256.6370614359173);
    let (sine, cosine) = 5f64.to_radians().sin_cos();
    let axes = [[1.0, 0.0, 0.0], [0.0, cosine, -sine], [0.0, sine, cosine]];
    let expected = [
        [(-2.7488163937221852e-09, -1.9244127462272765e-11), (0.0, 0.0), (0.0, 0.0)],
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
            assert!((got - expected).norm() < 1e-14 * h[3][3].norm(), "{got} {expected}");
        }
    }
}

/// Free and rigid: −(1/ω²)(1/M ± s²/J) and what goes with it.
#[test]
fn rigid_wheelset_without_suspension() {
    let body = RigidBody { mass: 1100.0, roll_inertia: 620.0, spin_inertia: 85.0 };
    let h = RigidWheelset::new(body, CONTACTS).unwrap().receptances(100.0);
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
        assert_relative_eq!(mode.angular_frequency.powi(2), expected(motion), max_relative = 0.05);
        motions.push(motion.to_string());
    }
    motions.sort();
    assert_eq!(motions, ["bounce", "lateral", "longitudinal", "roll", "yaw"]);
}
